/* Exchange between zones: see exchange.h. Patches of wall send rays; one stands
 * for its part of the patch's area. Which ways a patch's rays go depends on
 * where it is alone: in the next picture of an animation what stands still
 * sends the same ones, and its light does not change by chance with what moves
 * [flicker]. Patches beside each other have rays beside each other of one
 * sequence, by a curve through their wall (Morton 1966), so that those of any
 * part of a wall are spread evenly as well. */
#include "skeleton/exchange.h"

#include <math.h>
#include <stdlib.h>

#include "base/draw.h"
#include "base/memory.h"
#include "base/morton.h"
#include "base/parallel.h"
#include "base/warp.h"
#include "shade/emitters.h"
#include "shade/shadow.h"

enum {
    RAYS_LEAST = 64, /* of a zone [pillars] */
    PATCH_MOST = 64, /* of a patch, where there are few */
    NARROW_MOST = 8, /* walls of gaps that one goes on from */
};

/* From there with no less of its light. */
static const double narrow_least = 0.05;

/* What is drawn of a ray. */
enum { DRAW_WAY, DRAW_WHICH, DRAW_WHERE, DRAW_ON };

/* What a ray met, and how much of its zone's area it stands for. */
struct meeting {
    uint32_t zone;
    double area;
};

/* A zone with walls. */
struct sender {
    uint32_t zone;
    size_t first, end; /* its patches, in their order */
    double area;
    uint32_t each;       /* rays of a patch, a power of two, ... */
    bool all;            /* ... of all patches: there are few */
    struct meeting *met; /* by its rays, sorted by zones */
    size_t rays;
    double sky_area;     /* that the sky is met by */
    rgb sky;             /* sum of area * radiance over it */
    rgb shone, returned; /* as of enclosure_shine */
};

struct exchange {
    const struct sight *sight;
    const struct patches *patches;
    struct sender *senders;
    size_t count;
    uint32_t each, every; /* rays of a patch, and of one in so many patches;
                           * powers of two */
    uint32_t *order;      /* patches sorted by zone */
    uint32_t *sender;     /* of each zone; ZONE_NONE: it has no walls */
};

static uint32_t patch_zone(const struct exchange *exchange,
                           const struct wall_patch *patch)
{
    uint32_t piece = exchange->sight->pieces->of_voxel[patch->voxel];
    if (sight_may_pick(exchange->sight) &&
        !skeleton_faces(exchange->sight->skeleton, patch->point, patch->normal))
        return ZONE_NONE;
    return piece == PIECE_NONE ? ZONE_NONE
                               : zone_of(piece, side_of(patch->normal));
}

/* Sorts the patches by their zones, by counting. */
static void exchange_sort(struct exchange *exchange, size_t zones)
{
    const struct patches *patches = exchange->patches;
    size_t *next = memory_new((zones + 1) * sizeof *next);
    uint32_t *zone = memory_new(patches->count * sizeof *zone);
    exchange->order = memory_new(patches->count * sizeof *exchange->order);
    for (size_t i = 0; i < patches->count; i++) {
        zone[i] = patch_zone(exchange, &patches->items[i]);
        if (zone[i] != ZONE_NONE)
            next[zone[i] + 1]++;
    }
    for (size_t i = 0; i < zones; i++)
        exchange->count += next[i + 1] > 0;
    exchange->senders = memory_new(exchange->count * sizeof *exchange->senders);
    for (size_t i = 0, k = 0; i < zones; i++) {
        size_t own = next[i + 1];
        next[i + 1] += next[i];
        if (own > 0)
            exchange->senders[k++] = (struct sender){ .zone = (uint32_t)i,
                                                      .first = next[i],
                                                      .end = next[i + 1] };
    }
    for (size_t i = 0; i < patches->count; i++)
        if (zone[i] != ZONE_NONE)
            exchange->order[next[zone[i]]++] = (uint32_t)i;
    memory_free(zone);
    memory_free(next);
}

static const struct wall_patch *patch_at(const struct exchange *exchange,
                                         size_t place)
{
    return &exchange->patches->items[exchange->order[place]];
}

