/* Light sources as data: see light.h. */
#include "scene/light.h"

#include "scene/fields.h"

struct light light_default(void)
{
    return (struct light){
        .kind = LIGHT_POINT,
        .point_at = { 0, 0, 1 },
        .colour = { 1, 1, 1 },
        .radius = 30,
        .falloff = 45,
        .size1 = 1,
        .size2 = 1,
        .adaptive = -1,
        .photons = photon_flags_default,
    };
}

struct light light_moved(const struct light *light, const affine *transform)
{
    struct light moved = *light;
    moved.location = affine_point(transform, light->location);
    moved.point_at = affine_point(transform, light->point_at);
    moved.axis1 = affine_direction(transform, light->axis1);
    moved.axis2 = affine_direction(transform, light->axis2);
    return moved;
}

const struct field *const light_tables[] = { lamp_kind_fields, directed_fields,
                                             lamp_fields, NULL };

size_t light_said(const struct light *light, double said[LIGHT_SAID_MOST])
{
    struct light plain = *light;
    size_t count = 0;
    plain.colour = rgb_grey(0);
    if (light->kind == LIGHT_POINT && !light->parallel && !light->area)
        plain.point_at = vec3_make(0, 0, 0);
    if (!light->area)
        plain.axis1 = plain.axis2 = vec3_make(0, 0, 0);
    for (int i = 0; light_tables[i]; i++)
        count +=
            field_numbers(light_tables[i], &plain, FIELDS_BOTH, said + count);
    return count +
           field_numbers(lamp_photon_fields, &plain, FIELDS_BOTH, said + count);
}
