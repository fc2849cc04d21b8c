/* A point of a surface as the illumination model needs it. */
#ifndef SHADE_SURFACE_H
#define SHADE_SURFACE_H

#include "base/rgb.h"
#include "embree/world.h"

enum { SURFACE_LAYERS = 16 }; /* most layers of one texture */

/* One layer of the texture, evaluated at the point. */
struct surface_layer {
    const struct finish *finish;
    colour pigment;
    vec3 normal; /* unit, perturbed, towards the viewer's side */
};

struct surface {
    const struct intersection *at;
    vec3 point;
    vec3 view;   /* unit, to the viewer */
    vec3 normal; /* unit, unperturbed, turned towards the viewer */
    bool inside; /* the viewer is on the inner side */
    int count;
    struct surface_layer layer[SURFACE_LAYERS]; /* bottom first */
};

/* Light from one direction. */
struct light_sample {
    vec3 direction;  /* unit, from the point to the light */
    rgb colour;      /* of the light at the point: attenuation and visibility
                      * multiplied in, no cosine */
    bool highlights; /* false for shadowless lights: diffuse only */
};

#endif
