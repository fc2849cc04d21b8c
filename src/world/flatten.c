/* Walks the tree of objects: see flatten.h. */
#include "world/flatten.h"

#include "world/mesh_tree.h"
#include "scene/blob.h"
#include "scene/material.h"
#include "scene/medium.h"
#include "scene/mesh.h"
#include "scene/photon.h"
#include "scene/primitive.h"

struct limits {
    const struct solid **items;
    size_t count;
};

/* What a node hands down to its children. */
struct inherited {
    affine to_world; /* of the space the children's transform leads to */
    affine to_tree;  /* the same to the space that the tree is kept in */
    const struct pose *frame; /* that space; NULL: the world, or a clip's */
    const struct texture *texture;
    affine from_texture;
    const struct texture *inner;
    affine from_inner;
    const struct interior *interior;
    unsigned body;
    bool all_hollow; /* some node above is */
    bool hollow, no_shadow, no_image, no_reflection, double_illuminate;
    bool uv_mapping;
    unsigned light_group;
    bool no_global_lights;
    const struct photon_flags *photons; /* NULL: nothing was said */
    unsigned target;
    bool flipped;  /* inverted an odd number of times */
    bool inverted; /* inverted at all */
    bool clip;     /* part of a clip: has no surface of its own */
    bool no_flags; /* below an intersection parts are seen like the whole */
    bool no_shadow_flags; /* below a merge they cast shadows like it */
    int looks_like;
    struct limits clips, gates; /* of unions that were taken apart */
    unsigned depth;
};

static struct solid *build_solid(struct flat *flat, const struct object *object,
                                 const struct inherited *up, bool root);

/* Counts the node; false when a limit is met. */
static bool flat_enter(struct flat *flat, const struct object *object,
                       unsigned depth)
{
    if (flat->failed)
        return false;
    size_t limit = flat->node_limit ? flat->node_limit : FLAT_NODE_LIMIT;
    if (++flat->nodes > limit) {
        diag_print(flat->diag, DIAG_ERROR, object->span, NULL,
                   "the scene has too many objects (limit is %zu)", limit);
        flat->failed = true;
    } else if (depth > FLAT_DEPTH_LIMIT) {
        diag_print(flat->diag, DIAG_ERROR, object->span, NULL,
                   "objects are nested too deep (limit is %d)",
                   FLAT_DEPTH_LIMIT);
        flat->failed = true;
    }
    return !flat->failed;
}

/* What parts of CSG objects say about shadows is ignored, and within
 * intersections also the rest (measured on POV-Ray). */
static void inherit_visibility(const struct object *object,
                               struct inherited *in)
{
    if (!in->no_flags && !in->no_shadow_flags)
        in->no_shadow |= object->no_shadow;
    if (!in->no_flags) {
        in->no_image |= object->no_image;
        in->no_reflection |= object->no_reflection;
    }
}

static struct inherited inherit(struct flat *flat, const struct object *object,
                                const struct inherited *up)
{
    struct inherited in = *up;
    in.depth++;
    if (object->maps->own != &affine_unmoved) {
        in.to_world = affine_compose(up->to_world, *object->maps->own);
        in.to_tree = affine_compose(up->to_tree, *object->maps->own);
    }
    if (object->texture) {
        in.texture = object->texture;
        in.from_texture = affine_compose(up->to_world, *object->maps->texture);
    }
    if (object->primitive == &blob_primitive)
        in.texture = blob_texture(flat->arena, object->shape, &in.to_world,
                                  in.texture, &in.from_texture);
    if (object->more->inner) {
        in.inner = object->more->inner;
        in.from_inner = affine_compose(up->to_world, *object->maps->inner);
    }
    if (object->more->interior) {
        affine place = affine_compose(up->to_world, *object->maps->interior);
        in.interior =
            interior_moved(flat->arena, object->more->interior, &place);
    }
    if (object->more->interior || up->depth == 0)
        in.body = flat->bodies++;
    if (up->depth == 0)
        in.hollow = object->hollow;
    if (object->more->interior)
        in.hollow = object_is_hollow(object, up->all_hollow);
    in.all_hollow |= object->hollow;
    if (up->depth == 0 || object->more->light_group) {
        in.light_group = object->more->light_group;
        in.no_global_lights = object->no_global_lights;
    }
    if (object->more->photons) {
        in.photons = object->more->photons;
        in.target = object->more->photons->target ? ++flat->targets : 0;
    }
    inherit_visibility(object, &in);
    in.double_illuminate |= object->double_illuminate;
    in.uv_mapping |= object->uv_mapping;
    in.flipped ^= object->inverse;
    in.inverted |= object->inverse;
    return in;
}

