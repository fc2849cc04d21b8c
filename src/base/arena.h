/* An arena is a lifetime: everything allocated from it is freed at once.
 * Nothing in it is freed alone. Not safe for several threads at a time. */
#ifndef BASE_ARENA_H
#define BASE_ARENA_H

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

struct arena;

/* An arena that may hold `limit` bytes (0: no limit). The limit is soft:
 * allocation goes on past it, arena_over_limit tells, and whoever can be
 * driven by a stranger's input asks and stops with an error. */
struct arena *arena_new(size_t limit);
void arena_free(struct arena *arena);

/* Zeroed memory, aligned for any type, valid until arena_free or a reset to
 * an earlier mark. Never NULL. */
void *arena_alloc(struct arena *arena, size_t size);

/* Makes what was allocated last larger or smaller where it stands, from `old`
 * to `size` bytes. Returns false, and nothing has changed, when something was
 * allocated after it, the block has no room, or `memory` is NULL. */
bool arena_resize(struct arena *arena, void *memory, size_t old, size_t size);

size_t arena_used(const struct arena *arena);
size_t arena_limit(const struct arena *arena);
bool arena_over_limit(const struct arena *arena);

/* Frees everything allocated so far but keeps one block for reuse. */
void arena_reset(struct arena *arena);

/* Copies of `length` bytes with a NUL after them. */
char *arena_copy_text(struct arena *arena, const char *text, size_t length);

/* As sprintf, into the arena. */
__attribute__((format(printf, 2, 3))) char *
arena_printf(struct arena *arena, const char *format, ...);

#define ARENA_NEW(arena, type) ((type *)arena_alloc((arena), sizeof(type)))
#define ARENA_ARRAY(arena, type, count)                                        \
    ((type *)arena_alloc((arena), sizeof(type) * (count)))

#endif
