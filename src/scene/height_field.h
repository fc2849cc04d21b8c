/* height_field{}: a grid of heights over the square from 0 to 1 in x and z, as
 * a mesh of two triangles for each four neighbours. */
#ifndef SCENE_HEIGHT_FIELD_H
#define SCENE_HEIGHT_FIELD_H

#include "scene/mesh.h"

/* Heights of the largest: the mesh takes 150 bytes for each. */
enum { HEIGHT_FIELD_LIMIT = 1 << 24 };

struct height_field {
    int width, height; /* at least 2 */
    double *heights;   /* 0 to 1, row by row; the first is at z = 1 */
    bool smooth;
    double water_level; /* what is lower is not there */
};

/* Fills the mesh, its memory being of `arena`. */
void height_field_build(struct arena *arena, const struct height_field *field,
                        struct mesh *mesh);

#endif
