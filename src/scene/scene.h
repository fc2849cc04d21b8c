/* Everything a scene file says, as plain data; const after parsing. One arena
 * holds all of it. */
#ifndef SCENE_SCENE_H
#define SCENE_SCENE_H

#include "base/arena.h"
#include "base/rgb.h"
#include "scene/camera.h"
#include "scene/light_settings.h"
#include "scene/material.h"
#include "scene/noise.h"
#include "scene/object.h"
#include "scene/photon.h"
#include "scene/rainbow.h"

struct fog {
    double distance; /* > 0: T = exp(-d / distance) */
    colour colour;   /* filter and transmit keep some of what is behind */
    bool ground;     /* fog_type 2: thins out above a height */
    vec3 up;         /* unit, of ground fog; so are these: */
    double offset;   /* height up to which it is the same everywhere */
    double altitude; /* height above `offset` where half of it is left */
    bool turbulent;
    struct turbulence turbulence; /* stretches the point looked up */
    double turbulent_share; /* what of the way noise of 1 takes away, at most */
};

/* Pigments looked up in the direction of a ray that hits nothing, from the
 * bottom up. */
struct sky_sphere {
    const struct pigment **pigments;
    size_t count;
    rgb emission; /* multiplies */
};

enum gamma_kind {
    GAMMA_NONE,  /* numbers go out as they are: no #version, no assumed_gamma */
    GAMMA_POWER, /* v^assumed_gamma is linear light */
    GAMMA_SRGB,  /* decoded by the sRGB curve */
};

enum { SETTINGS_LEVELS_MAX = 256 }; /* of max_trace_level, as in POV-Ray */

/* global_settings */
/* subsurface {} */
struct subsurface_settings {
    bool on;            /* it was said */
    int samples[2];     /* of light that was scattered often, and once */
    double mm_per_unit; /* 10 */
};

struct settings {
    enum gamma_kind gamma_kind;
    double assumed_gamma;
    rgb ambient_light;   /* white */
    rgb irid_wavelength; /* of red, green and blue, in units of thickness */
    int max_trace_level; /* 5 */
    double adc_bailout;  /* 1/255 */
    bool radiosity;      /* radiosity {} was said, */
    struct radiosity_settings radiosity_said; /* and that in it */
    bool old_filter;       /* before 3.7, of skies: see shade/background.c */
    bool clear_background; /* said before 3.7: with +UA seen in mirrors only */
    struct light_mesh_settings light_mesh;
    struct skeleton_settings skeleton;
    struct photon_settings photons;
    struct subsurface_settings subsurface;
};

/* Whether sky and background light the scene, as with radiosity; else what
 * they would give is what `ambient` stands for (shade/ambience.h). */
static inline bool settings_sky(const struct settings *settings)
{
    return settings->radiosity || settings->light_mesh.sky;
}

/* Whether surfaces have their `ambient` beside radiosity, as before version
 * 3.7. */
static inline bool settings_keep_ambient(const struct settings *settings)
{
    return settings->radiosity && settings->old_filter;
}

struct scene {
    struct arena *arena;
    struct camera camera;
    bool camera_said; /* else it is the default one */
    struct settings settings;
    colour background;            /* clear; transmit counts for +UA */
    const struct sky_sphere *sky; /* or NULL */
    struct {
        struct fog *items;
        size_t count, capacity;
    } fogs;
    struct {
        struct rainbow *items;
        size_t count, capacity;
    } rainbows;
    /* Objects and lights at the top level, in file order. Each has a texture
     * by now: its own or the #default in force where it was written. */
    struct {
        const struct object **items;
        size_t count, capacity;
    } objects;
    bool windows;                /* of lamps that are projected_through */
    unsigned light_groups;       /* how many there are: 1 to that */
    struct media media;          /* of all space */
    bool misty;                  /* there are media somewhere */
    bool murky;                  /* and some of them take light */
    struct noise_settings noise; /* of all patterns and fogs */
    double version; /* the language's version the scene asked for */
};

/* Whether lamps light some places and not others by what a mesh point between
 * them can't know. */
static inline bool scene_lamps_choose(const struct scene *scene)
{
    return scene->light_groups > 0 || scene->windows;
}

/* `memory_limit` bytes for its arena, 0: none. */
struct scene *scene_new(size_t memory_limit);
void scene_free(struct scene *scene);

#endif
