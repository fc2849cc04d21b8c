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

/* From what a ray meets first (at->leaf; NULL: nothing) on the first wall, or
 * what is none but can't be seen through, as a sky is that is a sphere without
 * shadow; what lets light pass leaves so much of it, no more than all. */
static bool sight_end(const struct sight *sight, const struct ray *ray,
                      struct intersection *at, bool *wall, rgb *through)
{
    bool met = at->leaf != NULL;
    *through = rgb_grey(1);
    for (int i = 0; met && i < CROSSINGS; i++) {
        *wall = wall_stops(sight->skeleton->marks, at);
        if (*wall)
            return true;
        rgb passes = albedo_bounded(surface_transmittance(at), 1);
        if (!(rgb_peak(passes) > 0))
            return true;
        *through = rgb_mul(*through, passes);
        met = world_closest(sight->skeleton->world, ray,
                            at->t + surface_offset(at->point), RAY_GATHER, at);
    }
    return false;
}

/* What each meets first. */
static void sight_meet(const struct sight *sight, struct rays *rays,
                       unsigned count, struct intersection at[RAY_LANES])
{
    struct rays_span span;
    struct world_hit hits[RAY_LANES];
    if (count == 0)
        return;
    for (int i = 0; i < RAY_LANES; i++) {
        span.near[i] = 0;
        span.far[i] = (double)INFINITY;
    }
    rays_fill(rays, &span, count);
    world_closest_many(sight->skeleton->world, rays, &span, count, RAY_GATHER,
                       hits);
    for (unsigned i = 0; i < count; i++) {
        const struct ray ray = rays_at(rays, (int)i);
        at[i].leaf = NULL;
        if (hits[i].leaf)
            world_describe(&ray, &hits[i], &at[i]);
    }
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

/* What a ray sees that first meets this (at->leaf; NULL: nothing). */
static struct sighting sight_from(const struct sight *sight,
                                  const struct ray *ray,
                                  struct intersection *at, uint64_t key)
{
    const struct skeleton *skeleton = sight->skeleton;
    const struct voxels *v = skeleton->voxels;
    int place[3];
    rgb through;
    bool wall = false, met = sight_end(sight, ray, at, &wall, &through);
    if (!wall || !voxels_find(v, at->point, place)) {
        rgb beyond =
            patches_beyond(&sight->scene, ray->direction, met ? at : NULL, key);
        struct sighting sky = { .zone = ZONE_SKY,
                                .distance = HUGE_VAL,
                                .beyond = rgb_mul(through, beyond),
                                .clear = 1 };
        if (met)
            sight_glows(sight, ray, at, through, &sky);
        sight_fog(sight, ray, met ? at->t : (double)INFINITY, &sky);
        return sky;
    }
    struct sighting seen = { .zone = ZONE_NONE,
                             .distance =
                                 vec3_length(vec3_sub(at->point, ray->origin)),
                             .clear = 1 };
    sight_glows(sight, ray, at, through, &seen);
    sight_fog(sight, ray, seen.distance, &seen);
    vec3 face = vec3_against(at->face, ray->direction);
    struct skeleton_point point =
        skeleton_find(skeleton, at->point, face, ray->origin);
    seen.narrow = !point.faces && sight_may_pick(sight);
    if (seen.narrow)
        seen.at = *at;
    if (point.node == GRAPH_NONE)
        return seen;
    uint32_t piece = sight->pieces->of_voxel[point.voxel];
    if (piece != PIECE_NONE)
        seen.zone = zone_of(piece, side_of(face));
    return seen;
}

struct sighting sight_zone(const struct sight *sight, const struct ray *ray,
                           double tmin, uint64_t key)
{
    struct intersection at;
    if (!world_closest(sight->skeleton->world, ray, tmin, RAY_GATHER, &at))
        at.leaf = NULL;
    return sight_from(sight, ray, &at, key);
}

void sight_zones(const struct sight *sight, struct rays *rays, unsigned count,
                 const uint64_t *keys, struct sighting *seen)
{
    struct intersection at[RAY_LANES];
    sight_meet(sight, rays, count, at);
    for (unsigned i = 0; i < count; i++) {
        const struct ray ray = rays_at(rays, (int)i);
        seen[i] = sight_from(sight, &ray, &at[i], keys[i]);
    }
}

bool sight_may_pick(const struct sight *sight)
{
    return sight->scene.emitters && emitters_any(sight->scene.emitters);
}

/* What arrives of a pick by a ray that first meets this. */
static rgb sight_picked(const struct sight *sight, const struct ray *ray,
                        const struct emitter_pick *pick,
                        struct intersection *at)
{
    struct sighting seen = { .clear = 1 };
    rgb through;
    bool wall;
    if (!sight_end(sight, ray, at, &wall, &through) ||
        !emitter_is_met(pick, at))
        return rgb_grey(0);
    sight_glows(sight, ray, at, through, &seen);
    sight_fog(sight, ray, at->t, &seen);
    return seen.glow;
}

void sight_picks(const struct sight *sight, struct sight_pick *picks,
                 unsigned count)
{
    struct emitter_pick pick[RAY_LANES];
    struct intersection at[RAY_LANES];
    struct sight_pick *by[RAY_LANES];
    struct rays rays;
    unsigned any = 0;
    for (unsigned i = 0; i < count; i++) {
        picks[i].glow = rgb_grey(0);
        if (!emitters_pick(sight->scene.emitters, picks[i].point,
                           picks[i].which, picks[i].where, &pick[any]))
            continue;
        rays_set(&rays, (int)any, picks[i].point, pick[any].direction);
        by[any++] = &picks[i];
    }
    sight_meet(sight, &rays, any, at);
    for (unsigned i = 0; i < any; i++) {
        const struct ray ray = rays_at(&rays, (int)i);
        by[i]->direction = ray.direction;
        by[i]->picked = pick[i].density;
        by[i]->glow = sight_picked(sight, &ray, &pick[i], &at[i]);
    }
}
