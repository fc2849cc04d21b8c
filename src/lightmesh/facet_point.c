/* Mesh points on triangles: see facet_point.h. */
#include "lightmesh/facet_point.h"

#include "base/random.h"
#include "lightmesh/tuning.h"

/* 1 bit that says it is a key, 27, 1, 2, 4, 2 x 14. */
uint64_t facet_point_key(const struct facet_point *point)
{
    uint64_t key = 1ull << 27 | point->triangle;
    key = key << 1 | point->back;
    key = key << 2 | (uint64_t)point->kind;
    key = key << 4 | (uint64_t)point->division;
    key = key << 14 | (uint64_t)point->i;
    return key << 14 | (uint64_t)point->j;
}

struct facet_point facet_point_named(uint64_t key)
{
    return (struct facet_point){
        .triangle = (uint32_t)(key >> 35 & ((1 << 27) - 1)),
        .back = key >> 34 & 1,
        .kind = (enum facet_kind)(key >> 32 & 3),
        .division = (int)(key >> 28 & 15),
        .i = (int)(key >> 14 & ((1 << 14) - 1)),
        .j = (int)(key & ((1 << 14) - 1)),
    };
}

/* The corners of a cell have different thirds (three colours are enough for
 * triangles), within the third a number of their neighbourhood. */
double facet_point_dither(const struct facet_point *point)
{
    struct facet_point block = *point;
    int third = (point->i + 2 * point->j) % 3;
    block.i /= 3;
    block.j /= 3;
    return (third + random_unit(facet_point_key(&block))) / 3;
}

vec3 facet_point_place(const struct facet *facet,
                       const struct facet_point *point, double *wide)
{
    double n = 1 << point->division, share[3] = { 0, 0, 0 };
    *wide = point->kind == FACET_SINGLE ? spread_single : spread_cell / n;
    if (point->kind == FACET_CELLS) {
        share[1] = point->i / n;
        share[2] = point->j / n;
    } else {
        int apex = facet->apex;
        double along = point->kind == FACET_CHAIN ? 1 - point->i / n : 1 / 3.0;
        share[apex] = along;
        share[(apex + 1) % 3] = share[(apex + 2) % 3] = (1 - along) / 2;
    }
    double inside = facet->square ? 1 - 2 * *wide : 1 - *wide;
    double u = share[1] * inside + *wide / 3;
    double v = share[2] * inside + *wide / 3;
    return facet_place(facet, u, v);
}
