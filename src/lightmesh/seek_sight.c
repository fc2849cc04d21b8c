/* Sights of mesh points: see seek_sight.h. */
#include "lightmesh/seek_sight.h"

#include "base/lesser.h"
#include "lightmesh/tuning.h"
#include "shade/shadow.h"
#include "shade/surface.h"

enum sight seek_sight(const struct point_mesh *mesh, struct worker *worker,
                      const struct receiver *receiver,
                      const struct lattice_point *point, vec3 from)
{
    const struct obstacles *around = point_mesh_around(mesh, worker, point);
    return obstacles_sight(around, vec3_sub(receiver->point, from),
                           receiver->side);
}

/* Whether nothing is between; `filter`: but what it lets pass. */
static bool seek_ray(const struct point_mesh *mesh, struct worker *worker,
                     const struct receiver *receiver, vec3 from,
                     world_filter *filter)
{
    vec3 offset = vec3_sub(receiver->point, from);
    double length = vec3_length(offset);
    struct ray ray = { receiver->point, vec3_scale(offset, -1 / length) };
    worker->counters.shadow_rays++;
    return !world_occluded(
        mesh->world,
        &(struct occlusion){ .ray = &ray,
                             .tmin = surface_offset(receiver->point),
                             .tmax = length,
                             .light = -1,
                             .filter = filter,
                             .spread = gather_spread });
}

bool seek_looks(const struct point_mesh *mesh, struct worker *worker,
                const struct receiver *receiver, vec3 from)
{
    return seek_ray(mesh, worker, receiver, from, NULL);
}

/* Whether a surface on the way lets less than half of any colour pass: then the
 * light behind it is another. */
static bool pane_hides(void *context, const struct ray *ray,
                       const struct world_hit *hit)
{
    struct intersection at;
    (void)context;
    world_describe(ray, hit, &at);
    rgb through = surface_transmittance(&at);
    return lesser(lesser(through.r, through.g), through.b) < seek_clear;
}

bool seek_looks_through(const struct point_mesh *mesh, struct worker *worker,
                        const struct receiver *receiver, vec3 from)
{
    return seek_ray(mesh, worker, receiver, from, pane_hides);
}

bool seek_sees(const struct point_mesh *mesh, struct worker *worker,
               const struct receiver *receiver,
               const struct lattice_point *point, vec3 from)
{
    enum sight sight = seek_sight(mesh, worker, receiver, point, from);
    return sight == SIGHT_UNSURE ? seek_looks(mesh, worker, receiver, from)
                                 : sight == SIGHT_CLEAR;
}
