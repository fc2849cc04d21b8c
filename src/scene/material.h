/* What surfaces are made of: pigments, normals, finishes, textures, interiors.
 * Plain data, const once the scene is read. The light-mesh paper's kd, ks and
 * Emiss are finish.diffuse, finish.reflection and finish.emission.
 *
 * Sharing: a scene may use one declared texture for a million objects, each
 * moved its own way. So these structs are shared and never moved: moving makes
 * a shallow copy with another transformation (pigment_moved ...), and an object
 * carries one more transformation for its texture (scene/object.h). */
#ifndef SCENE_MATERIAL_H
#define SCENE_MATERIAL_H

#include "base/rgb.h"
#include "scene/finish.h"
#include "scene/pattern.h"
#include "text/source.h"

struct image;
struct noise_settings;
struct pigment;

/* Entries of a colour_map or pigment_map in increasing order of `value`; of a
 * block pattern's list, where value is the block's number. `pigment` non-NULL
 * replaces `colour`. Two entries may share a value: a step. */
struct blend_entry {
    double value;
    colour colour;
    const struct pigment *pigment;
};

struct blend_map {
    const struct blend_entry *entries;
    size_t count;
};

enum image_projection {
    IMAGE_PLANAR = 0,
    IMAGE_SPHERICAL = 1,
    IMAGE_CYLINDRICAL = 2,
    IMAGE_TORUS = 5,
};

enum image_interpolation {
    IMAGE_NEAREST = 0,
    IMAGE_BILINEAR = 2,
    IMAGE_BICUBIC = 3,
    IMAGE_NORMALISED_DISTANCE = 4,
};

struct image_map {
    const struct image *image; /* linear light in the working space */
    bool use_alpha; /* an image_pattern's value is how clear, not how bright */
    enum image_projection projection;
    enum image_interpolation interpolation;
    bool once;
    double filter_all, transmit_all;
    bool no_alpha; /* transmit_all stands instead of the file's alpha */
    /* Of a palette's entries: NAN is what all have. NULL: none has its own. */
    struct entry_clear {
        double filter, transmit;
    } * clear;
    const struct image *numbers; /* with `clear`: the entry of each pixel */
};

enum { PALETTE_ENTRIES = 256 };

enum pigment_kind { PIGMENT_COLOUR, PIGMENT_PATTERN, PIGMENT_IMAGE };

struct pigment {
    enum pigment_kind kind;
    colour colour;               /* PIGMENT_COLOUR; default opaque black */
    struct pattern pattern;      /* for every kind: the placing */
    const struct blend_map *map; /* PIGMENT_PATTERN; NULL: the kind's own */
    const struct image_map *image;
    unsigned depth, parts; /* of pigment_maps in each other: levels, and
                            * entries in all; the parser limits both */
    double work;           /* steps for one point, as of functions */
    unsigned levels;       /* likewise; the parser limits these, too */
    bool has_quick_colour;
    colour quick_colour; /* used at quality 5 and below */
};

struct normal;

struct normal_entry {
    double value;                /* of a block pattern: the block's number */
    const struct normal *normal; /* NULL: plain */
};

struct normal_map {
    struct normal_entry *entries;
    size_t count;
};

/* Where the pattern has this value, the bumps have this height and slope. */
struct slope_entry {
    double value, height, slope;
};

struct slope_map {
    struct slope_entry *entries;
    size_t count;
};

/* Perturbs the shading normal. */
struct normal {
    struct pattern pattern;
    double amount;   /* bump size; 0.5 by default */
    double accuracy; /* step of the numerical gradient, 0.02 by default */
    const struct normal_map *map;   /* of other normals, or NULL */
    const struct slope_map *slopes; /* or NULL */
    const struct image_map *bumps;  /* instead of a pattern, or NULL */
    unsigned depth, parts; /* of maps in each other, limited as pigments' */
    bool level; /* no_bump_scale: bumps are as high however they are scaled */
    bool uv_turned; /* mapped as a part of its texture: bumps turn with it */
};

