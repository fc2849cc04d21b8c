/* The balance: see enclosure.h. Its matrix is symmetric and diagonally
 * dominant with negative neighbours (an M-matrix): Gauss-Seidel converges, and
 * light is never negative. */
#include "skeleton/enclosure.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/memory.h"

enum { ROUNDS_MAX = 20000, EVEN_ROUNDS = 12 };

static const double tolerance = 1e-6;

/* Walls of more than this would never let go of their light. */
static const double albedo_max = 0.98;

struct enclosure *enclosure_new(struct arena *arena, size_t count)
{
    struct enclosure *enclosure = ARENA_NEW(arena, struct enclosure);
    enclosure->arena = arena;
    enclosure->count = count;
    enclosure->zones = ARENA_ARRAY(arena, struct zone, count);
    return enclosure;
}

static double albedo_limited(double albedo)
{
    return albedo > albedo_max ? albedo_max : albedo > 0 ? albedo : 0;
}

void enclosure_wall(struct enclosure *enclosure, uint32_t zone, double area,
                    rgb albedo, rgb direct, rgb emission)
{
    struct zone *z = &enclosure->zones[zone];
    albedo = rgb_make(albedo_limited(albedo.r), albedo_limited(albedo.g),
                      albedo_limited(albedo.b));
    z->area += area;
    z->reflecting = rgb_add_scaled(z->reflecting, albedo, area);
    z->source = rgb_add_scaled(z->source, rgb_mul(albedo, direct), area);
    z->glowing = rgb_add_scaled(z->glowing, emission, area);
}

void enclosure_shine(struct enclosure *enclosure, uint32_t zone, rgb shone,
                     rgb returned)
{
    struct zone *z = &enclosure->zones[zone];
    z->shone = rgb_add(z->shone, shone);
    z->source = rgb_add(z->source, returned);
}

void enclosure_open(struct enclosure *enclosure, uint32_t a, uint32_t b,
                    double area)
{
    struct opening opening = { a < b ? a : b, a < b ? b : a, area };
    *ARRAY_PUSH(enclosure->arena, &enclosure->openings) = opening;
}

void enclosure_sky(struct enclosure *enclosure, uint32_t zone, double area,
                   rgb radiance)
{
    struct zone *z = &enclosure->zones[zone];
    z->sky += area;
    z->sky_light = rgb_add_scaled(z->sky_light, radiance, area);
}

static int opening_compare(const void *a, const void *b)
{
    const struct opening *p = a, *q = b;
    if (p->a != q->a)
        return p->a < q->a ? -1 : 1;
    return p->b < q->b ? -1 : p->b > q->b;
}

static void enclosure_merge(struct enclosure *enclosure)
{
    struct opening *items = enclosure->openings.items;
    size_t left = 0;
    if (enclosure->openings.count == 0)
        return;
    qsort(items, enclosure->openings.count, sizeof *items, opening_compare);
    for (size_t i = 1; i < enclosure->openings.count; i++)
        if (opening_compare(&items[left], &items[i]) == 0)
            items[left].area += items[i].area;
        else
            items[++left] = items[i];
    enclosure->openings.count = left + 1;
}

/* What each zone sees, each opening scaled by the factors of both its ends. */
static void seen_add(const struct enclosure *enclosure, const double *factor,
                     double *seen)
{
    for (size_t i = 0; i < enclosure->count; i++)
        seen[i] = enclosure->zones[i].sky * factor[i];
    for (size_t i = 0; i < enclosure->openings.count; i++) {
        const struct opening *o = &enclosure->openings.items[i];
        double area = o->area * factor[o->a] * factor[o->b];
        seen[o->a] += area;
        if (o->a != o->b)
            seen[o->b] += area;
    }
}

void enclosure_even_out(struct enclosure *enclosure)
{
    size_t count = enclosure->count;
    double *factor = memory_new(count * sizeof *factor);
    double *seen = memory_new(count * sizeof *seen);
    enclosure_merge(enclosure);
    for (size_t i = 0; i < count; i++)
        factor[i] = 1;
    for (int round = 0; round < EVEN_ROUNDS; round++) {
        seen_add(enclosure, factor, seen);
        for (size_t i = 0; i < count; i++)
            if (seen[i] > 0)
                factor[i] *= sqrt(enclosure->zones[i].area / seen[i]);
    }
    for (size_t i = 0; i < enclosure->openings.count; i++) {
        struct opening *o = &enclosure->openings.items[i];
        o->area *= factor[o->a] * factor[o->b];
    }
    for (size_t i = 0; i < count; i++) {
        struct zone *z = &enclosure->zones[i];
        z->sky *= factor[i];
        z->sky_light = rgb_scale(z->sky_light, factor[i]);
    }
    memory_free(factor);
    memory_free(seen);
}

