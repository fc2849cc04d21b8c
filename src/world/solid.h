/* The scene's tree flattened for tracing: leaves with their composed
 * transformations, and the CSG conditions a crossing must meet to count.
 *
 * POV-Ray's rule, for every crossing of a leaf: climbing to the root, it must
 * be inside all siblings of an intersection, outside all siblings of a merge,
 * and inside every clip. This needs nothing from a shape but all crossings
 * and an inside test, so discs, triangles, half spaces and open cylinders
 * take part in CSG as they do in POV-Ray (spans would need closed solids).
 *
 * `inverse` is pushed down to the leaves (De Morgan), as POV-Ray does
 * (measured): an inverse union is an intersection of inverses, an inverse
 * intersection a merge of inverses. What has no inside (a triangle, a
 * polygon) contains no point, inverse or not; clips are never inverted. */
#ifndef WORLD_SOLID_H
#define WORLD_SOLID_H

#include "base/rgb.h"
#include "scene/mesh.h"
#include "scene/object.h"
#include "scene/rays.h"

struct photon_flags;

/* What a leaf is painted with inside. */
struct leaf_inner {
    const struct texture *texture;
    affine to_texture, from_texture;
};

/* A space in the one around it: points from it, and into it. Many share one. */
struct pose {
    const affine *outward, *inward;
};

extern const struct pose pose_unmoved;

/* How a leaf is seen, but for its shape: what many are alike in. */
struct leaf_look {
    const struct texture *texture;           /* never NULL */
    const affine *to_texture, *from_texture; /* world <-> the texture's space */
    const struct leaf_inner *inner;     /* seen from inside; NULL: the same */
    const struct interior *interior;    /* NULL: none */
    const struct photon_flags *photons; /* never NULL */
    const struct mesh *mesh; /* that has textures of its own; NULL: none */
    unsigned light_group;    /* 0: none */
    unsigned target; /* of photons: the same for all parts of one; 0: none */
    int looks_like;  /* number of the light it stands for, or -1 */
    bool no_shadow, no_image, no_reflection;
    bool double_illuminate;
    bool uv_mapping;       /* the texture is of the surface's own coordinates */
    bool no_global_lights; /* only those of its group */
    bool hollow;  /* as its interior is, or, without one, the object at the top
                   * level, whatever its parts say */
    bool inverse; /* turned inside out, all its ancestors considered */
    /* By what its textures are (shared.h): */
    bool opaque;  /* none lets light pass */
    bool coated;  /* its texture is not the same all over it */
    bool plain;   /* its paint is plain (texture_is_plain) wherever it is, */
    bool spatial; /* and the same on any surface there (texture_is_spatial) */
    bool last;    /* it is plain, and no ray goes on from it: it is opaque and
                   * mirrors nothing */
    bool clear;   /* nothing of it is seen: it is there for what it holds */
    bool tinted;  /* it lets the same light pass all over it: */
    rgb tint;
};

/* Whether it stops all shadow rays that meet it. */
static inline bool look_is_plain(const struct leaf_look *look)
{
    return look->opaque && !look->no_shadow && look->looks_like < 0;
}

/* A shape or a mesh in the world. */
struct leaf {
    const struct object *object; /* OBJECT_SHAPE or OBJECT_MESH */
    const void *shape;           /* the object's, or that moved into its tree */
    const struct solid *solid;   /* its node in the tree; NULL: a mesh that is
                                  * no part of a CSG object */
    const struct pose *pose;     /* in the world */
    const struct leaf_look *look;
    /* What a ray that enters is inside of: the same number for all leaves
     * below one use of an object at the top level, but a new one below every
     * node that has an interior of its own. A ray that meets the same body
     * once more has left it, so overlapping parts of one union cancel
     * (measured on POV-Ray). */
    unsigned body;
    unsigned number; /* 0..leaf_count-1 */
};

/* Whether its own space is not the world's. */
static inline bool leaf_is_moved(const struct leaf *leaf)
{
    return leaf->pose != &pose_unmoved;
}

/* A corner, 0 to 2, of a mesh's triangle in the world. */
static inline vec3 leaf_corner(const struct leaf *leaf, size_t triangle, int k)
{
    const struct mesh *mesh = leaf->object->mesh;
    vec3 v = mesh->vertices[mesh->triangles[triangle].vertex[k]];
    return leaf_is_moved(leaf) ? affine_point(leaf->pose->outward, v) : v;
}

