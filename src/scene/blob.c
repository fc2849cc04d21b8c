/* Densities along rays are polynomials of the fourth degree, piece by piece:
 * see blob.h. */
#include "scene/blob.h"

#include <stdlib.h>

#include "base/warp.h"
#include "scene/blob_tree.h"
#include "scene/crossings.h"
#include "scene/polynomial.h"

enum {
    STRETCHES_MAX = 1024, /* parts that one line may meet; more are left out */
    STRETCHES_FEW = 24,   /* to be sorted by hand */
};

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
    (void)warning;
    blob->bounds = box3_empty();
    for (size_t i = 0; i < count; i++)
        if (parts[i].strength > 0)
            blob->bounds = box3_union(blob->bounds, blob_part_box(&parts[i]));
    blob->tree = blob_tree_new(arena, parts, count);
    return blob->threshold > 0 ? NULL : "its threshold must be above 0";
}

static struct box3 blob_bounds(const void *shape)
{
    const struct blob *blob = shape;
    return blob->bounds;
}

/* From the part's middle line to a point, both in its space. */
static vec3 part_offset(const struct blob_part *part, vec3 p)
{
    double z = p.z < part->length ? p.z : part->length;
    p.z -= z > 0 ? z : 0;
    return p;
}

/* Calls visit for the parts that have a density at the point: how far it is
 * from the middle line in the part's space, and 1 less that squared. */
typedef void part_visit(void *context, const struct blob_part *part,
                        vec3 offset, double rest);

static void blob_visit(const struct blob *blob, vec3 point, part_visit *visit,
                       void *context)
{
    const struct blob_tree *tree = blob->tree;
    const struct blob_node *leaf = blob_tree_leaf_at(tree, 0, point);
    for (; leaf; leaf = blob_tree_leaf_at(tree, leaf->next, point)) {
        for (uint32_t i = leaf->first; i < leaf->first + leaf->count; i++) {
            const struct blob_part *part = &tree->bodies[i].part;
            vec3 d = part_offset(part, affine_point(&part->inward, point));
            double rest = 1 - vec3_dot(d, d);
            if (rest > 0)
                visit(context, part, d, rest);
        }
    }
}

void blob_densities(const struct blob *blob, vec3 point,
                    blob_density_visit *visit, void *context)
{
    const struct blob_tree *tree = blob->tree;
    const struct blob_node *leaf = blob_tree_leaf_at(tree, 0, point);
    for (; leaf; leaf = blob_tree_leaf_at(tree, leaf->next, point))
        for (uint32_t i = leaf->first; i < leaf->first + leaf->count; i++) {
            const struct blob_body *body = &tree->bodies[i];
            vec3 d = part_offset(&body->part,
                                 affine_point(&body->part.inward, point));
            double rest = 1 - vec3_dot(d, d);
            if (rest > 0)
                visit(context, body->number, body->part.strength * rest * rest);
        }
}

static void add_density(void *context, const struct blob_part *part,
                        vec3 offset, double rest)
{
    (void)offset;
    *(double *)context += part->strength * rest * rest;
}

static bool blob_inside(const void *shape, vec3 point)
{
    const struct blob *blob = shape;
    double density = 0;
    blob_visit(blob, point, add_density, &density);
    return density > blob->threshold;
}

static void add_slope(void *context, const struct blob_part *part, vec3 offset,
                      double rest)
{
    vec3 *sum = context;
    *sum = vec3_along(*sum, affine_normal(&part->inward, offset),
                      part->strength * rest);
}

/* Against the density's slope. */
static vec3 blob_normal(const void *shape, vec3 point, const struct hit *hit)
{
    vec3 sum = { 0, 0, 0 };
    (void)hit;
    blob_visit(shape, point, add_slope, &sum);
    return vec3_dot(sum, sum) > 0 ? sum : vec3_make(0, 1, 0);
}

/* ---- rays ---- */

/* Between low and high a part's density is strength q^2, where
 * q = most - a (t - nearest)^2: in this form no digits are lost. */
struct stretch {
    double low, high, strength, a, nearest, most;
};

struct stretches {
    double tmin, tmax; /* what is wanted of the ray */
    int count;
    struct stretch items[STRETCHES_MAX];
};

