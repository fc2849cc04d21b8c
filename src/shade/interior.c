/* The list of bodies around a ray, and fading inside them. All measured on
 * POV-Ray 3.7: a ray leaves a body when it meets it the second time, whatever
 * the normals say; the last entered body's index of refraction holds. */
#include "shade/interior.h"

#include <string.h>

#include "base/power.h"
#include "scene/material.h"

int interiors_find(const struct interiors *list, unsigned body)
{
    for (int i = list->count - 1; i >= 0; i--)
        if (list->at[i].body == body)
            return i;
    return -1;
}

void interiors_cross(struct interiors *list, const struct leaf *leaf)
{
    int place = interiors_find(list, leaf->body);
    if (place >= 0) {
        list->count--;
        memmove(&list->at[place], &list->at[place + 1],
                (size_t)(list->count - place) * sizeof list->at[0]);
    } else if (list->count < INTERIORS_MAX) {
        list->at[list->count++] =
            (struct interior_entry){ leaf->look->interior, leaf->body,
                                     leaf->look->hollow };
    }
}

void interiors_clear(struct interiors *list)
{
    list->count = 0;
    list->divided = false;
    list->place = 0;
}

/* Measured: from red to violet it grows by the same factor at each step. */
double interiors_ior_of(const struct interiors *list,
                        const struct interior *interior)
{
    if (!interior || !(interior->ior > 0))
        return 1;
    if (!list->divided || interior->dispersion == 1)
        return interior->ior;
    return interior->ior * pow(interior->dispersion, list->place - 0.5);
}

bool interiors_open(const struct interiors *list)
{
    for (int i = 0; i < list->count; i++)
        if (!list->at[i].hollow)
            return false;
    return true;
}

bool interior_dims_shadows(const struct interior *interior)
{
    return interior && interior->fade_power > 0 && interior->fade_distance > 0;
}

/* 1 / (1 + (d/D)^P) of the light that fade_colour doesn't keep; from power
 * 1000 on exp(-d/D) with an exponent per colour (measured; the manual's
 * "realistic" mode). */
rgb interior_fade(const struct interior *interior, double distance)
{
    if (!interior || !(interior->fade_distance > 0))
        return rgb_grey(1);
    rgb c = interior->fade_colour;
    double depth = distance / interior->fade_distance;
    if (interior->fade_power >= 1000)
        return (rgb){ exp((c.r - 1) * depth), exp((c.g - 1) * depth),
                      exp((c.b - 1) * depth) };
    double left = 1 / (1 + power_of(depth, interior->fade_power));
    return rgb_add_scaled(rgb_scale(c, 1 - left), rgb_grey(1), left);
}
