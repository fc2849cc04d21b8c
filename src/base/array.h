/* Growing arrays of any type in an arena: a struct with `items`, `count` and
 * `capacity`, declared where it is used:
 *     struct { struct light *items; size_t count, capacity; } lights;
 *     *ARRAY_PUSH(arena, &lights) = light;
 * It grows where it stands if nothing else was allocated since; else its old
 * storage is left to the arena, which at most doubles its size. */
#ifndef BASE_ARRAY_H
#define BASE_ARRAY_H

#include "base/arena.h"

/* The pointer to a new last item (not zeroed beyond what the arena gives). */
#define ARRAY_PUSH(arena, array)                                               \
    (((array)->count == (array)->capacity                                      \
          ? (void)((array)->items =                                            \
                       array_grow((arena), (array)->items, (array)->count,     \
                                  &(array)->capacity, sizeof *(array)->items)) \
          : (void)0),                                                          \
     &(array)->items[(array)->count++])

/* Room for `wanted` items in all, so that they are not moved while they grow
 * to so many. */
#define ARRAY_RESERVE(arena, array, wanted)                                    \
    ((array)->items =                                                          \
         array_reserve((arena), (array)->items, (array)->count,                \
                       &(array)->capacity, (wanted), sizeof *(array)->items))

/* Gives back the room that is not used, if nothing else was allocated since;
 * for arrays of which there may be very many. */
#define ARRAY_FIT(arena, array)                                                \
    array_fit((arena), (array)->items, (array)->count, &(array)->capacity,     \
              sizeof *(array)->items)

void *array_reserve(struct arena *arena, void *items, size_t count,
                    size_t *capacity, size_t wanted, size_t item_size);

/* Room for at least one more item: the items, moved. */
void *array_grow(struct arena *arena, void *items, size_t count,
                 size_t *capacity, size_t item_size);

void array_fit(struct arena *arena, void *items, size_t count, size_t *capacity,
               size_t item_size);

#endif
