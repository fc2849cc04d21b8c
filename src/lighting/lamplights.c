/* Lamps' light at several surfaces: see lamplights.h. */
#include "lighting/lamplights.h"

#include <string.h>

#include "lighting/lamplights_area.h"

/* The lamp at hand as all of them see it; the directions are those of the
 * ways. */
struct lamp_looks {
    LANE_LINES double distance[RAY_LANES], attenuation[RAY_LANES];
    unsigned lit; /* by it, if nothing is between */
};

void lamplights_start(struct lamplights *lights, struct facets *facets)
{
    struct occlusions *ways = &lights->ways;
    lights->facets = facets;
    lights->global = 0;
    ways->shaft = NULL;
    for (unsigned all = facets->all; all; all &= all - 1) {
        unsigned i = (unsigned)__builtin_ctz(all);
        lights->global |= (unsigned)!facets->leaf[i]->look->no_global_lights
                          << i;
    }
    memcpy(ways->rays.origin, facets->point, sizeof ways->rays.origin);
    memset(ways->rays.direction, 0, sizeof ways->rays.direction);
    memset(&ways->span, 0, sizeof ways->span);
}

/* What lamp_look finds of a lamp that stands at a place, and its ways; `faces`:
 * it is before the surface, as far as one layer tells, and not at it. */
CLONES static void look_many(const struct facets *restrict facets,
                             vec3 location, struct occlusions *ways,
                             double *restrict distances,
                             lane_flag *restrict faces)
{
    const double(*restrict points)[RAY_LANES] =
        (const double(*)[RAY_LANES])ways->rays.origin;
    double(*restrict directions)[RAY_LANES] = ways->rays.direction;
    double *restrict near = ways->span.near, *restrict far = ways->span.far;
    const struct facet_layer *restrict layer = &facets->layer[0];
    for (unsigned i = 0; i < RAY_LANES; i++) {
        vec3 point = lane_get(points, i);
        vec3 normal = lane_get(layer->normal, i);
        double cosine = vec3_dot(normal, vec3_sub(location, point));
        vec3 offset = vec3_sub(point, location);
        double distance = vec3_length(offset);
        vec3 direction = vec3_scale(offset, -1 / distance);
        lane_flag before = (cosine > 0 ? -1 : 0) | facets->twice[i];
        lane_flag behind = cosine < 0 ? -1 : 0;
        lane_put(directions, i, direction);
        distances[i] = distance;
        near[i] = shadow_start(point, distance);
        far[i] = shadow_end(distance);
        faces[i] = ((before & layer->front[i]) |
                    (~before & behind & layer->back[i]) | facets->many[i]) &
                   (distance > 0 ? -1 : 0);
    }
}

/* Whether the spot's cone has no light for them. */
CLONES static void beside_spot(const struct rays *restrict ways, vec3 axis,
                               double cosine_radius, double cosine_falloff,
                               lane_flag *restrict beside)
{
    for (int i = 0; i < RAY_LANES; i++) {
        double cosine = -vec3_dot(rays_direction(ways, i), axis);
        bool outside = (cosine < cosine_radius) & (cosine <= cosine_falloff);
        beside[i] = ((cosine <= 0) | outside) ? -1 : 0;
    }
}

/* One of them, as it asks by itself. */
static struct lamplight lamplights_at(const struct lamplights *lights,
                                      unsigned i)
{
    return (struct lamplight){ .lamps = lights->lamps,
                               .worker = lights->worker,
                               .surface = facets_surface(lights->facets, i),
                               .share = lights->share,
                               .knows = lights->knows };
}

static bool lamplights_face(const struct lamplights *lights,
                            const struct lamp *lamp, unsigned i)
{
    vec3 way = lamp_is_parallel(lamp)
                   ? vec3_negate(lamp->axis)
                   : vec3_sub(lamp->light->location,
                              lane_get(lights->facets->point, i));
    return facets_face(lights->facets, i, way);
}

/* Of those that face the lamp or may do so those that do. */
static unsigned lamplights_before(const struct lamplights *lights,
                                  const struct lamp *lamp, unsigned asked)
{
    unsigned faced = asked;
    for (; asked; asked &= asked - 1) {
        unsigned i = (unsigned)__builtin_ctz(asked);
        if (!lamplights_face(lights, lamp, i))
            faced &= ~(1u << i);
    }
    return faced;
}

/* Those that the lamp is for. */
static unsigned lamplights_for(const struct lamplights *lights,
                               const struct lamp *lamp)
{
    const struct facets *facets = lights->facets;
    unsigned lanes = facets->all;
    if (!lamp->light->group)
        return lights->global;
    for (unsigned each = lanes; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        if (!lamp_is_for(lamp, facets->leaf[i]))
            lanes &= ~(1u << i);
    }
    return lanes;
}