/* Clips or bounds of an object whose parent's space `up` leads from. */
static struct limits build_limits(struct flat *flat, const struct clip *clips,
                                  size_t count, const struct inherited *up)
{
    struct limits limits = {
        ARENA_ARRAY(flat->arena, const struct solid *, count), count
    };
    struct inherited in = { .from_texture = affine_identity(),
                            .looks_like = -1,
                            .clip = true,
                            .frame = up->frame,
                            .depth = up->depth + 1 };
    for (size_t i = 0; i < count; i++) {
        in.to_world = affine_compose(up->to_world, clips[i].transform);
        in.to_tree = affine_compose(up->to_tree, clips[i].transform);
        struct solid *solid = build_solid(flat, clips[i].object, &in, true);
        if (!solid) {
            /* Nothing left to be inside of: a merge of nothing. */
            solid = solid_new(flat->arena, OBJECT_MERGE);
        }
        solid_finish(flat->arena, solid);
        limits.items[i] = solid;
    }
    return limits;
}

/* `b` first; the result is new. */
static struct limits limits_join(struct flat *flat, struct limits a,
                                 struct limits b)
{
    struct limits both = { NULL, a.count + b.count };
    both.items = ARENA_ARRAY(flat->arena, const struct solid *, both.count);
    for (size_t i = 0; i < both.count; i++)
        both.items[i] = i < b.count ? b.items[i] : a.items[i - b.count];
    return both;
}

static const struct leaf_inner *build_inner(struct flat *flat,
                                            const struct inherited *in)
{
    affine to_texture;
    if (!in->inner || !affine_inverse(in->from_inner, &to_texture))
        return NULL;
    struct leaf_inner *inner = ARENA_NEW(flat->arena, struct leaf_inner);
    *inner = (struct leaf_inner){ in->inner, to_texture, in->from_inner };
    return inner;
}

/* NULL if it has no inverse. `kept` is of the scene and may be the same. */
static const struct pose *find_pose(struct flat *flat, const affine *outward,
                                    const affine *kept)
{
    return shared_pose(&flat->shared, flat->arena, outward, kept);
}

/* The shape moved into the space its tree is kept in, so that rays needn't be
 * taken into its own; NULL: it can't be, or has no need. */
static const void *moved_shape(struct flat *flat, const struct object *object,
                               const struct inherited *in)
{
    bool can = object->kind == OBJECT_SHAPE && !affine_is_identity(in->to_tree);
    return can ? primitive_moved(flat->arena, object->primitive, object->shape,
                                 &in->to_tree)
               : NULL;
}

/* Of clips nothing is seen, whatever they are painted with. */
static const struct leaf_look *build_look(struct flat *flat,
                                          const struct object *object,
                                          const struct inherited *in)
{
    struct leaf_look look;
    const struct pose *texture =
        find_pose(flat, &in->from_texture, object->maps->texture);
    if (!texture)
        texture = &pose_unmoved;
    memset(&look, 0, sizeof look); /* it is compared byte by byte */
    look.from_texture = texture->outward;
    look.to_texture = texture->inward;
    look.texture = in->texture && !in->clip ? in->texture : flat->fallback;
    look.inner = build_inner(flat, in);
    look.interior = in->interior;
    look.photons = in->photons ? in->photons : &photon_flags_default;
    if (object->kind == OBJECT_MESH && object->mesh->texture_count > 0)
        look.mesh = object->mesh;
    look.no_shadow = in->no_shadow;
    look.no_image = in->no_image;
    look.no_reflection = in->no_reflection;
    look.double_illuminate = in->double_illuminate;
    look.uv_mapping = in->uv_mapping;
    look.hollow = in->hollow;
    look.light_group = in->light_group;
    look.no_global_lights = in->no_global_lights;
    look.target = in->target;
    look.inverse = in->flipped;
    look.looks_like = in->looks_like;
    return shared_look(&flat->shared, flat->arena, &look);
}

/* `moved` is of moved_shape. NULL if its transformation squeezes it flat. */
static struct leaf *build_leaf(struct flat *flat, const struct object *object,
                               const void *moved, const struct inherited *in)
{
    const struct pose *pose = in->frame ? in->frame : &pose_unmoved;
    if (!moved)
        pose = find_pose(flat, &in->to_world, object->maps->own);
    if (!pose)
        return NULL;
    struct leaf *leaf = ARENA_NEW(flat->arena, struct leaf);
    leaf->object = object;
    leaf->shape = moved ? moved : object->shape;
    leaf->pose = pose;
    leaf->look = build_look(flat, object, in);
    leaf->body = in->body;
    if (!in->clip) {
        flat->translucent |= !leaf->look->opaque;
        leaf->number = (unsigned)flat->leaf_count++;
    }
    return leaf;
}

