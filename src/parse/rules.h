/* What the files that read the inside of `{ }` share: objects, textures,
 * lights, camera, atmosphere, settings. Each production of grammar/scene.ebnf
 * and grammar/textures.ebnf heads the function that reads it. */
#ifndef PARSE_RULES_H
#define PARSE_RULES_H

#include "parse/parser.h"
#include "parse/stream.h"
#include "scene/light.h"
#include "scene/mesh.h"
#include "scene/primitive.h"
#include "token/word.h"

/* ---- rules.c: small helps ---- */

/* Whether the next token is this word, reserved or not. */
bool at_word(struct parser *p, const char *word);
bool accept_word(struct parser *p, const char *word);

/* The row of the table named by the next token, which is taken if there is
 * one; else NULL. The other spelling (color) counts too. */
const struct field *accept_field(struct parser *p, const struct field *table);

/* Whether the next token begins a colour, keyword or bare vector or number. */
bool at_any_colour(struct parser *p);

/* '[' around an entry of a map. */
bool bracket_begin(struct parser *p, struct span *open);

/* Behind an entry of a map: the next one or the '}'. A comma is an error. */
bool entry_end(struct parser *p);

/* An item without any effect on the picture that glim draws: its name and,
 * if one follows, its number are taken. */
bool skip_item(struct parser *p);

/* The '}' of a block or the ']' of an entry of a map is next. */
bool at_body_end(struct parser *p);

/* The inside of a block whose settings change nothing, up to its '}'. */
bool skip_block(struct parser *p);

/* error_unknown_item, but "expected THING, found 'T', which is not declared"
 * for a word alone in its block, which must be meant as an identifier. */
bool error_unknown_thing(struct parser *p, const char *block,
                         const struct field *names, const char *thing);

/* ---- texture.c and the files of its parts ----
 *
 * A declared thing starts as a copy of the declaration, another as #default
 * says; `texture { T pigment { scale 2 } }` changes T's pigment. So `*in` is
 * what a block starts from and, after it, what it has become. */

/* Refuses uv_mapping, said from the span on, where there is no surface. */
bool uv_refuse(struct parser *p, struct span span,
               const struct pattern *pattern);
/* Of no surface, but of the sky, a function or a pattern: #default doesn't
 * count for it, but it does for the entries of its maps (measured). */
bool parse_plain_pigment(struct parser *p, const struct pigment **out);
bool parse_pigment_block(struct parser *p, const struct pigment **in);
bool parse_pigment_body(struct parser *p, const struct pigment **in);
/* The inside of normal { } or of an entry of a normal_map. */
bool parse_normal_body(struct parser *p, const struct normal **in);
bool parse_normal_block(struct parser *p, const struct normal **in);
bool parse_finish_block(struct parser *p, const struct finish **in);
/* Their parts, for texture_bare.c: what a block's content is written into, an
 * item of it, and the checks at its end. */
enum taken parse_pigment_start(struct parser *p, struct pigment *pigment);
enum taken parse_pigment_item(struct parser *p, struct pigment *pigment);
bool pigment_count(struct parser *p, struct pigment *pigment);
struct normal *normal_begin(struct parser *p, const struct normal *from);
enum taken parse_normal_start(struct parser *p, struct normal *normal);
enum taken parse_normal_item(struct parser *p, struct normal *normal);
struct finish *finish_begin(struct parser *p, const struct finish *from);
bool parse_finish_item(struct parser *p, struct finish *finish);
void finish_limit(struct parser *p, struct finish *finish);
/* Whether one of the items is next that stood in a texture without a block of
 * their own before version 3. */
bool at_bare_item(struct parser *p);
enum taken parse_bare_item(struct parser *p, const struct texture **in);
/* The inside of texture { } or of an entry of a texture_map. */
bool parse_interior_texture(struct parser *p, const struct texture **inner);
bool parse_texture_body(struct parser *p, const struct texture **in);
/* texture_choice.c: what begins with a pattern. */
enum taken parse_texture_choice(struct parser *p, const struct texture **out);
/* A texture that `rule` picks from these, looking at `thing`. */
const struct texture *texture_by_rule(struct parser *p, texture_rule *rule,
                                      const void *thing,
                                      const struct texture *const *textures,
                                      size_t count);
/* One for each block of the pattern. */
const struct texture *texture_by_blocks(struct parser *p,
                                        const struct pattern_kind *kind,
                                        const struct texture *const *textures);