/* Where a patch is on its wall, along the curve, and which wall that is. */
static struct draws patch_draws(const struct exchange *exchange,
                                const struct wall_patch *patch)
{
    int at[3], side = side_of(patch->normal), axis = side / 2;
    voxels_place(exchange->sight->skeleton->voxels, patch->voxel, at);
    uint64_t wall = (uint64_t)(at[axis] * SIDES + side);
    uint32_t u = (uint32_t)at[(axis + 1) % 3], v = (uint32_t)at[(axis + 2) % 3];
    return (struct draws){ random_key(exchange->sight->scene.seed, wall),
                           morton_place(u, v) };
}

/* A ray of a patch, and where it goes on from walls that no void is before:
 * what these send is nowhere else. What glows is found by such rays and by as
 * many that pick it: each counts by how likely it is. */
struct shot {
    const struct wall_patch *patch;
    struct draws draws;
    double area; /* that it stands for */
    rgb share;   /* what the patch gets of what comes along the ray */
    struct ray ray;
    vec3 normal; /* of what it comes from */
    int walls;   /* that it has gone on from */
};

/* Shots of a sender that are on their way together. */
struct volley {
    const struct exchange *exchange;
    struct sender *sender;
    struct shot shots[RAY_LANES];
    unsigned count;
};

/* So much light comes along it straight from what glows, or from walls that no
 * void is before. */
static void shot_shine(const struct shot *shot, struct sender *sender,
                       rgb light)
{
    rgb shone = rgb_scale(rgb_mul(shot->share, light), shot->area);
    sender->shone = rgb_add(sender->shone, shone);
    sender->returned = rgb_add(sender->returned,
                               rgb_mul(patch_rgb(shot->patch->albedo), shone));
}

/* The ray begins above the surface, not farther along: in a corner it would be
 * through the other wall. */
static void shot_aim(struct shot *shot, vec3 point, vec3 normal)
{
    double u[2];
    draw_pair(&shot->draws, DRAW_WAY, u);
    shot->normal = normal;
    shot->ray = (struct ray){ vec3_along(point, normal, surface_offset(point)),
                              warp_lobe(u, normal, 1) };
}

/* What glows lights the places where they begin, by one pick each. */
static void volley_pick(const struct volley *volley)
{
    struct sight_pick picks[RAY_LANES];
    if (!sight_may_pick(volley->exchange->sight))
        return;
    for (unsigned i = 0; i < volley->count; i++) {
        const struct shot *shot = &volley->shots[i];
        picks[i].point = shot->ray.origin;
        picks[i].which = draw_unit(&shot->draws, DRAW_WHICH);
        draw_pair(&shot->draws, DRAW_WHERE, picks[i].where);
    }
    sight_picks(volley->exchange->sight, picks, volley->count);
    for (unsigned i = 0; i < volley->count; i++) {
        const struct shot *shot = &volley->shots[i];
        if (!(rgb_peak(picks[i].glow) > 0))
            continue;
        double density = vec3_dot(picks[i].direction, shot->normal) / WARP_PI;
        shot_shine(shot, volley->sender,
                   rgb_scale(picks[i].glow,
                             emitters_balance(density, picks[i].picked)));
    }
}

/* What they meet. */
static void volley_look(const struct volley *volley,
                        struct sighting seen[RAY_LANES])
{
    struct rays rays;
    uint64_t keys[RAY_LANES];
    for (unsigned i = 0; i < volley->count; i++) {
        const struct shot *shot = &volley->shots[i];
        rays_set(&rays, (int)i, shot->ray.origin, shot->ray.direction);
        keys[i] = random_key(shot->draws.key, shot->draws.index);
    }
    sight_zones(volley->exchange->sight, &rays, volley->count, keys, seen);
}

/* What glows where the ray ends counts. */
static void shot_glow(const struct shot *shot, struct sender *sender,
                      struct sighting *seen)
{
    double density = vec3_dot(shot->ray.direction, shot->normal) / WARP_PI,
           once = emitters_balance(density, seen->picked);
    if (seen->zone == ZONE_SKY)
        seen->beyond = rgb_add_scaled(seen->beyond, seen->glow, once - 1);
    else
        shot_shine(shot, sender, rgb_scale(seen->glow, once));
}

