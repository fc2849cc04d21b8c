/* Densities along rays are polynomials of the fourth degree, piece by piece:
 * see blob.h. */
#include "scene/blob.h"

#include <stdlib.h>

#include "base/warp.h"
#include "scene/polynomial.h"

/* Parts that one line may meet; more are left out. */
enum { STRETCHES_MAX = 256 };

static const struct field blob_fields[] = {
    { "parts", FIELD_TERMS, offsetof(struct blob, parts), 0, 0, "what adds up",
      false },
    { .name = NULL },
};

static const struct field blob_items[] = {
    { "threshold", FIELD_FLOAT, offsetof(struct blob, threshold), 0, 0,
      "the density of the surface, 1", false },
    { "sturm", FIELD_BOOL, offsetof(struct blob, ignored), 0, 0,
      "accepted and needless", false },
    { "hierarchy", FIELD_BOOL, offsetof(struct blob, ignored), 0, 0,
      "accepted and needless", false },
    { .name = NULL },
};

bool blob_part_make(struct blob_part *part, vec3 base, vec3 apex, double radius,
                    double strength)
{
    vec3 axis = vec3_sub(apex, base), x = { 1, 0, 0 }, y = { 0, 1, 0 };
    vec3 z = { 0, 0, 1 };
    double length = vec3_length(axis);
    if (length > 0) {
        z = vec3_scale(axis, 1 / length);
        warp_frame(z, &x, &y);
    }
    affine outward = { { { radius * x.x, radius * y.x, radius * z.x, base.x },
                         { radius * x.y, radius * y.y, radius * z.y, base.y },
                         { radius * x.z, radius * y.z, radius * z.z,
                           base.z } } };
    part->strength = strength;
    part->length = length / fabs(radius);
    return radius != 0 && affine_inverse(outward, &part->inward);
}

bool blob_part_move(struct blob_part *part, const affine *transform)
{
    affine inverse;
    if (!affine_inverse(*transform, &inverse))
        return false;
    part->inward = affine_compose(part->inward, inverse);
    return true;
}

static const struct blob_part *blob_parts(const struct blob *blob,
                                          size_t *count)
{
    *count = blob->parts.count / BLOB_NUMBERS;
    return (const struct blob_part *)(const void *)blob->parts.values;
}

static const char *blob_prepare(void *shape, struct arena *arena,
                                const char **warning)
{
    struct blob *blob = shape;
    size_t count;
    const struct blob_part *parts = blob_parts(blob, &count);
    (void)arena;
    (void)warning;
    blob->bounds = box3_empty();
    for (size_t i = 0; i < count; i++) {
        struct box3 box = { { -1, -1, -1 }, { 1, 1, 1 + parts[i].length } };
        affine outward;
        if (parts[i].strength > 0 && affine_inverse(parts[i].inward, &outward))
            blob->bounds = box3_union(blob->bounds, affine_box(&outward, box));
    }
    return blob->threshold > 0 ? NULL : "its threshold must be above 0";
}

static struct box3 blob_bounds(const void *shape)
{
    const struct blob *blob = shape;
    return blob->bounds;
}

/* Where a point of the part's space is from the part's middle line. */
static vec3 part_offset(const struct blob_part *part, vec3 p)
{
    p.z -= fmin(fmax(p.z, 0), part->length);
    return p;
}

static double blob_density(const struct blob *blob, vec3 point)
{
    size_t count;
    const struct blob_part *parts = blob_parts(blob, &count);
    double density = 0;
    for (size_t i = 0; i < count; i++) {
        vec3 d = part_offset(&parts[i], affine_point(&parts[i].inward, point));
        double rest = 1 - vec3_dot(d, d);
        if (rest > 0)
            density += parts[i].strength * rest * rest;
    }
    return density;
}

static bool blob_inside(const void *shape, vec3 point)
{
    const struct blob *blob = shape;
    return blob_density(blob, point) > blob->threshold;
}

/* Against the density's slope. */
static vec3 blob_normal(const void *shape, vec3 point, const struct hit *hit)
{
    const struct blob *blob = shape;
    size_t count;
    const struct blob_part *parts = blob_parts(blob, &count);
    vec3 sum = { 0, 0, 0 };
    (void)hit;
    for (size_t i = 0; i < count; i++) {
        const affine *inward = &parts[i].inward;
        vec3 d = part_offset(&parts[i], affine_point(inward, point));
        double rest = 1 - vec3_dot(d, d);
        if (rest > 0)
            sum = vec3_along(sum, affine_normal(inward, d),
                             parts[i].strength * rest);
    }
    return vec3_dot(sum, sum) > 0 ? sum : vec3_make(0, 1, 0);
}

/* Between low and high the density is strength (1 - (a t^2 + 2 b t + c))^2. */
struct stretch {
    double low, high, strength, a, b, c;
};

struct stretches {
    struct stretch items[STRETCHES_MAX];
    int count;
};