/* material_map.c: or tiles. */
enum taken parse_material_map(struct parser *p, const struct texture **out);
/* texture_map of a #declare; the keyword is next. */
bool parse_declared_texture_map(struct parser *p,
                                const struct texture_map **out);
/* pigment, normal or finish: goes into the topmost layer of a copy. */
enum taken parse_texture_part(struct parser *p, const struct texture **in);
/* What objects that say nothing have: all of them share it. */
const struct texture *texture_from_defaults(struct parser *p);
/* A copy of the texture whose layers may be written. */
struct texture *texture_copy(struct parser *p, const struct texture *texture);
/* The same, and its topmost layer. */
struct texture *texture_top(struct parser *p, const struct texture *texture,
                            struct layer **top);
/* A copy whose pigments filter nothing and transmit more instead. */
const struct texture *texture_veiled(struct parser *p,
                                     const struct texture *texture);
/* The layers of `bottom` with those of `top` painted over. */
const struct texture *texture_stack(struct parser *p,
                                    const struct texture *bottom,
                                    const struct texture *top);

/* pattern.c: a pattern's name and its arguments; the placing stays. The first
 * is for normals, which alone take facets. */
enum taken parse_normal_pattern(struct parser *p, struct pattern *pattern);
enum taken parse_pattern(struct parser *p, struct pattern *pattern);
enum taken parse_pattern_item(struct parser *p, struct pattern *pattern);
/* density_file.c; the keyword is next. */
struct density_file;
bool parse_density_file(struct parser *p, struct density_file *file);
/* slope.c; the keyword is next. */
struct slope;
bool parse_slope(struct parser *p, struct slope *slope);
/* warp.c; the keyword is next. */
bool parse_warp(struct parser *p, struct pattern *pattern);
/* After the list of a block pattern: takes the '}' of object { }. `ok` false:
 * skips to it, and returns false. */
bool parse_pattern_end(struct parser *p, const struct pattern *pattern,
                       bool ok);
const char *pattern_name(const struct pattern *pattern);

/* colour_map.c: the map after its keyword, of colours or of pigments. */
bool parse_colour_map(struct parser *p, const struct blend_map **out);
bool parse_pigment_map(struct parser *p, bool average,
                       const struct blend_map **out);
/* The number of an entry of a map; of an average it may be missing. */
bool parse_map_value(struct parser *p, bool average, double *value);
/* normal_map.c: maps after their keywords, a normal for each block. */
bool parse_normal_map(struct parser *p, bool average,
                      const struct normal_map **out);
bool parse_slope_map(struct parser *p, const struct slope_map **out);
bool parse_normal_blocks(struct parser *p, struct normal *normal);
/* Fills depth and parts; refuses too many. */
bool normal_count(struct parser *p, struct normal *normal);
bool parse_block_list(struct parser *p, const struct pattern *pattern,
                      const struct blend_map **out);

/* png, jpeg ... before the name of a picture, or nothing: *found NULL. */
bool parse_image_type(struct parser *p, const char **found);

/* At "gamma": of a picture's numbers; 0: sRGB. */
bool parse_image_gamma(struct parser *p, double *gamma);

/* A number of a picture that means no colour, where the scene says the gamma of
 * the file (measured): light; a PNG's bytes of grey are rounded down to
 * bytes. */
double image_number(const struct image *image, double gamma, double value);

/* The path of a picture of that type, whose name may lack its extension; or
 * NULL. For file_checked: it may be one that is not to be read. */
const char *image_file(struct parser *p, const char *name, const char *type);
/* bump_map in a normal: bump_size goes where the last argument says. */
bool parse_bump_map(struct parser *p, const struct image_map **out,
                    double *bump_size);
bool parse_image_map(struct parser *p, const struct image_map **out);
/* Of function_image, which is next. */
struct image;
bool parse_image_of_function(struct parser *p, const struct image **out);
bool parse_image_pattern(struct parser *p, const struct image_map **out);
/* The inside of a material_map, up to its textures. */
bool parse_material_image(struct parser *p, const struct image_map **out);

/* ---- objects ---- */

/* What gathers while the modifiers of an object are read. */
struct modifiers {
    struct object *object;
    const char *block;         /* "sphere": for messages */
    const struct field *items; /* of the primitive, or NULL */
    void *shape;               /* what `items` describe */
    bool cutaway;              /* cutaway_textures was said */
    struct span inner;         /* where a texture for the inside is, or none */
    struct clip_list {
        struct clip *items;
        size_t count, capacity;
    } bounds; /* bounded_by, for clipped_by { bounded_by } */
};

