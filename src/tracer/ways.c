/* The ways of light at a surface: see ways.h. */
#include "tracer/ways.h"

#include "shade/finish.h"

double way_exponent(const struct way *way)
{
    return way->kind == WAY_MIRRORED ? way->layer->finish->reflection.exponent
                                     : 1;
}

void ways_add(struct ways *ways, enum way_kind kind, vec3 direction, rgb weight,
              const struct surface_layer *layer)
{
    if (rgb_peak(weight) > 0 && ways->count < WAYS_MAX)
        ways->at[ways->count++] =
            (struct way){ kind, layer, direction, weight };
}

static void ways_mirrors(struct ways *ways, const struct arrival *arrival,
                         const struct crossing *crossing)
{
    const struct surface *surface = &crossing->surface;
    if (arrival->tracer->quality < QUALITY_REFLECTION)
        return;
    for (int i = 0; i < surface->count; i++) {
        const struct surface_layer *layer = &surface->layer[i];
        if (rgb_peak(layer->reflection) == 0)
            continue;
        vec3 direction = surface_mirrored(crossing->surface.normal,
                                          arrival->direction, layer->normal);
        ways_add(ways, WAY_MIRRORED, direction, layer->reflection, layer);
    }
}

void ways_find(struct ways *ways, const struct arrival *arrival,
               const struct crossing *crossing)
{
    const struct surface *surface = &crossing->surface;
    vec3 normal = surface->pane, direction = arrival->direction;
    rgb through = arrival->split ? surface->through : surface_passed(surface);
    ways->count = 0;
    if (arrival->level >= tracer_levels(arrival->tracer))
        return;
    if (arrival->tracer->quality < QUALITY_TRANSPARENCY)
        through = rgb_grey(0);
    if (rgb_peak(through) > 0 && crossing->ior != 1 &&
        !crossing_refracted(crossing, direction, normal, &direction)) {
        direction = surface_mirrored(crossing->surface.normal,
                                     arrival->direction, normal);
        ways_add(ways, WAY_TURNED, direction, rgb_grey(1), NULL);
        return;
    }
    ways_add(ways, WAY_THROUGH, direction, through, NULL);
    ways_mirrors(ways, arrival, crossing);
}

double ways_total(const struct ways *ways)
{
    rgb sum = rgb_grey(0);
    for (int i = 0; i < ways->count; i++)
        sum = rgb_add(sum, ways->at[i].weight);
    return rgb_peak(sum);
}

void ways_choose(struct ways *ways, double which)
{
    double sum = 0;
    for (int i = 0; i < ways->count; i++)
        sum += rgb_peak(ways->at[i].weight);
    double wanted = which * sum;
    int i = 0;
    for (; i < ways->count - 1 && wanted >= rgb_peak(ways->at[i].weight); i++)
        wanted -= rgb_peak(ways->at[i].weight);
    double chance = rgb_peak(ways->at[i].weight) / sum;
    ways->at[0] = ways->at[i];
    ways->at[0].weight = rgb_scale(ways->at[0].weight, 1 / chance);
    ways->count = 1;
}
