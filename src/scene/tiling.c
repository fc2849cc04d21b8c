/* A tiling is looked up in one cell of its lattice, cut into small parts: each
 * knows the few tiles that reach into it. */
#include "scene/tiling.h"

#include <math.h>

enum { PARTS = 8 }; /* of a cell's side */

/* Convex; inside where all nx x + nz z > c. Lengths are the tiling's bevels. */
struct tile {
    int kind, sides;
    double nx[TILING_SIDES], nz[TILING_SIDES], c[TILING_SIDES];
};

struct tile_list {
    const struct tile *tiles;
    int count;
};

struct tiling {
    double step[2][2], inverse[2][2];
    double kinds;
    struct tile_list parts[PARTS][PARTS];
};

/* How far inside the tile the point is, in bevels; negative: outside. */
static double tile_depth(const struct tile *tile, double x, double z)
{
    double depth = HUGE_VAL;
    for (int i = 0; i < tile->sides; i++)
        depth = fmin(depth, tile->nx[i] * x + tile->nz[i] * z - tile->c[i]);
    return depth;
}

static struct tile tile_make(const struct tile_outline *outline, double bevel)
{
    struct tile tile = { outline->kind, 0 };
    double x = outline->x, z = outline->z, width = bevel;
    char last = 0;
    for (const char *side = outline->sides; *side; last = *side++) {
        if (*side == '!') {
            width = 1. / 3;
            continue;
        }
        int turn = *side >= 'a' ? *side - 'a' : *side - 'A';
        double length = *side >= 'a' ? 1 : sqrt(2);
        double c = cos(turn * M_PI / 12), s = sin(turn * M_PI / 12);
        if (*side != last) {
            int i = tile.sides++;
            tile.nx[i] = -s / width;
            tile.nz[i] = c / width;
            tile.c[i] = (c * z - s * x) / width;
            width = bevel;
        }
        x += length * c;
        z += length * s;
    }
    return tile;
}

static struct tile tile_moved(struct tile tile, double x, double z)
{
    for (int i = 0; i < tile.sides; i++)
        tile.c[i] += tile.nx[i] * x + tile.nz[i] * z;
    return tile;
}

/* A lattice's vectors and where tiles start are a few steps at most. */
enum { REACH = 4, SHIFTS = 2 * REACH + 1, TILES_MOST = 10 };

/* Those of the tiles that come within `radius`, in bevels, of a place in the
 * cell. */
static struct tile_list tiles_near(struct arena *arena,
                                   const struct tiling *tiling, double u,
                                   double v, double radius,
                                   struct tile_list tiles)
{
    const double(*step)[2] = tiling->step;
    double x = u * step[0][0] + v * step[1][0];
    double z = u * step[0][1] + v * step[1][1];
    struct tile_list list = { NULL, 0 };
    for (int i = 0; i < tiles.count; i++)
        list.count += tile_depth(&tiles.tiles[i], x, z) > -radius;
    struct tile *found = ARENA_ARRAY(arena, struct tile, list.count);
    list.tiles = found;
    for (int i = 0; i < tiles.count; i++)
        if (tile_depth(&tiles.tiles[i], x, z) > -radius)
            *found++ = tiles.tiles[i];
    return list;
}

static void tiling_lattice(struct tiling *tiling)
{
    const double(*step)[2] = tiling->step;
    double area = step[0][0] * step[1][1] - step[0][1] * step[1][0];
    tiling->inverse[0][0] = step[1][1] / area;
    tiling->inverse[0][1] = -step[1][0] / area;
    tiling->inverse[1][0] = -step[0][1] / area;
    tiling->inverse[1][1] = step[0][0] / area;
}

/* All tiles of an outline that come near the cell. */
static struct tile_list tiling_tiles(struct arena *arena,
                                     const struct tiling *tiling,
                                     const struct tiling_outline *outline,
                                     double radius)
{
    const double(*step)[2] = tiling->step;
    struct tile moved[TILES_MOST * SHIFTS * SHIFTS];
    struct tile_list list = { moved, 0 };
    for (int i = 0; i < outline->count; i++) {
        struct tile tile =
            tile_make(&tile_outlines[outline->first + i], outline->bevel);
        for (int a = -REACH; a <= REACH; a++)
            for (int b = -REACH; b <= REACH; b++)
                moved[list.count++] =
                    tile_moved(tile, a * step[0][0] + b * step[1][0],
                               a * step[0][1] + b * step[1][1]);
    }
    return tiles_near(arena, tiling, 0.5, 0.5, radius, list);
}

const struct tiling *tiling_make(struct arena *arena, int number)
{
    const double slack = 1e-6, least = 0.25; /* of all bevels */
    const struct tiling_outline *outline = &tiling_outlines[number - 1];
    struct tiling *tiling = ARENA_NEW(arena, struct tiling);
    memcpy(tiling->step, outline->step, sizeof tiling->step);
    tiling->kinds = outline->kinds;
    tiling_lattice(tiling);
    double radius = (hypot(tiling->step[0][0], tiling->step[0][1]) +
                     hypot(tiling->step[1][0], tiling->step[1][1])) /
                    2;
    struct tile_list tiles =
        tiling_tiles(arena, tiling, outline, radius / least + slack);
    for (int i = 0; i < PARTS; i++)
        for (int j = 0; j < PARTS; j++)
            tiling->parts[i][j] =
                tiles_near(arena, tiling, (i + 0.5) / PARTS, (j + 0.5) / PARTS,
                           radius / least / PARTS + slack, tiles);
    return tiling;
}

double tiling_value(const struct tiling *tiling, double x, double z)
{
    const double(*inverse)[2] = tiling->inverse, (*step)[2] = tiling->step;
    double u = floor(inverse[0][0] * x + inverse[0][1] * z);
    double v = floor(inverse[1][0] * x + inverse[1][1] * z);
    x -= u * step[0][0] + v * step[1][0];
    z -= u * step[0][1] + v * step[1][1];
    u = (inverse[0][0] * x + inverse[0][1] * z) * PARTS;
    v = (inverse[1][0] * x + inverse[1][1] * z) * PARTS;
    const struct tile_list *list =
        &tiling->parts[(int)fmax(0, fmin(u, PARTS - 1))]
                      [(int)fmax(0, fmin(v, PARTS - 1))];
    double depth = -HUGE_VAL;
    int kind = 0;
    for (int i = 0; i < list->count && depth < 0; i++) {
        double here = tile_depth(&list->tiles[i], x, z);
        if (here > depth) {
            depth = here;
            kind = list->tiles[i].kind;
        }
    }
    return (kind + 1 - fmax(0, fmin(depth, 1))) / tiling->kinds;
}
