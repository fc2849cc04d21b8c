/* Point, spot, cylinder and parallel lights: see lamp.h. */
#include "shade/lamp.h"

#include "base/power.h"
#include "base/smooth.h"

static double radians(double degrees)
{
    return degrees * (3.14159265358979323846 / 180);
}

struct lamp lamp_new(const struct light *light, int number)
{
    struct lamp lamp = {
        .light = light,
        .number = number,
        .axis = vec3_normalise(vec3_sub(light->point_at, light->location)),
        .cosine_radius = cos(radians(light->radius)),
        .cosine_falloff = cos(radians(light->falloff)),
        .fades = light->fade_distance > 0 && light->fade_power > 0,
    };
    lamp.even = light->kind == LIGHT_POINT && !light->parallel && !lamp.fades;
    return lamp;
}

/* 0 at `zero`, 1 at `one` and beyond, smooth between. */
static double smooth_between(double zero, double one, double x)
{
    return smooth_step((x - zero) / (one - zero));
}

/* Smooth in the cosine of the angle to the axis, not in the angle; nothing
 * behind the lamp, however wide it opens. */
static double spot_attenuation(const struct lamp *lamp, double cosine)
{
    double share = 1;
    if (cosine <= 0)
        return 0;
    if (cosine < lamp->cosine_radius) {
        if (cosine <= lamp->cosine_falloff)
            return 0;
        share =
            smooth_between(lamp->cosine_falloff, lamp->cosine_radius, cosine);
    }
    if (lamp->light->tightness != 0)
        share *= power_of(cosine, lamp->light->tightness);
    return share;
}

/* By the distance from the axis; nothing behind the lamp. */
static double cylinder_attenuation(const struct lamp *lamp, vec3 offset)
{
    const struct light *light = lamp->light;
    double along = vec3_dot(offset, lamp->axis);
    double square = vec3_dot(offset, offset) - along * along;
    double r = square > 0 ? sqrt(square) : 0;
    if (along <= 0 || r >= light->falloff)
        return 0;
    double share = 1;
    if (r > light->radius && light->radius > 0)
        share = smooth_between(light->falloff, light->radius, r);
    if (light->tightness != 0)
        share *= power_of(1 - r / light->falloff, light->tightness);
    return share;
}

/* Behind the plane of a parallel light the distance is below 0, and its odd
 * powers are too; those that aren't whole are no number, and no light: POV-Ray
 * has it so (measured). Its endless brightness at -D, and what is below nothing
 * beyond, would be all that other surfaces get to see: both end at what there
 * is before the plane. */
double lamp_fading(const struct lamp *lamp, double distance)
{
    if (!lamp->fades)
        return 1;
    double ratio = distance / lamp->light->fade_distance;
    double below = 1 + power_of(ratio, lamp->light->fade_power);
    if (isnan(below) || below <= 0)
        return 0;
    return 2 / fmax(below, 1);
}

/* Parallel lights and cylinders shine along their axis; their distance is
 * that of the plane through the location. */
static void lamp_look_along(const struct lamp *lamp, vec3 offset,
                            struct lamp_view *view)
{
    view->direction = vec3_negate(lamp->axis);
    view->distance = vec3_dot(offset, lamp->axis);
}

bool lamp_is_parallel(const struct lamp *lamp)
{
    return lamp->light->parallel || lamp->light->kind == LIGHT_CYLINDER;
}

bool lamp_look_uneven(const struct lamp *lamp, vec3 offset, double distance,
                      struct lamp_view *view)
{
    const struct light *light = lamp->light;
    view->attenuation = 0;
    if (lamp_is_parallel(lamp)) {
        lamp_look_along(lamp, offset, view);
    } else {
        view->distance = distance;
        view->direction = vec3_scale(offset, distance > 0 ? -1 / distance : -1);
        if (!(distance > 0))
            return false;
    }
    view->attenuation = 1;
    if (light->kind == LIGHT_SPOT)
        view->attenuation =
            spot_attenuation(lamp, -vec3_dot(view->direction, lamp->axis));
    else if (light->kind == LIGHT_CYLINDER)
        view->attenuation = cylinder_attenuation(lamp, offset);
    if (view->attenuation == 0)
        return false;
    view->attenuation *= lamp_fading(lamp, view->distance);
    return view->attenuation != 0 && isfinite(view->attenuation);
}
