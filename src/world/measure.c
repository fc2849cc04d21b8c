/* The boxes of a tree's nodes: where crossings can be, where the inside is,
 * which bounds are worth testing. See solid.h. */
#include "world/halfspace.h"
#include "world/solid.h"
#include "scene/primitive.h"

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

/* The child as a half space of the tree's space; false if it is none. */
static bool child_half_space(const struct solid *child, struct halfspace *out)
{
    vec3 n;
    double d;
    if (child->kind != OBJECT_SHAPE ||
        !child->leaf->object->primitive->half_space)
        return false;
    child->leaf->object->primitive->half_space(child->leaf->shape, &n, &d);
    const affine *a = child->to_shape;
    vec3 origin = { a->m[0][3], a->m[1][3], a->m[2][3] };
    d -= vec3_dot(n, origin);
    n = affine_normal(a, n);
    double length = vec3_length(n);
    if (!(length > 0) || !isfinite(length) || !isfinite(d))
        return false;
    double scale = (child->leaf->look->inverse ? -1 : 1) / length;
    *out = (struct halfspace){ vec3_scale(n, scale), d * scale };
    return true;
}

static struct box3 within_planes(const struct solid *solid, struct box3 region)
{
    struct halfspace planes[HALFSPACES_MAX];
    int count = 0;
    for (size_t i = 0; i < solid->child_count && count < HALFSPACES_MAX; i++)
        count += child_half_space(solid->children[i], &planes[count]);
    return count > 0 ? halfspaces_box(planes, count, region) : region;
}

/* An infinite shape may leave little of the box that its siblings leave. */
static struct box3 narrowed(const struct solid *solid, struct box3 region)
{
    for (size_t i = 0; i < solid->child_count; i++) {
        const struct solid *child = solid->children[i];
        if (child->kind != OBJECT_SHAPE || child->leaf->look->inverse ||
            !child->leaf->object->primitive->within)
            continue;
        const struct object *object = child->leaf->object;
        affine outward;
        if (!affine_inverse(*child->to_shape, &outward))
            continue;
        struct box3 box = affine_box(child->to_shape, region);
        box = object->primitive->within(child->leaf->shape, box);
        region =
            box3_intersection(region, solid_padded(affine_box(&outward, box)));
    }
    return region;
}

const struct box3 solid_nothing = { { HUGE_VAL, HUGE_VAL, HUGE_VAL },
                                    { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } };
const struct box3 solid_everything = { { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL },
                                       { HUGE_VAL, HUGE_VAL, HUGE_VAL } };

static const struct box3 *box_kept(struct arena *arena,
                                   const struct solid *solid, struct box3 box)
{
    const struct box3 *known[] = { &solid_nothing, &solid_everything,
                                   &solid->surface };
    for (int i = 0; i < 3; i++)
        if (memcmp(known[i], &box, sizeof box) == 0)
            return known[i];
    struct box3 *kept = ARENA_NEW(arena, struct box3);
    *kept = box;
    return kept;
}

void solid_set_boxes(struct arena *arena, struct solid *solid,
                     struct box3 region, struct box3 holes)
{
    solid->region = box_kept(arena, solid, region);
    solid->holes = box_kept(arena, solid, holes);
}

/* The boxes of a solid that is being measured. */
struct boxes {
    struct box3 surface, region, holes;
};

/* A crossing of a child must be in the region of every other child. A child's
 * own region holds its surface, unless it has no inside. */
static struct boxes measure_intersection(const struct solid *solid)
{
    struct box3 surface = box3_empty(), region = box3_infinite();
    struct box3 others = box3_infinite();
    const struct solid *hollow = NULL;
    size_t hollow_count = 0;
    struct box3 holes = box3_empty();
    for (size_t i = 0; i < solid->child_count; i++) {
        const struct solid *child = solid->children[i];
        bool without_inside = box3_is_empty(*child->region);
        region = box3_intersection(region, *child->region);
        surface = box3_union(surface, child->surface);
        holes = box3_union(holes, *child->holes);
        if (without_inside)
            hollow = child;
        else
            others = box3_intersection(others, *child->region);
        hollow_count += without_inside;
    }
    if (!box3_is_empty(region) && !box3_is_finite(region)) {
        region = narrowed(solid, narrowed(solid, region));
        if (!box3_is_finite(region))
            region = within_planes(solid, region);
    }
    if (hollow_count == 1)
        surface = box3_intersection(hollow->surface, others);
    else
        surface = box3_intersection(surface, region);
    return (struct boxes){ surface, region, holes };
}

static struct boxes measure_union(const struct solid *solid)
{
    struct boxes boxes = { box3_empty(), box3_empty(), box3_infinite() };
    for (size_t i = 0; i < solid->child_count; i++) {
        const struct solid *child = solid->children[i];
        boxes.surface = box3_union(boxes.surface, child->surface);
        boxes.region = box3_union(boxes.region, *child->region);
        boxes.holes = box3_intersection(boxes.holes, *child->holes);
    }
    return boxes;
}