/* The part of the line where its q is positive, between its limits. */
static void stretch_add(struct stretches *all, struct stretch wanted)
{
    double low = wanted.low, high = wanted.high, nearest = wanted.nearest;
    if (!(wanted.most > 0) || all->count == STRETCHES_MAX)
        return;
    if (wanted.a > 0) {
        double half = sqrt(wanted.most / wanted.a);
        low = low > nearest - half ? low : nearest - half;
        high = high < nearest + half ? high : nearest + half;
    }
    wanted.low = low > all->tmin ? low : all->tmin;
    wanted.high = high < all->tmax ? high : all->tmax;
    if (wanted.low < wanted.high)
        all->items[all->count++] = wanted;
}

/* A ball of radius 1 around the origin. */
static void ball_stretch(struct stretches *all, double strength, vec3 o, vec3 d,
                         double low, double high)
{
    double a = vec3_dot(d, d), nearest = -vec3_dot(o, d) / a;
    vec3 p = vec3_along(o, d, nearest);
    stretch_add(all, (struct stretch){ low, high, strength, a, nearest,
                                       1 - vec3_dot(p, p) });
}

/* The round ends below 0 and beyond the length, and what is between them. */
static void cylinder_stretches(struct stretches *all,
                               const struct blob_part *part, vec3 o, vec3 d)
{
    double top = o.z - part->length, in = -o.z / d.z, out = -top / d.z;
    bool up = d.z > 0;
    if (d.z == 0) {
        in = o.z < 0 ? HUGE_VAL : -HUGE_VAL;
        out = top > 0 ? -HUGE_VAL : HUGE_VAL;
        up = true;
    }
    ball_stretch(all, part->strength, o, d, up ? -HUGE_VAL : in,
                 up ? in : HUGE_VAL);
    double a = d.x * d.x + d.y * d.y;
    double nearest = a > 0 ? -(o.x * d.x + o.y * d.y) / a : 0;
    double x = o.x + nearest * d.x, y = o.y + nearest * d.y;
    stretch_add(all,
                (struct stretch){ fmin(in, out), fmax(in, out), part->strength,
                                  a, nearest, 1 - x * x - y * y });
    o.z = top;
    ball_stretch(all, part->strength, o, d, up ? out : -HUGE_VAL,
                 up ? HUGE_VAL : out);
}

static void body_stretches(struct stretches *all, const struct blob_body *body,
                           const struct ray *ray)
{
    const struct blob_part *part = &body->part;
    if (body->round) {
        vec3 o = vec3_sub(ray->origin, body->centre), d = ray->direction;
        double square = vec3_dot(d, d), nearest = -vec3_dot(o, d) / square;
        vec3 p = vec3_along(o, d, nearest);
        stretch_add(all,
                    (struct stretch){ -HUGE_VAL, HUGE_VAL, part->strength,
                                      square * body->inverse, nearest,
                                      1 - vec3_dot(p, p) * body->inverse });
        return;
    }
    vec3 o = affine_point(&part->inward, ray->origin);
    vec3 d = affine_direction(&part->inward, ray->direction);
    if (part->length > 0)
        cylinder_stretches(all, part, o, d);
    else
        ball_stretch(all, part->strength, o, d, -HUGE_VAL, HUGE_VAL);
}

static int stretch_order(const void *a, const void *b)
{
    const struct stretch *x = a, *y = b;
    return (x->low > y->low) - (x->low < y->low);
}

static void stretches_sort(struct stretches *all)
{
    if (all->count > STRETCHES_FEW) {
        qsort(all->items, (size_t)all->count, sizeof *all->items,
              stretch_order);
        return;
    }
    for (int i = 1; i < all->count; i++) {
        struct stretch s = all->items[i];
        int k = i;
        for (; k > 0 && all->items[k - 1].low > s.low; k--)
            all->items[k] = all->items[k - 1];
        all->items[k] = s;
    }
}

/* Those that there are at some place of the ray, as it goes along. */
struct sweep {
    const struct stretch *now[STRETCHES_MAX];
    int count;
    double at;
    bool known;  /* the ray was followed to there: */
    double last; /* the density there less the threshold */
};

