/* cone { BASE, BASE_RADIUS, APEX, APEX_RADIUS [open] } */
#include "base/lesser.h"
#include "scene/conic.h"

static const struct field cone_arguments[] = {
    { "base", FIELD_VECTOR, offsetof(struct conic, base), 0, 0,
      "the middle of one end", false },
    { "base radius", FIELD_FLOAT, offsetof(struct conic, base_radius), 0, 0,
      "the radius there", false },
    { "apex", FIELD_VECTOR, offsetof(struct conic, apex), 0, 0,
      "the middle of the other end", false },
    { "apex radius", FIELD_FLOAT, offsetof(struct conic, apex_radius), 0, 0,
      "the radius there", false },
    { .name = NULL },
};

static const struct field cone_items[] = {
    { "open", FIELD_FLAG, offsetof(struct conic, open), 0, 0,
      "leave out the caps", false },
    { .name = NULL },
};

/* POV-Ray measures by the greater radius: a cone of two that are below 0 is a
 * cylinder of the lesser, and one that has no radius above 0 is not there
 * (measured; tests/render/cone_negative). */
static const char *cone_prepare(void *shape, struct arena *arena,
                                const char **warning)
{
    struct conic *cone = shape;
    double radius = greater(cone->base_radius, cone->apex_radius);
    (void)arena;
    if (radius < 0)
        cone->base_radius = cone->apex_radius = -radius;
    if (!conic_prepare(cone))
        return "its two ends are the same point";
    if (radius == 0)
        *warning = "neither of its radii is above 0";
    return NULL;
}

const struct primitive cone_primitive = {
    .name = "cone",
    .help = "a cone between two points, pointed if a radius is 0",
    .size = sizeof(struct conic),
    .arguments = cone_arguments,
    .items = cone_items,
    .solid = true,
    .prepare = cone_prepare,
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
