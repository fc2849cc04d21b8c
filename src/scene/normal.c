/* Normals: bumps that exist only in the shading. All was measured with POV-Ray
 * 3.7: the tilt is computed in the pattern's own space, so that a texture's
 * bumps grow with it when it is scaled. */
#include "scene/material.h"

/* The value's slope by differences along the corners of a tetrahedron; where
 * the value is linear this is 2/15 of its gradient for whatever accuracy. */
static vec3 pattern_slope(const struct pattern *pattern, vec3 point,
                          double accuracy)
{
    static const vec3 corners[4] = {
        { 0.94280904158206336, -1.0 / 3, 0 },
        { -0.47140452079103168, -1.0 / 3, 0.81649658092772603 },
        { -0.47140452079103168, -1.0 / 3, -0.81649658092772603 },
        { 0, 1, 0 },
    };
    vec3 sum = { 0, 0, 0 };
    for (int i = 0; i < 4; i++) {
        vec3 at = vec3_along(point, corners[i], accuracy);
        sum = vec3_along(sum, corners[i], pattern_value_at(pattern, at));
    }
    return vec3_scale(sum, 0.1 / accuracy);
}

/* The unit normal in the pattern's space: by the cofactors of the map there,
 * which are its inverse transpose up to a factor. */
static vec3 normal_into_pattern(const affine *map, vec3 normal)
{
    vec3 row[3];
    for (int i = 0; i < 3; i++)
        row[i] = vec3_make(map->m[i][0], map->m[i][1], map->m[i][2]);
    vec3 first = vec3_cross(row[1], row[2]);
    vec3 local = { vec3_dot(first, normal),
                   vec3_dot(vec3_cross(row[2], row[0]), normal),
                   vec3_dot(vec3_cross(row[0], row[1]), normal) };
    bool mirrored = vec3_dot(row[0], first) < 0;
    return vec3_normalise(mirrored ? vec3_negate(local) : local);
}

vec3 normal_perturbed(const struct normal *perturbation, vec3 point,
                      vec3 normal)
{
    const struct pattern *pattern = &perturbation->pattern;
    if (!pattern->kind || perturbation->amount == 0)
        return normal;
    vec3 at = pattern_locate(pattern, point);
    vec3 local = normal_into_pattern(&pattern->inverse, normal);
    vec3 tilt;
    if (pattern->kind->perturbation)
        tilt = pattern->kind->perturbation(pattern, at, local);
    else
        tilt = vec3_negate(pattern_slope(pattern, at, perturbation->accuracy));
    local = vec3_along(local, tilt, perturbation->amount);
    vec3 result = vec3_normalise(affine_normal(&pattern->inverse, local));
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
