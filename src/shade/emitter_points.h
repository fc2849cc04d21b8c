/* Points all over a shape whose surface has no simple parts (scene/patch.h):
 * a tube, a letter, a ring. Lines in all directions cross it everywhere equally
 * often (Crofton 1868), so each crossing stands for the same area. */
#ifndef SHADE_EMITTER_POINTS_H
#define SHADE_EMITTER_POINTS_H

#include "scene/primitive.h"
#include "world/solid.h"

/* In the world. */
struct emitter_point {
    vec3 at;
    double area;  /* that it stands for */
    double along; /* where it is on the longest side */
};

struct emitter_points {
    struct emitter_point *items;
    size_t count, capacity;
};

/* Whether it has all of its crossings told, at a price that is less than what
 * chance costs. */
bool emitter_points_can(const struct primitive *primitive);

/* Those of about so many lines, from one end of the shape to the other, added
 * to `points`, in `arena`: none if it has no end. */
void emitter_points_add(struct arena *arena, const struct leaf *leaf,
                        uint32_t lines, struct emitter_points *points);

/* The density per solid angle, seen from the point, of directions to places
 * that are picked anywhere alike on the leaf, times its area: of all that are
 * in this direction. */
double emitter_points_density(const struct leaf *leaf, vec3 point,
                              vec3 direction);

#endif
