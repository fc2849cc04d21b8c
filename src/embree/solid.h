/* The scene's tree flattened for tracing: leaves with their composed
 * transformations, and the CSG conditions a crossing must meet to count.
 *
 * POV-Ray's rule, for every crossing of a leaf: climbing to the root, it must
 * be inside all siblings of an intersection, outside all siblings of a merge,
 * and inside every clip. This needs nothing from a shape but all crossings
 * and an inside test, so discs, triangles, half spaces and open cylinders
 * take part in CSG as they do in POV-Ray (spans would need closed solids). */
#ifndef EMBREE_SOLID_H
#define EMBREE_SOLID_H

#include "scene/object.h"
#include "scene/ray.h"

/* A shape or a mesh in the world. */
struct leaf {
    const struct object *object; /* OBJECT_SHAPE or OBJECT_MESH */
    const struct solid *solid;   /* its node in the tree, for CSG tests */
    affine to_object, to_world;  /* points */
    const struct texture *texture;
    affine to_texture, from_texture; /* world <-> the texture's space */
    const struct interior *interior; /* NULL: none */
    /* What a ray that enters is inside of: the same number for all leaves
     * below one use of an object at the top level, but a new one below every
     * node that has an interior of its own. A ray that meets the same body
     * once more has left it, so overlapping parts of one union cancel
     * (measured on POV-Ray). */
    unsigned body;
    bool opaque;                     /* no texture of it lets light pass */
    bool moved;                      /* to_object is not the identity */
    bool no_shadow, no_image, no_reflection;
    bool double_illuminate, inverse;
    bool hollow; /* of the object at the top level, whatever its parts say */
    int looks_like;  /* number of the light it stands for, or -1 */
    unsigned number; /* 0..leaf_count-1 */
};

#endif
