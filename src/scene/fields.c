/* The tables: see fields.h. The order of rows is that of fingerprints, which
 * tell whether a light mesh in a file is of a scene: a row that moves makes
 * those of yesterday strangers. */
#include "scene/fields.h"

#include <math.h>

#include "scene/light.h"
#include "scene/medium.h"
#include "scene/scene.h"
#include "scene/warp.h"

#define LIGHT(name, kind, member, low, high, help)                             \
    {                                                                          \
        name, kind, offsetof(struct light, member), low, high, help            \
    }

const struct field lamp_kind_fields[] = {
    LIGHT("kind of lamp", FIELD_CHOICE, kind, 0, 0, NULL),
    LIGHT("parallel", FIELD_FLAG, parallel, 0, 0,
          "rays parallel to location - point_at"),
    LIGHT("lamp place", FIELD_VECTOR, location, 0, 0, NULL),
    { NULL },
};

const struct field directed_fields[] = {
    LIGHT("point_at", FIELD_VECTOR, point_at, 0, 0, "where it shines, z"),
    LIGHT("radius", FIELD_FLOAT, radius, 0, 0,
          "full brightness inside: 30 degrees, or a cylinder's 0.75"),
    LIGHT("falloff", FIELD_FLOAT, falloff, 0, 0,
          "dark outside: 45 degrees, or a cylinder's 1"),
    LIGHT("tightness", FIELD_FLOAT, tightness, 0, 0,
          "how it gets darker from the axis, 0"),
    { NULL },
};

const struct field lamp_fields[] = {
    LIGHT("fade_distance", FIELD_FLOAT, fade_distance, 0, 0,
          "where the light is as bright as written, 0: no fading"),
    LIGHT("fade_power", FIELD_FLOAT, fade_power, 0, 0,
          "how fast it fades, 0: not"),
    LIGHT("shadowless", FIELD_FLAG, shadowless, 0, 0,
          "no shadows and no highlights"),
    LIGHT("media_attenuation", FIELD_BOOL, media_attenuation, 0, 0,
          "weakened by fog on its way"),
    LIGHT("no media interaction", FIELD_FLAG, no_media, 0, 0, NULL),
    LIGHT("photons refraction", FIELD_CHOICE, photons.refraction, 0, 0, NULL),
    LIGHT("light group", FIELD_INTEGER, group, 0, 0, NULL),
    LIGHT("area light", FIELD_FLAG, area, 0, 0, NULL),
    LIGHT("area size 1", FIELD_INTEGER, size1, 0, 0, NULL),
    LIGHT("area size 2", FIELD_INTEGER, size2, 0, 0, NULL),
    LIGHT("adaptive", FIELD_INTEGER, adaptive, 0, 20,
          "subdivisions of an area light always done"),
    LIGHT("circular", FIELD_FLAG, circular, 0, 0, "a round area light"),
    LIGHT("orient", FIELD_FLAG, orient, 0, 0,
          "an area light that turns to what it lights"),
    LIGHT("jitter", FIELD_FLAG, jitter, 0, 0,
          "samples of an area light moved at random"),
    LIGHT("area_illumination", FIELD_BOOL, area_illumination, 0, 0,
          "light, not only shadows, from the whole area"),
    LIGHT("area axis 1", FIELD_VECTOR, axis1, 0, 0, NULL),
    LIGHT("area axis 2", FIELD_VECTOR, axis2, 0, 0, NULL),
    LIGHT("lamp colour", FIELD_RGB, colour, 0, 0, NULL),
    { NULL },
};

const struct field lamp_photon_fields[] = {
    LIGHT("photons reflection", FIELD_CHOICE, photons.reflection, 0, 0, NULL),
    LIGHT("photons target", FIELD_FLAG, photons.target, 0, 0, NULL),
    LIGHT("photons spacing", FIELD_FLOAT, photons.spacing, 0, 0, NULL),
    LIGHT("photons unlit", FIELD_FLAG, photons.unlit, 0, 0, NULL),
    LIGHT("photons area", FIELD_FLAG, photons.area, 0, 0, NULL),
    { NULL },
};

#define INTERIOR(name, kind, member, low, high, help)                          \
    {                                                                          \
        name, kind, offsetof(struct interior, member), low, high, help         \
    }

