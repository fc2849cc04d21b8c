/* Warps, as measured with POV-Ray 3.7: see warp.h. */
#include "scene/warp.h"

#include <string.h>

#include "base/octet_math.h"
#include "scene/noise.h"
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

/* Of each x and z: round the axis, 0 to 1, into turns, and from it. */
CLONES static void spots_round(const struct spots *restrict spots,
                               double *restrict turns, double *restrict round)
{
    for (int i = 0; i < spots->count; i++) {
        double x = spots->x[i], z = spots->z[i];
        round[i] = sqrt(x * x + z * z);
        turns[i] = z;
    }
    numbers_atan2(turns, spots->x, spots->count);
    for (int i = 0; i < spots->count; i++) {
        double turn = turns[i] / (2 * M_PI);
        turns[i] = turn < 0 ? turn + 1 : turn;
    }
}

/* Each y becomes from pole to pole of a half circle, `out` from whose middle it
 * is, or of one that is whole, 0 to 1; `far` is how far it is from there. */
CLONES static void spots_poles(struct spots *restrict spots, bool whole,
                               const double *restrict out, double *restrict far)
{
    const double all = whole ? 2 * M_PI : M_PI;
    for (int i = 0; i < spots->count; i++)
        far[i] = sqrt(out[i] * out[i] + spots->y[i] * spots->y[i]);
    numbers_atan2(spots->y, out, spots->count);
    for (int i = 0; i < spots->count; i++)
        spots->y[i] = 0.5 + spots->y[i] / all;
}

/* Round the axis and along it or from pole to pole, both 0 to 1, and the
 * distance from the middle, which may stretch the first two. */
static void spots_lay(const struct warp *warp, struct spots *spots)
{
    double turns[SPOTS_MAX], out[SPOTS_MAX], far[SPOTS_MAX];
    spots_round(spots, turns, out);
    memcpy(far, out, sizeof far);
    if (warp->kind == WARP_TOROIDAL)
        for (int i = 0; i < spots->count; i++)
            out[i] -= warp->major;
    if (warp->kind != WARP_CYLINDRICAL)
        spots_poles(spots, warp->kind == WARP_TOROIDAL, out, far);
    memcpy(spots->x, turns, sizeof turns);
    memcpy(spots->z, far, sizeof far);
    for (int i = 0; warp->stretch != 0 && i < spots->count; i++) {
        double factor = pow(far[i], warp->stretch);
        spots->x[i] *= factor;
        spots->y[i] *= warp->kind == WARP_CYLINDRICAL ? 1 : factor;
    }
}

/* Likewise, or onto a plane, and turned. */
static void spots_laid(const struct warp *warp, struct spots *spots)
{
    if (warp->kind != WARP_PLANAR)
        spots_lay(warp, spots);
    for (int i = 0; i < spots->count; i++) {
        vec3 at = spots_at(spots, i);
        if (warp->kind == WARP_PLANAR)
            at.z = warp->distance;
        spots_put(spots, i, warp_turned(warp->orientation, at));
    }
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
    struct spots alone;
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
        alone = spots_of(point);
        spots_laid(warp, &alone);
        return spots_at(&alone, 0);
    }
}

/* What is made of all points at once; of others one by one. */
static void spots_bent(const struct warp *warp, struct spots *spots)
{
    switch (warp->kind) {
    case WARP_TURBULENCE:
        noise_vectors_stir(spots, &warp->turbulence);
        break;
    case WARP_CYLINDRICAL:
    case WARP_SPHERICAL:
    case WARP_TOROIDAL:
    case WARP_PLANAR:
        spots_laid(warp, spots);
        break;
    default:
        for (int i = 0; i < spots->count; i++)
            spots_put(spots, i, warp_bent(warp, spots_at(spots, i)));
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
        spots_bent(warp, &bent);
        spots_moved(&bent, &warp->inverse, spots);
    }
}
