/* inside() and trace(): see object_probe.h. The rule for CSG is that of
 * world/solid.h: a crossing of a part counts if it is inside all siblings of
 * an intersection, outside all siblings of a merge, and inside every clip. */
#include "scene/object_probe.h"

#include "scene/box_tree.h"
#include "scene/mesh.h"
#include "scene/primitive.h"

#define PROBE_NEAREST  1e-4
#define PROBE_FARTHEST 1e7 /* measured, as is the nearest */

bool object_is_solid(const struct object *object)
{
    switch (object->kind) {
    case OBJECT_SHAPE:
        return object->primitive->inside != NULL;
    case OBJECT_MESH:
        return object->mesh->solid;
    case OBJECT_LIGHT:
        return false;
    case OBJECT_UNION:
    case OBJECT_MERGE:
    case OBJECT_INTERSECTION:
        break;
    }
    return object->more->child_count > 0;
}

/* ---- trees of meshes and unions ---- */

enum {
    PROBES_FEW = 16,  /* questions that a tree takes longer to make than */
    TREE_BYTES = 320, /* of a triangle's part of a tree, while it is made */
};

/* Of the whole's size: boxes are so much larger, that no rounding hides a hit.
 */
static const double box_margin = 1e-7;

static double box_diagonal(struct box3 box)
{
    return vec3_length(vec3_sub(box.high, box.low));
}

static bool tree_has_room(struct arena *arena, size_t count)
{
    size_t limit = arena_limit(arena), used = arena_used(arena);
    return !limit || (used < limit && count < (limit - used) / TREE_BYTES);
}

static const struct box_tree *mesh_tree(const struct mesh *mesh,
                                        struct arena *arena)
{
    struct arena *boxes_arena = arena_new(0);
    struct box3 *boxes =
        ARENA_ARRAY(boxes_arena, struct box3, mesh->triangle_count);
    double margin = box_margin * box_diagonal(mesh->bounds);
    for (size_t i = 0; i < mesh->triangle_count; i++)
        boxes[i] = box3_grown(mesh_triangle_box(mesh, i), margin);
    const struct box_tree *tree =
        box_tree_new(arena, boxes, mesh->triangle_count);
    arena_free(boxes_arena);
    return tree;
}

static void mesh_expect(const struct mesh *mesh, bool often,
                        struct arena *arena)
{
    struct mesh_probes *probes = mesh->probes;
    if (!probes || probes->tree || (++probes->asked < PROBES_FEW && !often))
        return;
    if (tree_has_room(arena, mesh->triangle_count))
        probes->tree = mesh_tree(mesh, arena);
}

static struct box3 probe_bounds(const struct object *object);

static struct box3 children_bounds(const struct object *object)
{
    bool meet = object->kind == OBJECT_INTERSECTION;
    struct box3 box = meet ? box3_infinite() : box3_empty();
    for (size_t i = 0; i < object->more->child_count; i++) {
        struct box3 child = probe_bounds(object->more->children[i]);
        box = meet ? box3_intersection(box, child) : box3_union(box, child);
    }
    return box;
}

/* All of the node's surface and inside, in its parent's space. Not what
 * object_bounds tells, which is POV-Ray's and may be too small. */
static struct box3 probe_bounds(const struct object *object)
{
    bool shape = object->kind == OBJECT_SHAPE;
    if (object->kind == OBJECT_LIGHT)
        return box3_empty();
    if (object->inverse || (shape && object->primitive->beyond))
        return box3_infinite();
    struct box3 box = shape ? object->primitive->bounds(object->shape)
                      : object->kind == OBJECT_MESH ? object->mesh->bounds
                                                    : children_bounds(object);
    return affine_box(object->maps->own, box);
}

/* The children's boxes, those of lights being empty; false: one is endless. */
static bool children_boxes(const struct object *object, struct box3 *boxes)
{
    struct box3 all = box3_empty();
    size_t count = object->more->child_count;
    for (size_t i = 0; i < count; i++) {
        boxes[i] = probe_bounds(object->more->children[i]);
        all = box3_union(all, boxes[i]);
    }
    double margin = box_margin * box_diagonal(all);
    for (size_t i = 0; i < count; i++)
        boxes[i] = box3_is_empty(boxes[i]) ? (struct box3){ all.low, all.low }
                                           : box3_grown(boxes[i], margin);
    return isfinite(margin);
}

