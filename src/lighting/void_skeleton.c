/* Void and skeleton: see void_skeleton.h. */
#include "lighting/void_skeleton.h"

#include "base/text.h"
#include "skeleton/heuristic.h"
#include "skeleton/void.h"

/* NULL after an error. */
static const struct heuristic *heuristic_named(const char *name,
                                               struct diag *diag)
{
    const struct heuristic *found =
        name ? heuristic_find(name) : heuristic_at(0);
    if (found)
        return found;
    struct text_nearest nearest = text_nearest_start(name);
    for (size_t i = 0; heuristic_at(i); i++)
        text_nearest_try(&nearest, heuristic_at(i)->name);
    diag_print(diag, DIAG_ERROR, span_none(), NULL,
               "there is no heuristic '%s' of skeletons: type %s", name,
               nearest.best ? nearest.best : heuristic_at(0)->name);
    return NULL;
}

bool void_skeleton_make(struct void_skeleton *made, const struct world *world,
                        const struct scene *scene, const char *heuristic,
                        const struct lighting_options *options,
                        struct diag *diag)
{
    const struct skeleton_settings *said = &scene->settings.skeleton;
    struct skeleton_options wanted = {
        .heuristic =
            heuristic_named(heuristic ? heuristic : said->heuristic, diag),
        .seed = options->seed,
        .threads = options->threads,
    };
    *made = (struct void_skeleton){ NULL, NULL };
    if (wanted.heuristic)
        made->space =
            void_new(scene, world, said->resolution, options->threads, diag);
    if (made->space)
        made->skeleton =
            skeleton_new(world, scene, &made->space->voxels, &wanted);
    return made->space;
}

void void_skeleton_free(struct void_skeleton *made)
{
    skeleton_free(made->skeleton);
    void_free(made->space);
}
