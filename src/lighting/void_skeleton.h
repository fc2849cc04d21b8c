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

/* What a method wants of it. */
struct void_skeleton_wish {
    const char *heuristic; /* NULL: the one that the scene names */
    int resolution;        /* voxels along the longest side if the scene says
                            * nothing; 0: as skeletons have that are shown */
    bool still;            /* as of struct grid_wish */
    size_t rays;           /* as in struct skeleton_options, */
    const struct pieces_kept *root; /* and this */
};

/* As the scene's skeleton {} says, and the wish. If no light gets to where the
 * camera is the skeleton's ambient light is everywhere, as where no lamp is on.
 * False after an error was printed, or when it was stopped. Frees with
 * void_skeleton_free. */
bool void_skeleton_make(struct void_skeleton *made, const struct world *world,
                        const struct scene *scene,
                        struct void_skeleton_wish wish,
                        const struct lighting_options *options,
                        struct diag *diag);
void void_skeleton_free(struct void_skeleton *made);

#endif
