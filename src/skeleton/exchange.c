/* Exchange between zones: see exchange.h. All zones with walls send as many
 * rays, evenly over their area; a ray of zone i stands for S_i / N of it. */
#include "skeleton/exchange.h"

#include <math.h>
#include <stdlib.h>

#include "base/draw.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "base/warp.h"

enum {
    RAYS_LEAST = 16, /* of a zone */
    RAYS_MOST = 1024,
};

/* All zones send along the same directions: what moves in a scene gives zones
 * other numbers, and the light of all walls must not change by chance with it.
 */
static const uint64_t exchange_key = 0x65786368;

/* A zone with walls. */
struct sender {
    uint32_t zone;
    size_t first, end; /* its patches, in their order */
    double area;
    size_t sky_hits;
    rgb sky; /* sum over these */
};

struct exchange {
    const struct sight *sight;
    const struct patches *patches;
    struct sender *senders;
    size_t count;
    size_t rays;     /* of each sender */
    uint32_t *order; /* patches sorted by zone */
    uint32_t *met;   /* zones that the rays of each sender met, sorted */
};

static uint32_t patch_zone(const struct exchange *exchange,
                           const struct wall_patch *patch)
{
    uint32_t piece = exchange->sight->pieces->of_voxel[patch->voxel];
    return piece == PIECE_NONE ? ZONE_NONE
                               : zone_of(piece, side_of(patch->normal));
}

/* Sorts the patches by their zones, by counting. */
static void exchange_sort(struct exchange *exchange, size_t zones)
{
    const struct patches *patches = exchange->patches;
    size_t *next = memory_new((zones + 1) * sizeof *next);
    exchange->order = memory_new(patches->count * sizeof *exchange->order);
    for (size_t i = 0; i < patches->count; i++) {
        uint32_t zone = patch_zone(exchange, &patches->items[i]);
        if (zone != ZONE_NONE)
            next[zone + 1]++;
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
    for (size_t i = 0; i < patches->count; i++) {
        uint32_t zone = patch_zone(exchange, &patches->items[i]);
        if (zone != ZONE_NONE)
            exchange->order[next[zone]++] = (uint32_t)i;
    }
    memory_free(next);
}

static const struct wall_patch *patch_at(const struct exchange *exchange,
                                         size_t place)
{
    return &exchange->patches->items[exchange->order[place]];
}

static void sender_shoot(const struct exchange *exchange, struct sender *sender,
                         const struct wall_patch *patch, size_t ray_number,
                         uint32_t *met)
{
    uint64_t key = exchange->sight->scene.seed ^ exchange_key;
    struct draws draws = { key, (uint32_t)ray_number };
    double u[2];
    draw_pair(&draws, 0, u);
    struct ray ray = { patch->point, warp_lobe(u, patch->normal, 1) };
    struct sighting seen =
        sight_zone(exchange->sight, &ray, random_key(key, ray_number));
    *met = seen.zone;
    if (seen.zone != ZONE_SKY)
        return;
    sender->sky = rgb_add(sender->sky, seen.beyond);
    sender->sky_hits++;
}

static int zone_compare(const void *a, const void *b)
{
    const uint32_t *p = a, *q = b;
    return *p < *q ? -1 : *p > *q;
}

/* All rays of a zone, at equal steps of area. */
static void sender_look(void *context, size_t number, unsigned thread)
{
    const struct exchange *exchange = context;
    struct sender *sender = &exchange->senders[number];
    uint32_t *met = exchange->met + number * exchange->rays;
    size_t count = exchange->rays, done = 0;
    double before = 0;
    (void)thread;
    for (size_t i = sender->first; i < sender->end; i++)
        sender->area += (double)patch_at(exchange, i)->area;
    double step = sender->area / (double)count;
    for (size_t i = sender->first; i < sender->end; i++) {
        const struct wall_patch *patch = patch_at(exchange, i);
        before += (double)patch->area;
        for (; done < count && ((double)done + 0.5) * step < before; done++)
            sender_shoot(exchange, sender, patch, done, &met[done]);
    }
    for (; done < count; done++)
        met[done] = ZONE_NONE;
    qsort(met, count, sizeof *met, zone_compare);
}

static void exchange_walls(const struct exchange *exchange,
                           const struct sender *sender,
                           struct enclosure *enclosure)
{
    double hits = (double)sender->sky_hits;
    for (size_t k = sender->first; k < sender->end; k++) {
        const struct wall_patch *patch = patch_at(exchange, k);
        enclosure_wall(enclosure, sender->zone, (double)patch->area,
                       patch_rgb(patch->albedo), patch_rgb(patch->direct),
                       patch_rgb(patch->emission));
    }
    if (sender->sky_hits > 0)
        enclosure_sky(enclosure, sender->zone,
                      sender->area * hits / (double)exchange->rays,
                      rgb_scale(sender->sky, 1 / hits));
}

/* What i sees of j is what j sees of i: rays from both sides together stand for
 * hits / (N / S_i + N / S_j), which counts the surer side for more. A zone that
 * no patch is of has no area, and nothing to give. */
static void exchange_openings(const struct exchange *exchange, size_t number,
                              struct enclosure *enclosure)
{
    const struct sender *sender = &exchange->senders[number];
    const uint32_t *met = exchange->met + number * exchange->rays;
    double rays = (double)exchange->rays;
    for (size_t k = 0, hits; k < exchange->rays; k += hits) {
        double other = met[k] < ZONE_SKY ? enclosure->zones[met[k]].area : 0;
        for (hits = 1; k + hits < exchange->rays && met[k + hits] == met[k];)
            hits++;
        if (met[k] == ZONE_NONE || met[k] == sender->zone)
            enclosure_open(enclosure, sender->zone, sender->zone,
                           (double)hits * sender->area / rays);
        else if (other > 0)
            enclosure_open(enclosure, sender->zone, met[k],
                           (double)hits / (rays / sender->area + rays / other));
    }
}

/* How many rays each zone sends, of so many in all, about: the nearest power of
 * two. What moves in a scene makes a zone more or less, and by one ray more or
 * less the light of all walls would change by chance [flicker]. */
static size_t rays_each(size_t all, size_t zones)
{
    double wanted = (double)all / (double)(zones + 1);
    double rays = exp2(round(log2(wanted)));
    return (size_t)fmin(fmax(rays, RAYS_LEAST), RAYS_MOST);
}

void exchange_measure(const struct sight *sight, const struct patches *patches,
                      struct enclosure *enclosure)
{
    struct exchange exchange = { .sight = sight, .patches = patches };
    exchange_sort(&exchange, enclosure->count);
    exchange.rays = rays_each(sight->skeleton->rays, exchange.count);
    exchange.met =
        memory_new(exchange.count * exchange.rays * sizeof *exchange.met);
    parallel_run(sight->scene.threads, exchange.count, sight->scene.stop,
                 sender_look, &exchange);
    for (size_t i = 0; i < exchange.count; i++)
        exchange_walls(&exchange, &exchange.senders[i], enclosure);
    for (size_t i = 0; i < exchange.count; i++)
        exchange_openings(&exchange, i, enclosure);
    enclosure_even_out(enclosure);
    memory_free(exchange.met);
    memory_free(exchange.order);
    memory_free(exchange.senders);
}
