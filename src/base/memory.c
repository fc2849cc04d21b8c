/* Allocation that can't return NULL: see memory.h. */
#include "base/memory.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>

static _Noreturn void memory_exhausted(size_t size)
{
    fprintf(stderr, "glim: fatal: out of memory (%zu bytes wanted)\n", size);
    exit(1);
}

void *memory_new(size_t size)
{
    void *memory = calloc(1, size ? size : 1);
    if (!memory)
        memory_exhausted(size);
    return memory;
}

void *memory_resize(void *old, size_t size)
{
    void *memory = realloc(old, size ? size : 1);
    if (!memory)
        memory_exhausted(size);
    return memory;
}

void memory_free(void *memory)
{
    free(memory);
}

/* The number in a file, or `otherwise`: "max" stands for no limit. */
static size_t memory_read_limit(const char *path, size_t otherwise)
{
    unsigned long long bytes;
    FILE *file = fopen(path, "r");
    bool found = file && fscanf(file, "%llu", &bytes) == 1;
    if (file)
        fclose(file);
    return found && bytes < otherwise ? (size_t)bytes : otherwise;
}

size_t memory_available(void)
{
    long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
    size_t bytes =
        pages > 0 && size > 0 ? (size_t)pages * (size_t)size : SIZE_MAX;
    struct rlimit limit;
    if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur < bytes)
        bytes = (size_t)limit.rlim_cur;
    bytes = memory_read_limit("/sys/fs/cgroup/memory.max", bytes);
    return memory_read_limit("/sys/fs/cgroup/memory/memory.limit_in_bytes",
                             bytes);
}
