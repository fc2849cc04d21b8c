/* Light sources made ready for shading: direction, distance and attenuation at
 * a point. Used by every lighting method. Formulas of sections 5.5 and 5.6 of
 * tests/povray.md, measured on POV-Ray 3.7. */
#ifndef SHADE_LAMP_H
#define SHADE_LAMP_H

#include "world/solid.h"
#include "scene/light.h"

/* A light with what doesn't change from point to point. */
struct lamp {
    const struct light *light;
    int number;                           /* as in world_lights() */
    vec3 axis;                            /* unit, location to point_at */
    double cosine_radius, cosine_falloff; /* of spots */
    bool fades;
    bool even; /* shines as brightly everywhere, from one point */
};

/* The lamp as a point sees it. */
struct lamp_view {
    vec3 direction; /* unit, from the point to the lamp */
    /* How far anything can stand between: a shadow ray's length. Not positive
     * for points behind the plane of a parallel light, which nothing can
     * shadow. */
    double distance;
    double attenuation; /* cone and fading; times light->colour */
};

struct lamp lamp_new(const struct light *light, int number);

/* Whether its rays are parallel: said so, or a cylinder. */
bool lamp_is_parallel(const struct lamp *lamp);

/* Whether it lights what a light_group may keep it from. */
static inline bool light_is_for(const struct light *light,
                                const struct leaf *leaf)
{
    return light->group ? leaf->look->light_group == light->group
                        : !leaf->look->no_global_lights;
}

static inline bool lamp_is_for(const struct lamp *lamp, const struct leaf *leaf)
{
    return light_is_for(lamp->light, leaf);
}

/* Whether it lights media on a ray's way to that leaf; NULL: the way ends
 * nowhere. That the leaf and not what holds the media is of a light_group is
 * as in POV-Ray (measured). */
static inline bool lamp_is_for_media(const struct lamp *lamp,
                                     const struct leaf *end)
{
    const struct light *light = lamp->light;
    return !light->shadowless && !light->no_media &&
           (end ? light_is_for(light, end) : !light->group);
}

/* As lamp_look, of any lamp: from it to the point. */
bool lamp_look_uneven(const struct lamp *lamp, vec3 offset, double distance,
                      struct lamp_view *view);

/* Sees the lamp as if it stood at `location` (light->location, or a point of
 * an area light's grid) from `point`. Returns false if no light gets there;
 * direction and distance are given all the same. */
static inline bool lamp_look(const struct lamp *lamp, vec3 location, vec3 point,
                             struct lamp_view *view)
{
    vec3 offset = vec3_sub(point, location);
    double distance = vec3_length(offset);
    if (!lamp->even || !(distance > 0))
        return lamp_look_uneven(lamp, offset, distance, view);
    view->distance = distance;
    view->direction = vec3_scale(offset, -1 / distance);
    view->attenuation = 1;
    return true;
}

/* 2 / (1 + (d/D)^P): 1 at the distance D; always 1 for lamps without fading. */
double lamp_fading(const struct lamp *lamp, double distance);

#endif
