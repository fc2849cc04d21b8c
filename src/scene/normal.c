/* Normals: bumps that exist only in the shading. All was measured with POV-Ray
 * 3.7: the tilt is computed in the pattern's own space, so that a texture's
 * bumps grow with it when it is scaled. */
#include "scene/image_map.h"
#include "scene/map_entry.h"
#include "scene/material.h"
#include "scene/spots.h"

/* Between two entries a cubic with their heights and slopes at its ends. */
static double slope_height(const struct slope_map *map, double value)
{
    const struct slope_entry *entries = map->entries;
    struct map_place place =
        map_place_of(&entries[0].value, sizeof entries[0], map->count, value);
    const struct slope_entry *b = &entries[place.entry], *a = b - 1;
    if (place.share >= 1 || place.entry == 0)
        return b->height;
    double t = place.share, s = 1 - t;
    return s * s * (1 + 2 * t) * a->height + t * t * (1 + 2 * s) * b->height +
           s * t * (s * a->slope - t * b->slope);
}

/* The value's slope by differences along the corners of a tetrahedron; where
 * the value is linear this is 2/15 of its gradient for whatever accuracy. */
static vec3 normal_slope(const struct normal *normal, vec3 point)
{
    static const vec3 corners[4] = {
        { 0.94280904158206336, -1.0 / 3, 0 },
        { -0.47140452079103168, -1.0 / 3, 0.81649658092772603 },
        { -0.47140452079103168, -1.0 / 3, -0.81649658092772603 },
        { 0, 1, 0 },
    };
    struct spots at;
    double value[4];
    vec3 sum = { 0, 0, 0 };
    at.count = 0;
    for (int i = 0; i < 4; i++)
        spots_add(&at, vec3_along(point, corners[i], normal->accuracy));
    pattern_values_at(&normal->pattern, &at, value);
    for (int i = 0; i < 4; i++)
        sum = vec3_along(sum, corners[i],
                         normal->slopes ? slope_height(normal->slopes, value[i])
                                        : value[i]);
    return vec3_scale(sum, 0.1 / normal->accuracy);
}

/* The unit normal in the pattern's space: by the cofactors of the map there,
 * which are its inverse transpose up to a factor; *length is what it has by the
 * inverse transpose. */
static vec3 normal_into_pattern(const struct cofactors *map, vec3 normal,
                                double *length)
{
    vec3 local = { vec3_dot(map->row[0], normal), vec3_dot(map->row[1], normal),
                   vec3_dot(map->row[2], normal) };
    *length = vec3_length(local) / fabs(map->determinant);
    return vec3_normalise(map->determinant < 0 ? vec3_negate(local) : local);
}

/* Where a normal is bent: in the pattern's own space, and on which surface. */
struct bend {
    vec3 point, normal;
    const struct uv_source *surface;
};

static vec3 entry_normal(const struct normal_entry *entry,
                         const struct bend *at)
{
    if (!entry->normal)
        return at->normal;
    return normal_perturbed(
        entry->normal,
        pattern_start(&entry->normal->pattern, at->point, at->surface),
        at->normal, at->surface);
}

static vec3 average_normal(const struct normal_map *map, const struct bend *at)
{
    vec3 sum = { 0, 0, 0 };
    for (size_t i = 0; i < map->count; i++)
        sum = vec3_along(sum, entry_normal(&map->entries[i], at),
                         map->entries[i].value);
    return sum;
}

/* What the pattern picks of other normals, in its own space. */
static vec3 map_normal(const struct normal *perturbation, const struct bend *at)
{
    const struct pattern_kind *kind = perturbation->pattern.kind;
    const struct normal_map *map = perturbation->map;
    const struct normal_entry *entries = map->entries;
    if (kind->average)
        return average_normal(map, at);
    double value = pattern_value_at(&perturbation->pattern, at->point);
    struct map_place place =
        map_place_of(&entries[0].value, sizeof entries[0], map->count, value);
    const struct normal_entry *entry = &entries[place.entry];
    vec3 high = entry_normal(entry, at);
    if (place.share >= 1 || kind->blocks)
        return high;
    return vec3_mix(entry_normal(entry - 1, at), high, place.share);
}

/* `length` is that of the normal for bumps that are not scaled; else 1. */
static vec3 normal_tilted(const struct normal *perturbation,
                          const struct bend *at, double length)
{
    const struct pattern *pattern = &perturbation->pattern;
    vec3 point = at->point, normal = at->normal, tilt;
    if (perturbation->map)
        return map_normal(perturbation, at);
    if (perturbation->bumps)
        tilt = image_map_tilt(perturbation->bumps, point, normal);
    else if (pattern->kind->perturbation && !perturbation->slopes)
        tilt = pattern->kind->perturbation(pattern, point, normal);
    else
        tilt = vec3_negate(normal_slope(perturbation, point));
    bool full = pattern->kind && pattern->kind->full;
    return vec3_along(vec3_scale(normal, length), tilt,
                      full ? 1 : perturbation->amount);
}

bool normal_tilts(const struct normal *perturbation)
{
    return perturbation->pattern.kind || perturbation->bumps;
}

static bool normal_spatial(const struct normal *normal, int *budget)
{
    const struct pattern *pattern = &normal->pattern;
    const struct normal_map *map = normal->map;
    if (--*budget < 0 || pattern->uv || (pattern->kind && pattern->kind->seen))
        return false;
    for (size_t i = 0; map && i < map->count; i++)
        if (map->entries[i].normal &&
            !normal_spatial(map->entries[i].normal, budget))
            return false;
    return true;
}

bool normal_is_of_space(const struct normal *perturbation)
{
    int budget = 1000;
    return normal_spatial(perturbation, &budget);
}

vec3 normal_perturbed(const struct normal *perturbation, vec3 point,
                      vec3 normal, const struct uv_source *surface)
{
    const struct pattern *pattern = &perturbation->pattern;
    if (!normal_tilts(perturbation) ||
        (perturbation->amount == 0 && !perturbation->map))
        return normal;
    struct bend at = { .point = pattern_locate(pattern, point),
                       .surface = surface };
    const affine *inward = &pattern->inverse;
    const struct cofactors *cofactors = &pattern->cofactors;
    affine warped;
    struct cofactors of_warped;
    if (pattern->warps) {
        warped = pattern_affine(pattern);
        of_warped = affine_cofactors(&warped);
        inward = &warped;
        cofactors = &of_warped;
    }
    double height;
    at.normal = normal_into_pattern(cofactors, normal, &height);
    if (!perturbation->level || !isfinite(height))
        height = 1;
    vec3 local = normal_tilted(perturbation, &at, height);
    vec3 result = vec3_normalise(affine_normal(inward, local));
    double length = vec3_dot(result, result);
    return length > 0.5 && length < 2 ? result : normal;
}

const struct normal *normal_moved(struct arena *arena,
                                  const struct normal *normal,
                                  const affine *transform)
{
    struct normal *moved = ARENA_NEW(arena, struct normal);
    *moved = *normal;
    pattern_transform(&moved->pattern, transform);
    return moved;
}
