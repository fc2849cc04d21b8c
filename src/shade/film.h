/* Thin films: colours of light that interferes with itself. */
#ifndef SHADE_FILM_H
#define SHADE_FILM_H

#include "scene/material.h"

/* What a film at this point makes of light that the surface sends to the
 * viewer, diffuse, highlight or mirrored: multiplies it. The cosines to the
 * normal are those of where it comes from and of the viewer. */
rgb film_tint(const struct film *film, vec3 point, double lamp, double viewer);

#endif
