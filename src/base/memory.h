/* The only callers of malloc: allocation that can't return NULL. Out of memory
 * ends the program with a message and exit status 1. */
#ifndef BASE_MEMORY_H
#define BASE_MEMORY_H

#include <stddef.h>

/* Zeroed memory; freed with memory_free. */
void *memory_new(size_t size);

/* The same for what may stay untouched for the most part, here and there: then
 * it costs little. */
void *memory_new_sparse(size_t size);

/* The same for what is filled bit by bit from the front: the rest of it costs
 * little. */
void *memory_new_lazy(size_t size);

/* As realloc: new bytes are not zeroed; `old` may be NULL. */
void *memory_resize(void *old, size_t size);
void memory_free(void *memory);

/* How many bytes this process can hope for: what the machine has, or less
 * where a container (cgroup) or `ulimit -v` says so. */
size_t memory_available(void);

#endif
