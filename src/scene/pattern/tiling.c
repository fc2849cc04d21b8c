/* tiling: the plane of x and z paved with regular polygons and bricks. */
#include "scene/pattern.h"
#include "scene/tiling.h"

static double tiling_pattern_value(const struct pattern *pattern, vec3 point)
{
    const struct tiling_use *use = pattern->parameters;
    if (use->penrose)
        return use->penrose(point.x, point.z);
    return tiling_value(use->tiling, point.x, point.z);
}

static const struct field tiling_arguments[] = {
    { "tiling", FIELD_INTEGER, offsetof(struct tiling_use, number), 1, 27,
      "which one, 1 to 27", false },
    { .name = NULL },
};

const struct pattern_kind tiling_pattern = {
    .name = "tiling",
    .help = "the plane paved in one of 27 ways, tiles have bevels: tiling 5",
    .size = sizeof(struct tiling_use),
    .arguments = tiling_arguments,
    .value = tiling_pattern_value,
};
