/* Shadow rays with coloured filters: see shadow.h. Measured on POV-Ray 3.7:
 * every surface on the way filters once, but none that is closer than 1e-3
 * behind the one before it (touching bodies count one face); a segment that
 * ends where the ray leaves a body fades by that body's interior; reflection
 * and Fresnel don't weaken the light, but `caustics` brighten it where it meets
 * the surface steeply. */
#include "shade/shadow.h"

#include "scene/photon.h"
#include "shade/background.h"
#include "shade/free_path.h"
#include "shade/interior.h"
#include "shade/media_dims.h"
#include "shade/surface.h"

enum {
    CROSSINGS_MAX = 128, /* more than these only filter */
    CROSSINGS_LANE = 8,  /* of one of several ways; with more it goes alone */
};

struct shadow_crossing {
    double t;
    const struct leaf *leaf;
    rgb through;
};

struct shadow_ray {
    rgb share;                          /* of those that found no place */
    const struct photon_flags *photons; /* as in the path, and: */
    bool smooth;
    int count;
    struct shadow_crossing *at; /* in order of t, with room for: */
    int room;
};

static bool crossing_before(const struct shadow_crossing *a,
                            const struct shadow_crossing *b)
{
    return a->t < b->t || (a->t == b->t && a->leaf->number < b->leaf->number);
}

static void shadow_begin(struct shadow_ray *shadow,
                         const struct photon_flags *photons, bool smooth)
{
    shadow->photons = photons;
    shadow->smooth = smooth;
    shadow->share = rgb_grey(1);
    shadow->count = 0;
}

/* What light gets from `caustics` c at a surface, bumps and all: 1 + |cos|^(45
 * c) times. */
static double pane_caustics(const struct intersection *at, vec3 direction,
                            bool smooth)
{
    const struct interior *interior = at->leaf->look->interior;
    if (!interior || interior->caustics == 0)
        return 1;
    vec3 normal = smooth ? at->normal : surface_bumps(at, direction);
    double cosine = fabs(vec3_dot(normal, direction));
    return 1 + pow(cosine, 45 * interior->caustics);
}

/* What a surface lets pass of the light along the ray. Of most only the place
 * matters. */
static rgb pane_through(const struct ray *ray, const struct world_hit *hit,
                        bool smooth)
{
    const struct leaf *leaf = hit->leaf;
    const struct interior *interior = leaf->look->interior;
    struct intersection at;
    bool gathered = interior && interior->caustics != 0;
    if (leaf->look->tinted && !gathered)
        return leaf->look->tint;
    if (leaf->look->spatial && !leaf->look->coated && !gathered)
        return texture_transmittance(
            leaf->look->texture,
            affine_point(leaf->look->to_texture, ray_point(ray, hit->hit.t)),
            NULL);
    world_describe(ray, hit, &at);
    return rgb_scale(surface_passes(&at, ray->direction),
                     pane_caustics(&at, ray->direction, smooth));
}

/* Whether this light goes through it, or round it, as photons. */
static bool shadow_is_bent(const struct photon_flags *photons,
                           const struct leaf *leaf)
{
    return photons && leaf->look->target &&
           photon_happens(photons->refraction, leaf->look->photons->refraction);
}

static bool shadow_filter(void *context, const struct ray *ray,
                          const struct world_hit *hit)
{
    struct shadow_ray *shadow = context;
    if (shadow_is_bent(shadow->photons, hit->leaf))
        return true;
    struct shadow_crossing crossing = {
        hit->hit.t, hit->leaf, pane_through(ray, hit, shadow->smooth)
    };
    if (rgb_peak(crossing.through) == 0)
        return true;
    if (shadow->count == shadow->room) {
        shadow->share = rgb_mul(shadow->share, crossing.through);
        return rgb_peak(shadow->share) < 1e-9;
    }
    int i = shadow->count++;
    for (; i > 0 && crossing_before(&crossing, &shadow->at[i - 1]); i--)
        shadow->at[i] = shadow->at[i - 1];
    shadow->at[i] = crossing;
    return false;
}

/* What media on a stretch of the way let pass. */
static rgb shadow_media(const struct shadow_path *path,
                        const struct interiors *inside, double from,
                        double distance, struct worker *worker)
{
    struct media_list media;
    media_find(&media, path->fog ? &path->fog->media : NULL, inside);
    if (media.count == 0)
        return rgb_grey(1);
    struct media_way way = { .media = &media,
                             .origin =
                                 vec3_along(path->point, path->direction, from),
                             .direction = path->direction,
                             .length = distance,
                             .worker = worker,
                             .inside = inside };
    if (path->dims && media_dims_add(path->dims, &way, path->number))
        return rgb_grey(1);
    return path->key ? free_path_through(&way, path->key)
                     : media_veil(&way).through;
}