const struct field interior_fields[] = {
    INTERIOR("ior", FIELD_FLOAT, ior, 0, 0, "index of refraction, 1"),
    INTERIOR("fade_distance", FIELD_FLOAT, fade_distance, 0, 0,
             "the way after which half the light is left, 0: never"),
    INTERIOR("fade_power", FIELD_FLOAT, fade_power, 0, 0,
             "how fast it dims, 0: not at all"),
    INTERIOR("fade_colour", FIELD_RGB, fade_colour, 0, 0,
             "what is left after a long way, black"),
    INTERIOR("caustics", FIELD_FLOAT, caustics, 0, HUGE_VAL,
             "sharpness of the light that is pretended to gather, 0: none"),
    INTERIOR("dispersion", FIELD_FLOAT, dispersion, 0.01, 100,
             "ior of violet light over that of red, 1"),
    { "dispersion_samples", FIELD_INTEGER,
      offsetof(struct interior, dispersion_samples), 2, 1000,
      "colours that light is divided into, 7",
      .dark = "only camera rays and photons are divided into colours" },
    { NULL },
};

#define MEDIUM(name, kind, member, low, high, help)                            \
    {                                                                          \
        name, kind, offsetof(struct medium, member), low, high, help           \
    }

const struct field scattering_fields[] = {
    MEDIUM("type of scattering", FIELD_CHOICE, phase, 0, 0, NULL),
    MEDIUM("eccentricity", FIELD_FLOAT, eccentricity, -0.999999, 0.999999,
           "of type 5: 1 forwards, -1 backwards, 0"),
    MEDIUM("extinction", FIELD_FLOAT, extinction, 0, 1e9,
           "how much of it is lost to light that goes straight on, 1"),
    { NULL },
};

const struct field medium_fields[] = {
    MEDIUM("absorption", FIELD_RGB, absorption, 0, 0,
           "what a unit of length swallows of light, 0"),
    MEDIUM("emission", FIELD_RGB, emission, 0, 0,
           "light of its own that a unit of length gives, 0"),
    MEDIUM("scattered light", FIELD_RGB, scattering, 0, 0, NULL),
    MEDIUM("method", FIELD_INTEGER, method, 1, 3,
           "1: samples at random; 2: in a row, and more where they differ; 3: "
           "between those that differ, the default"),
    MEDIUM("samples at least", FIELD_INTEGER, samples, 0, 0, NULL),
    MEDIUM("intervals", FIELD_INTEGER, intervals, 1, MEDIUM_INTERVALS_LIMIT,
           "pieces that a ray is cut into, 1"),
    MEDIUM("samples at most", FIELD_INTEGER, samples_most, 0, 0, NULL),
    MEDIUM("aa_level", FIELD_INTEGER, levels, 1, 20,
           "method 3: how often pieces are halved at most, 3"),
    MEDIUM("ratio", FIELD_FLOAT, ratio, 0, 1,
           "of those pieces in the light of spots, 0.9"),
    MEDIUM("aa_threshold", FIELD_FLOAT, threshold, 0, 1e9,
           "method 3: samples that differ more are refined, 0.1"),
    MEDIUM("confidence", FIELD_FLOAT, confidence, 0, 0.999999,
           "methods 1 and 2: how sure the variance is met, 0.9"),
    MEDIUM("variance", FIELD_FLOAT, variance, 0, 1e9,
           "methods 1 and 2: more samples while theirs is above, 1/128"),
    MEDIUM("jitter", FIELD_FLOAT, jitter, 0, 1e9,
           "how far samples are moved at random, 0"),
    { NULL },
};

#define FOG(name, kind, member, low, high, help)                               \
    {                                                                          \
        name, kind, offsetof(struct fog, member), low, high, help              \
    }

const struct field fog_fields[] = {
    FOG("distance", FIELD_FLOAT, distance, 0, 0,
        "after which 1/e of what is behind is left"),
    FOG("fog type", FIELD_FLAG, ground, 0, 0, NULL),
    FOG("fog_offset", FIELD_FLOAT, offset, 0, 0,
        "of fog_type 2: up to this height it is everywhere the same"),
    FOG("fog_alt", FIELD_FLOAT, altitude, 0, 0,
        "of fog_type 2: so far above that, half of it is left"),
    FOG("fog colour", FIELD_COLOUR, colour, 0, 0, NULL),
    FOG("way up", FIELD_VECTOR, up, 0, 0, NULL),
    { NULL },
};