/* The part of the line nearer than 1 to an axis or a point, between limits. */
static void stretch_add(struct stretches *all, double strength, double a,
                        double b, double c, double low, double high)
{
    double roots[2];
    if (a > 0) {
        if (quadratic_roots(a, b, c - 1, roots) != 2)
            return;
        low = fmax(low, roots[0]);
        high = fmin(high, roots[1]);
    } else if (!(c < 1)) {
        return;
    }
    if (low < high && all->count < STRETCHES_MAX)
        all->items[all->count++] =
            (struct stretch){ low, high, strength, a, b, c };
}

/* A ball; or the round ends below 0 and beyond the length, and between them. */
static void part_stretches(const struct blob_part *part, const struct ray *ray,
                           struct stretches *all)
{
    vec3 o = affine_point(&part->inward, ray->origin);
    vec3 d = affine_direction(&part->inward, ray->direction);
    double strength = part->strength, length = part->length;
    double a = d.x * d.x + d.y * d.y, b = o.x * d.x + o.y * d.y;
    double c = o.x * o.x + o.y * o.y, top = o.z - length;
    double aa = a + d.z * d.z;
    if (length == 0) {
        stretch_add(all, strength, aa, b + o.z * d.z, c + o.z * o.z, -HUGE_VAL,
                    HUGE_VAL);
        return;
    }
    double in = -o.z / d.z, out = -top / d.z;
    bool up = d.z > 0;
    if (d.z == 0) {
        in = o.z < 0 ? HUGE_VAL : -HUGE_VAL;
        out = top > 0 ? -HUGE_VAL : HUGE_VAL;
        up = true;
    }
    stretch_add(all, strength, aa, b + o.z * d.z, c + o.z * o.z,
                up ? -HUGE_VAL : in, up ? in : HUGE_VAL);
    stretch_add(all, strength, a, b, c, fmin(in, out), fmax(in, out));
    stretch_add(all, strength, aa, b + top * d.z, c + top * top,
                up ? out : -HUGE_VAL, up ? HUGE_VAL : out);
}

static int order_number(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The density less the threshold between two ends of stretches, in t - middle,
 * which loses no digits; and where it changes its sign. */
static void blob_piece(const struct stretches *all, double threshold,
                       double low, double high, struct hits *hits)
{
    double middle = low + (high - low) / 2, sum[5] = { -threshold }, roots[4];
    for (int i = 0; i < all->count; i++) {
        const struct stretch *s = &all->items[i];
        if (!(s->low <= middle && middle <= s->high))
            continue;
        double q0 = 1 - ((s->a * middle + 2 * s->b) * middle + s->c);
        double q1 = -2 * (s->a * middle + s->b), q2 = -s->a;
        sum[0] += s->strength * q0 * q0;
        sum[1] += s->strength * 2 * q0 * q1;
        sum[2] += s->strength * (q1 * q1 + 2 * q0 * q2);
        sum[3] += s->strength * 2 * q1 * q2;
        sum[4] += s->strength * q2 * q2;
    }
    int count = polynomial_roots(sum, 4, low - middle, high - middle, roots, 4);
    for (int i = 0; i < count; i++)
        hits_add(hits, middle + roots[i], 0);
}

/* From near the blob, where numbers are small. */
static void blob_intersect(const void *shape, const struct ray *ray,
                           struct hits *hits)
{
    const struct blob *blob = shape;
    struct stretches all = { .count = 0 };
    double ends[2 * STRETCHES_MAX];
    size_t count;
    const struct blob_part *parts = blob_parts(blob, &count);
    vec3 centre =
        vec3_scale(vec3_add(blob->bounds.low, blob->bounds.high), 0.5);
    double shift = vec3_dot(vec3_sub(centre, ray->origin), ray->direction) /
                   vec3_dot(ray->direction, ray->direction);
    struct ray near = { ray_point(ray, shift), ray->direction };
    int first = hits->count;
    for (size_t i = 0; i < count; i++)
        part_stretches(&parts[i], &near, &all);
    for (int i = 0; i < all.count; i++) {
        ends[2 * i] = all.items[i].low;
        ends[2 * i + 1] = all.items[i].high;
    }
    qsort(ends, 2 * (size_t)all.count, sizeof *ends, order_number);
    for (int i = 1; i < 2 * all.count; i++)
        if (ends[i] > ends[i - 1])
            blob_piece(&all, blob->threshold, ends[i - 1], ends[i], hits);
    for (int i = first; i < hits->count; i++)
        hits->at[i].t += shift;
}

const struct primitive blob_primitive = {
    .name = "blob",
    .help = "balls and cylinders that flow together",
    .size = sizeof(struct blob),
    .arguments = blob_fields,
    .items = blob_items,
    .solid = true,
    .prepare = blob_prepare,
    .bounds = blob_bounds,
    .intersect = blob_intersect,
    .normal = blob_normal,
    .inside = blob_inside,
};