/* What fog on it lets pass. */
static rgb shadow_fog(const struct shadow_path *path, double from,
                      double distance)
{
    struct ray ray = { vec3_along(path->point, path->direction, from),
                       path->direction };
    return fog_veil(path->fog, &ray, distance).through;
}

/* What both let pass. */
static rgb shadow_air(const struct shadow_path *path,
                      const struct interiors *inside, double from,
                      double distance, struct worker *worker)
{
    rgb through = rgb_grey(1);
    if ((!path->fog && !path->misty) || !interiors_open(inside))
        return through;
    if (path->fog)
        through = shadow_fog(path, from, distance);
    if (path->misty)
        through = rgb_mul(through,
                          shadow_media(path, inside, from, distance, worker));
    return through;
}

/* What all crossings let pass, from the point on. */
static rgb shadow_share(const struct shadow_ray *shadow,
                        const struct shadow_path *path, struct worker *worker)
{
    struct interiors inside;
    rgb share = shadow->share;
    double from = 0;
    if (shadow->count == 0 && !path->fog && !path->misty)
        return share;
    interiors_clear(&inside);
    if (path->inside)
        interiors_copy(&inside, path->inside);
    for (int i = 0; i < shadow->count; i++) {
        const struct shadow_crossing *crossing = &shadow->at[i];
        const struct leaf *leaf = crossing->leaf;
        double distance = crossing->t - from;
        if (distance < SHADOW_MARGIN)
            continue;
        share = rgb_mul(share, crossing->through);
        share =
            rgb_mul(share, shadow_air(path, &inside, from, distance, worker));
        if (interior_dims_shadows(leaf->look->interior) &&
            interiors_find(&inside, leaf->body) >= 0)
            share =
                rgb_mul(share, interior_fade(leaf->look->interior, distance));
        interiors_cross(&inside, leaf);
        from = crossing->t;
    }
    double rest = path->distance - from;
    if (!interiors_open(&inside))
        return share;
    /* Media that the lamp itself is in, too, don't count (measured). */
    interiors_clear(&inside);
    return rgb_mul(share, shadow_air(path, &inside, from, rest, worker));
}

static bool shadow_blocked(const struct world *world,
                           const struct shadow_path *path, double from,
                           double to, struct shadow_ray *shadow)
{
    const struct ray ray = { path->point, path->direction };
    const struct occlusion asked = { .ray = &ray,
                                     .tmin = from,
                                     .tmax = to,
                                     .light = path->light,
                                     .filter = shadow_filter,
                                     .context = shadow,
                                     .spread = path->spread };
    return path->shaft
               ? world_occluded_in(world, path->shaft, path->place, &asked)
               : world_occluded(world, &asked);
}

/* Through what may weaken the light. */
static rgb shadow_filtered(const struct world *world, struct worker *worker,
                           const struct shadow_path *path, double from,
                           double to)
{
    struct shadow_crossing crossings[CROSSINGS_MAX];
    struct shadow_ray shadow;
    shadow_begin(&shadow, path->photons, path->smooth);
    shadow.at = crossings;
    shadow.room = CROSSINGS_MAX;
    if (shadow_blocked(world, path, from, to, &shadow))
        return rgb_grey(0);
    return shadow_share(&shadow, path, worker);
}

/* Light that is projected through something comes from there: nothing beyond
 * it casts a shadow, and what misses it is dark (measured). */
static bool shadow_begins(const struct world *world,
                          const struct shadow_path *path, double from,
                          double *to)
{
    struct ray ray = { path->point, path->direction };
    double pane = world_pane(world, path->light, &ray, from, *to);
    if (pane < *to)
        *to = pane - SHADOW_MARGIN;
    return pane >= 0;
}

bool shadow_falls(const struct world *world, struct worker *worker, vec3 point,
                  vec3 direction, double distance, int light)
{
    const struct ray ray = { point, direction };
    const struct occlusion way = { .ray = &ray,
                                   .tmin = shadow_start(point, distance),
                                   .tmax = shadow_end(distance),
                                   .light = light };
    if (!(way.tmax > way.tmin))
        return false;
    worker->counters.shadow_rays++;
    return world_occluded(world, &way);
}

/* Whether there is room for anything on them. */
CLONES static void ways_have_room(const struct rays_span *restrict span,
                                  lane_flag *restrict room)
{
    for (int i = 0; i < RAY_LANES; i++)
        room[i] = span->far[i] > span->near[i] ? -1 : 0;
}

/* Several ways and the panes on them. */
struct shadow_rays {
    const struct occlusions *ways;
    const struct shadow_around *around;
    unsigned begun; /* that have met any, */
    unsigned full;  /* and more than there is room for */
    struct shadow_ray at[RAY_LANES];
    struct shadow_crossing crossings[RAY_LANES][CROSSINGS_LANE];
};

static const struct photon_flags *
around_photons(const struct shadow_around *around, unsigned lane)
{
    return around->straight >> lane & 1 ? NULL : around->photons;
}

