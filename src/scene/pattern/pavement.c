/* pavement: the plane of x and z paved with tiles of triangles, squares or
 * hexagons. */
#include "scene/pavement.h"
#include "scene/pattern.h"

static const struct pavement pavement_defaults = { 3, 1, 1, 0, 0, 0, NULL };

#define PAVEMENT(name, member, low, high, help)                                \
    {                                                                          \
        name, FIELD_INTEGER, offsetof(struct pavement, member), low, high,     \
            help, false                                                        \
    }

static const struct field pavement_items[] = {
    PAVEMENT("number_of_sides", sides, 3, 6, "3, 4 or 6, of a cell; 3"),
    PAVEMENT("number_of_tiles", tiles, 1, 6, "cells of a tile, 1"),
    PAVEMENT("pattern", pattern, 1, 35, "which of those with such tiles, 1"),
    PAVEMENT("exterior", exterior, 0, 2,
             "corners of tiles: 0 pointed, 1 broken, 2 round"),
    PAVEMENT("interior", interior, 0, 2, "and of what is around them"),
    PAVEMENT("form", form, 0, 3, "and where tiles bend; 3: as the others"),
    { .name = NULL },
};

static double pavement_pattern_value(const struct pattern *pattern, vec3 point)
{
    const struct pavement *pavement = pattern->parameters;
    return pavement->edges ? pavement_value(pavement, point.x, point.z) : 0;
}

const struct pattern_kind pavement_pattern = {
    .name = "pavement",
    .help = "tiles of triangles, squares or hexagons",
    .size = sizeof(struct pavement),
    .defaults = &pavement_defaults,
    .items = pavement_items,
    .value = pavement_pattern_value,
};
