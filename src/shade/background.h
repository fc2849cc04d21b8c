/* What lies between and behind the objects: fog, sky, background. */
#ifndef SHADE_BACKGROUND_H
#define SHADE_BACKGROUND_H

#include "scene/scene.h"
#include "scene/spots.h"

struct rays;

/* Light seen along a ray and what it lets pass of the light behind it. */
struct veil {
    rgb light;
    rgb through;
};

/* All fogs along the ray (its direction is unit) over `distance` from its
 * origin, INFINITY where it hits nothing. */
struct veil fog_veil(const struct scene *scene, const struct ray *ray,
                     double distance);

/* The same of those that the bits `lanes` stand for, to the bit. */
void fog_veils(const struct scene *scene, const struct rays *rays,
               unsigned lanes, const double *distances, struct veil *veils);

/* The sky sphere in this unit direction; clear without one. */
struct veil sky_veil(const struct scene *scene, vec3 direction);

/* The same in several directions, to the bit; a veil for each. */
void sky_veils(const struct scene *scene, const struct spots *directions,
               struct veil *veils);

/* Sky and background as surfaces see them in this direction, +UA or not. */
rgb background_light(const struct scene *scene, vec3 direction);

#endif
