/* cylinder { BASE, APEX, RADIUS [open] } */
#include "scene/conic.h"

static const struct field cylinder_arguments[] = {
    { "base", FIELD_VECTOR, offsetof(struct conic, base), 0, 0,
      "the middle of one end", false },
    { "apex", FIELD_VECTOR, offsetof(struct conic, apex), 0, 0,
      "the middle of the other end", false },
    { "radius", FIELD_FLOAT, offsetof(struct conic, base_radius), 0, 0,
      "the radius", false },
    { .name = NULL },
};

static const struct field cylinder_items[] = {
    { "open", FIELD_FLAG, offsetof(struct conic, open), 0, 0,
      "leave out the caps", false },
    { .name = NULL },
};

static const char *cylinder_prepare(void *shape, struct arena *arena,
                                    const char **warning)
{
    struct conic *conic = shape;
    (void)arena;
    (void)warning;
    conic->apex_radius = conic->base_radius;
    return conic_prepare(conic) ? NULL : "its two ends are the same point";
}

const struct primitive cylinder_primitive = {
    .name = "cylinder",
    .help = "a cylinder between two points",
    .size = sizeof(struct conic),
    .arguments = cylinder_arguments,
    .items = cylinder_items,
    .solid = true,
    .convex = true,
    .prepare = cylinder_prepare,
    .bounds = conic_bounds,
    .told = conic_told,
    .move = conic_move,
    .intersect = conic_intersect,
    .all_many = conic_all_many,
    .crosses = conic_crosses,
    .crosses_many = conic_crosses_many,
    .normal = conic_normal,
    .inside = conic_inside,
    .inside_many = conic_inside_many,
    .meets = conic_meets,
};
