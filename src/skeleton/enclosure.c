/* The balance: see enclosure.h. Its matrix is symmetric and diagonally
 * dominant with negative neighbours (an M-matrix): Gauss-Seidel converges, and
 * light is never negative. */
#include "skeleton/enclosure.h"

#include <math.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/memory.h"

enum { ROUNDS_MAX = 20000 };

static const double tolerance = 1e-6;

/* Walls of more than this would never let go of their light. */
static const double albedo_max = 0.98;

struct enclosure *enclosure_new(struct arena *arena, size_t count)
{
    struct enclosure *enclosure = ARENA_NEW(arena, struct enclosure);
    enclosure->arena = arena;
    enclosure->count = count;
    enclosure->chambers = ARENA_ARRAY(arena, struct chamber, count);
    return enclosure;
}

static double albedo_limited(double albedo)
{
    return albedo > albedo_max ? albedo_max : albedo > 0 ? albedo : 0;
}

void enclosure_wall(struct enclosure *enclosure, uint32_t chamber, double area,
                    rgb albedo, rgb direct, rgb emission)
{
    struct chamber *c = &enclosure->chambers[chamber];
    albedo = rgb_make(albedo_limited(albedo.r), albedo_limited(albedo.g),
                      albedo_limited(albedo.b));
    c->area += area;
    c->absorbing =
        rgb_add_scaled(c->absorbing, rgb_sub(rgb_grey(1), albedo), area);
    rgb sent = rgb_add(rgb_mul(albedo, direct), emission);
    c->source = rgb_add_scaled(c->source, sent, area);
}

void enclosure_open(struct enclosure *enclosure, uint32_t a, uint32_t b,
                    double area)
{
    struct opening opening = { a < b ? a : b, a < b ? b : a, area };
    *ARRAY_PUSH(enclosure->arena, &enclosure->openings) = opening;
}

void enclosure_sky(struct enclosure *enclosure, uint32_t chamber, double area,
                   rgb radiance)
{
    struct chamber *c = &enclosure->chambers[chamber];
    c->sky += area;
    c->sky_light = rgb_add_scaled(c->sky_light, radiance, area);
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

/* Openings seen from both sides, sorted by the chamber that looks. */
struct views {
    size_t *first; /* of each chamber, and one more */
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
        views.first[items[i].a + 2]++;
        views.first[items[i].b + 2]++;
    }
    for (size_t i = 2; i < count + 2; i++)
        views.first[i] += views.first[i - 1];
    for (size_t i = 0; i < openings; i++) {
        size_t from_a = views.first[items[i].a + 1]++;
        size_t from_b = views.first[items[i].b + 1]++;
        views.items[from_a].to = items[i].b;
        views.items[from_b].to = items[i].a;
        views.items[from_a].area = views.items[from_b].area = items[i].area;
    }
    return views;
}

static double balanced(double incoming, double outgoing)
{
    return outgoing > 0 ? incoming / outgoing : 0;
}

static bool settled(double before, double after)
{
    return fabs(after - before) <= tolerance * fabs(after);
}

/* One chamber in balance with its neighbours; whether it was already. */
static bool chamber_balance(struct enclosure *enclosure,
                            const struct views *views, size_t i)
{
    struct chamber *c = &enclosure->chambers[i];
    rgb in = rgb_add(c->source, c->sky_light), before = c->light;
    double open = c->sky;
    for (size_t k = views->first[i]; k < views->first[i + 1]; k++) {
        double area = views->items[k].area;
        rgb there = enclosure->chambers[views->items[k].to].light;
        in = rgb_add_scaled(in, there, area);
        open += area;
    }
    c->light = rgb_make(balanced(in.r, c->absorbing.r + open),
                        balanced(in.g, c->absorbing.g + open),
                        balanced(in.b, c->absorbing.b + open));
    return settled(before.r, c->light.r) && settled(before.g, c->light.g) &&
           settled(before.b, c->light.b);
}

int enclosure_solve(struct enclosure *enclosure)
{
    enclosure_merge(enclosure);
    struct views views = views_new(enclosure);
    bool done = false;
    int rounds = 0;
    while (!done && rounds < ROUNDS_MAX) {
        done = true;
        for (size_t i = 0; i < enclosure->count; i++)
            done &= chamber_balance(enclosure, &views, i);
        rounds++;
    }
    memory_free(views.first);
    memory_free(views.items);
    return rounds;
}
