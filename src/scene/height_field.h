/* height_field{}: a grid of heights over the square from 0 to 1 in x and z; the
 * first are at z = 1. What is under them is inside. */
#ifndef SCENE_HEIGHT_FIELD_H
#define SCENE_HEIGHT_FIELD_H

#include "scene/height_grid.h"
#include "scene/primitive.h"

struct height_field {
    struct height_grid grid; /* heights in 65536ths */
    struct terms digest;     /* of the heights: their hash, as numbers */
    bool smooth;
    double water_level; /* what is lower is not there */
};

extern const struct primitive height_field_primitive;

#endif
