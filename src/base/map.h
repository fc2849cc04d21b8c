/* Files as memory, read only: all processes of a machine that have one open
 * share its pages. Whoever has a part of it holds it; the last one ends it. */
#ifndef BASE_MAP_H
#define BASE_MAP_H

#include <stddef.h>

struct map;

/* Held once. NULL with errno if it can't be had: missing, a directory
 * (EISDIR), empty or of another kind (EINVAL). It must be replaced as a whole
 * (base/save.h), never written to. */
struct map *map_open(const char *path);

void map_hold(struct map *map);

/* Of one that is held; NULL is none. */
void map_release(struct map *map);

const void *map_bytes(const struct map *map);
size_t map_size(const struct map *map);

#endif
