/* Virtual lights seen: see gather_virtual.h. */
#include "lightmesh/gather_virtual.h"

#include "lightmesh/gather_ways.h"
#include "lightmesh/virtual_lights.h"
#include "shade/shadow.h"

/* What a place would see of a virtual light. */
static struct gathered_glow virtual_look(const struct virtual_light *light,
                                         vec3 place, double *distance)
{
    vec3 to = vec3_sub(light->point, place);
    double square = vec3_dot(to, to), facing = -vec3_dot(to, light->normal);
    *distance = sqrt(square);
    return (struct gathered_glow){
        vec3_scale(to, 1 / *distance),
        rgb_scale(light->light, virtual_light_fade(light->near, *distance)),
        square * *distance / (light->area * facing)
    };
}

struct picked {
    const struct virtual_pick *picks;
    unsigned count;
};

/* Those of up to RAY_LANES that nothing stands before. */
static unsigned picks_look(const struct gather *gather, struct worker *worker,
                           vec3 place, const struct picked *picked,
                           struct gathered_glow *found)
{
    const unsigned count = picked->count;
    struct gathered_glow seen[RAY_LANES];
    struct world_hit hits[RAY_LANES];
    struct rays rays;
    struct rays_span span;
    unsigned met = 0;
    for (unsigned i = 0; i < count; i++) {
        const struct virtual_pick *pick = &picked->picks[i];
        double distance;
        seen[i] = virtual_look(pick->light, place, &distance);
        seen[i].density *= pick->often;
        rays_set(&rays, (int)i, place, seen[i].direction);
        span.near[i] = surface_offset(place);
        span.far[i] = distance - surface_offset(pick->light->point);
    }
    rays_fill(&rays, &span, count);
    worker->counters.shadow_rays += count;
    world_closest_many(gather->lamps->world, &rays, &span, count, RAY_GATHER,
                       hits);
    for (unsigned i = 0; i < count; i++)
        if (!hits[i].leaf)
            found[met++] = seen[i];
    return met;
}

unsigned gather_virtual(const struct gather *gather, struct worker *worker,
                        vec3 place, unsigned part, struct gathered_glow *found)
{
    struct virtual_pick picks[VIRTUAL_PICKS_MOST];
    unsigned met = 0;
    int count = virtual_lights_pick(gather->virtual_lights, place, part,
                                    gather->picks, picks);
    for (int first = 0; first < count && !worker_stopped(worker);
         first += RAY_LANES) {
        int left = count - first;
        const struct picked picked = { picks + first, left < RAY_LANES
                                                          ? (unsigned)left
                                                          : RAY_LANES };
        met += picks_look(gather, worker, place, &picked, found + met);
    }
    return met;
}

double gather_virtual_share(const struct gather *gather,
                            const struct intersection *at, vec3 way)
{
    const struct virtual_lights *lights = gather->virtual_lights;
    return lights ? virtual_lights_share(lights, at->point,
                                         vec3_against(at->face, way), at->t)
                  : 0;
}
