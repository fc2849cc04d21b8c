/* Blobs: see blob.h. */
#include "scene/blob.h"

#include "base/warp.h"
#include "scene/blob_sweep.h"
#include "scene/crossings.h"
#include "scene/slab_rays.h"

enum { LANE_STRETCHES = 48 }; /* of each of rays side by side */

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

/* Where a part ends its density meets 0 with a double root, which rounding
 * finds or not: POV-Ray draws a threshold of 0 as specks. The surface just
 * within is whole. */
static double blob_least_threshold(double strength)
{
    const double just_within = 1e-9; /* of the density: 1.6e-5 of a radius */
    return just_within * strength;
}

static const char *blob_prepare(void *shape, struct arena *arena,
                                const char **warning)
{
    struct blob *blob = shape;
    size_t count;
    const struct blob_part *parts = blob_parts(blob, &count);
    double strongest = 0;
    if (blob->threshold < 0) {
        *warning = "its threshold is below 0, where it has no surface";
        return NULL;
    }
    blob->bounds = box3_empty();
    for (size_t i = 0; i < count; i++)
        if (parts[i].strength > 0) {
            blob->bounds = box3_union(blob->bounds, blob_part_box(&parts[i]));
            strongest = fmax(strongest, parts[i].strength);
        }
    if (blob->threshold == 0)
        blob->threshold = blob_least_threshold(strongest);
    blob->tree = blob_tree_new(arena, parts, count);
    return NULL;
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
static vec3 blob_normal(const void *shape, const vec3 *at,
                        const struct hit *hit)
{
    const vec3 point = *at;
    vec3 sum = { 0, 0, 0 };
    (void)hit;
    blob_visit(shape, point, add_slope, &sum);
    return vec3_dot(sum, sum) > 0 ? sum : vec3_make(0, 1, 0);
}

static void blob_crossings(const void *shape, const struct ray *ray,
                           double tmin, double tmax, hit_visit *visit,
                           void *context)
{
    const struct blob *blob = shape;
    struct stretch items[STRETCHES_MAX];
    struct stretches all = { tmin, tmax, 0, STRETCHES_MAX, items };
    struct blob_walk walk = blob_walk_of(blob->tree, ray, tmin, tmax);
    const struct blob_node *leaf = blob_walk_on(&walk);
    for (; leaf; leaf = blob_walk_on(&walk))
        stretches_add(&all, &blob->tree->bodies[leaf->first], leaf->count, ray);
    stretches_sweep(&all, blob->threshold, visit, context);
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

/* Rays side by side. */
struct blob_lanes {
    const struct blob *blob;
    const struct rays *rays;
    const struct rays_span *span;
    struct lane_run run;
    struct stretches of[RAY_LANES];
    struct stretch items[RAY_LANES][LANE_STRETCHES];
};

/* The body's stretches of the rays of the bits `lanes`. */
static void lanes_add_round(struct blob_lanes *lanes,
                            const struct blob_body *body, unsigned met)
{
    struct lane_stretches found;
    LANE_LINES lane_flag is[RAY_LANES];
    lane_stretches_of(body, lanes->rays, lanes->span, &found, is);
    for (met &= rays_bits(is); met; met &= met - 1) {
        unsigned i = (unsigned)__builtin_ctz(met);
        struct stretches *all = &lanes->of[i];
        if (all->count < all->limit)
            all->items[all->count++] =
                (struct stretch){ found.low[i],        found.high[i],
                                  body->part.strength, found.a[i],
                                  found.nearest[i],    found.most[i] };
    }
}

static void lanes_add(struct blob_lanes *lanes, const struct blob_body *body,
                      unsigned met)
{
    if (body->round) {
        lanes_add_round(lanes, body, met);
        return;
    }
    for (; met; met &= met - 1) {
        int i = __builtin_ctz(met);
        const struct ray ray = rays_at(lanes->rays, i);
        stretches_add(&lanes->of[i], body, 1, &ray);
    }
}

/* As the rays of blob_crossings, but all in one walk over the boxes. */
static void lanes_look(struct blob_lanes *lanes)
{
    const struct blob_tree *tree = lanes->blob->tree;
    double inverse[3][RAY_LANES];
    const struct rays_boxed boxed = { lanes->rays,
                                      (const double(*)[RAY_LANES])inverse,
                                      lanes->span };
    rays_inverse(lanes->rays, lanes->run, inverse);
    for (uint32_t at = 0; at < tree->node_count;) {
        const struct blob_node *node = &tree->nodes[at];
        LANE_LINES lane_flag flags[RAY_LANES];
        rays_meet_box(&boxed, &node->box, lanes->run, flags);
        unsigned met = rays_bits(flags) & lane_run_bits(lanes->run);
        for (uint32_t i = 0; met && i < node->count; i++)
            lanes_add(lanes, &tree->bodies[node->first + i], met);
        at = met ? at + 1 : node->next;
    }
}

static void blob_first_many(const void *shape, struct lane_run run,
                            const struct rays *rays,
                            const struct rays_span *span, struct rays_met *met)
{
    struct blob_lanes lanes;
    lanes.blob = shape;
    lanes.rays = rays;
    lanes.span = span;
    lanes.run = run;
    for (int i = run.first; i < run.end; i++)
        lanes.of[i] = (struct stretches){ span->near[i], span->far[i], 0,
                                          LANE_STRETCHES, lanes.items[i] };
    lanes_look(&lanes);
    for (int i = run.first; i < run.end; i++) {
        struct stretches *all = &lanes.of[i];
        struct hit hit;
        struct crossings_nearest nearest = { &hit, false };
        if (all->count == all->limit) {
            const struct ray ray = rays_at(rays, i);
            nearest.found = blob_first(shape, &ray, all->tmin, all->tmax, &hit);
        } else if (all->count > 0) {
            stretches_sweep(all, lanes.blob->threshold, crossings_take,
                            &nearest);
        }
        met->t[i] = nearest.found ? hit.t : (double)INFINITY;
        met->part[i] = 0;
    }
}

static void blob_crosses_many(const void *shape, struct lane_run run,
                              const struct rays *rays,
                              const struct rays_span *span, lane_flag *met)
{
    struct rays_met first;
    blob_first_many(shape, run, rays, span, &first);
    rays_crosses_met(&first, run, met);
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
    .bounded = BOUNDS_IGNORED,
    .prepare = blob_prepare,
    .bounds = blob_bounds,
    .intersect = blob_intersect,
    .crossings = blob_crossings,
    .first = blob_first,
    .crosses = blob_crosses,
    .lane_by_lane = true,
    .first_many = blob_first_many,
    .crosses_many = blob_crosses_many,
    .normal = blob_normal,
    .inside = blob_inside,
};
