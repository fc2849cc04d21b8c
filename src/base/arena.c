/* Arenas: blocks that double in size, so that n bytes cost O(log n) calls. */
#include "base/arena.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>

#include "base/memory.h"

enum { ARENA_FIRST = 4096, ARENA_LARGEST = 1 << 24, ARENA_ALIGN = 16 };

struct block {
    struct block *previous;
    size_t size, used;
    _Alignas(ARENA_ALIGN) unsigned char bytes[];
};

struct arena {
    struct block *block;
    size_t used, limit;
    char apart[128]; /* from those of other threads: lines of the cache */
};

struct arena *arena_new(size_t limit)
{
    struct arena *arena = memory_new(sizeof *arena);
    arena->limit = limit;
    return arena;
}

static void arena_free_blocks(struct block *block)
{
    while (block) {
        struct block *previous = block->previous;
        memory_free(block);
        block = previous;
    }
}

void arena_free(struct arena *arena)
{
    if (!arena)
        return;
    arena_free_blocks(arena->block);
    memory_free(arena);
}

static void arena_grow(struct arena *arena, size_t size)
{
    size_t next = arena->block ? arena->block->size * 2 : ARENA_FIRST;
    if (next > ARENA_LARGEST)
        next = ARENA_LARGEST;
    if (next < size)
        next = size;
    struct block *block = memory_new_lazy(sizeof *block + next);
    block->size = next;
    block->previous = arena->block;
    arena->block = block;
}

static size_t arena_rounded(size_t size)
{
    return (size + ARENA_ALIGN - 1) & ~(size_t)(ARENA_ALIGN - 1);
}

void *arena_alloc(struct arena *arena, size_t size)
{
    size = arena_rounded(size);
    if (!arena->block || arena->block->size - arena->block->used < size)
        arena_grow(arena, size);
    void *memory = arena->block->bytes + arena->block->used;
    arena->block->used += size;
    arena->used += size;
    return memory;
}

bool arena_resize(struct arena *arena, void *memory, size_t old, size_t size)
{
    struct block *block = arena->block;
    unsigned char *bytes = memory;
    size_t used = arena_rounded(old), wanted = arena_rounded(size);
    if (!block || !bytes || bytes + used != block->bytes + block->used ||
        (wanted > used && block->size - block->used < wanted - used))
        return false;
    if (size < old)
        memset(bytes + size, 0, old - size);
    block->used += wanted - used;
    arena->used += wanted - used;
    return true;
}

size_t arena_used(const struct arena *arena)
{
    return arena->used;
}

size_t arena_limit(const struct arena *arena)
{
    return arena->limit;
}

bool arena_over_limit(const struct arena *arena)
{
    return arena->limit && arena->used > arena->limit;
}

void arena_reset(struct arena *arena)
{
    struct block *block = arena->block;
    arena->used = 0;
    if (!block)
        return;
    arena_free_blocks(block->previous);
    block->previous = NULL;
    memset(block->bytes, 0, block->used);
    block->used = 0;
}

char *arena_copy_text(struct arena *arena, const char *text, size_t length)
{
    char *copy = arena_alloc(arena, length + 1);
    memcpy(copy, text, length);
    return copy;
}

char *arena_printf(struct arena *arena, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    char *text = arena_alloc(arena, (size_t)length + 1);
    va_start(arguments, format);
    vsnprintf(text, (size_t)length + 1, format, arguments);
    va_end(arguments);
    return text;
}
