/* What is drawn for rays that go on from what gather rays meet. Mesh points
 * send the same few gather rays, and so do places that look around: theirs are
 * drawn once. */
#ifndef LIGHTMESH_ONWARD_H
#define LIGHTMESH_ONWARD_H

#include "base/draw.h"
#include "base/vec.h"

struct onward;

/* Of the samples 0 to count - 1 of a key, where they first meet something. */
struct onwards {
    uint64_t key;
    uint32_t count;
    struct onward *at;
};

/* Frees with onwards_free. */
struct onwards onwards_new(uint64_t key, uint32_t count);
void onwards_free(struct onwards *onwards);

/* Takes these instead for sample `index`: as onward_chance and onward_way. */
void onwards_set(struct onwards *onwards, uint32_t index, double chance,
                 vec3 way);

/* Whether it goes on is decided by this, in [0,1), for sample `draws` and
 * surface number `met` on its way; and it goes there, around a z that is the
 * surface's side, by the cosine. `known` may be NULL. */
double onward_chance(const struct onwards *known, const struct draws *draws,
                     uint32_t met);
vec3 onward_way(const struct onwards *known, const struct draws *draws,
                uint32_t met);

/* What else is drawn for it. */
struct draws onward_draws(const struct draws *draws, uint32_t met);

#endif