static void measure_leaf(struct flat *flat, struct solid *solid,
                         const affine *to_tree)
{
    const struct leaf *leaf = solid->leaf;
    const struct object *object = leaf->object;
    bool shape = object->kind == OBJECT_SHAPE;
    bool beyond = shape && object->primitive->beyond;
    bool has_inside = shape ? object->primitive->solid : object->mesh->solid;
    struct box3 box =
        shape ? object->primitive->bounds(leaf->shape) : object->mesh->bounds;
    solid->surface = solid_padded(
        to_tree == &affine_unmoved ? box : affine_box(to_tree, box));
    solid->region = &solid_nothing;
    solid->holes = &solid_everything;
    if (!has_inside)
        return;
    /* A disc's inside is the half space behind it. */
    struct box3 inside = beyond ? box3_infinite() : solid->surface;
    struct box3 region = leaf->look->inverse ? box3_infinite() : inside;
    if (leaf->look->inverse && shape && !beyond)
        region = solid_padded(affine_box(to_tree, box3_complement(box)));
    solid_set_boxes(flat->arena, solid, region,
                    leaf->look->inverse ? inside : box3_infinite());
}

static const struct mesh_tree *flat_tree(struct flat *flat,
                                         const struct mesh *mesh)
{
    struct mesh_entry *entry =
        mesh_table_entry(flat->arena, &flat->meshes_used, mesh);
    if (!entry->tree)
        entry->tree = mesh_tree_new(flat->arena, mesh);
    return entry->tree;
}

static struct solid *build_leaf_solid(struct flat *flat,
                                      const struct object *object,
                                      const struct inherited *in)
{
    const void *moved = moved_shape(flat, object, in);
    struct leaf *leaf = build_leaf(flat, object, moved, in);
    const struct pose *pose =
        moved ? &pose_unmoved
              : find_pose(flat, &in->to_tree, object->maps->own);
    if (!leaf || !pose)
        return NULL;
    struct solid *solid = solid_new(flat->arena, object->kind);
    solid->leaf = leaf;
    leaf->solid = solid;
    solid->to_shape = pose->inward;
    solid->moved = pose != &pose_unmoved;
    if (object->kind == OBJECT_MESH)
        solid_more(flat->arena, solid)->tree = flat_tree(flat, object->mesh);
    measure_leaf(flat, solid, solid->moved ? &in->to_tree : &affine_unmoved);
    return solid;
}

static void flatten(struct flat *flat, const struct object *object,
                    const struct inherited *up);

/* `in` leads from the light's own space, in which what it looks like stands:
 * that casts no shadow in the light of any lamp (measured on POV-Ray). */
static void add_light(struct flat *flat, const struct object *object,
                      const struct inherited *in)
{
    const struct light *light = object->light;
    if (in->clip)
        return;
    struct inherited shown = *in;
    shown.looks_like = (int)flat->lights.count;
    shown.no_shadow = true;
    shown.body = flat->bodies++;
    shown.to_tree = in->to_world;
    shown.frame = NULL;
    shown.flipped = shown.inverted = false;
    struct light moved = light_moved(light, &in->to_world);
    moved.group = in->light_group;
    size_t next = flat->lights.count, number = next;
    if (light->window) {
        const struct clip clip = { light->window, affine_identity() };
        moved.pane = build_limits(flat, &clip, 1, &shown).items[0];
    }
    if (!light->looks_like && !light->window)
        number =
            light_table_number(&flat->light_places, flat->arena, &moved, next);
    if (number < next) {
        rgb *sum = &flat->lights.items[number].colour;
        *sum = rgb_add(*sum, moved.colour);
        return;
    }
    *ARRAY_PUSH(flat->arena, &flat->lights) = moved;
    if (light->looks_like)
        flatten(flat, light->looks_like, &shown);
}

/* De Morgan. A union turned twice keeps the merge it became on the way. */
static enum object_kind turned_kind(enum object_kind kind,
                                    const struct inherited *in)
{
    if (in->flipped)
        return kind == OBJECT_INTERSECTION ? OBJECT_MERGE : OBJECT_INTERSECTION;
    return kind == OBJECT_UNION && in->inverted ? OBJECT_MERGE : kind;
}

struct children {
    struct solid **items;
    size_t count, capacity;
};

