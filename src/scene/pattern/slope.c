/* slope: how steep the surface is, and how high. */
#include "scene/pattern.h"
#include "scene/slope.h"

static double slope_value(const struct pattern *pattern, vec3 point)
{
    (void)pattern;
    (void)point;
    return 0;
}

static double slope_share(double value, const double range[2])
{
    double width = range[1] - range[0];
    return width != 0 ? (value - range[0]) / width : value;
}

/* Measured: the angle to a direction of the world, whatever the pattern's
 * transformations; the altitude by the pattern's own point; of both the mean,
 * weighted with the lengths of the vectors. */
static double slope_seen(const struct pattern *pattern, vec3 point,
                         const struct uv_source *surface)
{
    const struct slope *slope = pattern->parameters;
    vec3 towards = slope->direction;
    if (slope->point_at)
        towards = vec3_sub(towards, surface->place);
    double length = vec3_length(towards);
    double cosine =
        length > 0 ? vec3_dot(towards, surface->normal) / length : 0;
    double steep = 1 - acos(fmax(-1, fmin(cosine, 1))) / M_PI;
    double value = slope_share(steep, slope->slopes);
    double weight = vec3_length(slope->altitude);
    if (!(weight > 0))
        return value;
    double high = vec3_dot(slope->altitude, point) / weight;
    return (value * length + slope_share(high, slope->altitudes) * weight) /
           (length + weight);
}

static const struct slope slope_defaults = {
    .direction = { 0, 1, 0 },
    .slopes = { 0, 1 },
    .altitudes = { 0, 1 },
};

/* For fingerprints; read by parse/pattern.c. */
static const struct field slope_arguments[] = {
    { "direction", FIELD_VECTOR, offsetof(struct slope, direction), 0, 0,
      "that slopes are measured from, or the place" },
    { "point_at", FIELD_BOOL, offsetof(struct slope, point_at), 0, 0,
      "it is a place" },
    { "slopes", FIELD_PAIR, offsetof(struct slope, slopes), 0, 0,
      "what is 0 and what is 1" },
    { "altitude", FIELD_VECTOR, offsetof(struct slope, altitude), 0, 0,
      "upwards" },
    { "altitudes", FIELD_PAIR, offsetof(struct slope, altitudes), 0, 0,
      "what is 0 and what is 1" },
    { .name = NULL },
};

const struct pattern_kind slope_pattern = {
    .name = "slope",
    .help = "how steep the surface is: slope { y altitude y, 0, 9 }",
    .size = sizeof(struct slope),
    .defaults = &slope_defaults,
    .arguments = slope_arguments,
    .value = slope_value,
    .seen = slope_seen,
};