/* From a wall that no void is before. */
static void shot_go_on(struct shot *shot, const struct volley *volley,
                       const struct sighting *seen)
{
    const struct patches_scene *scene = &volley->exchange->sight->scene;
    const vec3 way = shot->ray.direction;
    rgb albedo;
    rgb lit =
        patches_lit(scene, way, &seen->at,
                    random_key(shot->draws.key, shot->draws.index), &albedo);
    shot->share = rgb_scale(rgb_mul(shot->share, albedo), seen->clear);
    shot->draws = draws_within(&shot->draws, DRAW_ON);
    shot->walls++;
    shot_aim(shot, seen->at.point, vec3_against(seen->at.face, way));
    shot_shine(shot, volley->sender, lit);
}

/* What is lost on the way is as if it went to a black sky. */
static void shot_end(const struct shot *shot, struct sender *sender,
                     const struct sighting *seen)
{
    bool sky = seen->zone == ZONE_SKY;
    double left =
        sky ? 0 : shot->area * seen->clear * rgb_brightness(shot->share);
    sender->met[sender->rays++] =
        (struct meeting){ seen->zone, sky ? shot->area : left };
    sender->sky_area += shot->area - left;
    sender->sky = rgb_add_scaled(
        sender->sky, rgb_mul(shot->share, sky ? seen->beyond : seen->veil),
        shot->area);
}

/* All the way. */
static void volley_fly(struct volley *volley)
{
    struct sighting seen[RAY_LANES];
    while (volley->count > 0) {
        unsigned on = 0;
        volley_pick(volley);
        volley_look(volley, seen);
        for (unsigned i = 0; i < volley->count; i++) {
            struct shot *shot = &volley->shots[i];
            shot_glow(shot, volley->sender, &seen[i]);
            if (seen[i].narrow && shot->walls < NARROW_MOST &&
                rgb_peak(shot->share) > narrow_least) {
                shot_go_on(shot, volley, &seen[i]);
                volley->shots[on++] = *shot;
            } else {
                shot_end(shot, volley->sender, &seen[i]);
            }
        }
        volley->count = on;
    }
}

static void volley_add(struct volley *volley, const struct wall_patch *patch,
                       const struct draws *draws)
{
    struct shot *shot = &volley->shots[volley->count++];
    *shot = (struct shot){ .patch = patch,
                           .draws = *draws,
                           .area = (double)patch->area / volley->sender->each,
                           .share = rgb_grey(1) };
    shot_aim(shot, patch->point, patch->normal);
    if (volley->count == RAY_LANES)
        volley_fly(volley);
}

/* The rays of a patch; returns the area for which they stand. */
static double volley_send(struct volley *volley, const struct wall_patch *patch)
{
    const struct exchange *exchange = volley->exchange;
    const struct sender *sender = volley->sender;
    struct draws draws = patch_draws(exchange, patch);
    if (!sender->all) {
        if (draws.index % exchange->every > 0)
            return 0;
        draws.index /= exchange->every;
    }
    draws.index *= sender->each;
    for (uint32_t i = 0; i < sender->each; i++, draws.index++)
        volley_add(volley, patch, &draws);
    return (double)patch->area;
}

static int meeting_compare(const void *a, const void *b)
{
    const struct meeting *p = a, *q = b;
    return p->zone != q->zone ? (p->zone > q->zone) - (p->zone < q->zone)
                              : (p->area > q->area) - (p->area < q->area);
}

/* All rays of a zone: together they stand for its area. */
static void sender_look(void *context, size_t number, unsigned thread)
{
    const struct exchange *exchange = context;
    struct sender *sender = &exchange->senders[number];
    struct volley volley; /* of its shots no more is set than is read */
    double sent = 0;
    (void)thread;
    volley.exchange = exchange;
    volley.sender = sender;
    volley.count = 0;
    sender->met = memory_new((sender->end - sender->first) * sender->each *
                             sizeof *sender->met);
    for (size_t i = sender->first; i < sender->end; i++)
        sent += volley_send(&volley, patch_at(exchange, i));
    volley_fly(&volley);
    double scale = sent > 0 ? sender->area / sent : 0;
    for (size_t i = 0; i < sender->rays; i++)
        sender->met[i].area *= scale;
    sender->sky_area *= scale;
    sender->sky = rgb_scale(sender->sky, scale);
    sender->shone = rgb_scale(sender->shone, scale);
    sender->returned = rgb_scale(sender->returned, scale);
    qsort(sender->met, sender->rays, sizeof *sender->met, meeting_compare);
}

