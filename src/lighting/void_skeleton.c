/* Void and skeleton: see void_skeleton.h. */
#include "lighting/void_skeleton.h"

#include "lighting/names.h"
#include "skeleton/void.h"

bool void_skeleton_make(struct void_skeleton *made, const struct world *world,
                        const struct scene *scene, const char *heuristic,
                        int resolution, const struct lighting_options *options,
                        struct diag *diag)
{
    const struct skeleton_settings *said = &scene->settings.skeleton;
    struct skeleton_options wanted = {
        .heuristic = heuristic ? heuristic_find(heuristic)
                               : names_heuristic(&scene->settings, diag),
        .seed = options->seed,
        .threads = options->threads,
        .stop = options->stop,
    };
    *made = (struct void_skeleton){ NULL, NULL };
    if (said->resolution > 0)
        resolution = said->resolution;
    if (wanted.heuristic)
        made->space =
            void_new(scene, world, resolution, options->threads, diag);
    if (made->space)
        made->skeleton =
            skeleton_new(world, scene, &made->space->voxels, &wanted);
    return made->skeleton;
}

void void_skeleton_free(struct void_skeleton *made)
{
    skeleton_free(made->skeleton);
    void_free(made->space);
}
