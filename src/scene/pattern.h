/* The interface of the patterns: functions of space with values in [0,1] (or a
 * block number) that pigments and normals are made of. One file in pattern/
 * and one row in pattern/list.h each. */
#ifndef SCENE_PATTERN_H
#define SCENE_PATTERN_H

#include "base/affine.h"
#include "base/arena.h"
#include "base/field.h"
#include "text/source.h"

/* How the raw value of a pattern is folded into [0,1]; see pattern.c. */
enum wave {
    WAVE_RAMP,
    WAVE_TRIANGLE,
    WAVE_SINE,
    WAVE_SCALLOP,
    WAVE_CUBIC,
    WAVE_POLY,
};

/* A random walk of the point looked up: `turbulence v octaves omega lambda` */
struct turbulence {
    vec3 amount;
    int octaves;
    double omega, lambda;
};

struct pattern_kind;
struct spots;
struct noise_settings;
struct warp;
struct blend_map; /* scene/material.h */
struct pigment;
struct function;
struct image_map;
struct object;

/* A pattern in use. */
struct pattern {
    const struct pattern_kind *kind; /* NULL: only the placing below counts */
    void *parameters;                /* kind->size bytes */
    affine inverse; /* from the texture's space into its own, but for these: */
    struct cofactors cofactors; /* of that: see pattern_lay */
    const struct warp *warps;   /* after it, or NULL */
    enum wave wave;
    double exponent; /* of poly_wave */
    double frequency, phase;
    bool turbulent;
    bool uv; /* of the surface's own coordinates: see pattern_start */
    struct turbulence turbulence;
    const struct noise_settings *noise; /* of all patterns */
    int generator; /* its own noise_generator; 0: that of `noise` */
};

/* The surface that is looked at: tells its own coordinates, (u, v, 0), for
 * uv_mapping. The rest, in the world, is for slope and aoi. */
struct uv_source {
    vec3 (*point)(const struct uv_source *source);
    /* Of a triangle: how near its corners are, in all 1. */
    void (*corners)(const struct uv_source *source, double shares[3]);
    vec3 place, normal; /* unit, turned to the viewer */
    vec3 view;          /* unit, to whoever looks */
};

/* Whether a whole number is odd; NaN is. */
static inline bool pattern_odd(double whole)
{
    return whole / 2 != floor(whole / 2);
}

/* Where the pattern is looked up: `point`, of the texture's space, or the
 * surface's coordinates. `uv` may be NULL, off any surface. */
static inline vec3 pattern_start(const struct pattern *pattern, vec3 point,
                                 const struct uv_source *uv)
{
    return pattern->uv && uv ? uv->point(uv) : point;
}

/* The parameters of patterns made of other things: one of these. */
struct made_pattern {
    struct terms samples; /* see scene/samples.h */
    const struct function *function;
    const struct pigment *pigment;
    const struct object *object;
    const struct image_map *image;
    struct span open; /* of the '{' of an object pattern */
};

/* What one point of it takes, and how deep it is made of other things. */
double pattern_work(const struct pattern *pattern);
unsigned pattern_levels(const struct pattern *pattern);

/* The table that fingerprints see; nothing is read by it. */
extern const struct field made_pattern_fields[];

struct pattern_kind {
    const char *name;
    const char *help;
    size_t size;                   /* of the parameters */
    const void *defaults;          /* parameters to start from, NULL zeroes */
    const struct field *arguments; /* positional: gradient <1,0,0> */
    const struct field *items;     /* named: brick_size, agate_turb ... */
    enum wave wave;                /* default */
    bool still; /* frequency 0 by default, with which there is no phase */
    /* 0: a continuous pattern. n: value() is one of 0..n-1 and the pattern
     * takes a list of n colours or pigments (checker 2, hexagon 3). */
    int blocks;
    /* Colours of the blocks where the scene names none. */
    const double (*block_colours)[3];
    /* Colours of a continuous pattern where the scene names none; NULL: black
     * to white. */
    const struct blend_map *map;
    /* Whether they are of patterns with these parameters; NULL: of all. */
    bool (*mapped)(const void *parameters);
    bool average; /* the map's entries are mixed: it needs one */
    /* Some patterns use their turbulence themselves, inside value(). */
    bool own_turbulence;
    /* The raw value at a point of the pattern's space, before frequency,
     * phase and wave. */
    double (*value)(const struct pattern *pattern, vec3 point);
    /* The same at several points, instead of it or as well. */
    void (*values)(const struct pattern *pattern, const struct spots *spots,
                   double *values);
    /* The same of patterns of the surface, where there is one; or NULL. */
    double (*seen)(const struct pattern *pattern, vec3 point,
                   const struct uv_source *surface);
    /* Whether the surface says nothing to patterns with these parameters, as
     * far as *budget pigments tell; NULL: it does if there is `seen`. */
    bool (*of_space)(const struct pattern *pattern, int *budget);
    /* As a normal: what to add to a unit normal for amount 1. NULL: the
     * gradient of the value is used. */
    vec3 (*perturbation)(const struct pattern *pattern, vec3 point,
                         vec3 normal);
    /* The same at several points, instead of it, where normals don't matter. */
    void (*perturbations)(const struct pattern *pattern,
                          const struct spots *points, vec3 *tilts);
    bool full; /* it is added as it is, for any amount */
};

/* A pattern of `kind` (may be NULL) with POV-Ray's default settings. */
struct pattern pattern_new(struct arena *arena,
                           const struct pattern_kind *kind);

/* The point of the pattern's own space for a point of the texture's:
 * transformation, then turbulence. */
vec3 pattern_locate(const struct pattern *pattern, vec3 point);

/* The same of several. */
void pattern_locate_all(const struct pattern *pattern,
                        const struct spots *points, struct spots *located);

/* As far as it is affine: the warps left out. For normals. */
affine pattern_affine(const struct pattern *pattern);

/* The colours it has where the scene names none; NULL: black to white. */
const struct blend_map *pattern_map(const struct pattern *pattern);

/* Which noise it is made of: enum noise_generator. */
int pattern_generator(const struct pattern *pattern);

/* Fills in the samples of one that is made of something else. */
void pattern_take_samples(struct arena *arena, struct pattern *pattern);

/* The value in [0,1] at a point of the texture's space, frequency, phase and
 * wave form applied; for block patterns the block's number. Above 1 only with
 * frequency 0 (as in POV-Ray). Never NaN. */
double pattern_value(const struct pattern *pattern, vec3 point);

/* The same for a point that pattern_locate gave. */
double pattern_value_at(const struct pattern *pattern, vec3 located);

/* The same for several, each of its own. */
void pattern_values_at(const struct pattern *pattern,
                       const struct spots *located, double *values);

/* Whether its value is that of the point alone, on any surface. *budget limits
 * how many pigments in each other are looked at, and is less then. */
bool pattern_is_of_space(const struct pattern *pattern, int *budget);

/* The same on a surface; NULL: off any. */
double pattern_value_seen(const struct pattern *pattern, vec3 located,
                          const struct uv_source *surface);

/* Sets `inverse`, and what is worked out from it. */
void pattern_lay(struct pattern *pattern, affine inverse);

/* Moves the pattern with `transform` (texture space): what `scale 2` written
 * after it does. `transform` must be invertible. */
void pattern_transform(struct pattern *pattern, const affine *transform);

const struct pattern_kind *pattern_find(const char *name);
const struct pattern_kind *pattern_at(size_t index);

#endif
