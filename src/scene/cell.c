/* Cells against points, boxes and triangles: see cell.h. */
#include "scene/cell.h"

static struct cell cell_finish(struct cell cell)
{
    const vec3 *s = cell.side;
    cell.half = (vec3){ fabs(s[0].x) + fabs(s[1].x) + fabs(s[2].x),
                        fabs(s[0].y) + fabs(s[1].y) + fabs(s[2].y),
                        fabs(s[0].z) + fabs(s[1].z) + fabs(s[2].z) };
    double square = 0;
    for (int i = 0; i < 4; i++) {
        vec3 d = vec3_along(s[0], s[1], i & 1 ? -1 : 1);
        d = vec3_along(d, s[2], i & 2 ? -1 : 1);
        square = fmax(square, vec3_dot(d, d));
    }
    cell.radius = sqrt(square);
    return cell;
}

struct cell cell_from_box(vec3 centre, vec3 half)
{
    struct cell cell = {
        centre,
        { { half.x, 0, 0 }, { 0, half.y, 0 }, { 0, 0, half.z } },
        half,
        vec3_length(half)
    };
    return cell;
}

struct cell cell_moved(const struct cell *cell, const affine *transform)
{
    struct cell moved;
    moved.centre = affine_point(transform, cell->centre);
    for (int i = 0; i < 3; i++)
        moved.side[i] = affine_direction(transform, cell->side[i]);
    return cell_finish(moved);
}

struct box3 cell_box(const struct cell *cell)
{
    return (struct box3){ vec3_sub(cell->centre, cell->half),
                          vec3_add(cell->centre, cell->half) };
}

vec3 cell_corner(const struct cell *cell, int i)
{
    vec3 p = vec3_along(cell->centre, cell->side[0], i & 1 ? 1 : -1);
    p = vec3_along(p, cell->side[1], i & 2 ? 1 : -1);
    return vec3_along(p, cell->side[2], i & 4 ? 1 : -1);
}

/* At least the distance of the box around the cell (Arvo 1990), and at least
 * that of the plane that touches the cell across the line from the point to the
 * centre. */
double cell_nearest(const struct cell *cell, vec3 point)
{
    vec3 d = vec3_sub(cell->centre, point);
    vec3 out = { fmax(0, fabs(d.x) - cell->half.x),
                 fmax(0, fabs(d.y) - cell->half.y),
                 fmax(0, fabs(d.z) - cell->half.z) };
    double distance = vec3_length(d), near = vec3_length(out);
    return distance > 0 ? fmax(near, distance - cell_reach(cell, d) / distance)
                        : near;
}

double cell_farthest(const struct cell *cell, vec3 point)
{
    double square = 0;
    for (int i = 0; i < 8; i++) {
        vec3 corner = vec3_sub(cell_corner(cell, i), point);
        square = fmax(square, vec3_dot(corner, corner));
    }
    return sqrt(square);
}

bool cell_meets_box(const struct cell *cell, struct box3 box)
{
    if (box3_is_empty(box3_intersection(cell_box(cell), box)))
        return false;
    vec3 half = vec3_scale(vec3_sub(box.high, box.low), 0.5);
    vec3 d = vec3_sub(vec3_mix(box.low, box.high, 0.5), cell->centre);
    for (int i = 0; i < 3; i++) {
        vec3 n = vec3_cross(cell->side[i], cell->side[(i + 1) % 3]);
        double reach = fabs(n.x) * half.x + fabs(n.y) * half.y +
                       fabs(n.z) * half.z + cell_reach(cell, n);
        if (fabs(vec3_dot(n, d)) > reach)
            return false;
    }
    return true;
}

/* Whether the triangle's edges let the box through, seen along the axis that
 * `n`, the triangle's normal, is turned to by `axis` (Schwarz and Seidel 2010,
 * section 3, equations 4 to 6, about the box's centre). */
static bool edges_meet(const vec3 *p, vec3 n, vec3 half, int axis)
{
    int u = (axis + 1) % 3, v = (axis + 2) % 3;
    double sign = vec3_component(n, axis) >= 0 ? 1 : -1;
    double hu = vec3_component(half, u), hv = vec3_component(half, v);
    for (int i = 0; i < 3; i++) {
        vec3 a = p[i], b = p[(i + 1) % 3];
        double au = vec3_component(a, u), av = vec3_component(a, v);
        double nu = -sign * (vec3_component(b, v) - av);
        double nv = sign * (vec3_component(b, u) - au);
        if (-(nu * au + nv * av) + hu * fabs(nu) + hv * fabs(nv) < 0)
            return false;
    }
    return true;
}

bool cell_meets_triangle(const struct cell *cell, vec3 a, vec3 b, vec3 c)
{
    vec3 p[3] = { vec3_sub(a, cell->centre), vec3_sub(b, cell->centre),
                  vec3_sub(c, cell->centre) };
    vec3 half = cell->half;
    vec3 low = vec3_min(vec3_min(p[0], p[1]), p[2]);
    vec3 high = vec3_max(vec3_max(p[0], p[1]), p[2]);
    if (low.x > half.x || low.y > half.y || low.z > half.z ||
        high.x < -half.x || high.y < -half.y || high.z < -half.z)
        return false;
    vec3 n = vec3_cross(vec3_sub(p[1], p[0]), vec3_sub(p[2], p[0]));
    double reach = fabs(n.x) * half.x + fabs(n.y) * half.y + fabs(n.z) * half.z;
    return fabs(vec3_dot(n, p[0])) <= reach && edges_meet(p, n, half, 0) &&
           edges_meet(p, n, half, 1) && edges_meet(p, n, half, 2);
}
