/* A cell, a square or a triangle, has a part for each of its corners, and what
 * borders there are at the corner says what the value is there (measured). */
#include "scene/pavement.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#define ROOT3 1.73205080756887729353

enum { FORM_POINTED, FORM_BROKEN, FORM_ROUND, FORM_APART };

static const struct {
    int sides, tiles, patterns;
} kinds[] = {
    { 3, 1, 1 },  { 3, 2, 1 },  { 3, 3, 1 }, { 3, 4, 3 }, { 3, 5, 4 },
    { 3, 6, 12 }, { 4, 1, 1 },  { 4, 2, 1 }, { 4, 3, 2 }, { 4, 4, 5 },
    { 4, 5, 12 }, { 4, 6, 35 }, { 6, 1, 1 }, { 6, 2, 1 }, { 6, 3, 3 },
    { 6, 4, 7 },  { 6, 5, 22 },
};

enum { KINDS = sizeof kinds / sizeof *kinds };

int pavement_patterns(int sides, int tiles)
{
    for (int i = 0; i < KINDS; i++)
        if (kinds[i].sides == sides && kinds[i].tiles == tiles)
            return kinds[i].patterns;
    return 0;
}

const struct pavement_edges *pavement_find(const struct pavement *pavement)
{
    const struct pavement_edges *edges = pavement_list;
    for (int i = 0; i < KINDS; edges += kinds[i++].patterns) {
        if (kinds[i].sides != pavement->sides ||
            kinds[i].tiles != pavement->tiles)
            continue;
        if (pavement->pattern < 1 || pavement->pattern > kinds[i].patterns)
            return NULL;
        return edges + pavement->pattern - 1;
    }
    return NULL;
}

/* A point of the lattice; its numbers are whole. */
struct knot {
    double i, j;
};

/* From 0 to `count` - 1. */
static int remainder_of(double whole, int count)
{
    return (int)(whole - count * floor(whole / count));
}

/* The digit of the point. */
static int knot_edges(const struct pavement_edges *edges, double i, double j)
{
    int height = (int)strlen(edges->rows) / edges->width;
    double cell = floor(j / height);
    int row = remainder_of(j, height);
    int column = remainder_of(i - cell * edges->shift, edges->width);
    return edges->rows[row * edges->width + column] - '0';
}

/* Whether a border leaves a point of the squares' lattice to the right, up, to
 * the left or down, 0 to 3; to any side. */
static bool square_border(const struct pavement_edges *edges, struct knot at,
                          int way)
{
    int digit = knot_edges(edges, at.i - (way == 2), at.j - (way == 3));
    return digit & (way % 2 ? 2 : 1);
}

static bool square_touched(const struct pavement_edges *edges, struct knot at)
{
    bool touched = false;
    for (int way = 0; way < 4; way++)
        touched |= square_border(edges, at, way);
    return touched;
}

/* Of triangles' lattices there are six ways, each 60 degrees further. */
static bool triangle_border(const struct pavement_edges *edges, struct knot at,
                            int way)
{
    static const struct knot from[] = { { -1, 0 }, { 0, -1 }, { 1, -1 } };
    if (way >= 3) {
        at.i += from[way - 3].i;
        at.j += from[way - 3].j;
    }
    return knot_edges(edges, at.i, at.j) >> way % 3 & 1;
}

/* A corner within a tile, u and v from the two lines through it. */
static double square_interior(int form, double u, double v)
{
    switch (form) {
    case FORM_BROKEN:
        return 1 - 2 * (u + v);
    case FORM_ROUND:
        return 1 - 2 * hypot(u, v);
    default:
        return 1 - 2 * fmax(u, v);
    }
}

static double square_exterior(int form, double u, double v)
{
    switch (form) {
    case FORM_BROKEN:
        return 2 * (1 - u - v);
    case FORM_ROUND:
        return 2 * hypot(0.5 - u, 0.5 - v);
    default:
        return 1 - 2 * fmin(u, v);
    }
}

/* A cell within a bend of its tile; u and v from the inner corner, along the
 * cell. */
static double square_bend(int form, double u, double v)
{
    if (form == FORM_BROKEN)
        return 2 * fabs(u + v - 0.5);
    return fabs(1 - 2 * hypot(u, v));
}

/* A cell of squares, of which one has a quarter around each corner. */
struct square {
    double u, v;                /* in the cell */
    bool left, right, low, top; /* borders */
};

/* Whether the cell has two borders that meet, and their opposite corner is of
 * other tiles: there the tile bends. */
static bool square_bends(const struct pavement_edges *edges, struct knot at,
                         const struct square *cell)
{
    if (cell->left == cell->right || cell->low == cell->top)
        return false;
    struct knot inner = { at.i + cell->left, at.j + cell->low };
    return square_touched(edges, inner);
}

