/* The scene's void and its skeleton, made together: what the lighting methods
 * that ask the skeleton have in common. */
#ifndef LIGHTING_VOID_SKELETON_H
#define LIGHTING_VOID_SKELETON_H

#include "lighting/lighting.h"
#include "skeleton/skeleton.h"

struct void_space;

struct void_skeleton {
    struct void_space *space;
    struct skeleton *skeleton;
};

/* As the scene's skeleton {} says, with `heuristic` or, if NULL, the one that
 * it names; `resolution` voxels along the longest side if it says nothing, 0:
 * as many as skeletons have that are shown. False after an error was printed,
 * or when it was stopped. Frees with void_skeleton_free. */
bool void_skeleton_make(struct void_skeleton *made, const struct world *world,
                        const struct scene *scene, const char *heuristic,
                        int resolution, const struct lighting_options *options,
                        struct diag *diag);
void void_skeleton_free(struct void_skeleton *made);

#endif