const struct field fog_turbulence_fields[] = {
    FOG("any turbulence", FIELD_FLAG, turbulent, 0, 0, NULL),
    FOG("turb_depth", FIELD_FLOAT, turbulent_share, 0, 0,
        "how much fog the noise takes away, 0.5"),
    FOG("omega", FIELD_FLOAT, turbulence.omega, 0, 0,
        "weight of the next octave, 0.5"),
    FOG("octaves", FIELD_INTEGER, turbulence.octaves, 1, 10, "of the noise, 6"),
    FOG("lambda", FIELD_FLOAT, turbulence.lambda, 0, 0,
        "frequency of the next octave, 2"),
    FOG("turbulence", FIELD_VECTOR, turbulence.amount, 0, 0,
        "how many features of its noise a unit has"),
    { NULL },
};

const struct field normal_fields[] = {
    { "bump_size", FIELD_FLOAT, offsetof(struct normal, amount), 0, 0,
      "how strong, 0.5" },
    { "accuracy", FIELD_FLOAT, offsetof(struct normal, accuracy), 0, 0,
      "step by which the slope is measured, 0.02" },
    { "turned by uv", FIELD_FLAG, offsetof(struct normal, uv_turned) },
    { NULL },
};

#define PATTERN(name, kind, member)                                            \
    {                                                                          \
        name, kind, offsetof(struct pattern, member)                           \
    }

const struct field pattern_said[] = {
    PATTERN("wave", FIELD_CHOICE, wave),
    PATTERN("exponent", FIELD_FLOAT, exponent),
    PATTERN("frequency", FIELD_FLOAT, frequency),
    PATTERN("phase", FIELD_FLOAT, phase),
    PATTERN("any turbulence", FIELD_FLAG, turbulent),
    PATTERN("octaves", FIELD_INTEGER, turbulence.octaves),
    PATTERN("omega", FIELD_FLOAT, turbulence.omega),
    PATTERN("lambda", FIELD_FLOAT, turbulence.lambda),
    PATTERN("turbulence", FIELD_VECTOR, turbulence.amount),
    { NULL },
};

#define IMAGE(name, kind, member)                                              \
    {                                                                          \
        name, kind, offsetof(struct image_map, member)                         \
    }

const struct field image_map_said[] = {
    IMAGE("map_type", FIELD_CHOICE, projection),
    IMAGE("interpolate", FIELD_CHOICE, interpolation),
    IMAGE("once", FIELD_FLAG, once),
    IMAGE("filter all", FIELD_FLOAT, filter_all),
    IMAGE("transmit all", FIELD_FLOAT, transmit_all),
    IMAGE("no alpha", FIELD_FLAG, no_alpha),
    { NULL },
};

#define WARP(name, kind, member)                                               \
    {                                                                          \
        name, kind, offsetof(struct warp, member)                              \
    }

const struct field warp_said[] = {
    WARP("kind of warp", FIELD_CHOICE, kind),
    WARP("turbulence", FIELD_VECTOR, turbulence.amount),
    WARP("octaves", FIELD_INTEGER, turbulence.octaves),
    WARP("omega", FIELD_FLOAT, turbulence.omega),
    WARP("lambda", FIELD_FLOAT, turbulence.lambda),
    WARP("repeat", FIELD_VECTOR, period),
    WARP("offset", FIELD_VECTOR, offset),
    WARP("flip", FIELD_VECTOR, flip),
    WARP("centre", FIELD_VECTOR, centre),
    WARP("radius", FIELD_FLOAT, radius),
    WARP("falloff", FIELD_FLOAT, falloff),
    WARP("strength", FIELD_FLOAT, strength),
    WARP("inverse", FIELD_FLAG, push),
    WARP("distance", FIELD_FLOAT, distance),
    WARP("dist_exp", FIELD_FLOAT, stretch),
    WARP("major_radius", FIELD_FLOAT, major),
    WARP("orientation", FIELD_VECTOR, orientation),
    { NULL },
};
