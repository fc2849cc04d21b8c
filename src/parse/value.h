/* What an identifier can hold and an expression can give. */
#ifndef PARSE_VALUE_H
#define PARSE_VALUE_H

#include "scene/scene.h"

enum value_kind {
    VALUE_NONE,
    VALUE_FLOAT,  /* number[0] */
    VALUE_VECTOR, /* number[0..size-1], size 2 to 5 */
    VALUE_COLOUR, /* number: r g b filter transmit */
    VALUE_STRING,
    VALUE_ARRAY,
    VALUE_MACRO,
    VALUE_FUNCTION,
    VALUE_SPLINE,
    VALUE_REFERENCE, /* a macro argument passed by reference */
    VALUE_OBJECT,
    VALUE_LIGHT_GROUP,
    VALUE_TEXTURE,
    VALUE_PIGMENT,
    VALUE_NORMAL,
    VALUE_FINISH,
    VALUE_INTERIOR,
    VALUE_MATERIAL,
    VALUE_TRANSFORM,
    VALUE_CAMERA,
    VALUE_COLOUR_MAP,
    VALUE_PIGMENT_MAP,
    VALUE_TEXTURE_MAP,
    VALUE_DENSITY,
    VALUE_DENSITY_MAP,
    VALUE_MEDIA,
    VALUE_NORMAL_MAP,
    VALUE_SLOPE_MAP,
    VALUE_FOG,
    VALUE_SKY_SPHERE,
    VALUE_RAINBOW,
    VALUE_FILE,   /* an open one */
    VALUE_POISON, /* after an error that was reported */
};

struct array;
struct data_file;
struct rainbow;
struct macro;
struct medium;
struct function;
struct spline;
struct symbol;

struct value {
    enum value_kind kind;
    int size; /* of a vector; of a float 0, or how many numbers the vector had
               * that it is a component of: see value_to_vector */
    union {
        double number[5];
        const char *text;
        struct array *array;
        const struct macro *macro;
        const struct function *function;
        const struct spline *spline;
        struct symbol *symbol;
        const struct object *object;
        const struct texture *texture;
        const struct pigment *pigment;
        const struct normal *normal;
        const struct finish *finish;
        const struct interior *interior;
        const struct material *material;
        const struct medium *medium;
        const affine *transform;
        const struct camera *camera;
        const struct blend_map *map;
        const struct texture_map *texture_map;
        const struct normal_map *normal_map;
        const struct slope_map *slope_map;
        const struct fog *fog;
        const struct rainbow *rainbow;
        const struct sky_sphere *sky;
        struct data_file *file;
    };
};

/* As an assignment, which would wait for what was just written in parts: most
 * values are numbers. */
static inline void value_copy(struct value *to, const struct value *from)
{
    if (from->kind == VALUE_FLOAT) {
        to->kind = VALUE_FLOAT;
        to->size = from->size;
        to->number[0] = from->number[0];
    } else {
        *to = *from;
    }
}

/* "a float", "a texture": for messages. */
const char *value_kind_name(enum value_kind kind);

#endif
