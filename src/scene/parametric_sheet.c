/* Cutting a parametric surface into cells: see parametric_sheet.h. Cells are
 * halved, along the side that is longer in space, until the surface in them
 * bends little in proportion to their size. */
#include "scene/parametric_sheet.h"

#include "base/array.h"

enum {
    SHEET_FIRST = 32,      /* cells along u and v to begin with */
    SHEET_DEPTH = 14,      /* halvings of each */
    SHEET_CELLS = 1 << 17, /* no more are halved then: memory, */
    SHEET_LOOKS = 1 << 19, /* nor after so many looks at cells: time */
    SHEET_LONGEST = 4,     /* sides of a cell, one by the other */
};

static const double sheet_flat = 0.05; /* bend by size of a flat cell */

struct sheet_builder {
    const struct parametric *surface;
    struct arena *arena;
    struct {
        struct parametric_cell *items;
        size_t count, capacity;
    } cells;
    struct {
        struct box3 *items;
        size_t count, capacity;
    } boxes;
    unsigned long steps, looks;
};

/* Nine points of a cell. */
struct cell_points {
    vec3 at[3][3];
    bool all; /* there is a point everywhere */
};

static void cell_sample(struct sheet_builder *b,
                        const struct parametric_cell *cell,
                        struct cell_points *points)
{
    points->all = true;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            double uv[2] = { cell->middle[0] + (i - 1) * cell->half[0],
                             cell->middle[1] + (j - 1) * cell->half[1] };
            points->all &=
                parametric_point(b->surface, uv, &b->steps, &points->at[i][j]);
        }
}

/* The plane of the cell, and how far the nine points are from it. */
static void cell_fit(struct parametric_cell *cell, const struct cell_points *p)
{
    cell->centre = p->at[1][1];
    cell->across[0] = vec3_scale(vec3_sub(p->at[2][1], p->at[0][1]), 0.5);
    cell->across[1] = vec3_scale(vec3_sub(p->at[1][2], p->at[1][0]), 0.5);
    cell->bend = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            vec3 flat = vec3_along(cell->centre, cell->across[0], i - 1);
            flat = vec3_along(flat, cell->across[1], j - 1);
            cell->bend =
                fmax(cell->bend, vec3_length(vec3_sub(p->at[i][j], flat)));
        }
}

/* Between the points it may reach a little farther. */
static struct box3 cell_around(const struct parametric_cell *cell,
                               const struct cell_points *p)
{
    struct box3 box = box3_empty();
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            box = box3_add(box, p->at[i][j]);
    double more = cell->bend + 1e-9 * (vec3_length(cell->centre) +
                                       vec3_length(cell->across[0]) +
                                       vec3_length(cell->across[1]));
    return box3_grown(box, more);
}

/* The side to halve, or -1: it is flat enough. */
static int cell_side(const struct parametric_cell *cell)
{
    double u = vec3_length(cell->across[0]), v = vec3_length(cell->across[1]);
    double longer = fmax(u, v), shorter = fmin(u, v);
    if (cell->bend <= sheet_flat * shorter)
        return -1;
    if (cell->bend <= sheet_flat * longer && longer < SHEET_LONGEST * shorter)
        return -1;
    return v > u;
}

static void sheet_add(struct sheet_builder *b, struct parametric_cell cell,
                      int depth);

static void sheet_halve(struct sheet_builder *b, struct parametric_cell cell,
                        int side, int depth)
{
    double half = cell.half[side] / 2, middle = cell.middle[side];
    cell.half[side] = half;
    cell.middle[side] = middle - half;
    sheet_add(b, cell, depth);
    cell.middle[side] = middle + half;
    sheet_add(b, cell, depth);
}

/* Where it has no points all round, it may have some within. */
static void sheet_add(struct sheet_builder *b, struct parametric_cell cell,
                      int depth)
{
    struct cell_points points;
    cell_sample(b, &cell, &points);
    bool may_halve = depth < SHEET_DEPTH && b->cells.count < SHEET_CELLS &&
                     b->looks++ < SHEET_LOOKS;
    if (b->steps == 0)
        return;
    if (!points.all) {
        if (may_halve && depth < SHEET_DEPTH / 2)
            sheet_halve(b, cell, depth % 2, depth + 1);
        return;
    }
    cell_fit(&cell, &points);
    int side = cell_side(&cell);
    struct box3 box = cell_around(&cell, &points);
    if (box3_is_empty(box3_intersection(box, b->surface->container.box)))
        return;
    if (side >= 0 && may_halve) {
        sheet_halve(b, cell, side, depth + 1);
        return;
    }
    *ARRAY_PUSH(b->arena, &b->cells) = cell;
    *ARRAY_PUSH(b->arena, &b->boxes) = box;
}