/* Openings between two zones seen from both sides, sorted by the zone that
 * looks. */
struct views {
    size_t *first; /* of each zone, and one more */
    struct {
        uint32_t to;
        double area;
    } * items;
};

static struct views views_new(const struct enclosure *enclosure)
{
    struct views views;
    size_t openings = enclosure->openings.count, count = enclosure->count;
    const struct opening *items = enclosure->openings.items;
    views.first = memory_new((count + 2) * sizeof *views.first);
    views.items = memory_new(2 * openings * sizeof *views.items);
    for (size_t i = 0; i < openings; i++) {
        if (items[i].a == items[i].b)
            continue;
        views.first[items[i].a + 2]++;
        views.first[items[i].b + 2]++;
    }
    for (size_t i = 2; i < count + 2; i++)
        views.first[i] += views.first[i - 1];
    for (size_t i = 0; i < openings; i++) {
        if (items[i].a == items[i].b)
            continue;
        size_t from_a = views.first[items[i].a + 1]++;
        size_t from_b = views.first[items[i].b + 1]++;
        views.items[from_a].to = items[i].b;
        views.items[from_b].to = items[i].a;
        views.items[from_a].area = views.items[from_b].area = items[i].area;
    }
    return views;
}

/* What is left of the area sees the zone itself; by chance others may see more
 * than there is. */
static void zone_begin(struct enclosure *enclosure, const struct views *views,
                       size_t i)
{
    struct zone *z = &enclosure->zones[i];
    double seen = z->sky;
    for (size_t k = views->first[i]; k < views->first[i + 1]; k++)
        seen += views->items[k].area;
    z->whole = fmax(z->area, seen);
    z->self = z->whole - seen;
    if (z->whole > 0)
        z->sent = rgb_scale(z->source, 1 / z->whole);
}

/* E (S - A_ii rho) = what comes in from others and at first from itself. */
static double balanced(const struct zone *zone, double incoming,
                       double reflecting)
{
    double out = zone->whole - zone->self * reflecting / zone->whole;
    return out > 0 ? incoming / out : 0;
}

static bool settled(double before, double after)
{
    return fabs(after - before) <= tolerance * fabs(after);
}

/* One zone in balance with the others; whether it was already. */
static bool zone_balance(struct enclosure *enclosure, const struct views *views,
                         size_t i)
{
    struct zone *z = &enclosure->zones[i];
    rgb before = z->light;
    if (!(z->whole > 0))
        return true;
    rgb in = rgb_add_scaled(z->sky_light, z->source, z->self / z->whole);
    for (size_t k = views->first[i]; k < views->first[i + 1]; k++)
        in = rgb_add_scaled(in, enclosure->zones[views->items[k].to].sent,
                            views->items[k].area);
    z->light = rgb_make(balanced(z, in.r, z->reflecting.r),
                        balanced(z, in.g, z->reflecting.g),
                        balanced(z, in.b, z->reflecting.b));
    rgb sent = rgb_add(rgb_mul(z->reflecting, z->light), z->source);
    z->sent = rgb_scale(sent, 1 / z->whole);
    return settled(before.r, z->light.r) && settled(before.g, z->light.g) &&
           settled(before.b, z->light.b);
}

/* With what comes straight from what glows, and goes there. */
static void zone_finish(struct zone *z)
{
    if (!(z->area > 0))
        return;
    z->light = rgb_add_scaled(z->light, z->shone, 1 / z->area);
    z->sent = rgb_add_scaled(z->sent, z->glowing, 1 / z->area);
}

int enclosure_solve(struct enclosure *enclosure)
{
    enclosure_merge(enclosure);
    struct views views = views_new(enclosure);
    bool done = false;
    int rounds = 0;
    for (size_t i = 0; i < enclosure->count; i++)
        zone_begin(enclosure, &views, i);
    while (!done && rounds < ROUNDS_MAX) {
        done = true;
        for (size_t i = 0; i < enclosure->count; i++)
            done &= zone_balance(enclosure, &views, i);
        rounds++;
    }
    for (size_t i = 0; i < enclosure->count; i++)
        zone_finish(&enclosure->zones[i]);
    memory_free(views.first);
    memory_free(views.items);
    return rounds;
}