/* The transformations that are next, if there are any, all of them. */
enum taken parse_moves(struct parser *p, struct modifiers *m);
/* Modifiers up to the '}' of the object's block. */
bool parse_modifiers(struct parser *p, struct modifiers *m);

/* cutaway.c: what cutaway_textures does with a CSG object. */
bool cutaway_textures(struct parser *p, struct object *object);

/* Before it goes into the scene: one without texture gets what #default says
 * now. Only there: in POV-Ray that texture is not moved with the object. */
void object_link(struct parser *p, struct object *object);
/* Counts what hangs on the object in its depth, parts and patch. */
bool object_adopt(struct parser *p, struct object *object,
                  const struct object *child);
/* The object, or nothing if POV-Ray does not see it alone or in a union. */
struct object *object_seen(struct parser *p, struct object *object);
/* A node without any part: what is left out of the picture. */
struct object *object_empty(struct parser *p, struct span span);

/* An object of a shape whose arguments `rule` reads; NULL: the shape's table
 * says how. */
typedef bool shape_rule(struct parser *p, void *shape);
bool parse_shape(struct parser *p, struct object **out,
                 const struct primitive *primitive, shape_rule *rule);

/* container.c; the keyword is next. */
struct container;
bool parse_contained_by(struct parser *p, struct container *container);

/* The keyword is next. */
bool parse_triangle(struct parser *p, struct object **out);
bool parse_smooth_triangle(struct parser *p, struct object **out);
bool parse_mesh(struct parser *p, struct object **out);
bool parse_mesh2(struct parser *p, struct object **out);
bool parse_csg(struct parser *p, struct object **out);
bool parse_blob(struct parser *p, struct object **out);
bool parse_prism(struct parser *p, struct object **out);
bool parse_lathe(struct parser *p, struct object **out);
bool parse_text(struct parser *p, struct object **out);
bool parse_height_field(struct parser *p, struct object **out);
bool parse_isosurface(struct parser *p, struct object **out);
bool parse_julia_fractal(struct parser *p, struct object **out);
bool parse_parametric(struct parser *p, struct object **out);
bool parse_sphere_sweep(struct parser *p, struct object **out);
bool parse_polynomial(struct parser *p, struct object **out);
bool parse_bicubic_patch(struct parser *p, struct object **out);
bool parse_light_source(struct parser *p, struct object **out);

/* ---- media.c; the keyword is next ---- */

bool parse_density(struct parser *p, const struct pigment **out);
bool parse_density_map(struct parser *p, const struct blend_map **out);
/* colour_map.c: the same as of pigments, in the midst of a density. */
bool parse_density_entries(struct parser *p, bool average,
                           const struct blend_map **out);
bool parse_medium(struct parser *p, const struct medium **out);
/* One more of these. */
bool parse_media(struct parser *p, struct media *media);

/* ---- light_group.c: a node with its members below it, moved together ---- */

bool parse_light_group(struct parser *p, const struct object **out);
bool parse_light_group_part(struct parser *p, struct object **out);

/* ---- mesh_camera.c; the keyword is next ---- */

bool parse_mesh_camera(struct parser *p, struct camera *camera);

/* ---- atmosphere.c; the keyword is next ---- */

bool parse_background(struct parser *p, colour *out);
bool parse_fog(struct parser *p, struct fog *out);
bool parse_sky_sphere(struct parser *p, const struct sky_sphere **out);

/* ---- light_mesh.c; the word is next ---- */

bool parse_light_mesh(struct parser *p);
bool parse_skeleton(struct parser *p);
bool parse_radiosity(struct parser *p);
bool parse_rainbow(struct parser *p, struct rainbow *out); /* rainbow.c */
bool parse_photons(struct parser *p);                      /* photons.c */
bool parse_photon_flags(struct parser *p, struct photon_flags *flags);

/* ---- settings.c ---- */

bool parse_noise_generator(struct parser *p, int *generator);
bool parse_default_block(struct parser *p);

bool parse_global_setting(struct parser *p);

/* What depends on #version, if the scene doesn't say it. */
void settings_follow_version(struct parser *p);

/* The working space as far as it is known now. */
enum gamma_kind settings_gamma(const struct parser *p);

#endif
