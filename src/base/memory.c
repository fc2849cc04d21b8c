/* Allocation that can't return NULL: see memory.h. */
#include "base/memory.h"

#include <malloc.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

enum {
    LARGE_PAGE = 2 << 20,
    HEAP_STEP = 4 * LARGE_PAGE,
    HEAP_KEPT = 16 * HEAP_STEP, /* free, for what is wanted next */
};

static _Noreturn void memory_exhausted(size_t size)
{
    fprintf(stderr, "glim: fatal: out of memory (%zu bytes wanted)\n", size);
    exit(1);
}

/* Pages of the usual size are got from the system one by one, when they are
 * first touched, which on virtual machines takes longer than to fill them. */
static void memory_in_large_pages(uintptr_t from, uintptr_t end)
{
#ifdef MADV_HUGEPAGE
    from += LARGE_PAGE - 1;
    from -= from % LARGE_PAGE;
    end -= end % LARGE_PAGE;
    if (end > from)
        madvise((void *)from, end - from, MADV_HUGEPAGE);
#else
    (void)from;
    (void)end;
#endif
}

/* The same for what everybody's heap has grown by, in steps that have room for
 * large pages and hold all but the largest blocks. */
static void heap_in_large_pages(void)
{
#ifdef __GLIBC__
    static _Atomic uintptr_t known;
    uintptr_t end = (uintptr_t)sbrk(0);
    uintptr_t before = atomic_exchange(&known, end);
    if (before == 0) {
        mallopt(M_TOP_PAD, HEAP_STEP);
        mallopt(M_MMAP_THRESHOLD, HEAP_STEP);
        mallopt(M_TRIM_THRESHOLD, HEAP_KEPT);
    } else if (end > before) {
        memory_in_large_pages(before, end);
    }
#endif
}

void *memory_new(size_t size)
{
    heap_in_large_pages();
    void *memory = calloc(1, size ? size : 1);
    if (!memory)
        memory_exhausted(size);
    if (size >= LARGE_PAGE)
        memory_in_large_pages((uintptr_t)memory, (uintptr_t)memory + size);
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
