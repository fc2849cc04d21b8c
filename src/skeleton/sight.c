/* Rays to zones: see sight.h. */
#include "skeleton/sight.h"

#include "shade/background.h"
#include "shade/emitters.h"
#include "shade/finish.h"
#include "shade/shadow.h"
#include "shade/surface.h"
#include "skeleton/matter.h"
#include "skeleton/wall.h"

enum { CROSSINGS = 16 }; /* of things that a ray passes through, at most */

/* The first wall that a ray meets, or what is none but can't be seen through,
 * as a sky is that is a sphere without shadow; what lets light pass leaves so
 * much of it, no more than all. */
static bool sight_end(const struct sight *sight, const struct ray *ray,
                      double tmin, struct intersection *at, bool *wall,
                      rgb *through)
{
    *through = rgb_grey(1);
    for (int i = 0; i < CROSSINGS; i++) {
        if (!world_closest(sight->skeleton->world, ray, tmin, RAY_GATHER, at))
            return false;
        *wall = wall_stops(sight->skeleton->marks, at);
        if (*wall)
            return true;
        rgb passes = albedo_bounded(surface_transmittance(at), 1);
        if (!(rgb_peak(passes) > 0))
            return true;
        *through = rgb_mul(*through, passes);
        tmin = at->t + surface_offset(at->point);
    }
    return false;
}

/* Whether it may glow. */
static bool sight_may_glow(const struct sight *sight,
                           const struct intersection *at)
{
    return (sight->skeleton->marks[at->leaf->number] & MATTER_EMITTER) ||
           at->texture != at->leaf->look->texture || at->leaf->look->no_shadow;
}

static void sight_glows(const struct sight *sight, const struct ray *ray,
                        const struct intersection *at, rgb through,
                        struct sighting *seen)
{
    const struct emitters *emitters = sight->scene.emitters;
    if (!emitters || !sight_may_glow(sight, at))
        return;
    seen->glow = rgb_mul(through, patches_glow(ray->direction, at));
    if (rgb_peak(seen->glow) > 0)
        seen->picked =
            emitters_density(emitters, ray->origin, ray->direction, at);
}

/* Fog on the way: it gives light as the sky does (light meshes: gather.c). */
static void sight_fog(const struct sight *sight, const struct ray *ray,
                      double distance, struct sighting *seen)
{
    const struct ambience *ambience = &sight->skeleton->ambience;
    if (ambience->scene->fogs.count == 0)
        return;
    struct veil veil = fog_veil(ambience->scene, ray, distance);
    rgb clear = veil.through;
    if (!ambience->sky)
        veil.light = rgb_mul(ambience_beyond(ambience, ray->direction),
                             rgb_sub(rgb_grey(1), clear));
    seen->clear = rgb_brightness(clear);
    seen->veil = veil.light;
    seen->glow = rgb_mul(clear, seen->glow);
    seen->beyond = rgb_add(rgb_mul(clear, seen->beyond), veil.light);
}

struct sighting sight_zone(const struct sight *sight, const struct ray *ray,
                           double tmin, uint64_t key)
{
    const struct skeleton *skeleton = sight->skeleton;
    const struct voxels *v = skeleton->voxels;
    struct intersection at;
    int place[3];
    rgb through;
    bool wall = false, met = sight_end(sight, ray, tmin, &at, &wall, &through);
    if (!wall || !voxels_find(v, at.point, place)) {
        rgb beyond = patches_beyond(&sight->scene, ray->direction,
                                    met ? &at : NULL, key);
        struct sighting sky = { .zone = ZONE_SKY,
                                .distance = HUGE_VAL,
                                .beyond = rgb_mul(through, beyond),
                                .clear = 1 };
        if (met)
            sight_glows(sight, ray, &at, through, &sky);
        sight_fog(sight, ray, met ? at.t : (double)INFINITY, &sky);
        return sky;
    }
    struct sighting seen = { .zone = ZONE_NONE,
                             .distance =
                                 vec3_length(vec3_sub(at.point, ray->origin)),
                             .clear = 1 };
    sight_glows(sight, ray, &at, through, &seen);
    sight_fog(sight, ray, seen.distance, &seen);
    vec3 face = vec3_against(at.face, ray->direction);
    struct skeleton_point point =
        skeleton_find(skeleton, at.point, face, ray->origin);
    seen.narrow = !point.faces && sight_picks(sight);
    if (seen.narrow)
        seen.at = at;
    if (point.node == GRAPH_NONE)
        return seen;
    uint32_t piece = sight->pieces->of_voxel[point.voxel];
    if (piece != PIECE_NONE)
        seen.zone = zone_of(piece, side_of(face));
    return seen;
}

bool sight_picks(const struct sight *sight)
{
    return sight->scene.emitters && emitters_any(sight->scene.emitters);
}

bool sight_pick(const struct sight *sight, vec3 point, double which,
                const double u[2], struct sight_glow *found)
{
    struct emitter_pick pick;
    struct intersection at;
    rgb through;
    bool wall;
    if (!sight_picks(sight) ||
        !emitters_pick(sight->scene.emitters, point, which, u, &pick))
        return false;
    const struct ray ray = { point, pick.direction };
    struct sighting seen = { .clear = 1 };
    if (!sight_end(sight, &ray, 0, &at, &wall, &through) ||
        !emitter_is_met(&pick, &at))
        return false;
    sight_glows(sight, &ray, &at, through, &seen);
    sight_fog(sight, &ray, at.t, &seen);
    *found = (struct sight_glow){ pick.direction, seen.glow, pick.density };
    return rgb_peak(seen.glow) > 0;
}
