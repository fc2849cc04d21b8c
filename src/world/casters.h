/* What casts shadows, taken apart for those who look at all of it from a lamp:
 * triangles, half spaces, and boxes around what only rays know exactly. */
#ifndef WORLD_CASTERS_H
#define WORLD_CASTERS_H

#include "world/world.h"

enum {
    CASTER_WIDTH = 8,  /* triangles are looked at so many at a time */
    CASTER_SPACES = 8, /* half spaces, at most */
};

/* Triangles in single precision, from the casters' centre: corner 0's x, y and
 * z, corner 1's, corner 2's. There is room for CASTER_WIDTH - 1 more, filled
 * with triangles of no size. */
struct caster_triangles {
    size_t count;
    float *corner[9];
};

struct casters {
    vec3 centre;
    double size; /* the largest coordinate, from the centre */
    struct caster_triangles certain;  /* opaque */
    struct caster_triangles doubtful; /* sides of boxes, of which what is in
                                       * them hides a part */
    double doubt; /* of all ways through the world, about what share meets one
                   * of these boxes; for some that is more than once: above 1 */
    int space_count;
    struct caster_space {
        vec3 normal; /* matter is where normal.p <= distance */
        double distance;
    } spaces[CASTER_SPACES];
};

/* Takes the world apart. False, with nothing to be freed, if it holds what lets
 * light pass or has no end and is no half space. Frees with casters_free. */
bool casters_new(struct casters *casters, const struct world *world);
void casters_free(struct casters *casters);

#endif