static void children_tree(const struct object *object, struct arena *arena)
{
    const struct object_more *more = object->more;
    struct arena *boxes_arena = arena_new(0);
    struct box3 *boxes =
        ARENA_ARRAY(boxes_arena, struct box3, more->child_count);
    if (children_boxes(object, boxes))
        more->probes->tree = box_tree_new(arena, boxes, more->child_count);
    else
        more->probes->endless = true;
    arena_free(boxes_arena);
}

/* Whether the children are known by now, as they are in a tree. */
static bool children_expect(const struct object *object, bool *often,
                            struct arena *arena)
{
    struct child_probes *probes = object->more->probes;
    if (!probes || probes->endless)
        return false;
    if (probes->tree)
        return true;
    if (++probes->asked < PROBES_FEW && !*often)
        return false;
    if (tree_has_room(arena, object->more->child_count))
        children_tree(object, arena);
    *often |= probes->tree != NULL; /* this was the last time */
    return false;
}

void object_probe_expect(const struct object *object, bool often,
                         struct arena *arena)
{
    const struct object_more *more = object->more;
    bool known = children_expect(object, &often, arena);
    if (object->kind == OBJECT_MESH)
        mesh_expect(object->mesh, often, arena);
    for (size_t i = 0; i < more->child_count && !known; i++)
        object_probe_expect(more->children[i], often, arena);
    for (size_t i = 0; i < more->clip_count; i++)
        object_probe_expect(more->clips[i].object, often, arena);
}

/* Of a union or a merge with a tree. */
static const struct box_tree *children_known(const struct object *object)
{
    return object->more->probes ? object->more->probes->tree : NULL;
}

/* Triangles that the ray may meet between 0 and *tmax. */
static void mesh_visit(const struct mesh *mesh, const struct ray *ray,
                       const double *tmax, box_tree_visit *visit, void *context)
{
    if (mesh->probes && mesh->probes->tree) {
        box_tree_ray(mesh->probes->tree, ray, 0, tmax, visit, context);
        return;
    }
    for (size_t i = 0; i < mesh->triangle_count; i++)
        if (visit(context, i))
            return;
}

/* ---- inside() ---- */

struct inside_count {
    const struct mesh *mesh;
    struct ray ray;
    bool odd;
};

static bool inside_visit(void *context, size_t triangle)
{
    struct inside_count *count = context;
    struct hit hit;
    if (mesh_intersect(count->mesh, triangle, &count->ray, &hit) && hit.t > 0)
        count->odd = !count->odd;
    return false;
}

/* An odd number of triangles lies in the mesh's inside direction. */
static bool mesh_inside(const struct mesh *mesh, vec3 point)
{
    struct inside_count count = { mesh, { point, mesh->inside_vector }, false };
    const double far = HUGE_VAL;
    if (mesh->solid)
        mesh_visit(mesh, &count.ray, &far, inside_visit, &count);
    return count.odd;
}

struct child_inside {
    const struct object *parent,
        *except; /* a child that isn't asked, or NULL */
    vec3 point;
    bool found;
};

static bool child_visit(void *context, size_t i)
{
    struct child_inside *inside = context;
    const struct object *child = inside->parent->more->children[i];
    inside->found =
        child != inside->except && object_inside(child, inside->point);
    return inside->found;
}

/* Whether the point is in another child of a union or a merge. */
static bool children_inside(const struct object *parent,
                            const struct object *except, vec3 point)
{
    struct child_inside inside = { parent, except, point, false };
    const struct box_tree *tree = children_known(parent);
    if (tree)
        box_tree_box(tree, (struct box3){ point, point }, child_visit, &inside);
    for (size_t i = 0; !tree && i < parent->more->child_count; i++)
        if (child_visit(&inside, i))
            break;
    return inside.found;
}

