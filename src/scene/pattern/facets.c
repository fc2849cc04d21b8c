/* facets: normals that are the same all over a facet. Of a size: the facets are
 * the crackle cells of the sphere of normals; by coords: those of space, each
 * tilted to a side at random (measured). */
#include "scene/crackle.h"
#include "scene/noise.h"

struct facets {
    double size, coords;
};

static const struct facets facets_defaults = { 0.1, 0 };

static const struct field facets_items[] = {
    { "size", FIELD_FLOAT, offsetof(struct facets, size), 0, 0,
      "of facets, 0.1: where normals are alike, or of cells of space" },
    { "coords", FIELD_FLOAT, offsetof(struct facets, coords), 0, 0,
      "how much facets tilt that are cells of space" },
    { .name = NULL },
};

static vec3 facets_perturbation(const struct pattern *pattern, vec3 point,
                                vec3 normal)
{
    const struct facets *facets = pattern->parameters;
    if (facets->coords != 0) {
        vec3 cell = crackle_centre(vec3_scale(point, 1 / facets->size));
        vec3 tilt = noise_vector(cell);
        tilt = vec3_along(tilt, normal, -vec3_dot(tilt, normal));
        return vec3_scale(tilt, facets->coords);
    }
    vec3 facet =
        vec3_normalise(crackle_centre(vec3_scale(normal, 1 / facets->size)));
    return vec3_finite(facet) ? vec3_sub(facet, normal) : vec3_make(0, 0, 0);
}

static double facets_value(const struct pattern *pattern, vec3 point)
{
    (void)pattern;
    (void)point;
    return 0;
}

const struct pattern_kind facets_pattern = {
    .name = "facets",
    .help = "of normals alone: flat facets",
    .size = sizeof(struct facets),
    .defaults = &facets_defaults,
    .items = facets_items,
    .value = facets_value,
    .perturbation = facets_perturbation,
    .full = true,
};