/* What few solids have. */
struct solid_more {
    unsigned clip_count, gate_count;
    unsigned own_clips;         /* the first of clips; the rest are of unions */
    const struct solid **clips; /* outside the frame, as are the gates */
    const struct solid **gates; /* rays that miss one miss the solid */
    const struct mesh_tree *tree; /* of a mesh */
    /* The space the tree below a root is kept in: its object's own, in which
     * its parts are more often unmoved and its planes along the axes. NULL:
     * none. */
    const struct pose *frame;
    const struct box3 *inner; /* of a root with a frame: the surface there */
};

/* A node of a tree. A root's space is the world's (or, for a clip, that of
 * what it clips); everything below a root with a frame is in the frame. */
struct solid {
    enum object_kind kind; /* shape, mesh, union, merge or intersection */
    unsigned child_count;
    bool simple;   /* a leaf without parent, frame, clips and bounds */
    bool boxed;    /* rays must meet the box that `surface` is then, though
                    * crossings outside of it count, too */
    bool moved;    /* to_shape is not the identity */
    bool together; /* most leaves are asked by rays side by side */
    /* A shape that has such a routine, or one that tells all: kept at hand. */
    bool first_many, crosses_many, all_many;
    const struct solid *parent;
    const struct leaf *leaf; /* shape, mesh; else NULL */
    union {
        const affine *to_shape; /* of a leaf: from the space it is in */
        struct solid **children;
    };
    const struct solid_more *more;
    struct box3 surface;       /* holds every crossing that counts */
    const struct box3 *region; /* outside it nothing is inside */
    const struct box3 *holes;  /* outside it everything is inside */
};

/* A new solid that is of this kind and has nothing more than others. */
struct solid *solid_new(struct arena *arena, enum object_kind kind);

/* What it has more, to write to: its own from now on, in `arena`. */
struct solid_more *solid_more(struct arena *arena, struct solid *solid);

/* Boxes of which most solids have one. */
extern const struct box3 solid_nothing, solid_everything;

/* Sets region and holes, and keeps in `arena` only what is not the same for
 * many. */
void solid_set_boxes(struct arena *arena, struct solid *solid,
                     struct box3 region, struct box3 holes);

/* Beyond this a bound counts as infinite; crossings end at 1e7 anyway. */
extern const double solid_limit;

bool solid_is_bounded(const struct solid *solid);

static inline struct ray ray_into(const affine *transform,
                                  const struct ray *ray)
{
    return (struct ray){ affine_point(transform, ray->origin),
                         affine_direction(transform, ray->direction) };
}

/* Whether the point is inside the solid and its clips. */
bool solid_inside(const struct solid *solid, vec3 point);

/* Whether the ray has a crossing of a simple shape between tmin and tmax. */
bool solid_crosses(const struct solid *solid, const struct ray *ray,
                   double tmin, double tmax);

/* The same of rays side by side, each within its span: bit by bit of `lanes`.
 */
unsigned solid_crosses_many(const struct solid *solid, const struct rays *rays,
                            const struct rays_span *span, unsigned lanes);

/* Whether the box is known to be inside the solid, so that no ray can meet the
 * box and miss the solid. */
bool solid_surrounds(const struct solid *solid, struct box3 box);

/* Whether a crossing of this leaf's surface counts; the point in the root's
 * frame and outside it. */
bool solid_counts(const struct solid *leaf, vec3 inner, vec3 outer);

/* Fills surface, region and holes from the children and clips. For a leaf,
 * `region` and `holes` of the shape alone must be there. */
void solid_measure(struct arena *arena, struct solid *solid);

/* From now on rays must meet the box around all bounds to meet the solid, but
 * meet it outside of that box too, as in POV-Ray; unless its own box is
 * smaller.
 */
void solid_bound_by_box(struct arena *arena, struct solid *solid,
                        const struct solid *const *bounds, size_t count);

/* The box a little larger, so that rounding loses nothing. */
struct box3 solid_padded(struct box3 box);

/* Makes a tree ready: parents, boxes, groups. */
void solid_finish(struct arena *arena, struct solid *solid);

/* Cuts a node with many children into a tree of nodes of its kind with few
 * children each, so that far ones are left out together. */
void solid_group(struct arena *arena, struct solid *solid);

/* Calls visit for the leaves that hold the point: every part of a union, the
 * first of an intersection. As in POV-Ray (measured) nothing holds a point
 * outside its bounding box, be it a half space behind a disc. */
void solid_containing(const struct solid *solid, vec3 point,
                      void (*visit)(void *context, const struct leaf *leaf),
                      void *context);

#endif