bool solid_surrounds(const struct solid *gate, struct box3 box)
{
    if (gate->kind != OBJECT_SHAPE || gate->leaf->look->inverse ||
        gate->more->frame || gate->more->clip_count ||
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

/* What was as large as the surface stays so large. */
static void keep_boxes(struct arena *arena, struct solid *solid)
{
    if (solid->region != &solid->surface && solid->holes != &solid->surface)
        return;
    struct box3 *kept = ARENA_NEW(arena, struct box3);
    *kept = solid->surface;
    if (solid->region == &solid->surface)
        solid->region = kept;
    if (solid->holes == &solid->surface)
        solid->holes = kept;
}

void solid_bound_by_box(struct arena *arena, struct solid *solid,
                        const struct solid *const *bounds, size_t count)
{
    struct box3 box = box3_infinite(), own = solid->surface;
    for (size_t i = 0; i < solid->more->own_clips; i++)
        own = box3_intersection(own, *solid->more->clips[i]->region);
    for (size_t i = 0; i < count; i++)
        if (!solid_surrounds(bounds[i], own))
            box = box3_intersection(box, *bounds[i]->region);
    if (!(box3_volume(box) < box3_volume(own)))
        return;
    keep_boxes(arena, solid);
    solid->surface = box;
    solid->boxed = true;
}

/* Most gates are well around what they bound: those are forgotten. Others give
 * a root that has no end a box to be found by. */
static void drop_gates(struct arena *arena, struct solid *solid)
{
    unsigned kept = 0;
    if (!solid->more->gate_count)
        return;
    struct solid_more *more = solid_more(arena, solid);
    for (size_t i = 0; i < more->gate_count; i++)
        if (!solid_surrounds(more->gates[i], solid->surface))
            more->gates[kept++] = more->gates[i];
    more->gate_count = kept;
    for (unsigned i = 0; i < kept && !solid->parent; i++)
        if (!box3_is_finite(solid->surface))
            solid_bound_by_box(arena, solid, more->gates + i, 1);
}

static struct boxes measure_frame(struct arena *arena, struct solid *solid,
                                  struct boxes boxes)
{
    const affine *outward = solid->more->frame->outward;
    struct box3 *inner = ARENA_NEW(arena, struct box3);
    *inner = boxes.surface;
    solid_more(arena, solid)->inner = inner;
    return (struct boxes){ affine_box(outward, boxes.surface),
                           affine_box(outward, boxes.region),
                           affine_box(outward, boxes.holes) };
}

static struct boxes measure_content(const struct solid *solid)
{
    if (solid->kind == OBJECT_INTERSECTION)
        return measure_intersection(solid);
    if (!solid->leaf)
        return measure_union(solid);
    return (struct boxes){ solid->surface, *solid->region, *solid->holes };
}

/* Whether there is inside of the clip where none of its surface is, as below a
 * height field, and the clipped solid goes on without end. A ray that misses
 * the box of the clip's surface then misses what the clip leaves (measured). */
static bool clip_is_box(const struct solid *clip, struct box3 clipped)
{
    return clip->leaf && !clip->leaf->look->inverse &&
           !box3_is_finite(clipped) && box3_is_finite(clip->surface) &&
           !box3_is_finite(*clip->region);
}

static void find_routines(struct solid *solid)
{
    const struct primitive *primitive =
        solid->kind == OBJECT_SHAPE ? solid->leaf->object->primitive : NULL;
    solid->first_many =
        primitive && (primitive->all_many || primitive->first_many);
    solid->crosses_many =
        primitive && (primitive->all_many || primitive->crosses_many);
    solid->all_many =
        primitive && (primitive->all_many || primitive->crossings_many);
}

void solid_measure(struct arena *arena, struct solid *solid)
{
    struct boxes boxes = measure_content(solid);
    if (solid->more->frame)
        boxes = measure_frame(arena, solid, boxes);
    for (size_t i = 0; i < solid->more->clip_count; i++) {
        const struct solid *clip = solid->more->clips[i];
        bool box =
            i < solid->more->own_clips && clip_is_box(clip, boxes.surface);
        boxes.surface = box3_intersection(boxes.surface,
                                          box ? clip->surface : *clip->region);
        solid->boxed |= box;
        boxes.region = box3_intersection(boxes.region, *clip->region);
        boxes.holes = box3_union(boxes.holes, *clip->holes);
    }
    solid->surface = boxes.surface;
    drop_gates(arena, solid);
    solid_set_boxes(arena, solid, boxes.region, boxes.holes);
    solid->simple = solid->leaf && !solid->parent && !solid->more->frame &&
                    !solid->more->clip_count && !solid->more->gate_count &&
                    !solid->boxed;
    find_routines(solid);
}

/* Whether crossings of most of its leaves are told of many rays at a time. */
static bool has_routines(const struct solid *solid)
{
    size_t having = 0;
    if (solid->leaf)
        return solid->first_many || solid->all_many;
    for (size_t i = 0; i < solid->child_count; i++)
        having += solid->children[i]->together;
    return 2 * having > solid->child_count;
}

void solid_finish(struct arena *arena, struct solid *solid)
{
    for (size_t i = 0; i < solid->child_count; i++) {
        solid->children[i]->parent = solid;
        solid_finish(arena, solid->children[i]);
    }
    solid_measure(arena, solid);
    solid->together = has_routines(solid);
    if (!solid->leaf)
        solid_group(arena, solid);
}