static double square_value(const struct pavement *pavement, double x, double z)
{
    const struct pavement_edges *edges = pavement->edges;
    struct knot at = { floor(x), floor(z) };
    struct knot next = { at.i + 1, at.j + 1 };
    struct square cell = { x - at.i,
                           z - at.j,
                           square_border(edges, at, 1),
                           square_border(edges, next, 3),
                           square_border(edges, at, 0),
                           square_border(edges, next, 2) };
    int exterior = pavement->exterior, interior = pavement->interior;
    if (square_bends(edges, at, &cell) && pavement->form != FORM_APART) {
        if (pavement->form == FORM_BROKEN || pavement->form == FORM_ROUND)
            return square_bend(pavement->form, cell.left ? 1 - cell.u : cell.u,
                               cell.low ? 1 - cell.v : cell.v);
        exterior = interior = FORM_POINTED;
    }
    bool right = cell.u >= 0.5, top = cell.v >= 0.5;
    bool across = right ? cell.right : cell.left;
    bool along = top ? cell.top : cell.low;
    double u = right ? 1 - cell.u : cell.u, v = top ? 1 - cell.v : cell.v;
    if (across && along)
        return square_exterior(exterior, u, v);
    if (across || along)
        return 1 - 2 * (across ? u : v);
    struct knot corner = { at.i + right, at.j + top };
    return square_touched(edges, corner) ? square_interior(interior, u, v) : 0;
}

/* The corners of a triangle's tile. u and v are how near the other two corners
 * are, of 1; a length is 2 / sqrt(3) heights. */
static double triangle_interior(int form, double u, double v)
{
    switch (form) {
    case FORM_BROKEN:
        return 1 - 1.5 * (u + v + fmax(u, v));
    case FORM_ROUND:
        return 1 - 3 * sqrt(u * u + u * v + v * v);
    default:
        return 1 - 3 * (u + v);
    }
}

static double triangle_exterior(int form, double u, double v)
{
    double pointed = 1 - 3 * fmin(u, v);
    if (form == FORM_BROKEN)
        return fmax(pointed, 2 - 3 * (u + v));
    if (form != FORM_ROUND)
        return pointed;
    u -= 1. / 3;
    v -= 1. / 3;
    return 2 * ROOT3 * sqrt(u * u + u * v + v * v);
}

/* With a border where v is 0, that turns at the corner by 60 degrees. */
static double triangle_turn(int form, double u, double v)
{
    switch (form) {
    case FORM_BROKEN:
        return 2 - 2 * u - 4 * v;
    case FORM_ROUND:
        return 2 * ROOT3 * sqrt(u * u + u * (v - 1) + (v - 1) * (v - 1)) - 2;
    default:
        return 1 - 3 * v;
    }
}

/* What the corner is by the borders that leave it; the triangle is between the
 * ways `way` and `way` + 1. */
static double triangle_corner(const struct pavement *pavement, struct knot at,
                              int way, double u, double v)
{
    bool border[6], any = false;
    for (int i = 0; i < 6; i++) {
        border[i] = triangle_border(pavement->edges, at, (way + i) % 6);
        any |= border[i];
    }
    if (!any)
        return 0;
    if (border[0] && border[1])
        return triangle_exterior(pavement->exterior, u, v);
    if (!border[0] && !border[1])
        return triangle_interior(pavement->interior, u, v);
    int form = border[border[0] ? 2 : 5] ? pavement->form : FORM_POINTED;
    return border[0] ? triangle_turn(form, u, v) : triangle_turn(form, v, u);
}

static double triangle_value(const struct pavement *pavement, double x,
                             double z)
{
    double b = z * (2 / ROOT3), a = x - b / 2;
    struct knot at = { floor(a), floor(b) };
    double u = a - at.i, v = b - at.j;
    bool down = u + v >= 1;
    const double near[3] = { down ? u + v - 1 : 1 - u - v, down ? 1 - u : u,
                             down ? 1 - v : v };
    int corner = near[0] >= near[1] ? 0 : 1;
    if (near[2] > near[corner])
        corner = 2;
    const struct knot knots[3] = { { at.i + down, at.j + down },
                                   { at.i + !down, at.j + down },
                                   { at.i + down, at.j + !down } };
    return triangle_corner(pavement, knots[corner], (2 * corner + 3 * down) % 6,
                           near[(corner + 1) % 3], near[(corner + 2) % 3]);
}

double pavement_value(const struct pavement *pavement, double x, double z)
{
    const double far = 1e9; /* a number has no digits left for the cell */
    if (!(fabs(x) < far && fabs(z) < far))
        return 0;
    double value = pavement->sides == 4 ? square_value(pavement, x, z)
                                        : triangle_value(pavement, x, z);
    return fmax(0, fmin(value, 1));
}
