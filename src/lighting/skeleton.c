/* Direct light by shadow rays, and all other light from the skeleton of the
 * void: a lit scene in a moment. There is no ambient term but where nothing
 * else gives light: what it stood for is now known. */
#include "base/memory.h"
#include "lighting/lamplight.h"
#include "lighting/skeleton_views.h"
#include "lighting/void_skeleton.h"
#include "skeleton/export.h"

struct skeleton_lighting {
    struct lamps lamps;
    struct void_skeleton made;
};

static void skeleton_finish(void *state)
{
    struct skeleton_lighting *lighting = state;
    if (!lighting)
        return;
    void_skeleton_free(&lighting->made);
    lamps_free(&lighting->lamps);
    memory_free(lighting);
}

static void *skeleton_start(const struct world *world,
                            const struct scene *scene,
                            const struct lighting_options *options,
                            struct diag *diag)
{
    struct skeleton_lighting *lighting = memory_new(sizeof *lighting);
    const char *file = scene->settings.skeleton.save_file;
    lighting->lamps = lamps_new(world, scene, options->quality, options->seed);
    struct void_skeleton_wish wish = { 0 };
    if (!void_skeleton_make(&lighting->made, world, scene, wish, options,
                            diag) ||
        (file && !skeleton_save(lighting->made.skeleton, file, diag))) {
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
    const struct skeleton *skeleton = lighting->made.skeleton;
    const struct ambience *ambience = &skeleton->ambience;
    return (struct diffuse_light){
        .ambient = ambience->everywhere ? ambience->light : rgb_grey(0),
        .irradiance = skeleton_indirect(skeleton, worker, surface->point,
                                        surface->normal),
    };
}

static const struct lamps *skeleton_lamps(const void *state)
{
    const struct skeleton_lighting *lighting = state;
    return &lighting->lamps;
}

static vec3 skeleton_stream(const void *state, struct worker *worker,
                            vec3 place, vec3 normal)
{
    const struct skeleton_lighting *lighting = state;
    return skeleton_light(lighting->made.skeleton, worker, place, normal)
        .stream;
}

static void skeleton_give_graph(const void *state, struct show *show)
{
    const struct skeleton_lighting *lighting = state;
    skeleton_show_graph(lighting->made.skeleton, show);
}

static void skeleton_give_light(const void *state, struct show *show)
{
    const struct skeleton_lighting *lighting = state;
    skeleton_show_light(lighting->made.skeleton, show);
}

static void skeleton_give_stream(const void *state, struct show *show)
{
    const struct skeleton_lighting *lighting = state;
    skeleton_show_stream(lighting->made.skeleton, show);
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
    .lamps = skeleton_lamps,
    .stream = skeleton_stream,
    .views = skeleton_views,
};
