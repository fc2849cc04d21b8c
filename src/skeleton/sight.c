/* Rays to zones: see sight.h. */
#include "skeleton/sight.h"

#include "shade/shadow.h"
#include "shade/surface.h"
#include "skeleton/wall.h"

enum { CROSSINGS = 16 }; /* of things that a ray passes through, at most */

/* The first wall that a ray meets; what lets light pass is none, and leaves so
 * much of it. */
static bool sight_wall(const struct sight *sight, const struct ray *ray,
                       double tmin, struct intersection *at, rgb *through)
{
    *through = rgb_grey(1);
    for (int i = 0; i < CROSSINGS; i++) {
        if (!world_closest(sight->skeleton->world, ray, tmin, RAY_REFLECTION,
                           at))
            return false;
        if (wall_stops(sight->skeleton->marks, at))
            return true;
        *through = rgb_mul(*through, surface_transmittance(at));
        tmin = at->t + surface_offset(at->point);
    }
    return false;
}

struct sighting sight_zone(const struct sight *sight, const struct ray *ray,
                           double tmin, uint64_t key)
{
    const struct skeleton *skeleton = sight->skeleton;
    const struct voxels *v = skeleton->voxels;
    struct intersection at;
    int place[3];
    rgb through;
    bool met = sight_wall(sight, ray, tmin, &at, &through);
    if (!met || !voxels_find(v, at.point, place)) {
        rgb beyond = patches_beyond(&sight->scene, ray->direction,
                                    met ? &at : NULL, key);
        return (struct sighting){ ZONE_SKY, HUGE_VAL,
                                  rgb_mul(through, beyond) };
    }
    struct sighting seen = { .zone = ZONE_NONE,
                             .distance =
                                 vec3_length(vec3_sub(at.point, ray->origin)) };
    vec3 face = vec3_against(at.face, ray->direction);
    struct skeleton_point point =
        skeleton_find(skeleton, at.point, face, ray->origin);
    if (point.node == GRAPH_NONE)
        return seen;
    uint32_t piece = sight->pieces->of_voxel[point.voxel];
    if (piece != PIECE_NONE)
        seen.zone = zone_of(piece, side_of(face));
    return seen;
}