const struct parametric_sheet *
parametric_sheet_new(const struct parametric *surface, struct arena *arena)
{
    struct sheet_builder b = { .surface = surface,
                               .arena = arena,
                               .steps = PARAMETRIC_STEPS };
    struct parametric_cell first;
    for (int k = 0; k < 2; k++)
        first.half[k] = (surface->to[k] - surface->from[k]) / 2 / SHEET_FIRST;
    for (int i = 0; i < SHEET_FIRST; i++)
        for (int j = 0; j < SHEET_FIRST && b.steps > 0; j++) {
            first.middle[0] = surface->from[0] + (2 * i + 1) * first.half[0];
            first.middle[1] = surface->from[1] + (2 * j + 1) * first.half[1];
            sheet_add(&b, first, 0);
        }
    if (b.steps == 0)
        return NULL;
    struct parametric_sheet *sheet = ARENA_NEW(arena, struct parametric_sheet);
    sheet->cells = b.cells.items;
    sheet->count = b.cells.count;
    sheet->bounds = box3_empty();
    for (size_t i = 0; i < b.boxes.count; i++)
        sheet->bounds = box3_union(sheet->bounds, b.boxes.items[i]);
    if (b.cells.count > 0)
        sheet->tree = box_tree_new(arena, b.boxes.items, b.boxes.count);
    return sheet;
}

/* ---- where a line meets a cell ---- */

/* The line as two planes through it, whose normals these are. Coordinates of
 * the cell are scaled to -1 .. 1. */
struct aim {
    const struct parametric *surface;
    const struct parametric_cell *cell;
    vec3 origin, normal[2];
    double enough; /* distance from the line */
    int *looks_left;
};

static struct aim aim_new(const struct parametric *surface,
                          const struct parametric_cell *cell,
                          const struct ray *ray)
{
    struct aim aim = { .surface = surface,
                       .cell = cell,
                       .origin = ray->origin };
    vec3 d = vec3_normalise(ray->direction);
    vec3 other = fabs(d.x) < 0.6 ? vec3_make(1, 0, 0) : vec3_make(0, 1, 0);
    aim.normal[0] = vec3_normalise(vec3_cross(d, other));
    aim.normal[1] = vec3_cross(d, aim.normal[0]);
    aim.enough =
        1e-9 * (vec3_length(cell->across[0]) + vec3_length(cell->across[1])) +
        1e-13 * vec3_length(vec3_sub(cell->centre, ray->origin));
    return aim;
}

/* How far the point is from both planes. */
static void aim_off(const struct aim *aim, vec3 point, double off[2])
{
    vec3 w = vec3_sub(point, aim->origin);
    off[0] = vec3_dot(w, aim->normal[0]);
    off[1] = vec3_dot(w, aim->normal[1]);
}

static bool aim_at(const struct aim *aim, const double place[2], vec3 *point,
                   double off[2])
{
    enum { STEPS = 1000000 };
    unsigned long steps = STEPS;
    const struct parametric_cell *cell = aim->cell;
    if (--*aim->looks_left < 0)
        return false;
    double uv[2] = { cell->middle[0] + place[0] * cell->half[0],
                     cell->middle[1] + place[1] * cell->half[1] };
    if (!parametric_point(aim->surface, uv, &steps, point))
        return false;
    aim_off(aim, *point, off);
    return true;
}

/* x with m x = off. */
static bool solve(double m[2][2], const double off[2], double x[2])
{
    double det = m[0][0] * m[1][1] - m[0][1] * m[1][0];
    double size = fabs(m[0][0] * m[1][1]) + fabs(m[0][1] * m[1][0]);
    if (!(fabs(det) > 1e-12 * size))
        return false;
    x[0] = (off[0] * m[1][1] - off[1] * m[0][1]) / det;
    x[1] = (off[1] * m[0][0] - off[0] * m[1][0]) / det;
    return true;
}

/* From `place` on by Broyden's method ("A Class of Methods for Solving
 * Nonlinear Simultaneous Equations", 1965), m being the derivatives there or
 * near. False: it leads nowhere, or out of the cell. */
static bool aim_search(const struct aim *aim, double m[2][2], double place[2],
                       vec3 *point)
{
    enum { ROUNDS = 16 };
    const double beyond = 2, edge = 1 + 1e-7;
    double off[2], next[2], step[2];
    if (!aim_at(aim, place, point, off))
        return false;
    for (int i = 0; i < ROUNDS; i++) {
        if (fabs(off[0]) + fabs(off[1]) <= aim->enough)
            return fabs(place[0]) <= edge && fabs(place[1]) <= edge;
        if (!solve(m, off, step))
            return false;
        double length2 = step[0] * step[0] + step[1] * step[1];
        place[0] -= step[0];
        place[1] -= step[1];
        if (!(fabs(place[0]) < beyond && fabs(place[1]) < beyond) ||
            !aim_at(aim, place, point, next))
            return false;
        for (int k = 0; k < 2 && length2 > 0; k++)
            for (int j = 0; j < 2; j++)
                m[k][j] -= next[k] * step[j] / length2;
        off[0] = next[0];
        off[1] = next[1];
    }
    return false;
}

