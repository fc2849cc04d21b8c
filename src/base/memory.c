/* Allocation that can't return NULL: see memory.h. */
#include "base/memory.h"

#include <stdio.h>
#include <stdlib.h>

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
