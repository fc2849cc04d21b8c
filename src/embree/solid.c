/* Inside tests and the rule of CSG: see solid.h. */
#include "embree/solid.h"

#include "embree/mesh_tree.h"
#include "scene/mesh.h"
#include "scene/primitive.h"

static bool leaf_inside(const struct solid *solid, vec3 point)
{
    const struct leaf *leaf = solid->leaf;
    const struct object *object = leaf->object;
    vec3 p = solid->moved ? affine_point(&solid->to_shape, point) : point;
    bool inside = solid->kind == OBJECT_SHAPE
                      ? object->primitive->inside(object->shape, p)
                      : mesh_tree_inside(solid->tree, p);
    return inside != leaf->inverse;
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
    return solid->frame ? affine_point(&solid->frame->inward, point) : point;
}

bool solid_inside(const struct solid *solid, vec3 point)
{
    if (!box3_contains(solid->region, point))
        return false;
    if (!box3_contains(solid->holes, point))
        return true;
    return content_inside(solid, into_frame(solid, point)) &&
           all_inside(solid->clips, solid->clip_count, point);
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
        if (!all_inside(node->clips, node->clip_count, point))
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

struct box3 solid_padded(struct box3 box)
{
    if (box3_is_empty(box))
        return box;
    double pad[3];
    for (int i = 0; i < 3; i++) {
        double low = vec3_component(box.low, i);
        double high = vec3_component(box.high, i);
        double most = fmax(isfinite(low) ? fabs(low) : 0,
                           isfinite(high) ? fabs(high) : 0);
        pad[i] = 1e-9 * most + 1e-12;
    }
    vec3 more = { pad[0], pad[1], pad[2] };
    return (struct box3){ vec3_sub(box.low, more), vec3_add(box.high, more) };
}

/* An infinite shape may leave little of the box that its siblings leave. */
static struct box3 narrowed(const struct solid *solid, struct box3 region)
{
    for (size_t i = 0; i < solid->child_count; i++) {
        const struct solid *child = solid->children[i];
        if (child->kind != OBJECT_SHAPE || child->leaf->inverse ||
            !child->leaf->object->primitive->within)
            continue;
        const struct object *object = child->leaf->object;
        affine outward;
        if (!affine_inverse(child->to_shape, &outward))
            continue;
        struct box3 box = affine_box(&child->to_shape, region);
        box = object->primitive->within(object->shape, box);
        region =
            box3_intersection(region, solid_padded(affine_box(&outward, box)));
    }
    return region;
}

/* A crossing of a child must be in the region of every other child. A child's
 * own region holds its surface, unless it has no inside. */
static void measure_intersection(struct solid *solid)
{
    struct box3 surface = box3_empty(), region = box3_infinite();
    struct box3 others = box3_infinite();
    const struct solid *hollow = NULL;
    size_t hollow_count = 0;
    solid->holes = box3_empty();
    for (size_t i = 0; i < solid->child_count; i++) {
        const struct solid *child = solid->children[i];
        bool without_inside = box3_is_empty(child->region);
        region = box3_intersection(region, child->region);
        surface = box3_union(surface, child->surface);
        solid->holes = box3_union(solid->holes, child->holes);
        if (without_inside)
            hollow = child;
        else
            others = box3_intersection(others, child->region);
        hollow_count += without_inside;
    }
    if (!box3_is_empty(region) && !box3_is_finite(region))
        region = narrowed(solid, narrowed(solid, region));
    if (hollow_count == 1)
        solid->surface = box3_intersection(hollow->surface, others);
    else
        solid->surface = box3_intersection(surface, region);
    solid->region = region;
}

static void measure_union(struct solid *solid)
{
    solid->surface = solid->region = box3_empty();
    solid->holes = box3_infinite();
    for (size_t i = 0; i < solid->child_count; i++) {
        const struct solid *child = solid->children[i];
        solid->surface = box3_union(solid->surface, child->surface);
        solid->region = box3_union(solid->region, child->region);
        solid->holes = box3_intersection(solid->holes, child->holes);
    }
}

bool solid_surrounds(const struct solid *gate, struct box3 box)
{
    if (gate->kind != OBJECT_SHAPE || gate->leaf->inverse || gate->frame ||
        !gate->leaf->object->primitive->convex || !box3_is_finite(box))
        return false;
    for (int i = 0; i < 8; i++) {
        vec3 corner = { i & 1 ? box.high.x : box.low.x,
                        i & 2 ? box.high.y : box.low.y,
                        i & 4 ? box.high.z : box.low.z };
        if (!solid_inside(gate, corner))
            return false;
    }
    return true;
}

/* Most gates are well around what they bound: those are forgotten. */
static void drop_gates(struct solid *solid)
{
    size_t kept = 0;
    for (size_t i = 0; i < solid->gate_count; i++)
        if (!solid_surrounds(solid->gates[i], solid->surface))
            solid->gates[kept++] = solid->gates[i];
    solid->gate_count = kept;
    for (size_t i = 0; i < kept; i++)
        solid->surface =
            box3_intersection(solid->surface, solid->gates[i]->region);
}

static void measure_frame(struct solid *solid)
{
    const affine *outward = &solid->frame->outward;
    solid->surface = affine_box(outward, solid->surface);
    solid->region = affine_box(outward, solid->region);
    solid->holes = affine_box(outward, solid->holes);
}

void solid_measure(struct solid *solid)
{
    if (solid->kind == OBJECT_INTERSECTION)
        measure_intersection(solid);
    else if (!solid->leaf)
        measure_union(solid);
    solid->inner = solid->surface;
    if (solid->frame)
        measure_frame(solid);
    for (size_t i = 0; i < solid->clip_count; i++) {
        const struct solid *clip = solid->clips[i];
        solid->surface = box3_intersection(solid->surface, clip->region);
        solid->region = box3_intersection(solid->region, clip->region);
        solid->holes = box3_union(solid->holes, clip->holes);
    }
    drop_gates(solid);
    solid->simple = solid->leaf && !solid->parent && !solid->frame &&
                    !solid->clip_count && !solid->gate_count;
}

void solid_finish(struct arena *arena, struct solid *solid)
{
    for (size_t i = 0; i < solid->child_count; i++) {
        solid->children[i]->parent = solid;
        solid_finish(arena, solid->children[i]);
    }
    solid_measure(solid);
    if (!solid->leaf)
        solid_group(arena, solid);
}
