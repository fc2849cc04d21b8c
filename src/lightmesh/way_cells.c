/* Cells of ways: see way_cells.h. */
#include "lightmesh/way_cells.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/memory.h"

/* A part's own ways by how high they go. */
struct ladder {
    struct rung {
        vec3 way;
        uint32_t cell;
    } * rungs;
    uint32_t count;
};

/* The ways nearest to one, by the cosines of the angles to them. */
struct nearest {
    double cosine[2];
    uint32_t cell[2];
};

static int rung_compare(const void *a, const void *b)
{
    const struct rung *x = a, *y = b;
    return (x->way.z > y->way.z) - (x->way.z < y->way.z);
}

/* The first rung that is not below a height. */
static uint32_t ladder_at(const struct ladder *ladder, double height)
{
    uint32_t low = 0, high = ladder->count;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (ladder->rungs[middle].way.z < height)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Returns false where neither it nor any beyond it can be nearer: all of them
 * are farther off in height alone than the second is. */
static bool nearest_try(struct nearest *nearest, vec3 way,
                        const struct rung *rung)
{
    double off = rung->way.z - way.z;
    double cosine = vec3_dot(rung->way, way);
    if (off * off > 2 - 2 * nearest->cosine[1])
        return false;
    if (cosine > nearest->cosine[0]) {
        nearest->cosine[1] = nearest->cosine[0];
        nearest->cell[1] = nearest->cell[0];
        nearest->cosine[0] = cosine;
        nearest->cell[0] = rung->cell;
    } else if (cosine > nearest->cosine[1]) {
        nearest->cosine[1] = cosine;
        nearest->cell[1] = rung->cell;
    }
    return true;
}

static struct nearest ladder_nearest(const struct ladder *ladder, vec3 way)
{
    struct nearest nearest = { { -2, -2 }, { 0, 0 } };
    uint32_t at = ladder_at(ladder, way.z);
    for (uint32_t i = at;
         i < ladder->count && nearest_try(&nearest, way, &ladder->rungs[i]);
         i++)
        continue;
    for (uint32_t i = at;
         i > 0 && nearest_try(&nearest, way, &ladder->rungs[i - 1]); i--)
        continue;
    return nearest;
}

static int pair_compare(const void *a, const void *b)
{
    return memcmp(a, b, sizeof(uint32_t[2]));
}

/* Each once. */
static uint32_t pairs_settle(uint32_t (*pair)[2], uint32_t count)
{
    uint32_t kept = 0;
    qsort(pair, count, sizeof *pair, pair_compare);
    for (uint32_t i = 0; i < count; i++)
        if (i == 0 || pair_compare(pair[i], pair[i - 1]) != 0)
            memmove(pair[kept++], pair[i], sizeof *pair);
    return kept;
}

/* Way `i` of all that are looked at, as gather_ways numbers them. */
static uint32_t way_number(const struct gather_ways *ways, uint32_t i,
                           uint32_t count)
{
    return i / count * ways->set + i % count;
}

/* Sorted by counting: first[c + 1] counts those of cell c, then tells where the
 * next of them goes. */
static void part_sort(struct part_cells *cells, const uint32_t *cell,
                      const struct gather_ways *ways, uint32_t count)
{
    uint32_t *next = cells->first + 1;
    for (uint32_t i = 0, sum = 0; i < count; i++) {
        uint32_t own = next[i];
        next[i] = sum;
        sum += own;
    }
    for (uint32_t i = 0; i < GATHER_PARTS * count; i++)
        cells->ways[next[cell[i]]++] = way_number(ways, i, count);
}

static struct part_cells part_new(const struct gather_ways *ways,
                                  const struct ladder *ladder)
{
    uint32_t count = ladder->count, all = GATHER_PARTS * count;
    uint32_t *cell = memory_new(all * sizeof *cell);
    struct part_cells cells = {
        .first = memory_new((count + 1) * sizeof *cells.first),
        .ways = memory_new(all * sizeof *cells.ways),
        .pair = memory_new(all * sizeof *cells.pair),
    };
    for (uint32_t i = 0; i < all; i++) {
        vec3 way = ways->ways[way_number(ways, i, count)];
        struct nearest nearest = ladder_nearest(ladder, way);
        uint32_t a = nearest.cell[0], b = nearest.cell[1];
        cell[i] = a;
        cells.first[a + 1]++;
        cells.pair[i][0] = a < b ? a : b;
        cells.pair[i][1] = a < b ? b : a;
    }
    part_sort(&cells, cell, ways, count);
    cells.pairs = pairs_settle(cells.pair, all);
    memory_free(cell);
    return cells;
}

struct way_cells way_cells_new(const struct gather_ways *ways, uint32_t count)
{
    struct way_cells cells = { .count = 0 };
    if (!ways->ways || count < 2 || count > WAY_CELLS_MOST)
        return cells;
    cells.count = count;
    struct ladder ladder = { memory_new(count * sizeof *ladder.rungs), count };
    for (uint32_t part = 0; part < GATHER_PARTS; part++) {
        for (uint32_t i = 0; i < count; i++)
            ladder.rungs[i] =
                (struct rung){ ways->ways[part * ways->set + i], i };
        qsort(ladder.rungs, count, sizeof *ladder.rungs, rung_compare);
        cells.part[part] = part_new(ways, &ladder);
    }
    memory_free(ladder.rungs);
    return cells;
}

void way_cells_free(struct way_cells *cells)
{
    for (int i = 0; i < GATHER_PARTS; i++) {
        memory_free(cells->part[i].first);
        memory_free(cells->part[i].ways);
        memory_free(cells->part[i].pair);
    }
}

void way_cells_edges(const struct way_cells *cells, uint32_t part,
                     const double *brought, double most, bool *edge)
{
    const struct part_cells *own = &cells->part[part];
    for (uint32_t i = 0; i < cells->count; i++)
        edge[i] = false;
    for (uint32_t i = 0; i < own->pairs; i++) {
        uint32_t a = own->pair[i][0], b = own->pair[i][1];
        bool differ = fabs(brought[a] - brought[b]) > most;
        edge[a] |= differ;
        edge[b] |= differ;
    }
}
