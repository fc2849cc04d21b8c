/* quilted: a cushion in each unit cube. */
#include "scene/pattern.h"

struct quilted {
    double control0, control1;
};

static const struct quilted quilted_defaults = { 1, 1 };

static const struct field quilted_items[] = {
    { "control0", FIELD_FLOAT, offsetof(struct quilted, control0), 0, 0,
      "how steep the cushion begins, 1", false },
    { "control1", FIELD_FLOAT, offsetof(struct quilted, control1), 0, 0,
      "and how it ends, 1", false },
    { .name = NULL },
};

static vec3 from_middle(vec3 point)
{
    return vec3_make(point.x - floor(point.x) - 0.5,
                     point.y - floor(point.y) - 0.5,
                     point.z - floor(point.z) - 0.5);
}

static const double half_diagonal = 0.86602540378443865;

/* A Bezier curve of the distance from the cube's middle (measured). */
static double quilted_curve(const struct quilted *quilted, double t)
{
    double rest = 1 - t;
    double curve = 3 * rest * rest * t * quilted->control0 +
                   3 * rest * t * t * quilted->control1 + t * t * t;
    return curve / half_diagonal;
}

static double quilted_value(const struct pattern *pattern, vec3 point)
{
    vec3 d = from_middle(point);
    double curve = quilted_curve(pattern->parameters, vec3_length(d));
    return curve * (fabs(d.x) + fabs(d.y) + fabs(d.z)) / 3;
}

/* Away from the cube's middle. */
static vec3 quilted_perturbation(const struct pattern *pattern, vec3 point,
                                 vec3 normal)
{
    vec3 d = from_middle(point);
    (void)normal;
    return vec3_scale(d, quilted_curve(pattern->parameters, vec3_length(d)));
}

const struct pattern_kind quilted_pattern = {
    .name = "quilted",
    .still = true,
    .help = "a cushion in each unit cube",
    .size = sizeof(struct quilted),
    .defaults = &quilted_defaults,
    .items = quilted_items,
    .value = quilted_value,
    .perturbation = quilted_perturbation,
};
