/* Tiles are halved into triangles, and a triangle falls into smaller ones of
 * the same shapes ("deflation"): from a triangle with a corner at the origin
 * that is large enough to hold the point, down to the tile. */
#include "scene/penrose.h"

#include <math.h>
#include <stdbool.h>

#define GOLDEN 1.61803398874989484820
#define SIN18  0.30901699437494742410
#define COS18  0.95105651629515357212
#define SIN36  0.58778525229247312917
#define COS36  0.80901699437494742410

/* Of a pentagon with sides of 1: from its middle to a side, and to a corner. */
#define APOTHEM (COS36 / (2 * SIN36))
#define RADIUS  (1 / (2 * SIN36))

/* Steps down: by four of them all is turned back as it was. */
enum { ROUND = 4, STEPS_MOST = 80 };

/* The point in a triangle of corners 0, 1 and 2, by its weights: corner 0 has
 * 1 - b - c. `acute`: corner 0 has 36 degrees and both sides there are of the
 * same length; otherwise these are 36, 108 and 36 degrees of half a dart, and
 * 108, 36, 36 of half a thick rhomb. */
struct place {
    bool acute;
    double b, c;
    bool outer; /* of half a kite: its side corner was the far one of the larger
                   half kite */
};

/* All that is the same by turning by 72 degrees and by mirroring: into the
 * wedge from x to 36 degrees. */
static void fold(double *x, double *z)
{
    *z = fabs(*z);
    for (int i = 0; i < 2; i++) {
        double beyond = COS36 * *z - SIN36 * *x;
        if (beyond <= 0)
            return;
        *x += 2 * SIN36 * beyond;
        *z = fabs(*z - 2 * COS36 * beyond);
    }
}

/* Of triangles with two sides of 1 from the origin, x and 36 degrees: the one
 * that is a power of GOLDEN larger and holds the point. Returns how many steps
 * it is down to size 1, a multiple of ROUND but 0; 0: too far away. */
static int wedge_steps(double *x, double *z)
{
    const double round = 1 / (GOLDEN * GOLDEN * GOLDEN * GOLDEN);
    const double reach = 0.8; /* COS36 at least is inside */
    fold(x, z);
    for (int steps = 0; steps <= STEPS_MOST; steps += ROUND) {
        if (steps > 0 && *x * *x + *z * *z < reach * reach)
            return steps;
        *x *= round;
        *z *= round;
    }
    return 0;
}

/* Half a kite: its tip, its far corner on the axis, and the one at the side. */
static struct place kite_step(struct place at)
{
    double a = 1 - at.b - at.c, side = GOLDEN * a - at.b;
    double tip = GOLDEN * GOLDEN * at.c, axis = GOLDEN * at.b;
    if (tip + axis <= 1)
        return (struct place){ false, tip, axis, false };
    if (side >= 0)
        return (struct place){ true, axis, side, false };
    return (struct place){ true, GOLDEN * GOLDEN * a, -side, true };
}

/* Half a dart: its tip, its notch, and its wing. */
static struct place dart_step(struct place at)
{
    double a = 1 - at.b - at.c;
    if (at.b + GOLDEN * at.c <= 1)
        return (struct place){ true, at.b, GOLDEN * at.c, false };
    return (struct place){ false, GOLDEN * GOLDEN * a, at.b, false };
}

/* Where it is in half a kite or dart of which the longer sides are 1. `along`:
 * the kites at the origin have their axes along x, else their sides. */
static bool kite_find(double x, double z, bool along, struct place *at)
{
    int steps = wedge_steps(&x, &z);
    double side = z / SIN36, axis = x - COS36 * side;
    *at = along ? (struct place){ true, axis, side, false }
                : (struct place){ true, side, axis, false };
    for (int i = 0; i < steps; i++)
        *at = at->acute ? kite_step(*at) : dart_step(*at);
    return steps > 0;
}

/* Half a thin rhomb: the corner of 36 degrees first. */
static struct place thin_step(struct place at)
{
    double a = 1 - at.b - at.c, side = at.b - GOLDEN * a;
    if (side >= 0)
        return (struct place){ true, GOLDEN * GOLDEN * a, side, false };
    return (struct place){ false, at.c, -side / GOLDEN, false };
}

/* Half a thick rhomb: the corner of 108 degrees first. */
static struct place thick_step(struct place at)
{
    double a = 1 - at.b - at.c, b = at.c - GOLDEN * at.b;
    if (b >= 0)
        return (struct place){ false, b, a, false };
    double c = 1 - GOLDEN * a - GOLDEN * at.c;
    if (c >= 0)
        return (struct place){ false, GOLDEN * at.c, c, false };
    b = -GOLDEN * b;
    return (struct place){ true, b, 1 - b - GOLDEN * at.c, false };
}

/* Where it is in half a rhomb with sides of 1. At the origin are thick ones. */
static bool rhomb_find(double x, double z, struct place *at)
{
    int steps = wedge_steps(&x, &z);
    double far = z / (GOLDEN * SIN36), apex = x - far * GOLDEN * COS36;
    *at = (struct place){ false, far, 1 - apex - far, false };
    for (int i = 0; i < steps; i++)
        *at = at->acute ? thin_step(*at) : thick_step(*at);
    return steps > 0;
}

