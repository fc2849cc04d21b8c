/* Inside tests and the rule of CSG: see solid.h. */
#include "world/solid.h"

#include "scene/material.h"
#include "scene/mesh.h"
#include "scene/primitive.h"
#include "world/mesh_tree.h"

static const struct solid_more nothing_more;

struct solid *solid_new(struct arena *arena, enum object_kind kind)
{
    struct solid *solid = ARENA_NEW(arena, struct solid);
    solid->kind = kind;
    solid->more = &nothing_more;
    return solid;
}

struct solid_more *solid_more(struct arena *arena, struct solid *solid)
{
    if (solid->more == &nothing_more)
        solid->more = ARENA_NEW(arena, struct solid_more);
    return (struct solid_more *)(uintptr_t)solid->more;
}

const double solid_limit = 1e9;

bool solid_is_bounded(const struct solid *solid)
{
    vec3 low = solid->surface.low, high = solid->surface.high;
    return low.x > -solid_limit && low.y > -solid_limit &&
           low.z > -solid_limit && high.x < solid_limit &&
           high.y < solid_limit && high.z < solid_limit;
}

static bool leaf_inside(const struct solid *solid, vec3 point)
{
    const struct leaf *leaf = solid->leaf;
    const struct object *object = leaf->object;
    vec3 p = solid->moved ? affine_point(solid->to_shape, point) : point;
    bool inside = solid->kind == OBJECT_SHAPE
                      ? object->primitive->inside(leaf->shape, p)
                      : mesh_tree_inside(solid->more->tree, p);
    return inside != leaf->look->inverse;
}

static bool all_inside(const struct solid *const *solids, size_t count,
                       vec3 point)
{
    for (size_t i = 0; i < count; i++)
        if (!solid_inside(solids[i], point))
            return false;
    return true;
}

static bool any_inside(const struct solid *solid, vec3 point)
{
    for (size_t i = 0; i < solid->child_count; i++)
        if (solid_inside(solid->children[i], point))
            return true;
    return false;
}

/* The content of a node, clips left aside. A shape without an inside has an
 * empty region and never gets here. */
static bool content_inside(const struct solid *solid, vec3 point)
{
    switch (solid->kind) {
    case OBJECT_SHAPE:
    case OBJECT_MESH:
        return leaf_inside(solid, point);
    case OBJECT_INTERSECTION:
        return all_inside((const struct solid *const *)solid->children,
                          solid->child_count, point);
    case OBJECT_UNION:
    case OBJECT_MERGE:
    case OBJECT_LIGHT:
        break;
    }
    return any_inside(solid, point);
}

static vec3 into_frame(const struct solid *solid, vec3 point)
{
    return solid->more->frame ? affine_point(solid->more->frame->inward, point)
                              : point;
}

bool solid_inside(const struct solid *solid, vec3 point)
{
    if (!box3_contains(*solid->region, point))
        return false;
    if (!box3_contains(*solid->holes, point))
        return true;
    return content_inside(solid, into_frame(solid, point)) &&
           all_inside(solid->more->clips, solid->more->clip_count, point);
}

/* Whether the siblings of `node` let a crossing of it count. */
static bool siblings_agree(const struct solid *node, vec3 point)
{
    const struct solid *parent = node->parent;
    if (parent->kind == OBJECT_UNION)
        return true;
    bool wanted = parent->kind == OBJECT_INTERSECTION;
    for (size_t i = 0; i < parent->child_count; i++) {
        const struct solid *sibling = parent->children[i];
        if (sibling != node && solid_inside(sibling, point) != wanted)
            return false;
    }
    return true;
}

bool solid_counts(const struct solid *leaf, vec3 inner, vec3 outer)
{
    for (const struct solid *node = leaf; node; node = node->parent) {
        vec3 point = node->parent ? inner : outer;
        if (!all_inside(node->more->clips, node->more->clip_count, point))
            return false;
        if (node->parent && !siblings_agree(node, inner))
            return false;
    }
    return true;
}

void solid_containing(const struct solid *solid, vec3 point,
                      void (*visit)(void *context, const struct leaf *leaf),
                      void *context)
{
    bool bounded = box3_is_finite(solid->surface);
    if ((bounded && !box3_contains(solid->surface, point)) ||
        !solid_inside(solid, point))
        return;
    if (solid->leaf) {
        visit(context, solid->leaf);
        return;
    }
    size_t count = solid->child_count;
    point = into_frame(solid, point);
    if (solid->kind == OBJECT_INTERSECTION && count > 1)
        count = 1;
    for (size_t i = 0; i < count; i++)
        solid_containing(solid->children[i], point, visit, context);
}

bool solid_crosses(const struct solid *solid, const struct ray *ray,
                   double tmin, double tmax)
{
    const struct object *object = solid->leaf->object;
    struct ray local;
    struct hits hits;
    if (solid->moved) {
        local = ray_into(solid->to_shape, ray);
        ray = &local;
    }
    if (object->primitive->crosses)
        return object->primitive->crosses(solid->leaf->shape, ray, tmin, tmax);
    hits.count = 0;
    object->primitive->intersect(solid->leaf->shape, ray, &hits);
    return hits_between(&hits, tmin, tmax);
}

/* One after the other. */
static unsigned crosses_each(const struct solid *solid, const struct rays *rays,
                             const struct rays_span *span, unsigned lanes)
{
    unsigned met = 0;
    for (; lanes; lanes &= lanes - 1) {
        int i = __builtin_ctz(lanes);
        const struct ray ray = rays_at(rays, i);
        bool is = solid_crosses(solid, &ray, span->near[i], span->far[i]);
        met |= (unsigned)is << i;
    }
    return met;
}

unsigned solid_crosses_many(const struct solid *solid, const struct rays *rays,
                            const struct rays_span *span, unsigned lanes)
{
    const struct primitive *primitive = solid->leaf->object->primitive;
    const void *shape = solid->leaf->shape;
    LANE_LINES lane_flag met[RAY_LANES];
    struct rays local;
    struct rays_span asked;
    const struct lane_run run = lane_run_of(lanes);
    if (!primitive->crosses_many && !primitive->all_many)
        return crosses_each(solid, rays, span, lanes);
    if (solid->moved) {
        rays_into(solid->to_shape, run, rays, &local);
        rays = &local;
    }
    span = rays_span_asked(span, lanes, primitive->lane_by_lane, &asked);
    if (primitive->crosses_many) {
        primitive->crosses_many(shape, run, rays, span, met);
    } else {
        struct rays_crossings all;
        primitive->all_many(shape, run, rays, &all);
        rays_crosses_of(&all, run, span, met);
    }
    return lanes & rays_bits(met);
}
