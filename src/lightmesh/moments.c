/* What mesh points know, smoothed over time: by what the same points know at
 * moments around, as irradiance maps of animations are interpolated between
 * those of frames (V-Ray's prepass). Light from surface to surface changes
 * slowly, but of that it is known by few rays some find something else in each
 * picture in which something moves, and surfaces flicker. Where it changes by
 * more than chance does, each moment has its own (a bilateral filter: Tomasi
 * and Manduchi 1998). */
#include "base/smooth.h"
#include "lightmesh/gatherer.h"
#include "lightmesh/indirect.h"
#include "lightmesh/tuning.h"

/* How much another moment's light counts by how much it differs. */
static double moment_alike(const struct indirect_light *own,
                           const struct indirect_light *other)
{
    rgb a = harmonics_total(&own->light), b = harmonics_total(&other->light);
    double apart =
        rgb_peak(rgb_make(fabs(a.r - b.r), fabs(a.g - b.g), fabs(a.b - b.b)));
    double most = fmax(rgb_peak(a), rgb_peak(b));
    return most > 0 ? 1 - smooth_step((apart / most - moments_alike) /
                                      (moments_apart - moments_alike))
                    : 1;
}

static const struct indirect_light *moment_knows(const struct indirect_mesh *of,
                                                 struct worker *worker,
                                                 const struct mesh_site *site)
{
    const struct lattice_point point = lattice_named(site->key);
    return point_mesh_payload(&of->points, worker, &point);
}

/* A mesh_fill. */
static void moments_fill(const void *context, struct worker *worker,
                         const struct mesh_site *site, void *payload)
{
    const struct indirect_mesh *mesh = context;
    const struct indirect_moments *moments = &mesh->moments;
    struct indirect_light *light = payload;
    double weights = 0;
    if (site->lone) {
        gatherer_fill(context, worker, site, payload);
        return;
    }
    const struct indirect_light *own =
        moment_knows(moments->at[moments->now].mesh, worker, site);
    *light = indirect_light_none;
    for (int i = 0; i < moments->count; i++) {
        const struct indirect_light *other =
            moment_knows(moments->at[i].mesh, worker, site);
        double weight = moments->at[i].weight * moment_alike(own, other);
        if (weight > 0)
            indirect_light_mix(light, other, (float)weight);
        weights += weight;
    }
    indirect_light_scale(light, (float)(1 / weights));
}

void indirect_mesh_smooth(struct indirect_mesh *mesh,
                          const struct indirect_moments *moments)
{
    mesh->moments = *moments;
    mesh->points.fill = moments_fill;
}
