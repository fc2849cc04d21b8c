/* Sights of mesh points: see seek_sight.h. */
#include "lightmesh/seek_sight.h"

#include "lightmesh/tuning.h"
#include "shade/shadow.h"

enum sight seek_sight(const struct point_mesh *mesh, struct worker *worker,
                      const struct receiver *receiver,
                      const struct lattice_point *point, vec3 from)
{
    const struct obstacles *around = point_mesh_around(mesh, worker, point);
    return obstacles_sight(around, vec3_sub(receiver->point, from),
                           receiver->side);
}

bool seek_looks(const struct point_mesh *mesh, struct worker *worker,
                const struct receiver *receiver, vec3 from)
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
                             .spread = gather_spread });
}

bool seek_sees(const struct point_mesh *mesh, struct worker *worker,
               const struct receiver *receiver,
               const struct lattice_point *point, vec3 from)
{
    enum sight sight = seek_sight(mesh, worker, receiver, point, from);
    return sight == SIGHT_UNSURE ? seek_looks(mesh, worker, receiver, from)
                                 : sight == SIGHT_CLEAR;
}
