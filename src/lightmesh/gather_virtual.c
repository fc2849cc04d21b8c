/* Virtual lights seen: see gather_virtual.h. */
#include "lightmesh/gather_virtual.h"

#include "lightmesh/gather_ways.h"
#include "lightmesh/virtual_lights.h"
#include "shade/shadow.h"

/* What a place would see of a virtual light; false: it is behind, or too near.
 */
static bool virtual_look(const struct virtual_lights *lights,
                         const struct virtual_light *light, vec3 place,
                         double *distance, struct gathered_glow *seen)
{
    vec3 to = vec3_sub(light->point, place);
    double square = vec3_dot(to, to), facing = -vec3_dot(to, light->normal);
    *distance = sqrt(square);
    if (!(*distance > lights->near) || !(facing > 0))
        return false;
    *seen = (struct gathered_glow){
        vec3_scale(to, 1 / *distance),
        rgb_scale(light->light, virtual_lights_fade(lights, *distance)),
        square * *distance / (light->area * facing)
    };
    return true;
}

unsigned gather_virtual(const struct gather *gather, struct worker *worker,
                        vec3 place, unsigned part, int *next,
                        struct gathered_glow *found)
{
    const struct virtual_lights *lights = gather->virtual_lights;
    struct gathered_glow seen[RAY_LANES];
    struct world_hit hits[RAY_LANES];
    struct rays rays;
    struct rays_span span;
    unsigned count = 0, met = 0;
    for (; *next < lights->count && count < RAY_LANES; ++*next) {
        const struct virtual_light *light =
            &lights->at[*next * GATHER_PARTS + (int)part];
        double distance;
        if (!virtual_look(lights, light, place, &distance, &seen[count]))
            continue;
        rays_set(&rays, (int)count, place, seen[count].direction);
        span.near[count] = surface_offset(place);
        span.far[count++] = distance - surface_offset(light->point);
    }
    if (count == 0)
        return 0;
    worker->counters.shadow_rays += count;
    world_closest_many(gather->lamps->world, &rays, &span, count,
                       RAY_REFLECTION, hits);
    for (unsigned i = 0; i < count; i++)
        if (!hits[i].leaf)
            found[met++] = seen[i];
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