/* One layer of paint. No member is NULL but `normal`. */
struct layer {
    const struct pigment *pigment;
    const struct normal *normal;
    const struct finish *finish;
};

enum { TEXTURE_LAYERS = 32 }; /* the parser refuses more */

/* A pattern that picks textures, as a pigment_map picks pigments. */
struct texture_entry {
    double value; /* of a block pattern: the block's number */
    const struct texture *texture;
};

struct texture_choice;
struct texture_pick;

/* Picks at a point of the texture's space as texture_choose does. Those of
 * texture_rules.c. */
typedef int texture_rule(const struct texture_choice *choice, vec3 point,
                         const struct uv_source *surface,
                         struct texture_pick *picks);
texture_rule pick_by_corners; /* of a triangle; the entries are theirs */
texture_rule pick_by_image;   /* `thing` is the image_map */
texture_rule pick_by_parts;   /* `thing` is the struct blob */
texture_rule pick_by_insides; /* `thing` is a struct cutaway */

/* Declared, and not yet some pattern's. */
struct texture_map {
    struct texture_entry *entries;
    size_t count;
};

struct texture_choice {
    struct pattern pattern;
    texture_rule *rule; /* picks instead of the pattern, or NULL */
    const void *thing;  /* that the rule looks at */
    struct texture_entry *entries;
    size_t count;   /* at least one */
    unsigned depth; /* of choices in each other */
    bool bumps;     /* some texture that may be picked has a normal */
};

enum { TEXTURE_DEPTH = 10 }; /* the parser refuses more choices in each other */

/* Layers from the bottom up; at least one. With a choice it has no paint of its
 * own: then the layers are those of all that may be picked, in any order. */
struct texture {
    struct layer *layers;
    size_t count;
    const struct texture_choice *choice; /* or NULL */
    struct span span; /* where it was written, as near as is known */
};

enum { TEXTURE_PICKS = TEXTURE_LAYERS };

/* What a choice picks: one texture, the blend of two, or of all if its pattern
 * is average; those are as many as TEXTURE_PICKS. */
struct texture_pick {
    const struct texture *texture;
    double share;
};

/* Fills picks for a point of the texture's space on a surface; returns how
 * many. *located is the point in the space of what is picked. */
int texture_choose(const struct texture_choice *choice, vec3 point,
                   const struct uv_source *surface,
                   struct texture_pick picks[TEXTURE_PICKS], vec3 *located);

/* The same of a choice that is plain (texture_is_plain), at several points:
 * picks[i] has room for two, and counts[i] of them are picked. */
void texture_choose_all(const struct texture_choice *choice,
                        const struct spots *points, struct spots *located,
                        struct texture_pick (*picks)[2], int *counts);

/* The ways from the world into the space of what is picked and back, as bumps
 * need them: `to` and `from` are those of the choice's texture. False: there
 * are none, or nothing that is picked has bumps. */
bool texture_choice_ways(const struct texture_choice *choice, const affine *to,
                         const affine *from, affine *inner_to,
                         affine *inner_from);

/* The share of light that passes the whole texture at a point of its space. */
rgb texture_transmittance(const struct texture *texture, vec3 point,
                          const struct uv_source *uv);

/* A copy of which all patterns, normals too, are of the surface's own
 * coordinates. */
const struct texture *texture_mapped(struct arena *arena,
                                     const struct texture *texture);

/* All that fill one place at a time: see scene/medium.h. */
struct media {
    const struct medium **items;
    size_t count;
};

enum { MEDIA_MAX = 64 }; /* in one place; the parser refuses more in one list */

struct interior {
    double ior;             /* 1, of green light */
    double dispersion;      /* that of violet light over that of red, 1 */
    int dispersion_samples; /* colours that light is divided into, 7 */
    double fade_distance;   /* 0: none */
    double fade_power;      /* 0: none */
    rgb fade_colour;        /* black */
    double caustics;        /* pretended, in shadows: shade/shadow.c; 0: none */
    struct media media;     /* of the space that the interior is written in */
};

struct material {
    const struct texture *texture;
    const struct texture *interior_texture; /* seen from inside, or NULL */
    const struct interior *interior;        /* may be NULL */
};

