/* What stands near a mesh point: how far it sees in 26 directions, the middles
 * of the faces, edges and corners of a cube around it. As in the depth maps of
 * Majercik et al. 2019 (Dynamic Diffuse Global Illumination), points that
 * can't see a place don't light it.
 *
 * Kept are the inverse distances, because 1/d of a plane is linear in the
 * direction: between three of the directions interpolation is exact. */
#ifndef LIGHTMESH_OBSTACLES_H
#define LIGHTMESH_OBSTACLES_H

#include "base/worker.h"
#include "world/world.h"

enum { OBSTACLE_DIRECTIONS = 26 };

struct obstacles {
    float near[OBSTACLE_DIRECTIONS]; /* 1/distance; 0: nothing in reach */
};

/* Sends the rays, each as long as `reach`. Transparent things are obstacles
 * too: light on their other side may be another. */
void obstacles_look(struct obstacles *obstacles, const struct world *world,
                    vec3 place, double reach);

/* What obstacles say of the way to a place. */
enum sight {
    SIGHT_CLEAR,  /* nothing that was found stands on it */
    SIGHT_HIDDEN, /* something stands before it on all sides */
    SIGHT_UNSURE, /* only a ray can tell */
};

/* Of the way, at most `reach` long, from the mesh point along `offset` to a
 * place whose normal, on the mesh point's side, is given. */
enum sight obstacles_sight(const struct obstacles *obstacles, vec3 offset,
                           vec3 normal);

/* The unit direction into the plane that is all there is nearer than `reach`;
 * zero if there is more, or nothing. */
vec3 obstacles_plane(const struct obstacles *obstacles, double reach);

#endif
