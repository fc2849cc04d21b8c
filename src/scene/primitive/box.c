/* box { CORNER, OPPOSITE_CORNER }, its sides along the axes. */
#include "scene/primitive.h"

struct box {
    vec3 low, high;
};

static const struct field box_arguments[] = {
    { "corner", FIELD_VECTOR, offsetof(struct box, low), 0, 0, "a corner",
      false },
    { "opposite corner", FIELD_VECTOR, offsetof(struct box, high), 0, 0,
      "the corner opposite to it", false },
    { .name = NULL },
};

static const char *box_prepare(void *shape, struct arena *arena,
                               const char **warning)
{
    struct box *box = shape;
    vec3 a = box->low, b = box->high;
    (void)arena;
    (void)warning;
    box->low = vec3_min(a, b);
    box->high = vec3_max(a, b);
    return NULL;
}

static struct box3 box_bounds(const void *shape)
{
    const struct box *box = shape;
    return (struct box3){ box->low, box->high };
}

static bool box_move(void *shape, const affine *outward, const affine *inward)
{
    struct box *box = shape;
    (void)inward;
    if (!affine_is_along_axes(*outward))
        return false;
    box->low = affine_point(outward, box->low);
    box->high = affine_point(outward, box->high);
    return true;
}

/* The interval of the ray between two parallel sides (Kay and Kajiya 1986).
 * `part` of a hit is axis * 2, + 1 for the high side. */
struct interval {
    double enter, leave;
    int enter_part, leave_part;
};

/* Both sides' crossings are one division of two numbers. */
typedef double crossings __attribute__((vector_size(2 * sizeof(double))));

/* A ray along the sides is in the slab from end to end, or nowhere: then no
 * number is before where it leaves. */
static inline void clip_to_slab(struct interval *interval, double origin,
                                double direction, double low, double high,
                                int part)
{
    crossings to = { low - origin, high - origin };
    if (direction == 0) {
        if (!(origin >= low && origin <= high))
            interval->leave = (double)NAN;
        return;
    }
    to /= (crossings){ direction, direction };
    bool swap = to[0] > to[1];
    double enter = swap ? to[1] : to[0], leave = swap ? to[0] : to[1];
    if (enter > interval->enter) {
        interval->enter = enter;
        interval->enter_part = part + swap;
    }
    if (leave < interval->leave) {
        interval->leave = leave;
        interval->leave_part = part + !swap;
    }
}

static bool box_clip(const struct box *box, const struct ray *ray,
                     struct interval *in)
{
    vec3 o = ray->origin, d = ray->direction, a = box->low, b = box->high;
    *in = (struct interval){ -HUGE_VAL, HUGE_VAL, 0, 0 };
    clip_to_slab(in, o.x, d.x, a.x, b.x, 0);
    clip_to_slab(in, o.y, d.y, a.y, b.y, 2);
    clip_to_slab(in, o.z, d.z, a.z, b.z, 4);
    return in->enter <= in->leave;
}

static void box_intersect(const void *shape, const struct ray *ray,
                          struct hits *hits)
{
    struct interval in;
    if (!box_clip(shape, ray, &in))
        return;
    hits_add(hits, in.enter, in.enter_part);
    hits_add(hits, in.leave, in.leave_part);
}

static bool box_crosses(const void *shape, const struct ray *ray, double tmin,
                        double tmax)
{
    struct interval in;
    return box_clip(shape, ray, &in) && ((in.enter > tmin && in.enter < tmax) ||
                                         (in.leave > tmin && in.leave < tmax));
}

static bool box_first(const void *shape, const struct ray *ray, double tmin,
                      double tmax, struct hit *hit)
{
    struct interval in;
    if (!box_clip(shape, ray, &in))
        return false;
    *hit = in.enter > tmin ? (struct hit){ in.enter, in.enter_part, 0, 0 }
                           : (struct hit){ in.leave, in.leave_part, 0, 0 };
    return hit->t > tmin && hit->t < tmax;
}

/* The same side by side. `missed`: it is along a slab that it is outside of. */
struct interval_lane {
    double enter, leave;
    double enter_part, leave_part; /* as wide as the others */
    bool missed;
};

static inline void lane_to_slab(struct interval_lane *in, double origin,
                                double direction, double low, double high,
                                double part)
{
    double a = (low - origin) / direction, b = (high - origin) / direction;
    bool along = direction == 0, swap = a > b;
    double enter = swap ? b : a, leave = swap ? a : b;
    double turned = swap ? 1 : 0;
    bool later = !along & (enter > in->enter);
    bool sooner = !along & (leave < in->leave);
    in->missed |= along & !((origin >= low) & (origin <= high));
    in->enter = later ? enter : in->enter;
    in->leave = sooner ? leave : in->leave;
    in->enter_part = later ? part + turned : in->enter_part;
    in->leave_part = sooner ? part + 1 - turned : in->leave_part;
}

static inline struct interval_lane lane_clip(const struct box *box,
                                             const struct rays *rays, int i)
{
    vec3 o = rays_origin(rays, i), d = rays_direction(rays, i);
    vec3 a = box->low, b = box->high;
    struct interval_lane in = { -HUGE_VAL, HUGE_VAL, 0, 0, false };
    lane_to_slab(&in, o.x, d.x, a.x, b.x, 0);
    lane_to_slab(&in, o.y, d.y, a.y, b.y, 2);
    lane_to_slab(&in, o.z, d.z, a.z, b.z, 4);
    in.missed |= !(in.enter <= in.leave);
    return in;
}