struct interior interior_default(void);

/* Whether light goes straight on where it enters or leaves, and none of it is
 * lost, but for media. */
bool interior_passes(const struct interior *interior);

/* Opaque black, as POV-Ray's. */
struct pigment pigment_default(struct arena *arena);

/* One layer of the default pigment and finish: of objects without a texture. */
const struct texture *texture_default(struct arena *arena);

/* Pigments nested in pigments more deeply than this are black; the parser
 * should refuse them. */
enum { PIGMENT_DEPTH = 32 };

/* A map's colour at this value. */
colour blend_map_colour(const struct blend_map *map, double value);

/* The pigment's value at a point of the texture's space. */
colour pigment_colour(const struct pigment *pigment, vec3 point);

/* The same at several points, side by side as far as it goes. */
void pigment_colours(const struct pigment *pigment, const struct spots *points,
                     colour *colours);

/* The same on a surface (NULL: off any), which may map it by coordinates of its
 * own. */
colour pigment_seen(const struct pigment *pigment, vec3 point,
                    const struct uv_source *surface);

/* Whether no point of it lets light pass: told from the colours it names. */
bool pigment_is_opaque(const struct pigment *pigment);

/* Whether it is the same on any surface there, so that pigment_colour is
 * enough. *budget as of pattern_is_of_space. */
bool pigment_is_of_space(const struct pigment *pigment);
bool pigment_all_of_space(const struct pigment *pigment, int *budget);

/* The same, but its own pattern may be laid by the surface's coordinates: the
 * point is then these. */
bool pigment_is_of_point(const struct pigment *pigment);
bool normal_is_of_space(const struct normal *perturbation);
bool texture_is_opaque(const struct texture *texture);

/* Whether it is paint that needs to know no more of a surface than the point,
 * the surface's coordinates and the normal, and no mirror takes from the layers
 * below; or a choice of such by the point alone. `mapped`: the point is the
 * surface's coordinates. */
bool texture_is_plain(const struct texture *texture, bool mapped);

/* Whether none of its pigments is laid by the surface's coordinates. */
bool texture_is_spatial(const struct texture *texture);

/* Whether its pigments are colours: the share of light that passes it is the
 * same at any point. */
bool texture_is_even(const struct texture *texture);

/* Whether any layer does, that of a choice included. */
bool texture_mirrors(const struct texture *texture);

/* Whether lamps leave highlights on some layer of it. */
bool texture_shines(const struct texture *texture);

/* Whether light that comes to any layer is scattered. */
bool texture_takes_light(const struct texture *texture);

/* The finish of the layer that gives back most of it; NULL: there is none. */
const struct finish *texture_finish(const struct texture *texture);

/* Whether it has a pattern or an image: else it only holds what others begin
 * with, as `#default { normal { bump_size 2 } }` does. */
bool normal_tilts(const struct normal *perturbation);

/* The normal after perturbation; `normal` unit, both in texture space and
 * turned towards the viewer (measured: bumps rise to whoever looks). `length`
 * is what it had become on its way there, which is how high bumps with
 * no_bump_scale are (measured); 0: it is not told. Normals in its map may be of
 * the surface's own coordinates; NULL: off any. */
vec3 normal_perturbed(const struct normal *perturbation, vec3 point,
                      vec3 normal, double length,
                      const struct uv_source *surface);

/* The same at several points, off any surface or of what is of space;
 * `perturbed` is none of the others. `lengths` may be NULL. */
void normals_perturbed(const struct normal *perturbation,
                       const struct spots *points, const struct spots *normals,
                       const double *lengths, struct spots *perturbed);

/* Copies in `arena`, moved by an invertible transformation. */
const struct pigment *pigment_moved(struct arena *arena,
                                    const struct pigment *pigment,
                                    const affine *transform);
const struct normal *normal_moved(struct arena *arena,
                                  const struct normal *normal,
                                  const affine *transform);
const struct texture *texture_moved(struct arena *arena,
                                    const struct texture *texture,
                                    const affine *transform);

#endif
