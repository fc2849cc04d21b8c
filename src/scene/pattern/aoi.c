/* aoi: the angle between the surface and whoever looks at it. */
#include "scene/pattern.h"

static double aoi_value(const struct pattern *pattern, vec3 point)
{
    (void)pattern;
    (void)point;
    return 0;
}

/* 1 where the surface faces the viewer, 0.5 at its edge. */
static double aoi_seen(const struct pattern *pattern, vec3 point,
                       const struct uv_source *surface)
{
    double cosine = vec3_dot(surface->normal, surface->view);
    (void)pattern;
    (void)point;
    return 1 - acos(fmax(-1, fmin(cosine, 1))) / M_PI;
}

const struct pattern_kind aoi_pattern = {
    .name = "aoi",
    .help = "how much the surface faces the viewer",
    .value = aoi_value,
    .seen = aoi_seen,
};
