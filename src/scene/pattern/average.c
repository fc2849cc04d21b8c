/* average: no pattern of its own; all entries of its map are mixed, each as
 * much as its number says. */
#include "scene/pattern.h"

static double average_value(const struct pattern *pattern, vec3 point)
{
    (void)pattern;
    (void)point;
    return 0;
}

const struct pattern_kind average_pattern = {
    .name = "average",
    .help = "all entries of the map mixed, by their numbers",
    .average = true,
    .value = average_value,
};