/* At one that shines differently from place to place. */
static void look_at_uneven(struct lamplights *lights, const struct lamp *lamp,
                           unsigned lanes, struct lamp_looks *looks)
{
    struct occlusions *ways = &lights->ways;
    vec3 location = lamp->light->location;
    looks->lit = 0;
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        vec3 point = rays_origin(&ways->rays, (int)i);
        struct lamp_view view;
        if (!lamp_look(lamp, location, point, &view))
            continue;
        rays_set(&ways->rays, (int)i, point, view.direction);
        ways->span.near[i] = shadow_start(point, view.distance);
        ways->span.far[i] = shadow_end(view.distance);
        looks->distance[i] = view.distance;
        looks->attenuation[i] = view.attenuation;
        looks->lit |= 1u << i;
    }
}

static void lamplights_look(struct lamplights *lights, const struct lamp *lamp,
                            struct lamp_looks *looks)
{
    unsigned lit = lamplights_for(lights, lamp);
    unsigned layered = lights->facets->layered;
    LANE_LINES lane_flag flags[RAY_LANES];
    for (int i = 0; i < RAY_LANES; i++)
        looks->attenuation[i] = 1;
    if (lamp_is_parallel(lamp)) {
        lit = lamplights_before(lights, lamp, lit);
        look_at_uneven(lights, lamp, lit, looks);
        return;
    }
    look_many(lights->facets, lamp->light->location, &lights->ways,
              looks->distance, flags);
    lit &= rays_bits(flags);
    lit = (lit & ~layered) | lamplights_before(lights, lamp, lit & layered);
    if (lamp->light->kind == LIGHT_SPOT) {
        beside_spot(&lights->ways.rays, lamp->axis, lamp->cosine_radius,
                    lamp->cosine_falloff, flags);
        lit &= ~rays_bits(flags);
    }
    looks->lit = lit;
    if (!lamp->even)
        look_at_uneven(lights, lamp, lit, looks);
}

CLONES static void colours_whole(rgb light, const double *restrict attenuation,
                                 double (*restrict colours)[RAY_LANES])
{
    for (int i = 0; i < RAY_LANES; i++) {
        rgb whole = rgb_scale(light, attenuation[i]);
        colours[0][i] = whole.r;
        colours[1][i] = whole.g;
        colours[2][i] = whole.b;
    }
}

/* Multiplies the light that is lit; where nothing is left it is no more. */
static void lamplights_tint(struct lamp_looks *looks, struct facets_lit *lit,
                            unsigned i, rgb share)
{
    if (!(rgb_peak(share) > 0))
        looks->lit &= ~(1u << i);
    lit->colour[0][i] *= share.r;
    lit->colour[1][i] *= share.g;
    lit->colour[2][i] *= share.b;
}

static struct lamp_target lamplights_target(const struct lamplights *lights,
                                            unsigned i,
                                            const struct lamp_looks *looks)
{
    const struct facets *facets = lights->facets;
    const struct leaf *leaf = facets->leaf[i];
    return (struct lamp_target){
        .point = lane_get(facets->point, i),
        .inside = facets->inside[i],
        .view = { rays_direction(&lights->ways.rays, (int)i),
                  looks->distance[i], looks->attenuation[i] },
        .leaf = leaf,
        .face = world_face_side(leaf, facets->faces, i),
    };
}

static rgb lamplights_share(const struct lamplights *lights,
                            const struct lamp *lamp, unsigned i,
                            const struct lamp_looks *looks)
{
    const struct lamp_target target = lamplights_target(lights, i, looks);
    if (lights->traced)
        return lights->traced(lights->lamps, lamp, lights->worker, &target);
    struct lamplight one = lamplights_at(lights, i);
    return lights->share(&one, lamp, &target.view);
}

/* The share of each of `lanes` by itself. Those that are dark are lit no more.
 */
static void lamplights_shares(const struct lamplights *lights,
                              const struct lamp *lamp, unsigned lanes,
                              struct lamp_looks *looks, struct facets_lit *lit)
{
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        lamplights_tint(looks, lit, i,
                        lamplights_share(lights, lamp, i, looks));
    }
}

/* Those of `lanes` where photons bring nothing. */
static unsigned lamplights_straight(const struct lamplights *lights,
                                    unsigned lanes)
{
    unsigned straight = 0;
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        const struct leaf *leaf = lights->facets->leaf[i];
        straight |= (unsigned)leaf->look->photons->unlit << i;
    }
    return straight;
}

/* The same of all of them together. Returns those that are left. */
static unsigned lamplights_fall(struct lamplights *lights,
                                const struct lamp *lamp, unsigned lanes,
                                struct lamp_looks *looks,
                                struct facets_lit *lit)
{
    const struct lamps *lamps = lights->lamps;
    struct shadow_around around =
        lamps_around(lamps, lamp, lights->facets->inside);
    bool through = lights->traced && lamps_together(lamps, lamp);
    struct shadows found;
    if (!through && !lamps_clear(lamps, lamp))
        return lanes;
    if (around.photons)
        around.straight = lamplights_straight(lights, lanes);
    shadow_falls_many(lamps->world, lights->worker, &lights->ways, lanes,
                      through ? &around : NULL, &found);
    looks->lit &= ~found.dark;
    for (unsigned each = found.tinted; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        lamplights_tint(looks, lit, i, found.share[i]);
    }
    return found.left;
}