static void aim_slopes(const struct aim *aim, double m[2][2])
{
    for (int k = 0; k < 2; k++)
        for (int j = 0; j < 2; j++)
            m[k][j] = vec3_dot(aim->normal[k], aim->cell->across[j]);
}

/* The derivatives at a place, by small differences. */
static bool aim_slopes_at(const struct aim *aim, const double place[2],
                          double m[2][2])
{
    const double small = 1e-4;
    double here[2], there[2];
    vec3 point;
    if (!aim_at(aim, place, &point, here))
        return false;
    for (int j = 0; j < 2; j++) {
        double moved[2] = { place[0], place[1] };
        moved[j] += small;
        if (!aim_at(aim, moved, &point, there))
            return false;
        for (int k = 0; k < 2; k++)
            m[k][j] = (there[k] - here[k]) / small;
    }
    return true;
}

static int found_add(double found[PARAMETRIC_CROSSINGS][3], int count,
                     const struct aim *aim, const struct ray *ray,
                     const double place[2], vec3 point)
{
    double t = vec3_dot(vec3_sub(point, ray->origin), ray->direction) /
               vec3_dot(ray->direction, ray->direction);
    double uv[2];
    for (int k = 0; k < 2; k++)
        uv[k] = aim->cell->middle[k] + place[k] * aim->cell->half[k];
    for (int i = 0; i < count; i++)
        if (fabs(found[i][1] - uv[0]) <= 1e-5 * aim->cell->half[0] &&
            fabs(found[i][2] - uv[1]) <= 1e-5 * aim->cell->half[1])
            return count;
    if (count < PARAMETRIC_CROSSINGS) {
        found[count][0] = t;
        found[count][1] = uv[0];
        found[count++][2] = uv[1];
    }
    return count;
}

/* Where the line may graze it, from several places. */
static int cell_graze(const struct aim *aim, const struct ray *ray,
                      double found[PARAMETRIC_CROSSINGS][3])
{
    static const double starts[][2] = {
        { 0, 0 }, { 0.7, 0.7 }, { -0.7, 0.7 }, { 0.7, -0.7 }, { -0.7, -0.7 }
    };
    int count = 0;
    for (size_t i = 0; i < sizeof starts / sizeof *starts; i++) {
        double place[2] = { starts[i][0], starts[i][1] }, m[2][2];
        vec3 point;
        if (aim_slopes_at(aim, place, m) && aim_search(aim, m, place, &point))
            count = found_add(found, count, aim, ray, place, point);
    }
    return count;
}

int parametric_cell_cross(const struct parametric *surface,
                          const struct parametric_cell *cell,
                          const struct ray *ray, int *looks_left,
                          double found[PARAMETRIC_CROSSINGS][3])
{
    struct aim aim = aim_new(surface, cell, ray);
    aim.looks_left = looks_left;
    double m[2][2], off[2], place[2];
    vec3 point;
    aim_slopes(&aim, m);
    aim_off(&aim, cell->centre, off);
    /* How far the bend may move a crossing: by the inverse of m. */
    double det = fabs(m[0][0] * m[1][1] - m[0][1] * m[1][0]);
    double doubt[2] = { cell->bend * (fabs(m[0][1]) + fabs(m[1][1])) / det,
                        cell->bend * (fabs(m[0][0]) + fabs(m[1][0])) / det };
    bool sure = doubt[0] < 0.3 && doubt[1] < 0.3 && solve(m, off, place);
    if (!sure) {
        double reach = cell->bend + fabs(m[0][0]) + fabs(m[0][1]);
        double other = cell->bend + fabs(m[1][0]) + fabs(m[1][1]);
        bool near = fabs(off[0]) <= reach && fabs(off[1]) <= other;
        return near ? cell_graze(&aim, ray, found) : 0;
    }
    for (int k = 0; k < 2; k++) {
        place[k] = -place[k];
        if (fabs(place[k]) > 1.001 + 2 * doubt[k])
            return 0;
        place[k] = fmin(fmax(place[k], -1), 1);
    }
    return aim_search(&aim, m, place, &point)
               ? found_add(found, 0, &aim, ray, place, point)
               : cell_graze(&aim, ray, found);
}
