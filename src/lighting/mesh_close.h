/* What ends the bounces of the indirect mesh: the scene's closing skeleton, a
 * coarse one, since gathering blurs what it says. */
#ifndef LIGHTING_MESH_CLOSE_H
#define LIGHTING_MESH_CLOSE_H

#include "lighting/void_skeleton.h"
#include "lightmesh/survey.h"

/* The skeleton, or none if the scene wants none. `root`: as in struct
 * skeleton_options. False as of void_skeleton_make. */
bool mesh_close_make(struct void_skeleton *close, const struct world *world,
                     const struct scene *scene,
                     const struct lighting_options *options,
                     const struct pieces_kept *root, struct diag *diag);

/* A gather_close; `context` is the skeleton. */
bool mesh_close_light(const void *context, struct worker *worker, vec3 place,
                      vec3 normal, vec3 from, rgb *light);

/* Whether it knows nearly all places that a survey met. */
bool mesh_close_knows(const struct void_skeleton *close,
                      const struct survey *survey, struct worker *worker);

#endif