/* Takes out what ends here, and returns where the next one does. */
static double sweep_end(struct sweep *sweep)
{
    double end = HUGE_VAL;
    int kept = 0;
    for (int i = 0; i < sweep->count; i++) {
        const struct stretch *s = sweep->now[i];
        if (!(s->high > sweep->at))
            continue;
        sweep->now[kept++] = s;
        end = s->high < end ? s->high : end;
    }
    sweep->count = kept;
    return end;
}

/* The density less the threshold as Bernstein polynomials over a piece: the
 * product of two of the second degree each. Its sign where the piece begins is
 * what it was where the last one ended. */
static int sweep_piece(struct sweep *sweep, double threshold, double end,
                       double *roots)
{
    double width = end - sweep->at;
    double b[5] = { -threshold, -threshold, -threshold, -threshold,
                    -threshold };
    for (int i = 0; i < sweep->count; i++) {
        const struct stretch *s = sweep->now[i];
        double from = sweep->at - s->nearest, to = end - s->nearest;
        double q0 = s->most - s->a * from * from;
        double q1 = q0 - s->a * from * width;
        double q2 = s->most - s->a * to * to;
        b[0] += s->strength * q0 * q0;
        b[1] += s->strength * q0 * q1;
        b[2] += s->strength * (2 * q1 * q1 + q0 * q2) * (1.0 / 3);
        b[3] += s->strength * q1 * q2;
        b[4] += s->strength * q2 * q2;
    }
    if (sweep->known && (b[0] < 0) != (sweep->last < 0))
        b[0] = sweep->last;
    sweep->last = b[4];
    return polynomial_bernstein_roots(b, 4, roots);
}

static void sweep_stretches(struct stretches *all, double threshold,
                            hit_visit *visit, void *context)
{
    struct sweep sweep;
    int next = 0;
    sweep.count = 0;
    sweep.last = -1;
    while (sweep.count > 0 || next < all->count) {
        double roots[2 * BERNSTEIN_DEGREE];
        if (sweep.count == 0)
            sweep.at = all->items[next].low;
        for (; next < all->count && all->items[next].low <= sweep.at; next++)
            sweep.now[sweep.count++] = &all->items[next];
        double end = sweep_end(&sweep);
        if (next < all->count && all->items[next].low < end)
            end = all->items[next].low;
        if (sweep.count == 0) {
            sweep.last = -1;
            continue;
        }
        sweep.known = sweep.at > all->tmin;
        int count = sweep_piece(&sweep, threshold, end, roots);
        for (int i = 0; i < count; i++) {
            double t = sweep.at + (end - sweep.at) * roots[i];
            struct hit hit = { t, 0, 0, 0 };
            if (t > all->tmin && t < all->tmax && visit(context, &hit))
                return;
        }
        sweep.at = end;
    }
}

static void blob_crossings(const void *shape, const struct ray *ray,
                           double tmin, double tmax, hit_visit *visit,
                           void *context)
{
    const struct blob *blob = shape;
    const struct blob_tree *tree = blob->tree;
    struct slabs slabs = slabs_of(ray);
    struct stretches all;
    all.tmin = tmin;
    all.tmax = tmax;
    all.count = 0;
    const struct blob_node *leaf = blob_tree_leaf(tree, 0, &slabs, tmin, tmax);
    for (; leaf; leaf = blob_tree_leaf(tree, leaf->next, &slabs, tmin, tmax))
        for (uint32_t i = leaf->first; i < leaf->first + leaf->count; i++)
            body_stretches(&all, &tree->bodies[i], ray);
    stretches_sort(&all);
    sweep_stretches(&all, blob->threshold, visit, context);
}

static bool blob_first(const void *shape, const struct ray *ray, double tmin,
                       double tmax, struct hit *hit)
{
    return crossings_first(blob_crossings, shape, ray, tmin, tmax, hit);
}

static bool blob_crosses(const void *shape, const struct ray *ray, double tmin,
                         double tmax)
{
    struct hit hit;
    return blob_first(shape, ray, tmin, tmax, &hit);
}

static void blob_intersect(const void *shape, const struct ray *ray,
                           struct hits *hits)
{
    crossings_all(blob_crossings, shape, ray, hits);
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
    .crossings = blob_crossings,
    .first = blob_first,
    .crosses = blob_crosses,
    .normal = blob_normal,
    .inside = blob_inside,
};
