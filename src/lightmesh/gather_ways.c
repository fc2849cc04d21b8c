/* Ways of gather rays: see gather_ways.h. */
#include "lightmesh/gather_ways.h"

#include <stdlib.h>

#include "base/draw.h"
#include "base/memory.h"
#include "base/morton.h"
#include "base/warp.h"
#include "lightmesh/gather.h"
#include "lightmesh/tuning.h"

static void way_pair(uint64_t key, uint32_t index, double u[2])
{
    const struct draws draws = { key, index };
    draw_pair(&draws, GATHER_DIRECTION, u);
}

vec3 gather_way(uint64_t key, uint32_t index)
{
    double u[2];
    way_pair(key, index, u);
    return warp_sphere(u);
}

/* Neighbours on a curve through the square that ways are drawn from (Morton
 * 1966) go nearly the same way. */
static uint32_t pair_place(const double u[2])
{
    return morton_place((uint32_t)(256 * u[1]), (uint32_t)(256 * u[0]));
}

/* Ways wind around the sphere along a spiral, from pole to pole by equal areas:
 * they leave smaller gaps than a net that is drawn [truth: 0.95 of its error].
 * By such a part of a turn from each to the next all parts together are even,
 * each of them, and every second and every fourth way of one (Stolarsky 1973
 * tells by their distances from each other). */
static const double way_turn = 0.21225;

struct way_order {
    uint32_t place, sample;
};

static int way_compare(const void *a, const void *b)
{
    const struct way_order *x = a, *y = b;
    return x->place != y->place
               ? (x->place > y->place) - (x->place < y->place)
               : (x->sample > y->sample) - (x->sample < y->sample);
}

/* Which of so many along the spiral sample `i` is: the first half and the first
 * quarter of them go all along it as well, those of each part beside those of
 * others. */
static uint32_t way_step(uint32_t i, uint32_t samples)
{
    uint32_t quarter = (samples + 3) / 4, half = (samples + 1) / 2;
    return i < quarter ? 4 * i
           : i < half  ? 4 * (i - quarter) + 2
                       : 2 * (i - half) + 1;
}

/* Those of the part. */
static void ways_draw(struct gather_ways *ways, uint32_t part,
                      struct way_order *sorted)
{
    const uint32_t first = part * ways->set;
    const double count = (double)GATHER_PARTS * ways->samples;
    for (uint32_t i = 0; i < ways->samples; i++) {
        uint32_t turned = (way_step(i, ways->samples) + part) % ways->samples;
        uint32_t step = GATHER_PARTS * turned + part;
        const double turns = step * way_turn;
        const double u[2] = { (step + 0.5) / count, turns - floor(turns) };
        ways->ways[first + i] = warp_sphere(u);
        sorted[i] = (struct way_order){ pair_place(u), i };
    }
    qsort(sorted, ways->samples, sizeof *sorted, way_compare);
    for (uint32_t i = 0; i < ways->samples; i++)
        ways->order[first + i] = sorted[i].sample;
}

struct gather_ways gather_ways_new(int samples)
{
    struct gather_ways ways = { .samples = (uint32_t)samples, .set = 1 };
    while (ways.set < ways.samples)
        ways.set *= 2;
    uint32_t count = (GATHER_PARTS - 1) * ways.set + ways.samples;
    if (count > WAYS_MOST)
        return ways;
    ways.count = count;
    ways.ways = memory_new(count * sizeof *ways.ways);
    ways.order = memory_new(count * sizeof *ways.order);
    struct way_order *sorted = memory_new(ways.samples * sizeof *sorted);
    for (uint32_t part = 0; part < GATHER_PARTS; part++)
        ways_draw(&ways, part, sorted);
    memory_free(sorted);
    return ways;
}

void gather_ways_free(struct gather_ways *ways)
{
    memory_free(ways->ways);
    memory_free(ways->order);
}

void gather_part_shift(uint32_t part, double place[2])
{
    static const double second[GATHER_PARTS] = { 0,     0.5,   0.25,  0.75,
                                                 0.125, 0.625, 0.375, 0.875 };
    place[0] += (double)part / GATHER_PARTS;
    place[1] += second[part];
    place[0] -= floor(place[0]);
    place[1] -= floor(place[1]);
}
