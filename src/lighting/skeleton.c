/* Direct light by shadow rays, and all other light from the skeleton of the
 * void: a lit scene in a moment. There is no ambient term: what it stood for is
 * now known. */
#include "base/memory.h"
#include "base/text.h"
#include "lighting/lamplight.h"
#include "lighting/skeleton_views.h"
#include "skeleton/export.h"
#include "skeleton/heuristic.h"
#include "skeleton/void.h"

struct skeleton_lighting {
    struct lamps lamps;
    struct void_space *space;
    struct skeleton *skeleton;
};

static void skeleton_finish(void *state)
{
    struct skeleton_lighting *lighting = state;
    if (!lighting)
        return;
    skeleton_free(lighting->skeleton);
    void_free(lighting->space);
    lamps_free(&lighting->lamps);
    memory_free(lighting);
}

/* The one asked for, or NULL after an error. */
static const struct heuristic *
skeleton_heuristic(const struct skeleton_settings *said, struct diag *diag)
{
    const struct heuristic *found =
        said->heuristic ? heuristic_find(said->heuristic) : heuristic_at(0);
    if (found)
        return found;
    struct text_nearest nearest = text_nearest_start(said->heuristic);
    for (size_t i = 0; heuristic_at(i); i++)
        text_nearest_try(&nearest, heuristic_at(i)->name);
    diag_print(diag, DIAG_ERROR, span_none(), NULL,
               "there is no heuristic '%s' of skeletons: type %s",
               said->heuristic,
               nearest.best ? nearest.best : heuristic_at(0)->name);
    return NULL;
}

static void *skeleton_start(const struct world *world,
                            const struct scene *scene,
                            const struct lighting_options *options,
                            struct diag *diag)
{
    const struct skeleton_settings *said = &scene->settings.skeleton;
    struct skeleton_lighting *lighting = memory_new(sizeof *lighting);
    struct skeleton_options wanted = {
        .heuristic = skeleton_heuristic(said, diag),
        .seed = options->seed,
        .threads = options->threads,
    };
    lighting->lamps = lamps_new(world, scene, options->quality, options->seed);
    if (wanted.heuristic)
        lighting->space =
            void_new(scene, world, said->resolution, options->threads, diag);
    if (!lighting->space) {
        skeleton_finish(lighting);
        return NULL;
    }
    lighting->skeleton =
        skeleton_new(world, scene, &lighting->space->voxels, &wanted);
    if (said->save_file &&
        !skeleton_save(lighting->skeleton, said->save_file, diag)) {
        skeleton_finish(lighting);
        return NULL;
    }
    return lighting;
}

static struct diffuse_light skeleton_illuminate(const void *state,
                                                struct worker *worker,
                                                const struct surface *surface,
                                                light_visit *visit,
                                                void *context)
{
    const struct skeleton_lighting *lighting = state;
    struct lamplight light = {
        .lamps = &lighting->lamps,
        .worker = worker,
        .surface = surface,
        .visit = visit,
        .context = context,
        .share = lamplight_trace,
    };
    for (size_t i = 0; i < lighting->lamps.count; i++)
        lamplight_give(&light, &lighting->lamps.items[i]);
    return (struct diffuse_light){ .irradiance = skeleton_indirect(
                                       lighting->skeleton, worker,
                                       surface->point, surface->normal) };
}

static vec3 skeleton_stream(const void *state, struct worker *worker,
                            vec3 place, vec3 normal)
{
    const struct skeleton_lighting *lighting = state;
    return skeleton_light(lighting->skeleton, worker, place, normal).stream;
}

static void skeleton_give_graph(const void *state, struct show *show)
{
    const struct skeleton_lighting *lighting = state;
    skeleton_show_graph(lighting->skeleton, show);
}

static void skeleton_give_light(const void *state, struct show *show)
{
    const struct skeleton_lighting *lighting = state;
    skeleton_show_light(lighting->skeleton, show);
}

static void skeleton_give_stream(const void *state, struct show *show)
{
    const struct skeleton_lighting *lighting = state;
    skeleton_show_stream(lighting->skeleton, show);
}

static const struct lighting_view skeleton_views[] = {
    { "skeleton", "the skeleton of the void, by radius", skeleton_give_graph },
    { "skeleton:irradiance", "the same, by irradiance", skeleton_give_light },
    { "stream", "where light goes, by irradiance", skeleton_give_stream },
    { NULL, NULL, NULL },
};

const struct lighting skeleton_lighting = {
    .name = "skeleton",
    .help = "shadow rays, and indirect light along the skeleton of the void",
    .start = skeleton_start,
    .finish = skeleton_finish,
    .illuminate = skeleton_illuminate,
    .stream = skeleton_stream,
    .views = skeleton_views,
};