/* A child of the node's own kind gives it its children instead. */
static void add_child(struct flat *flat, struct children *children,
                      enum object_kind kind, struct solid *child)
{
    if (child->leaf || child->kind != kind || child->more->clip_count ||
        child->more->gate_count) {
        *ARRAY_PUSH(flat->arena, children) = child;
        return;
    }
    for (size_t i = 0; i < child->child_count; i++)
        *ARRAY_PUSH(flat->arena, children) = child->children[i];
}

/* Whether an intersection is empty since a part of it is: an empty union. */
static bool leaves_nothing(const struct object *object,
                           const struct object *part)
{
    bool group = part->kind == OBJECT_UNION || part->kind == OBJECT_MERGE ||
                 part->kind == OBJECT_INTERSECTION;
    return object->kind == OBJECT_INTERSECTION && group && !part->inverse;
}

static struct solid *build_node(struct flat *flat, const struct object *object,
                                struct inherited *in)
{
    struct children children = { NULL, 0, 0 };
    enum object_kind kind = turned_kind(object->kind, in);
    bool is_void = false;
    in->no_flags |= kind == OBJECT_INTERSECTION;
    in->no_shadow_flags |= kind == OBJECT_MERGE;
    for (size_t i = 0; i < object->more->child_count; i++) {
        struct solid *child =
            build_solid(flat, object->more->children[i], in, false);
        if (child)
            add_child(flat, &children, kind, child);
        else
            is_void |= leaves_nothing(object, object->more->children[i]);
    }
    if (children.count == 0 || is_void)
        return NULL;
    /* A leaf alone has no frame: it would be looked for where it isn't. */
    struct solid *only = children.items[0];
    if (children.count == 1 && !in->frame && !only->more->clip_count &&
        !only->more->gate_count && !object->more->clip_count &&
        !object->more->bound_count)
        return only;
    struct solid *solid = solid_new(flat->arena, kind);
    solid->children = children.items;
    solid->child_count = (unsigned)children.count;
    return solid;
}

/* In POV-Ray a part of a CSG object heeds its bounds whatever it is. */
static void add_limits(struct flat *flat, const struct object *object,
                       const struct inherited *up, bool root,
                       struct solid *solid)
{
    if (object->more->clip_count) {
        struct limits limits = build_limits(flat, object->more->clips,
                                            object->more->clip_count, up);
        struct solid_more *more = solid_more(flat->arena, solid);
        more->clips = limits.items;
        more->clip_count = more->own_clips = (unsigned)limits.count;
    }
    if (!object->more->bound_count || (root && !object_is_bounded(object)))
        return;
    struct limits limits =
        build_limits(flat, object->more->bounds, object->more->bound_count, up);
    if (root && (object->kind == OBJECT_MESH ||
                 (object->kind == OBJECT_SHAPE &&
                  object->primitive->bounded == BOUNDS_AS_BOX))) {
        solid_bound_by_box(flat->arena, solid, limits.items, limits.count);
    } else {
        struct solid_more *more = solid_more(flat->arena, solid);
        more->gates = limits.items;
        more->gate_count = (unsigned)limits.count;
    }
}

/* Those of unions that were taken apart come after its own. */
static void add_outer_limits(struct flat *flat, const struct inherited *up,
                             struct solid *solid)
{
    if (!up->clips.count && !up->gates.count)
        return;
    struct solid_more *more = solid_more(flat->arena, solid);
    struct limits clips = { more->clips, more->clip_count };
    struct limits gates = { more->gates, more->gate_count };
    clips = limits_join(flat, clips, up->clips);
    gates = limits_join(flat, gates, up->gates);
    more->clips = clips.items;
    more->clip_count = (unsigned)clips.count;
    more->gates = gates.items;
    more->gate_count = (unsigned)gates.count;
}

/* The object as a tree (`root`) or as a part of one; NULL if nothing is left
 * of it. */
static struct solid *build_solid(struct flat *flat, const struct object *object,
                                 const struct inherited *up, bool root)
{
    struct inherited in = inherit(flat, object, up);
    const struct pose *frame = NULL;
    struct solid *solid;
    if (!flat_enter(flat, object, in.depth))
        return NULL;
    if (object->kind == OBJECT_LIGHT) {
        add_light(flat, object, &in);
        return NULL;
    }
    if (object->kind == OBJECT_SHAPE || object->kind == OBJECT_MESH) {
        solid = build_leaf_solid(flat, object, &in);
    } else {
        if (root && !affine_is_along_axes(in.to_tree)) {
            in.frame = frame = find_pose(flat, &in.to_tree, object->maps->own);
            if (!frame)
                return NULL;
            in.to_tree = affine_identity();
        }
        solid = build_node(flat, object, &in);
    }
    if (solid && frame)
        solid_more(flat->arena, solid)->frame = frame;
    if (solid)
        add_limits(flat, object, up, root, solid);
    return solid;
}

