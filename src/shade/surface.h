/* A point of a surface as the illumination model needs it: which layers of
 * paint can be seen, their pigments, normals and mirrors, and what passes. */
#ifndef SHADE_SURFACE_H
#define SHADE_SURFACE_H

#include "base/rgb.h"
#include "world/world.h"
#include "shade/interior.h"

/* The quality levels of +Q at which something begins. */
enum {
    QUALITY_LIT = 2,          /* lights, ambient; below: plain quick_colour */
    QUALITY_SHADOWS = 4,      /* area lights still as points */
    QUALITY_AREA_LIGHTS = 5,  /* the true shadow of area lights */
    QUALITY_TRANSPARENCY = 6, /* transmitted rays; no more quick_colour */
    QUALITY_REFLECTION = 8,   /* reflected rays */
    QUALITY_BUMPS = 8,        /* `normal` */
    QUALITY_FOG = 9,
    QUALITY_PHOTONS = 9,
};

/* One layer of the texture, evaluated at the point. */
struct surface_layer {
    const struct finish *finish;
    colour pigment;
    vec3 normal;    /* unit, perturbed, towards the viewer's side */
    rgb weight;     /* what the layers above let through, 1 for the top one */
    rgb reflection; /* share of mirrored light, in [0,1] if the finish is */
    double reflection_weight; /* of the ray there: finish_mirror.weight */
};

struct picture_place;

struct surface {
    const struct intersection *at;
    vec3 point;
    const struct picture_place *place; /* where the camera sees it; NULL: not at
                                        * first sight */
    bool unmirrored; /* the camera sees it at first sight or through panes */
    double weight;   /* its share in the picture, as far as is known */
    vec3 view;       /* unit, to the viewer */
    const struct interiors *inside; /* what the viewer's ray came through */
    vec3 normal; /* unit, unperturbed, turned towards the viewer */
    vec3 side;   /* unit, not even interpolated, likewise */
    int count;   /* layers that can be seen: those below are hidden */
    struct surface_layer layer[TEXTURE_LAYERS]; /* top first */
    rgb through; /* what all layers let pass; black when the last is hidden */
    vec3 pane;   /* the normal that bends it: the top layer's of the texture
                  * that lets most pass, where several are blended (measured: in
                  * POV-Ray each bends its own) */
    double pane_share; /* the largest colour of what that one lets pass */
};

/* How a surface is looked at. */
struct surface_view {
    vec3 direction;                 /* of the ray, unit */
    const struct interiors *inside; /* the bodies the ray is in */
    double ior;     /* of the medium behind over that before the surface */
    int quality;    /* +Q */
    double bailout; /* layers below this brightness are left out */
    bool smooth;    /* without bumps, which are nothing to one ray of many */
};

/* Evaluates all that can be seen of the texture at `at`, which must stay
 * valid as long as the surface. */
void surface_fill(struct surface *surface, const struct intersection *at,
                  const struct surface_view *view);

/* A layer of paint at a point: unit normals, turned to the viewer, without
 * bumps and with them. */
struct surface_paint {
    const struct finish *finish;
    vec3 point, normal, bumped;
    colour pigment;
};

/* A texture that begins with this layer lets so much pass: keeps `pane`, which
 * is the normal without bumps at first, and pane_share 0. */
void surface_let_pass(struct surface *surface, const struct surface_layer *top,
                      rgb through);

/* What all layers let pass straight through: a shadow ray's view. */
rgb surface_transmittance(const struct intersection *at);

/* The same along a ray: to slope and aoi its origin is the viewer (measured).
 */
rgb surface_passes(const struct intersection *at, vec3 direction);

/* Gives unit normals in the world a layer's bumps, at points of the texture's
 * space; all of it must be of space. `to` and `from`: world <-> the texture's
 * space; `picked`: it is of a texture that a map has picked. */
void layer_bump_many(const struct layer *layer, const affine *to,
                     const affine *from, bool picked,
                     const struct spots *points, struct spots *normals);

/* The unit normal there, turned against the ray's direction, with the bumps of
 * the topmost layer. */
vec3 surface_bumps(const struct intersection *at, vec3 direction);

/* Whether light from this unit direction can change the picture: some layer
 * that reflects faces it. Ask before tracing a shadow ray. */
bool surface_faces(const struct surface *surface, vec3 direction);

/* Brightness that decides how much a coloured ray weighs and how opaque a
 * filter is (measured: .297, .589, .114). Exact for greys. */
static inline double rgb_brightness(rgb c)
{
    return c.g + 0.297 * (c.r - c.g) + 0.114 * (c.b - c.g);
}

/* Light from one direction. */
struct light_sample {
    vec3 direction;  /* unit, from the point to the light */
    rgb colour;      /* of the light at the point: attenuation and visibility
                      * multiplied in, no cosine */
    bool highlights; /* false for shadowless lights: diffuse only */
    bool diffused;   /* diffuse light is counted elsewhere: highlights only */
};

/* Light without a direction. */
struct diffuse_light {
    rgb ambient;    /* multiplies finish ambient (POV-Ray's ambient_light) */
    rgb irradiance; /* multiplies finish diffuse */
};

#endif
