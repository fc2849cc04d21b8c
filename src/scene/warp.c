/* Warps, as measured with POV-Ray 3.7: see warp.h. */
#include "scene/warp.h"

#include "scene/noise.h"
#include "scene/ray.h"
#include "scene/spots.h"

static vec3 warp_repeat(const struct warp *warp, vec3 point)
{
    double at[3] = { point.x, point.y, point.z };
    const double period[3] = { warp->period.x, warp->period.y, warp->period.z };
    const double flip[3] = { warp->flip.x, warp->flip.y, warp->flip.z };
    int axis = period[0] != 0 ? 0 : period[1] != 0 ? 1 : 2;
    double width = period[axis], count = floor(at[axis] / width);
    at[axis] -= count * width;
    bool odd = fmod(count, 2) != 0;
    for (int i = 0; odd && i < 3; i++)
        if (flip[i] != 0)
            at[i] = (i == axis ? width : 0) - at[i];
    return vec3_along(vec3_make(at[0], at[1], at[2]), warp->offset, count);
}

/* Along one axis the middle of the hole of the cell; the first does not begin
 * below 0, and a cell is at least as wide as where that ends, however it moves
 * at random (measured). */
static double hole_middle(const struct warp *warp, int axis, double at,
                          double *number)
{
    double centre = vec3_component(warp->centre, axis);
    double period = vec3_component(warp->period, axis);
    double most = fmax(0, vec3_component(warp->turbulence.amount, axis));
    *number = 0;
    if (!(period > 0))
        return centre;
    double first = fmax(centre, warp->radius);
    period = fmax(period, first + warp->radius + most);
    *number = floor(at / period);
    return first + *number * period;
}

static vec3 warp_black_hole(const struct warp *warp, vec3 point)
{
    vec3 c = warp->centre, period = warp->period;
    double radius = warp->radius;
    double number[3];
    c = vec3_make(hole_middle(warp, 0, point.x, &number[0]),
                  hole_middle(warp, 1, point.y, &number[1]),
                  hole_middle(warp, 2, point.z, &number[2]));
    bool repeated = period.x > 0 || period.y > 0 || period.z > 0;
    if (repeated && vec3_length(warp->turbulence.amount) > 0)
        c = vec3_add(
            c, vec3_mul(warp->turbulence.amount,
                        noise_cell_point(number[0], number[1], number[2])));
    vec3 away = vec3_sub(point, c);
    double distance = vec3_length(away);
    if (!(distance < radius))
        return point;
    double pull = pow(1 - distance / radius, warp->falloff) * warp->strength;
    pull = pull > 1 ? 1 : pull;
    return vec3_along(point, away, warp->push ? -pull : pull);
}

/* The middle of the pattern's third axis along the orientation: a sum of what
 * is for each axis, and so no rotation for others. */
static vec3 warp_turned(vec3 orientation, vec3 p)
{
    vec3 x = { p.z, p.y, -p.x }, y = { p.x, -p.z, p.y };
    vec3 sum = vec3_scale(p, orientation.z);
    sum = vec3_along(sum, x, orientation.x);
    return vec3_along(sum, y, orientation.y);
}

/* Round the axis and along it or from pole to pole, both 0 to 1, and the
 * distance from the middle, which may stretch the first two. */
static vec3 warp_laid(const struct warp *warp, vec3 p)
{
    double round = hypot(p.x, p.z), ring = round - warp->major;
    vec3 laid = { ray_turn(p.x, p.z), p.y, round };
    if (warp->kind == WARP_PLANAR)
        return vec3_make(p.x, p.y, warp->distance);
    if (warp->kind == WARP_SPHERICAL) {
        laid.y = 0.5 + atan2(p.y, round) / M_PI;
        laid.z = vec3_length(p);
    } else if (warp->kind == WARP_TOROIDAL) {
        laid.y = 0.5 + atan2(p.y, ring) / (2 * M_PI);
        laid.z = hypot(ring, p.y);
    }
    if (warp->stretch == 0)
        return laid;
    double factor = pow(laid.z, warp->stretch);
    laid.x *= factor;
    laid.y *= warp->kind == WARP_CYLINDRICAL ? 1 : factor;
    return laid;
}

/* The middle of a side's square in a cross that is 1 wide and high, and how far
 * a turn goes along it. */
static vec3 cross_place(double column, double row, double u, double v, double w)
{
    return vec3_make((2 * column + 1 + u / w) / 8, (2 * row + 1 + v / w) / 6,
                     w);
}

/* Six squares in a cross, the sides -x, z, x, -z in its middle row, y above z
 * and -y below: a place in it, and the largest coordinate. */
static vec3 warp_cubic(vec3 p)
{
    vec3 size = { fabs(p.x), fabs(p.y), fabs(p.z) };
    double most = fmax(size.x, fmax(size.y, size.z));
    if (most == 0)
        return p;
    if (p.x >= most)
        return cross_place(2, 1, -p.z, p.y, most);
    if (p.y >= most)
        return cross_place(1, 2, p.x, -p.z, most);
    if (p.z >= most)
        return cross_place(1, 1, p.x, p.y, most);
    if (-p.x >= most)
        return cross_place(0, 1, p.z, p.y, most);
    if (-p.y >= most)
        return cross_place(1, 0, p.x, p.z, most);
    return cross_place(3, 1, -p.x, p.y, most);
}

/* What it makes of a point, before what was moved before it. */
static vec3 warp_bent(const struct warp *warp, vec3 point)
{
    switch (warp->kind) {
    case WARP_TURBULENCE:
        return vec3_add(
            point, vec3_mul(warp->turbulence.amount,
                            noise_vector_turbulence(point, &warp->turbulence)));
    case WARP_REPEAT:
        return warp_repeat(warp, point);
    case WARP_BLACK_HOLE:
        return warp_black_hole(warp, point);
    case WARP_CUBIC:
        return warp_cubic(point);
    default:
        return warp_turned(warp->orientation, warp_laid(warp, point));
    }
}

vec3 warp_all(const struct warp *warp, vec3 point)
{
    for (; warp; warp = warp->inner)
        point = affine_point(&warp->inverse, warp_bent(warp, point));
    return point;
}

void warps_move(const struct warp *warp, struct spots *spots)
{
    for (; warp; warp = warp->inner) {
        struct spots bent = *spots;
        if (warp->kind == WARP_TURBULENCE)
            noise_vectors_stir(&bent, &warp->turbulence);
        else
            for (int i = 0; i < bent.count; i++)
                spots_put(&bent, i, warp_bent(warp, spots_at(&bent, i)));
        spots_moved(&bent, &warp->inverse, spots);
    }
}