CLONES static void box_crosses_many(const void *shape, struct lane_run run,
                                    const struct rays *restrict rays,
                                    const struct rays_span *restrict span,
                                    lane_flag *restrict met)
{
    const struct box box = *(const struct box *)shape;
    EACH_LANE(i, run) {
        struct interval_lane in = lane_clip(&box, rays, i);
        double near = span->near[i], far = span->far[i];
        bool either = ((in.enter > near) & (in.enter < far)) |
                      ((in.leave > near) & (in.leave < far));
        met[i] = (!in.missed & either) ? -1 : 0;
    }
}

CLONES static void box_all_many(const void *shape, struct lane_run run,
                                const struct rays *restrict rays,
                                struct rays_crossings *restrict all)
{
    const struct box box = *(const struct box *)shape;
    all->count = 2;
    EACH_LANE(i, run) {
        struct interval_lane in = lane_clip(&box, rays, i);
        all->t[0][i] = in.missed ? (double)INFINITY : in.enter;
        all->t[1][i] = in.missed ? (double)INFINITY : in.leave;
        all->part[0][i] = in.enter_part;
        all->part[1][i] = in.leave_part;
    }
}

static vec3 box_normal(const void *shape, const vec3 *at, const struct hit *hit)
{
    static const vec3 sides[6] = { { -1, 0, 0 }, { 1, 0, 0 },  { 0, -1, 0 },
                                   { 0, 1, 0 },  { 0, 0, -1 }, { 0, 0, 1 } };
    (void)shape;
    (void)at;
    return sides[hit->part];
}

static bool box_inside(const void *shape, vec3 point)
{
    const struct box *box = shape;
    return box3_contains((struct box3){ box->low, box->high }, point);
}

CLONES static void box_inside_many(const void *shape, struct lane_run run,
                                   const struct lane_points *restrict points,
                                   lane_flag *restrict inside)
{
    const struct box box = *(const struct box *)shape;
    EACH_LANE(i, run)
        inside[i] = box3_contains((struct box3){ box.low, box.high },
                                  lane_get(points->at, i))
                        ? -1
                        : 0;
}

static unsigned box_meets(const void *shape, const struct cell *cell)
{
    const struct box *box = shape;
    struct box3 all = { box->low, box->high }, around = cell_box(cell);
    bool within = around.low.x > all.low.x && around.high.x < all.high.x &&
                  around.low.y > all.low.y && around.high.y < all.high.y &&
                  around.low.z > all.low.z && around.high.z < all.high.z;
    return within || !cell_meets_box(cell, all) ? 0
                                                : CELL_SURFACE | CELL_BORDER;
}

static int box_patches(const void *shape, struct patch *patches)
{
    const struct box *box = shape;
    vec3 d = vec3_sub(box->high, box->low);
    vec3 x = { d.x, 0, 0 }, y = { 0, d.y, 0 }, z = { 0, 0, d.z };
    vec3 edges[3][2] = { { y, z }, { z, x }, { x, y } };
    for (int i = 0; i < 6; i++)
        patches[i] = (struct patch){
            .kind = PATCH_PARALLELOGRAM,
            .at = i % 2 ? vec3_sub(vec3_sub(box->high, edges[i / 2][0]),
                                   edges[i / 2][1])
                        : box->low,
            .a = edges[i / 2][0],
            .b = edges[i / 2][1],
        };
    return 6;
}

/* A cross of six squares, four in a row: -x, +z, +x, -z from the left, -y below
 * and +y above the second (measured). */
static void box_uv(const void *shape, vec3 point, double uv[2])
{
    const struct box *box = shape;
    vec3 size = vec3_sub(box->high, box->low), p = vec3_sub(point, box->low);
    double a = p.x / size.x, b = p.y / size.y, c = p.z / size.z;
    const double away[6] = { fabs(a * size.x),       fabs((1 - c) * size.z),
                             fabs((1 - a) * size.x), fabs(c * size.z),
                             fabs(b * size.y),       fabs((1 - b) * size.y) };
    int side = 0;
    for (int i = 1; i < 6; i++)
        if (away[i] < away[side])
            side = i;
    const double across[6] = { c, 1 + a, 3 - c, 4 - a, 1 + a, 1 + a };
    const double up[6] = { 1 + b, 1 + b, 1 + b, 1 + b, c, 3 - c };
    uv[0] = across[side] / 4;
    uv[1] = up[side] / 3;
}

const struct primitive box_primitive = {
    .name = "box",
    .help = "a box with its sides along the axes",
    .size = sizeof(struct box),
    .arguments = box_arguments,
    .solid = true,
    .convex = true,
    .prepare = box_prepare,
    .bounds = box_bounds,
    .move = box_move,
    .intersect = box_intersect,
    .crosses = box_crosses,
    .first = box_first,
    .crosses_many = box_crosses_many,
    .all_many = box_all_many,
    .normal = box_normal,
    .uv = box_uv,
    .inside = box_inside,
    .inside_many = box_inside_many,
    .meets = box_meets,
    .patches = box_patches,
};