static bool shadow_filter_lane(void *context, unsigned lane,
                               const struct world_hit *hit)
{
    struct shadow_rays *shadows = context;
    struct shadow_ray *shadow = &shadows->at[lane];
    const struct ray ray = rays_at(&shadows->ways->rays, (int)lane);
    if (!(shadows->begun >> lane & 1))
        shadow_begin(shadow, around_photons(shadows->around, lane),
                     shadows->around->smooth);
    shadows->begun |= 1u << lane;
    shadow->at = shadows->crossings[lane];
    shadow->room = CROSSINGS_LANE;
    shadows->full |= (unsigned)(shadow->count == CROSSINGS_LANE) << lane;
    return shadows->full >> lane & 1 || shadow_filter(shadow, &ray, hit);
}

/* Of those of `lanes`, to which surfaces let some light pass, the share. */
static void shadows_shares(const struct shadow_rays *rays,
                           struct worker *worker,
                           const struct shadow_around *around, unsigned lanes,
                           struct shadows *shadows)
{
    struct media_dims dims; /* no more of it than is needed */
    if (around->misty)
        media_dims_begin(&dims, worker, RAY_LANES);
    for (unsigned each = lanes; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        const struct rays *ways = &rays->ways->rays;
        const struct shadow_path path = {
            .point = rays_origin(ways, (int)i),
            .direction = rays_direction(ways, (int)i),
            .distance = shadow_distance(rays->ways->span.far[i]),
            .inside = around->inside[i],
            .fog = around->fog,
            .misty = around->misty,
            .dims = around->misty ? &dims : NULL,
            .number = (int)i,
        };
        shadows->share[i] = shadow_share(&rays->at[i], &path, worker);
    }
    if (around->misty)
        media_dims_look(&dims);
    for (; lanes && around->misty; lanes &= lanes - 1) {
        int i = __builtin_ctz(lanes);
        shadows->share[i] =
            rgb_mul(shadows->share[i], media_dims_through(&dims, i));
    }
}

/* Which are dark, where something may let light pass. */
static void shadows_filtered(const struct world *world, struct worker *worker,
                             struct occlusions *ways, unsigned lanes,
                             const struct shadow_around *around,
                             struct shadows *shadows)
{
    struct shadow_rays rays;
    rays.ways = ways;
    rays.around = around;
    rays.begun = rays.full = 0;
    ways->filter = shadow_filter_lane;
    ways->context = &rays;
    struct occluded found = world_occluded_many(world, ways, lanes);
    shadows->dark = found.dark & ~rays.full;
    shadows->left = found.panes | rays.full;
    shadows->tinted = rays.begun & ~found.dark;
    if (around->fog || around->misty)
        shadows->tinted = lanes & ~shadows->dark & ~shadows->left;
    for (unsigned each = shadows->tinted & ~rays.begun; each; each &= each - 1)
        shadow_begin(&rays.at[__builtin_ctz(each)], NULL, true);
    shadows_shares(&rays, worker, around, shadows->tinted, shadows);
}

static bool around_matters(const struct world *world,
                           const struct shadow_around *around)
{
    return around && (around->fog || around->misty || !world_is_opaque(world));
}

void shadow_falls_many(const struct world *world, struct worker *worker,
                       struct occlusions *ways, unsigned lanes,
                       const struct shadow_around *around,
                       struct shadows *shadows)
{
    LANE_LINES lane_flag room[RAY_LANES];
    ways_have_room(&ways->span, room);
    lanes &= rays_bits(room);
    shadows->dark = shadows->left = shadows->tinted = 0;
    if (!lanes)
        return;
    if (around_matters(world, around)) {
        shadows_filtered(world, worker, ways, lanes, around, shadows);
    } else {
        ways->filter = NULL;
        struct occluded found = world_occluded_many(world, ways, lanes);
        shadows->dark = found.dark;
        shadows->left = found.panes;
    }
    unsigned known = lanes & ~shadows->left;
    worker->counters.shadow_rays += (unsigned)__builtin_popcount(known);
}

rgb shadow_visibility(const struct world *world, struct worker *worker,
                      const struct shadow_path *path)
{
    double from = shadow_start(path->point, path->distance);
    double to = shadow_end(path->distance);
    if (!(to > from))
        return rgb_grey(1);
    if (!shadow_begins(world, path, from, &to))
        return rgb_grey(0);
    worker->counters.shadow_rays++;
    if (!world_is_opaque(world) || path->shaft || path->fog || path->misty)
        return shadow_filtered(world, worker, path, from, to);
    const struct ray ray = { path->point, path->direction };
    const struct occlusion asked = { .ray = &ray,
                                     .tmin = from,
                                     .tmax = to,
                                     .light = path->light,
                                     .spread = path->spread };
    bool blocked = world_occluded(world, &asked);
    return rgb_grey(blocked ? 0 : 1);
}
