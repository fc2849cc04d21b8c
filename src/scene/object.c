/* Nodes of the object tree: see object.h. */
#include "scene/object.h"

#include "scene/mesh.h"
#include "scene/primitive.h"

static const struct object_maps maps_unmoved = {
    &affine_unmoved, &affine_unmoved, &affine_unmoved, &affine_unmoved,
    &affine_unmoved
};
static const struct object_more nothing_more = { .depth = 1, .parts = 1 };

struct object *object_new(struct arena *arena, enum object_kind kind,
                          struct span span)
{
    struct object *object = ARENA_NEW(arena, struct object);
    object->kind = kind;
    object->span = span;
    object->maps = &maps_unmoved;
    object->more = &nothing_more;
    return object;
}

struct object_more *object_more(struct arena *arena, struct object *object)
{
    if (object->more->owner == object)
        return (struct object_more *)(uintptr_t)object->more;
    struct object_more *more = ARENA_NEW(arena, struct object_more);
    *more = *object->more;
    more->owner = object;
    object->more = more;
    return more;
}

void object_place(struct arena *arena, struct object *object,
                  struct object_maps maps)
{
    const struct object_maps *known[] = { object->maps, &maps_unmoved };
    for (int i = 0; i < 2; i++) {
        if (memcmp(known[i], &maps, sizeof maps) == 0) {
            object->maps = known[i];
            return;
        }
    }
    struct object_maps *kept = ARENA_NEW(arena, struct object_maps);
    *kept = maps;
    object->maps = kept;
}

struct object *object_copy(struct arena *arena, const struct object *object)
{
    struct object *copy = ARENA_NEW(arena, struct object);
    *copy = *object;
    return copy;
}

/* The list may be shared with the node this one was copied from. */
static const struct clip *clips_moved(struct arena *arena,
                                      const struct clip *clips, size_t count,
                                      const affine *transform)
{
    if (!count)
        return NULL;
    struct clip *moved = ARENA_ARRAY(arena, struct clip, count);
    for (size_t i = 0; i < count; i++) {
        moved[i] = clips[i];
        moved[i].transform = affine_compose(*transform, moved[i].transform);
    }
    return moved;
}

/* What was the same as `before` is the same as `after`. */
static const affine *affine_moved(struct arena *arena, const affine *transform,
                                  const affine *old, const affine *before,
                                  const affine *after)
{
    if (old == before)
        return after;
    affine moved = affine_compose(*transform, *old);
    return affine_kept(arena, &moved);
}

/* Moves a shape that can be moved where it is; false: the node must keep the
 * map. */
static bool shape_move(struct arena *arena, struct object *object,
                       const affine *transform)
{
    const void *moved =
        primitive_moved(arena, object->primitive, object->shape, transform);
    if (moved)
        object->shape = moved;
    return moved;
}

void object_settle(struct arena *arena, struct object *object)
{
    struct object_maps maps = *object->maps;
    object->settled = true;
    if (maps.own == &affine_unmoved || !shape_move(arena, object, maps.own))
        return;
    maps.own = maps.alike = &affine_unmoved;
    object_place(arena, object, maps);
}

/* A ball that was moved in any other way before is none any more. */
static void maps_move_alike(struct arena *arena, struct object_maps *maps,
                            const struct object_maps *before,
                            const struct object_step *step)
{
    if (before->alike != before->own)
        return;
    bool whole = memcmp(&step->alike, &step->all, sizeof step->all) == 0;
    maps->alike =
        whole || maps->own == before->own
            ? maps->own
            : affine_moved(arena, &step->alike, before->own, NULL, NULL);
}

static bool object_is_ball(const struct object *object)
{
    return object->kind == OBJECT_SHAPE && object->primitive->ball;
}

void object_move(struct arena *arena, struct object *object,
                 const affine *transform)
{
    object_move_step(arena, object, &(struct object_step){ .all = *transform });
}

void object_move_step(struct arena *arena, struct object *object,
                      const struct object_step *step)
{
    struct object_maps maps = *object->maps;
    const affine *before = maps.own, *transform = &step->all;
    const affine *after = affine_moved(arena, transform, before, NULL, NULL);
    const affine **covering[] = { &maps.texture, &maps.inner, &maps.interior };
    if (!object->settled || before != &affine_unmoved ||
        !shape_move(arena, object, transform))
        maps.own = after;
    for (size_t i = 0; i < sizeof covering / sizeof covering[0]; i++)
        *covering[i] =
            affine_moved(arena, transform, *covering[i], before, after);
    if (object_is_ball(object))
        maps_move_alike(arena, &maps, object->maps, step);
    object_place(arena, object, maps);
    if (!object->more->clip_count && !object->more->bound_count)
        return;
    struct object_more *more = object_more(arena, object);
    more->clips = clips_moved(arena, more->clips, more->clip_count, transform);
    more->bounds =
        clips_moved(arena, more->bounds, more->bound_count, transform);
}

