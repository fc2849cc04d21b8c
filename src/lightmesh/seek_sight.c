/* Sights of mesh points: see seek_sight.h. */
#include "lightmesh/seek_sight.h"

#include "lightmesh/tuning.h"
#include "scene/primitive.h"
#include "shade/shadow.h"
#include "shade/surface.h"

/* Whether it is seen through a pane that a point so high above it can't tell
 * from its own plane. */
static bool seek_is_beneath(const struct receiver *receiver, double height)
{
    const vec3 pane = vec3_sub(receiver->from, receiver->point);
    return receiver->unmirrored && !receiver->pixel &&
           vec3_dot(pane, receiver->side) < obstacle_plane * height;
}

enum sight seek_sight(const struct point_mesh *mesh, struct worker *worker,
                      const struct receiver *receiver,
                      const struct lattice_point *point, vec3 from)
{
    const struct obstacles *around = point_mesh_around(mesh, worker, point);
    const vec3 offset = vec3_sub(receiver->point, from);
    const enum sight sight = obstacles_sight(around, offset, receiver->side);
    return sight == SIGHT_CLEAR &&
                   seek_is_beneath(receiver, -vec3_dot(offset, receiver->side))
               ? SIGHT_UNSURE
               : sight;
}

/* Whether nothing is between; `filter`: but what it lets pass, into *through.
 */
static bool seek_ray(const struct point_mesh *mesh, struct worker *worker,
                     const struct receiver *receiver, vec3 from,
                     world_filter *filter, rgb *through)
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
                             .context = through,
                             .spread = gather_spread });
}

bool seek_looks(const struct point_mesh *mesh, struct worker *worker,
                const struct receiver *receiver, vec3 from)
{
    return seek_ray(mesh, worker, receiver, from, NULL, NULL);
}

/* Whether a surface lets too little pass: then the light behind it is another.
 */
static bool pane_is_dim(const struct intersection *at, rgb *through)
{
    *through = rgb_mul(*through, surface_transmittance(at));
    return rgb_peak(*through) < seek_clear;
}

static bool pane_hides(void *context, const struct ray *ray,
                       const struct world_hit *hit)
{
    struct intersection at;
    world_describe(ray, hit, &at);
    return pane_is_dim(&at, context);
}

/* Or isn't that of a body which the ray leaves as it is. */
static bool shell_hides(void *context, const struct ray *ray,
                        const struct world_hit *hit)
{
    const struct leaf *leaf = hit->leaf;
    const struct interior *interior = leaf->look->interior;
    struct intersection at;
    if ((interior && interior->ior != 1) ||
        leaf->object->kind != OBJECT_SHAPE || !leaf->object->primitive->solid ||
        leaf->object->primitive->beyond)
        return true;
    world_describe(ray, hit, &at);
    return vec3_dot(at.face, ray->direction) < 0 || pane_is_dim(&at, context);
}

bool seek_looks_through(const struct point_mesh *mesh, struct worker *worker,
                        const struct receiver *receiver, vec3 from,
                        rgb *through)
{
    *through = rgb_grey(1);
    return seek_ray(mesh, worker, receiver, from, pane_hides, through);
}

bool seek_looks_out(const struct point_mesh *mesh, struct worker *worker,
                    const struct receiver *receiver, vec3 from, rgb *through)
{
    *through = rgb_grey(1);
    return seek_ray(mesh, worker, receiver, from, shell_hides, through);
}

bool seek_sees(const struct point_mesh *mesh, struct worker *worker,
               const struct receiver *receiver,
               const struct lattice_point *point, vec3 from)
{
    enum sight sight = seek_sight(mesh, worker, receiver, point, from);
    return sight == SIGHT_UNSURE ? seek_looks(mesh, worker, receiver, from)
                                 : sight == SIGHT_CLEAR;
}
