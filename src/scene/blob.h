/* Blobs: the surface where the densities of balls and round-ended cylinders
 * add up to a threshold. */
#ifndef SCENE_BLOB_H
#define SCENE_BLOB_H

#include "scene/primitive.h"

/* Of radius 1 in its own space: a ball around the origin, or what is around the
 * z axis from 0 to `length`. Numbers only, as they are hashed as such. */
struct blob_part {
    double strength; /* times (1 - d^2)^2 at the distance d < 1 */
    double length;   /* 0: a ball */
    affine inward;   /* from the blob's space */
};

enum {
    BLOB_NUMBERS = sizeof(struct blob_part) / sizeof(double),
    BLOB_PARTS_LIMIT = 100000
};

struct blob_tree;
struct texture;

struct blob {
    struct terms parts; /* struct blob_part after part, as numbers */
    double threshold;
    bool ignored; /* sturm and hierarchy: needless */
    struct box3 bounds;
    const struct blob_tree *tree; /* over the parts */
    const unsigned *textures;     /* of each part, a number of these; NULL: all
                                   * parts are alike */
    const struct texture **part_textures; /* the first stands for the object's:
                                           * NULL */
    size_t texture_count;
};

extern const struct primitive blob_primitive;

/* Takes what a part adds to the density at a point. */
typedef void blob_density_visit(void *context, size_t part, double density);

/* Calls visit for every part that reaches the point of the blob's space. */
void blob_densities(const struct blob *blob, vec3 point,
                    blob_density_visit *visit, void *context);

/* A ball, or with two different ends a cylinder. False: it has no radius. */
bool blob_part_make(struct blob_part *part, vec3 base, vec3 apex, double radius,
                    double strength);

/* Moves a part, as modifiers of its own do. False: nothing would be left. */
bool blob_part_move(struct blob_part *part, const affine *transform);

/* What a blob is painted with whose object has the texture `own`: with the
 * parts' textures where they have one. `from_texture` leads from its space to
 * the world, and is set to that of what is returned. */
const struct texture *blob_texture(struct arena *arena, const struct blob *blob,
                                   const affine *to_world,
                                   const struct texture *own,
                                   affine *from_texture);

#endif
