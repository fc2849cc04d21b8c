/* The scene's objects as a tree. Nodes are shared between all uses of a
 * declared identifier, so they are const: using one makes a new node, a
 * shallow copy with its own transformation, texture and flags.
 *
 * Spaces: maps->own takes the node's own space to its parent's. A texture or a
 * clip moves with the transformations written after it, so each has a map of
 * its own. */
#ifndef SCENE_OBJECT_H
#define SCENE_OBJECT_H

#include "base/affine.h"
#include "base/arena.h"
#include "text/source.h"

struct primitive;
struct mesh;
struct light;
struct texture;
struct interior;
struct photon_flags;
struct child_probes;
struct object;

enum object_kind {
    OBJECT_SHAPE,        /* primitive, shape */
    OBJECT_MESH,         /* mesh */
    OBJECT_LIGHT,        /* light */
    OBJECT_UNION,        /* children keep their inner surfaces */
    OBJECT_MERGE,        /* inner surfaces removed */
    OBJECT_INTERSECTION, /* difference: children after the first inverted */
};

struct clip {
    const struct object *object;
    affine transform; /* clip's parent space to the node's parent space */
};

/* Scenes have millions of these: what is small stands together, and what few of
 * them have is kept aside. */
struct object {
    struct span span; /* the keyword, for late errors */
    enum object_kind kind;
    bool no_global_lights : 1; /* no lamps light it but those of its group */
    bool patch : 1;            /* some part has no inside */
    bool inverse : 1;
    bool hollow : 1, has_hollow : 1; /* has_: said at all, else the parent's */
    bool no_shadow : 1, no_image : 1, no_reflection : 1;
    bool double_illuminate : 1;
    bool uv_mapping : 1; /* the texture is of the surface's own coordinates */
    bool settled : 1;    /* the shape is prepared, and may be moved itself */
    const struct primitive *primitive; /* of a shape */
    union {
        const void *shape;
        const struct mesh *mesh;
        const struct light *light;
    };
    const struct texture *texture; /* NULL: the parent's, or the default */
    const struct object_maps *maps;
    const struct object_more *more;
};

/* None is NULL; most are affine_unmoved, or the same. */
struct object_maps {
    const affine *own;
    const affine *texture; /* from the texture's space to the parent's */
    const affine *inner;
    const affine *interior; /* of its media */
    /* Of a ball: the first part of `own`, up to the first step that it is no
     * ball after to POV-Ray (object_step); the same pointer: all of it. */
    const affine *alike;
};

/* Transformations written one after another. */
struct object_step {
    affine all;
    /* Those before the first that isn't `translate`, `rotate` or a `scale` that
     * is the same along all axes. */
    affine alike;
};

/* What single shapes seldom have. */
struct object_more {
    const struct object *owner; /* who may write here; all others copy it */
    const struct object **children;

    /* Of the tree below, clips included: a declared object may be used by one
     * that is used by another, and so on. The parser limits both. */
    unsigned depth; /* levels, 1 for a shape */
    unsigned parts; /* shapes, each counted as often as it is used */

    const struct texture *inner; /* the same seen from inside, or NULL */
    const struct interior *interior;
    const struct clip *clips;
    /* bounded_by: a ray that misses one of these misses the node, if that is
     * CSG or a shape that POV-Ray doesn't bound by itself. */
    const struct clip *bounds;
    const struct photon_flags *photons; /* NULL: the parent's */
    struct child_probes *probes; /* of many children: object_probe.h, or NULL */
    unsigned child_count, clip_count, bound_count;
    unsigned light_group; /* whose lamps light it; 0: none, or the parent's */
};

/* A new node of this kind that stands where it is written. */
struct object *object_new(struct arena *arena, enum object_kind kind,
                          struct span span);

/* A copy of the node that shares everything below it. */
struct object *object_copy(struct arena *arena, const struct object *object);

/* What it has more than others, to write to: its own from now on, in `arena`.
 */
struct object_more *object_more(struct arena *arena, struct object *object);

/* The node's maps from now on: in `arena`, unless it has them already or they
 * leave everything where it is. */
void object_place(struct arena *arena, struct object *object,
                  struct object_maps maps);

/* Moves the node, its texture, its clips and bounds. */
void object_move_step(struct arena *arena, struct object *object,
                      const struct object_step *step);

/* The same of what min_extent and max_extent don't tell the extents of. */
void object_move(struct arena *arena, struct object *object,
                 const affine *transform);

/* The node's shape is prepared: if it can be moved, it takes over the node's
 * map. */
void object_settle(struct arena *arena, struct object *object);

/* Whether media fill the node's interior, which its last part decides; a node
 * that is hollow, or below one (`hollow`), makes all its parts so (measured).
 */
bool object_is_hollow(const struct object *object, bool hollow);

/* Whether the node's bounds have an effect. */
bool object_is_bounded(const struct object *object);

/* The box around everything in the node, in its parent's space; may be
 * infinite. What min_extent and max_extent tell. */
struct box3 object_bounds(const struct object *object);

#endif