static bool content_inside(const struct object *object, vec3 point)
{
    bool all = object->kind == OBJECT_INTERSECTION;
    if (object->kind == OBJECT_SHAPE)
        return object->primitive->inside(object->shape, point);
    if (object->kind == OBJECT_MESH)
        return mesh_inside(object->mesh, point);
    if (!all)
        return children_inside(object, NULL, point);
    for (size_t i = 0; i < object->more->child_count; i++)
        if (!object_inside(object->more->children[i], point))
            return false;
    return true;
}

static bool clips_inside(const struct object *object, vec3 point)
{
    for (size_t i = 0; i < object->more->clip_count; i++) {
        affine inverse;
        const struct clip *clip = &object->more->clips[i];
        if (!affine_inverse(clip->transform, &inverse) ||
            !object_inside(clip->object, affine_point(&inverse, point)))
            return false;
    }
    return true;
}

/* What has no inside contains no point, inverse or not. */
bool object_inside(const struct object *object, vec3 point)
{
    affine inverse;
    vec3 own = point;
    if (!object_is_solid(object))
        return false;
    if (object->maps->own != &affine_unmoved) {
        if (!affine_inverse(*object->maps->own, &inverse))
            return false;
        own = affine_point(&inverse, point);
    }
    bool inside = content_inside(object, own);
    return inside != object->inverse && clips_inside(object, point);
}

/* ---- trace() ---- */

struct probe {
    struct ray ray;
    double best;
    vec3 normal;
};

/* A node on the way down from the root. */
struct level {
    const struct level *above;
    const struct object *object;
    affine to_own; /* from the root's parent space */
    bool inverse;  /* all levels above considered */
};

static bool siblings_agree(const struct object *parent, bool parent_inverse,
                           const struct object *child, vec3 point)
{
    if (parent->kind == OBJECT_UNION && !parent_inverse)
        return true;
    if (parent->kind != OBJECT_INTERSECTION)
        return !children_inside(parent, child, point);
    for (size_t i = 0; i < parent->more->child_count; i++)
        if (parent->more->children[i] != child &&
            !object_inside(parent->more->children[i], point))
            return false;
    return true;
}

static bool crossing_counts(const struct level *level, vec3 point)
{
    for (; level; level = level->above) {
        const struct level *above = level->above;
        vec3 here = above ? affine_point(&above->to_own, point) : point;
        if (!clips_inside(level->object, here) ||
            (above && !siblings_agree(above->object, above->inverse,
                                      level->object, here)))
            return false;
    }
    return true;
}

static void probe_crossing(struct probe *probe, const struct level *level,
                           double t, vec3 normal)
{
    vec3 point = ray_point(&probe->ray, t);
    if (!(t > PROBE_NEAREST && t < probe->best) ||
        !crossing_counts(level, point))
        return;
    normal = vec3_normalise(affine_normal(&level->to_own, normal));
    probe->best = t;
    probe->normal = level->inverse ? vec3_negate(normal) : normal;
}

struct probe_shape {
    struct probe *probe;
    const struct level *level;
    const struct ray *ray;
};

static bool probe_hit(void *context, const struct hit *hit)
{
    const struct probe_shape *shape = context;
    const struct object *object = shape->level->object;
    const struct primitive *primitive = object->primitive;
    if (!(hit->t < shape->probe->best))
        return false;
    vec3 point = ray_point(shape->ray, hit->t);
    vec3 normal = primitive->normal_placed
                      ? primitive->normal_placed(object->shape, &point, hit,
                                                 &shape->level->to_own)
                      : primitive->normal(object->shape, &point, hit);
    probe_crossing(shape->probe, shape->level, hit->t, normal);
    return false;
}