/* Those of `lanes` that are on the leaf of the first. */
static unsigned lamplights_same(const struct lamplights *lights, unsigned lanes)
{
    const struct leaf *leaf = lights->facets->leaf[__builtin_ctz(lanes)];
    unsigned same = 0;
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        same |= (unsigned)(lights->facets->leaf[i] == leaf) << i;
    }
    return same;
}

/* The one in their middle and what is around it, as far as they are. */
static struct lamp_piece lamplights_piece(const struct lamplights *lights,
                                          unsigned lanes,
                                          const struct lamp_looks *looks)
{
    const struct facets *facets = lights->facets;
    vec3 sum = vec3_make(0, 0, 0);
    double count = __builtin_popcount(lanes), nearest = HUGE_VAL;
    unsigned middle = 0;
    struct lamp_piece piece = { .radius = 0 };
    for (unsigned each = lanes; each; each &= each - 1)
        sum = vec3_add(sum,
                       lane_get(facets->point, (unsigned)__builtin_ctz(each)));
    for (unsigned each = lanes; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        vec3 off =
            vec3_sub(lane_get(facets->point, i), vec3_scale(sum, 1 / count));
        middle = vec3_dot(off, off) < nearest ? i : middle;
        nearest = fmin(nearest, vec3_dot(off, off));
    }
    piece.middle = lamplights_target(lights, middle, looks);
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        vec3 face = world_face_side(piece.middle.leaf, facets->faces, i);
        vec3 off = vec3_sub(lane_get(facets->point, i), piece.middle.point);
        piece.radius = fmax(piece.radius, vec3_length(off));
        piece.bend =
            fmax(piece.bend, vec3_length(vec3_sub(face, piece.middle.face)));
    }
    return piece;
}

/* Of `lanes` those to which all light of a lamp with a size gets because
 * nothing is near its way to all of them that are on one leaf. */
static unsigned lamplights_open(const struct lamplights *lights,
                                const struct lamp *lamp, unsigned lanes,
                                const struct lamp_looks *looks)
{
    unsigned open = 0;
    while (lanes && lights->traced && lamps_soft(lights->lamps, lamp)) {
        unsigned same = lamplights_same(lights, lanes);
        struct lamp_piece piece = lamplights_piece(lights, same, looks);
        lanes &= ~same;
        if (lamps_open(lights->lamps, lamp, &piece))
            open |= same;
    }
    return open;
}

/* Most are wholly lit or wholly dark. */
static void lamplights_shadow(struct lamplights *lights,
                              const struct lamp *lamp, struct lamp_looks *looks,
                              struct facets_lit *lit)
{
    unsigned left = looks->lit;
    if (lights->foresee) {
        struct lamplights_known known = lights->foresee(lights, lamp, left);
        looks->lit &= ~known.dark;
        left &= ~known.dark & ~known.lit;
    }
    left &= ~lamplights_open(lights, lamp, left, looks);
    left = lamplights_fall(lights, lamp, left, looks, lit);
    lamplights_shares(lights, lamp, left, looks, lit);
}

/* Of one that lights from all over its area; shadows are asked one by one. */
static void lamplights_give_area(struct lamplights *lights,
                                 const struct lamp *lamp)
{
    rgb shares[RAY_LANES];
    unsigned lit = lamplights_for(lights, lamp);
    for (unsigned each = lit; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        struct lamplight one = lamplights_at(lights, i);
        struct lamp_view view;
        lamp_look(lamp, lamp->light->location, one.surface->point, &view);
        shares[i] = lights->share(&one, lamp, &view);
        if (rgb_peak(shares[i]) == 0)
            lit &= ~(1u << i);
    }
    lamplights_add_area(lights, lamp, lit, shares);
}

void lamplights_give(struct lamplights *lights, const struct lamp *lamp)
{
    const struct lamps *lamps = lights->lamps;
    struct lamp_looks looks;
    struct facets_lit lit;
    if (lamp->light->area_illumination && lamps_soft(lamps, lamp)) {
        lamplights_give_area(lights, lamp);
        return;
    }
    lamplights_look(lights, lamp, &looks);
    if (!looks.lit)
        return;
    lights->ways.light = lamp->number;
    lit.direction = (const double(*)[RAY_LANES])lights->ways.rays.direction;
    lit.highlights = !lamp->light->shadowless;
    colours_whole(lamp->light->colour, looks.attenuation, lit.colour);
    lamplights_shadow(lights, lamp, &looks, &lit);
    facets_add(lights->facets, &lit, looks.lit);
}