bool object_is_bounded(const struct object *object)
{
    if (!object->more->bound_count)
        return false;
    return object->kind != OBJECT_SHAPE ||
           object->primitive->bounded != BOUNDS_IGNORED;
}

/* A half space that ends along an axis, within rounding; else everything. */
static struct box3 half_space_bounds(const struct object *object)
{
    struct box3 box = box3_infinite();
    affine inverse;
    vec3 normal;
    double distance;
    object->primitive->half_space(object->shape, &normal, &distance);
    if (!affine_inverse(*object->maps->own, &inverse))
        return box;
    vec3 on = affine_point(object->maps->own, vec3_scale(normal, distance));
    normal = vec3_normalise(affine_normal(&inverse, normal));
    if (object->inverse)
        normal = vec3_negate(normal);
    double *sides[3][2] = { { &box.low.x, &box.high.x },
                            { &box.low.y, &box.high.y },
                            { &box.low.z, &box.high.z } };
    for (int axis = 0; axis < 3; axis++) {
        double along = vec3_component(normal, axis);
        if (fabs(along) > 1 - 1e-12)
            *sides[axis][along > 0] = vec3_component(on, axis);
    }
    return box;
}

/* The box around the ball that was turned, and around that box as what came
 * after has moved it. */
static struct box3 ball_bounds(const struct object *object)
{
    const struct object_maps *maps = object->maps;
    struct box3 box = object->primitive->ball(object->shape, maps->alike);
    affine back;
    if (maps->alike == maps->own || !affine_inverse(*maps->alike, &back))
        return box;
    affine after = affine_compose(*maps->own, back);
    return affine_box(&after, box);
}

static struct box3 shape_bounds(const struct object *object)
{
    const struct primitive *primitive = object->primitive;
    if (primitive->ball)
        return ball_bounds(object);
    return primitive->told ? primitive->told(object->shape, object->maps->own)
                           : affine_box(object->maps->own,
                                        primitive->bounds(object->shape));
}

/* What a part of an intersection leaves of it: a single shape that is not
 * bounded on all sides, by those that it has (measured). */
static struct box3 object_part_bounds(const struct object *object)
{
    bool shape = object->kind == OBJECT_SHAPE;
    if (shape && object->primitive->half_space)
        return half_space_bounds(object);
    if (object->inverse)
        return box3_infinite();
    if (!shape || object->more->clip_count > 0 || object_is_bounded(object))
        return object_bounds(object);
    return shape_bounds(object);
}

static struct box3 object_children_bounds(const struct object *object)
{
    bool meet = object->kind == OBJECT_INTERSECTION;
    struct box3 box = meet ? box3_infinite() : box3_empty();
    for (size_t i = 0; i < object->more->child_count; i++) {
        if (object->more->children[i]->kind == OBJECT_LIGHT)
            continue;
        struct box3 child = meet ? object_part_bounds(object->more->children[i])
                                 : object_bounds(object->more->children[i]);
        box = meet ? box3_intersection(box, child) : box3_union(box, child);
    }
    return box;
}

static struct box3 object_own_bounds(const struct object *object)
{
    switch (object->kind) {
    case OBJECT_SHAPE:
        return shape_bounds(object);
    case OBJECT_MESH:
        return mesh_told(object->mesh, object->maps->own);
    case OBJECT_LIGHT:
        return box3_empty();
    case OBJECT_UNION:
    case OBJECT_MERGE:
    case OBJECT_INTERSECTION:
        break;
    }
    return affine_box(object->maps->own, object_children_bounds(object));
}

/* The box around what all of them share, if that is smaller (measured). */
static struct box3 box_within(struct box3 box, const struct clip *clips,
                              size_t count)
{
    struct box3 shared = box3_infinite();
    for (size_t i = 0; i < count; i++) {
        const struct object *clip = clips[i].object;
        struct box3 limit =
            clip->inverse ? box3_infinite() : object_bounds(clip);
        shared =
            box3_intersection(shared, affine_box(&clips[i].transform, limit));
    }
    return box3_volume(shared) < box3_volume(box) ? shared : box;
}

static bool box_is_endless(struct box3 box)
{
    return isinf(box.low.x) || isinf(box.low.y) || isinf(box.low.z) ||
           isinf(box.high.x) || isinf(box.high.y) || isinf(box.high.z);
}

/* Inside out it has the same bounds: only as a part of an intersection or a
 * clip, whose inside counts, it reaches everywhere. What is endless in one
 * direction is so in all (measured). */
struct box3 object_bounds(const struct object *object)
{
    struct box3 box = object_own_bounds(object);
    if (!box3_is_empty(box) && box_is_endless(box))
        box = box3_infinite();
    box = box_within(box, object->more->clips, object->more->clip_count);
    if (object_is_bounded(object))
        box = box_within(box, object->more->bounds, object->more->bound_count);
    return box;
}

bool object_is_hollow(const struct object *object, bool hollow)
{
    hollow |= object->hollow;
    while (object->more->child_count > 0) {
        object = object->more->children[object->more->child_count - 1];
        hollow |= object->hollow;
    }
    return hollow;
}