static void probe_shape(struct probe *probe, const struct level *level,
                        const struct ray *ray)
{
    const struct object *object = level->object;
    struct probe_shape shape = { probe, level, ray };
    struct hits hits = { .count = 0 };
    if (object->primitive->crossings) {
        object->primitive->crossings(object->shape, ray, 0, probe->best,
                                     probe_hit, &shape);
        return;
    }
    if (object->primitive->traced)
        object->primitive->traced(object->shape, ray, &hits);
    else
        object->primitive->intersect(object->shape, ray, &hits);
    for (int i = 0; i < hits.count; i++)
        probe_hit(&shape, &hits.at[i]);
}

struct probe_mesh {
    struct probe *probe;
    const struct level *level;
    const struct ray *ray;
    size_t best; /* the triangle that probe.best is on; 0 also for none */
};

/* Of triangles in one place the first counts, whichever is looked at first. The
 * normal of a flat triangle a, b, c is (c - a) x (b - a) (measured): the other
 * side's; for rendering it does not matter. */
static bool probe_triangle(void *context, size_t i)
{
    struct probe_mesh *all = context;
    struct probe *probe = all->probe;
    const struct mesh *mesh = all->level->object->mesh;
    struct hit hit;
    if (!mesh_intersect(mesh, i, all->ray, &hit))
        return false;
    vec3 normal = mesh_normal(mesh, i, hit.u, hit.v);
    if (mesh->triangles[i].normal[0] == MESH_NONE)
        normal = vec3_negate(normal);
    bool sooner = hit.t < probe->best;
    if (hit.t == probe->best && i < all->best)
        probe->best = nextafter(hit.t, HUGE_VAL);
    probe_crossing(probe, all->level, hit.t, normal);
    if (probe->best == hit.t && (sooner || i < all->best))
        all->best = i;
    return false;
}

static void probe_mesh(struct probe *probe, const struct level *level,
                       const struct ray *ray)
{
    const struct mesh *mesh = level->object->mesh;
    struct probe_mesh all = { probe, level, ray, 0 };
    mesh_visit(mesh, ray, &probe->best, probe_triangle, &all);
}

static void probe_object(struct probe *probe, const struct object *object,
                         const struct level *above);

struct probe_children {
    struct probe *probe;
    const struct level *level;
    size_t best; /* the child that probe.best is on; 0 also for none */
};

/* Of children in one place the first counts, whichever is looked at first. */
static bool probe_child(void *context, size_t i)
{
    struct probe_children *all = context;
    struct probe *probe = all->probe;
    double before = probe->best;
    if (i < all->best)
        probe->best = nextafter(before, HUGE_VAL);
    double limit = probe->best;
    probe_object(probe, all->level->object->more->children[i], all->level);
    if (probe->best < limit)
        all->best = i;
    else
        probe->best = before;
    return false;
}

static void probe_object(struct probe *probe, const struct object *object,
                         const struct level *above)
{
    affine inverse = affine_unmoved, to_own;
    bool moved = object->maps->own != &affine_unmoved;
    if (moved && !affine_inverse(*object->maps->own, &inverse))
        return;
    to_own = above ? above->to_own : inverse;
    if (above && moved)
        to_own = affine_compose(inverse, above->to_own);
    struct level level = {
        .above = above,
        .object = object,
        .to_own = to_own,
        .inverse = object->inverse != (above && above->inverse),
    };
    struct ray ray = { affine_point(&level.to_own, probe->ray.origin),
                       affine_direction(&level.to_own, probe->ray.direction) };
    if (object->kind == OBJECT_SHAPE)
        probe_shape(probe, &level, &ray);
    else if (object->kind == OBJECT_MESH)
        probe_mesh(probe, &level, &ray);
    struct probe_children all = { probe, &level, 0 };
    const struct box_tree *tree = children_known(object);
    if (tree)
        box_tree_ray(tree, &ray, 0, &probe->best, probe_child, &all);
    for (size_t i = 0; !tree && i < object->more->child_count; i++)
        probe_child(&all, i);
}

bool object_trace(const struct object *object, const struct ray *ray, double *t,
                  vec3 *normal)
{
    struct probe probe = { .ray = *ray, .best = PROBE_FARTHEST };
    probe_object(&probe, object, NULL);
    *t = probe.best;
    *normal = probe.normal;
    return probe.best < PROBE_FARTHEST;
}