/* Of `kinds`, this one; the point is that deep in it, and bevels that wide.
 * POV-Ray keeps the insides of all but the first kind off the next lower one,
 * which is there with another colour where a map jumps. */
static double tile_value(int kind, int kinds, double depth, double bevel)
{
    const double off = 1e-6;
    if (depth >= bevel)
        return kind ? (double)kind / kinds + off : 0;
    return (kind + 1 - fmax(0, depth) / bevel) / kinds;
}

double penrose_kites(double x, double z)
{
    const double bevel = 1 / 4.46; /* measured, as the others */
    struct place at;
    if (!kite_find(x, z, true, &at))
        return 0;
    double depth = fmin(SIN36 * at.b, COS18 * (1 - at.b - at.c));
    return at.acute ? tile_value(0, 2, depth, bevel)
                    : tile_value(1, 2, depth / GOLDEN, bevel);
}

double penrose_rhombs(double x, double z)
{
    const double bevel = GOLDEN / 5.55;
    struct place at;
    if (!rhomb_find(x, z, &at))
        return 0;
    double depth = fmin(at.b, at.c);
    return at.acute ? tile_value(1, 2, SIN36 * depth, bevel)
                    : tile_value(0, 2, COS18 * depth, bevel);
}

/* The shapes of the tiling of pentagons, their middles at the origin and a
 * corner on x: how deep the point is in them, negative outside. */
enum shape { PENTAGON, STAR, BOAT, RHOMB };

/* A star's points are 2 * APOTHEM away from its middle. A boat is three of
 * them, the middle one on x, and a straight side opposite. */
static double shape_depth(enum shape shape, double x, double z)
{
    double straight = x + SIN36 - 2 * APOTHEM * SIN18;
    if (shape == RHOMB)
        return SIN36 / 2 - SIN18 * fabs(x) - COS18 * fabs(z);
    fold(&x, &z);
    if (shape == PENTAGON)
        return APOTHEM - COS36 * x - SIN36 * z;
    double point = SIN18 * (2 * APOTHEM - x) - COS18 * z;
    return shape == BOAT ? fmin(point, straight) : point;
}

/* A tile that reaches into half a kite or dart: where its middle is from
 * corner 0, corner 1 being on x; how far it is turned, in steps of 36
 * degrees. */
struct part {
    enum shape shape;
    int kind;
    double x, z;
    int turned;
};

/* The longer sides of the kites and darts, whose corners are the middles of
 * pentagons (a kite's tip and far corner, a dart's wings), stars and boats. */
#define SIDE (2 * APOTHEM * GOLDEN * GOLDEN)

enum { PARTS = 5 };

/* In half a kite, up to its star or boat; */
static const struct part kite_parts[PARTS] = {
    { PENTAGON, 1, SIDE - 2 * APOTHEM *COS36, 2 * APOTHEM *SIN36, 0 },
    { PENTAGON, 2, 2 * APOTHEM *COS36, 2 * APOTHEM *SIN36, 1 },
    { PENTAGON, 0, 0, 0, 0 },
    { PENTAGON, 0, SIDE, 0, 1 },
    { RHOMB, 5, SIDE / 2, 0, 0 },
};
static const struct part kite_star = { STAR, 3, SIDE *COS36, SIDE *SIN36, 0 };
static const struct part kite_boat = { BOAT, 4, SIDE *COS36, SIDE *SIN36, 6 };

/* in half a dart. */
static const struct part dart_parts[PARTS] = {
    { PENTAGON, 1, RADIUS / GOLDEN + RADIUS, 0, 1 },
    { PENTAGON, 2, (SIDE - 2 * APOTHEM) * COS36, (SIDE - 2 * APOTHEM) * SIN36,
      0 },
    { PENTAGON, 0, SIDE *COS36, SIDE *SIN36, 1 },
    { STAR, 3, 0, 0, 1 },
    { BOAT, 4, SIDE / GOLDEN, 0, 0 },
};

static double part_depth(const struct part *part, double x, double z)
{
    static const double turns[][2] = {
        [0] = { 1, 0 }, [1] = { COS36, SIN36 }, [6] = { -COS36, -SIN36 }
    };
    const double *turn = turns[part->turned];
    x -= part->x;
    z -= part->z;
    return shape_depth(part->shape, turn[0] * x + turn[1] * z,
                       turn[0] * z - turn[1] * x);
}

double penrose_pentagons(double x, double z)
{
    const double bevel = GOLDEN / 5.55;
    struct place at;
    if (!kite_find(x / SIDE, z / SIDE, false, &at))
        return 0;
    const struct part *parts = at.acute ? kite_parts : dart_parts;
    const struct part *part = at.outer ? &kite_star : &kite_boat;
    double axis = at.acute ? SIDE : SIDE / GOLDEN;
    x = axis * at.b + SIDE * COS36 * at.c;
    z = SIDE * SIN36 * at.c;
    double depth = at.acute ? part_depth(part, x, z) : -HUGE_VAL;
    for (int i = 0; i < PARTS && depth < 0; i++) {
        double here = part_depth(&parts[i], x, z);
        if (here > depth) {
            depth = here;
            part = &parts[i];
        }
    }
    return tile_value(part->kind, 6, depth, bevel);
}
