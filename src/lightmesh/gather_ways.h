/* The ways that gather rays of mesh points go: all points look along the same
 * ones, but for the corners of a cell, which have eight parts of one large set:
 * neighbours don't differ by chance, and between them a place has a set as
 * large. They are found once. */
#ifndef LIGHTMESH_GATHER_WAYS_H
#define LIGHTMESH_GATHER_WAYS_H

#include <stdint.h>

#include "base/vec.h"

enum { GATHER_PARTS = 8 }; /* of a set */

struct gather_ways {
    uint32_t samples; /* of a part, */
    uint32_t set;     /* of which the next begins so many further on */
    uint32_t count;   /* of all parts; 0: too many to be kept */
    vec3 *ways;       /* unit; NULL: there are none */
    uint32_t *order;  /* samples of each part, so that neighbours go nearly the
                       * same way; likewise */
};

/* Frees with gather_ways_free. */
struct gather_ways gather_ways_new(int samples);
void gather_ways_free(struct gather_ways *ways);

/* Way `index` of those that `key` names: all are equally likely. */
vec3 gather_way(uint64_t key, uint32_t index);

/* Moves a place of the unit square, round its edges, for each part by another
 * of a net of eight (Cranley and Patterson 1976; Hammersley's points): each
 * part keeps its own net, and of few rays those of all parts are even as well.
 */
void gather_part_shift(uint32_t part, double place[2]);

#endif
