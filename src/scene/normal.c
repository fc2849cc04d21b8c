/* Normals: bumps that exist only in the shading. */
#include "scene/material.h"

vec3 normal_perturbed(const struct normal *perturbation, vec3 point,
                      vec3 normal)
{
    (void)perturbation;
    (void)point;
    return normal;
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
