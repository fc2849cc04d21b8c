/* Void and skeleton: see void_skeleton.h. */
#include "lighting/void_skeleton.h"

#include "lighting/names.h"
#include "skeleton/void.h"

bool void_skeleton_make(struct void_skeleton *made, const struct world *world,
                        const struct scene *scene,
                        struct void_skeleton_wish wish,
                        const struct lighting_options *options,
                        struct diag *diag)
{
    int said = scene->settings.skeleton.resolution;
    struct skeleton_options wanted = {
        .heuristic = wish.heuristic ? heuristic_find(wish.heuristic)
                                    : names_heuristic(&scene->settings, diag),
        .seed = options->seed,
        .threads = options->threads,
        .stop = options->stop,
        .rays = wish.rays,
        .root = wish.root,
    };
    const struct grid_wish grid = { said > 0 ? said : wish.resolution,
                                    wish.still };
    *made = (struct void_skeleton){ NULL, NULL };
    if (wanted.heuristic)
        made->space =
            void_new(scene, world, grid, options->threads, options->stop, diag);
    if (made->space)
        made->skeleton =
            skeleton_new(world, scene, &made->space->voxels, &wanted);
    if (!made->skeleton)
        return false;
    struct ambience *ambience = &made->skeleton->ambience;
    ambience->everywhere |= made->space->dark && !ambience->sky;
    return true;
}

void void_skeleton_free(struct void_skeleton *made)
{
    skeleton_free(made->skeleton);
    void_free(made->space);
}
