/* Tilings of the plane by polygons: what the tiling pattern looks up. */
#ifndef SCENE_TILING_H
#define SCENE_TILING_H

#include "base/arena.h"

/* Numbers of tilings with a lattice are 1 to TILING_COUNT. */
enum { TILING_COUNT = 24, TILING_SIDES = 12 };

/* A tile: where it starts, and a letter a side of length 1, anticlockwise: `a`
 * goes along x, each next letter turns by 15 degrees; capitals are sides of
 * length sqrt(2). A letter that is repeated is one longer side. */
struct tile_outline {
    int kind;
    double x, z;
    const char *sides;
};

struct tiling_outline {
    int kinds;
    double bevel; /* from a tile's border, where its own value is reached */
    double step[2][2]; /* the tiling is the same so far away */
    int first, count;  /* of tile_outlines */
};

extern const struct tiling_outline tiling_outlines[TILING_COUNT];
extern const struct tile_outline tile_outlines[];

struct tiling;

/* The parameters of the pattern. */
struct tiling_use {
    int number;
    const struct tiling *tiling; /* made of the number, up to TILING_COUNT; */
    double (*penrose)(double x, double z); /* after it, see scene/penrose.h */
};

/* Tiling `number`, in the arena. */
const struct tiling *tiling_make(struct arena *arena, int number);

/* Of n kinds of tiles, kind k has k / n inside, and rises to (k + 1) / n
 * towards its border. In [0,1]. */
double tiling_value(const struct tiling *tiling, double x, double z);

#endif