/* A solid of its own, with the limits of the unions it was taken out of. */
static void add_solid(struct flat *flat, const struct object *object,
                      const struct inherited *up)
{
    struct inherited plain = *up;
    plain.clips = plain.gates = (struct limits){ NULL, 0 };
    struct solid *solid = build_solid(flat, object, &plain, true);
    if (!solid)
        return;
    add_outer_limits(flat, up, solid);
    solid_finish(flat->arena, solid);
    *ARRAY_PUSH(flat->arena, &flat->solids) = solid;
    *ARRAY_PUSH(flat->arena, &flat->containers) = solid;
}

/* A mesh that Embree gets as it is. */
static void add_mesh(struct flat *flat, const struct object *object,
                     const struct inherited *up)
{
    struct inherited in = inherit(flat, object, up);
    const struct mesh *mesh = object->mesh;
    if (!flat_enter(flat, object, in.depth) || mesh->triangle_count == 0)
        return;
    const struct leaf *leaf;
    if (mesh->solid) {
        struct solid *solid = build_leaf_solid(flat, object, &in);
        if (!solid)
            return;
        solid_finish(flat->arena, solid);
        *ARRAY_PUSH(flat->arena, &flat->containers) = solid;
        leaf = solid->leaf;
    } else {
        leaf = build_leaf(flat, object, NULL, &in);
        if (!leaf)
            return;
    }
    *ARRAY_PUSH(flat->arena, &flat->meshes) = leaf;
    struct mesh_entry *entry =
        mesh_table_entry(flat->arena, &flat->meshes_used, mesh);
    entry->uses++;
    entry->special |= !look_is_plain(leaf->look);
    flat->triangle_count += mesh->triangle_count;
}

/* A union's clips and bounds apply to each of its children. */
static void flatten_union(struct flat *flat, const struct object *object,
                          const struct inherited *up)
{
    struct inherited in = inherit(flat, object, up);
    if (!flat_enter(flat, object, in.depth))
        return;
    if (object->more->clip_count)
        in.clips = limits_join(flat, up->clips,
                               build_limits(flat, object->more->clips,
                                            object->more->clip_count, up));
    if (object_is_bounded(object))
        in.gates = limits_join(flat, up->gates,
                               build_limits(flat, object->more->bounds,
                                            object->more->bound_count, up));
    for (size_t i = 0; i < object->more->child_count; i++)
        flatten(flat, object->more->children[i], &in);
}

static bool limits_surround(struct limits limits, struct box3 box)
{
    for (size_t i = 0; i < limits.count; i++)
        if (!solid_surrounds(limits.items[i], box))
            return false;
    return true;
}

/* Whether its own limits, or those of unions around it, cut the mesh. */
static bool mesh_is_limited(struct flat *flat, const struct object *object,
                            const struct inherited *up)
{
    affine to_world = affine_compose(up->to_world, *object->maps->own);
    struct box3 box = affine_box(&to_world, object->mesh->bounds);
    if (up->clips.count || object->more->clip_count)
        return true;
    if (!limits_surround(up->gates, box))
        return true;
    return object->more->bound_count &&
           !limits_surround(build_limits(flat, object->more->bounds,
                                         object->more->bound_count, up),
                            box);
}

/* An object that is no part of a CSG object. */
static void flatten(struct flat *flat, const struct object *object,
                    const struct inherited *up)
{
    if (object->kind == OBJECT_UNION && !up->inverted && !object->inverse)
        flatten_union(flat, object, up);
    else if (object->kind == OBJECT_MESH && !mesh_is_limited(flat, object, up))
        add_mesh(flat, object, up);
    else
        add_solid(flat, object, up);
}

bool flatten_scene(struct flat *flat, const struct scene *scene)
{
    struct inherited top = { .to_world = affine_identity(),
                             .to_tree = affine_identity(),
                             .from_texture = affine_identity(),
                             .looks_like = -1 };
    flat->fallback = texture_default(flat->arena);
    ARRAY_RESERVE(flat->arena, &flat->solids, scene->objects.count);
    ARRAY_RESERVE(flat->arena, &flat->containers, scene->objects.count);
    for (size_t i = 0; i < scene->objects.count && !flat->failed; i++)
        flatten(flat, scene->objects.items[i], &top);
    return !flat->failed;
}
