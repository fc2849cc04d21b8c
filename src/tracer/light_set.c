/* What shines: see light_set.h. The integrator follows the paths itself
 * (integrator/path.c), because light that comes back again depends on all that
 * a ray does. */
#include "tracer/light_set.h"

#include "base/memory.h"
#include "shade/area.h"

static void path_finish(void *state)
{
    struct light_set *set = state;
    if (!set)
        return;
    guide_free(set->guide);
    emitters_free(set->emitters);
    memory_free(set->sums);
    memory_free(set->lamps);
    memory_free(set);
}

static void *path_start(const struct world *world, const struct scene *scene,
                        const struct lighting_options *options,
                        struct diag *diag)
{
    struct light_set *set = memory_new(sizeof *set);
    const struct light *lights = world_lights(world, &set->count);
    double sum = 0;
    set->seed = options->seed;
    set->lamps = memory_new(set->count * sizeof *set->lamps);
    set->sums = memory_new(set->count * sizeof *set->sums);
    for (size_t i = 0; i < set->count; i++) {
        double glow = rgb_peak(lights[i].colour);
        set->lamps[i] = lamp_new(&lights[i], (int)i);
        set->sums[i] = sum += isfinite(glow) ? glow : 0;
    }
    set->emitters = emitters_new(world, false);
    set->ambience = ambience_new(world, scene);
    if (scene->settings.skeleton.guide == PATH_GUIDE_OFF)
        return set;
    set->guide = guide_new(world, scene, options, diag);
    if (!set->guide) {
        path_finish(set);
        return NULL;
    }
    if (!guide_useful(set->guide)) {
        guide_free(set->guide);
        set->guide = NULL;
    }
    return set;
}

bool light_set_look(const struct lamp *lamp, vec3 point, const double u[2],
                    struct lamp_pick *pick)
{
    const struct light *light = lamp->light;
    vec3 place = light->location;
    bool parallel = lamp_is_parallel(lamp);
    if (light->area)
        place = area_anywhere(lamp, point, u);
    bool there =
        lamp_look(lamp, parallel ? light->location : place, point, &pick->view);
    vec3 way = vec3_scale(pick->view.direction, pick->view.distance);
    if (parallel)
        way = vec3_add(way, vec3_sub(place, light->location));
    pick->towards = vec3_normalise(way);
    pick->distance = pick->view.distance > 0 ? vec3_length(way) : 0;
    return there;
}

const struct lighting path_lighting = {
    .name = "path",
    .help = "the reference: all paths of light, sample by sample (--samples)",
    .start = path_start,
    .finish = path_finish,
};