static void exchange_walls(const struct exchange *exchange,
                           const struct sender *sender,
                           struct enclosure *enclosure)
{
    for (size_t k = sender->first; k < sender->end; k++) {
        const struct wall_patch *patch = patch_at(exchange, k);
        enclosure_wall(enclosure, sender->zone, (double)patch->area,
                       patch_rgb(patch->albedo), patch_rgb(patch->direct),
                       patch_rgb(patch->emission));
    }
    enclosure_shine(enclosure, sender->zone, sender->shone, sender->returned);
    if (sender->sky_area > 0)
        enclosure_sky(enclosure, sender->zone, sender->sky_area,
                      rgb_scale(sender->sky, 1 / sender->sky_area));
}

/* What i sees of j is what j sees of i: each side counts as much as it has rays
 * for its area, the balance heuristic (Veach 1997, section 9.2) of both. A zone
 * that no patch is of has no area, and nothing to give. */
static double exchange_share(const struct exchange *exchange,
                             const struct sender *sender, uint32_t zone)
{
    if (zone == ZONE_NONE || zone == sender->zone)
        return 1;
    if (zone == ZONE_SKY || exchange->sender[zone] == ZONE_NONE)
        return 0;
    const struct sender *other = &exchange->senders[exchange->sender[zone]];
    double own = (double)sender->rays / sender->area;
    return own / (own + (double)other->rays / other->area);
}

static void exchange_openings(const struct exchange *exchange, size_t number,
                              struct enclosure *enclosure)
{
    const struct sender *sender = &exchange->senders[number];
    const struct meeting *met = sender->met;
    for (size_t k = 0, next; k < sender->rays; k = next) {
        double area = 0;
        for (next = k; next < sender->rays && met[next].zone == met[k].zone;)
            area += met[next++].area;
        double share = exchange_share(exchange, sender, met[k].zone);
        if (share > 0)
            enclosure_open(enclosure, sender->zone,
                           met[k].zone == ZONE_NONE ? sender->zone
                                                    : met[k].zone,
                           area * share);
    }
}

/* How many rays each patch sends, of about so many in all. Those of a small
 * zone send more. */
static void exchange_plan(struct exchange *exchange, size_t zones, size_t rays)
{
    double wanted = (double)rays / (double)(exchange->patches->count + 1);
    double each = exp2(round(log2(wanted)));
    exchange->each = (uint32_t)fmin(fmax(each, 1), PATCH_MOST);
    exchange->every = (uint32_t)fmax(1 / each, 1);
    exchange->sender = memory_new(zones * sizeof *exchange->sender);
    for (size_t i = 0; i < zones; i++)
        exchange->sender[i] = ZONE_NONE;
    for (size_t i = 0; i < exchange->count; i++) {
        struct sender *sender = &exchange->senders[i];
        size_t patches = sender->end - sender->first;
        sender->each = exchange->each;
        sender->all = patches * sender->each < RAYS_LEAST * exchange->every;
        while (sender->all && patches * sender->each < RAYS_LEAST)
            sender->each *= 2;
        for (size_t k = sender->first; k < sender->end; k++)
            sender->area += (double)patch_at(exchange, k)->area;
        exchange->sender[sender->zone] = (uint32_t)i;
    }
}

void exchange_measure(const struct sight *sight, const struct patches *patches,
                      struct enclosure *enclosure)
{
    struct exchange exchange = { .sight = sight, .patches = patches };
    exchange_sort(&exchange, enclosure->count);
    exchange_plan(&exchange, enclosure->count, sight->skeleton->rays);
    parallel_run(sight->scene.threads, exchange.count, sight->scene.stop,
                 sender_look, &exchange);
    for (size_t i = 0; i < exchange.count; i++)
        exchange_walls(&exchange, &exchange.senders[i], enclosure);
    for (size_t i = 0; i < exchange.count; i++)
        exchange_openings(&exchange, i, enclosure);
    enclosure_even_out(enclosure);
    for (size_t i = 0; i < exchange.count; i++)
        memory_free(exchange.senders[i].met);
    memory_free(exchange.senders);
    memory_free(exchange.sender);
    memory_free(exchange.order);
}
