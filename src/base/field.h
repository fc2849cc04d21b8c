/* One table row describes one setting of a thing: its name, where it lives in
 * the struct, its range. The same row reads it, checks it, words its errors
 * and lists it in --list and the man pages. */
#ifndef BASE_FIELD_H
#define BASE_FIELD_H

#include <stddef.h>

#include "base/vec.h"

enum field_kind {
    FIELD_FLOAT,   /* double */
    FIELD_INTEGER, /* int, from a float rounded to nearest */
    FIELD_BOOL,    /* bool: on/off/yes/no/true/false/number; none means on */
    FIELD_FLAG,    /* bool: the word alone sets it */
    FIELD_VECTOR2, /* double[2] */
    FIELD_PAIR,    /* double[2], one number after the other: 1, 0.5 */
    FIELD_VECTOR,  /* vec3; a lone float is promoted to all components */
    FIELD_VECTOR5, /* double[5], missing components 0 */
    FIELD_COLOUR,  /* colour */
    FIELD_RGB,     /* rgb */
    FIELD_TERMS,   /* struct terms: a vector of any length, < a, b, ... > */
    FIELD_NAME,    /* const char *: a word, reserved or not */
    FIELD_CHOICE,  /* an enum: the place of a word in `choices` */
    FIELD_POINTS,  /* struct points: how many, then so many vectors, each of 2
                    * or 3 components (a 2-D one has z = 0), commas optional:
                    * 4, <0,0>, <1,0>, <1,1>, <0,0> */
    FIELD_POINTS2, /* the same, each of 2 components */
};

/* The value of a FIELD_TERMS. */
struct terms {
    double *values;
    size_t count;
};

/* The value of a FIELD_POINTS. The reader must not trust the number that
 * is written first with an allocation: it pushes point by point. */
struct points {
    vec3 *items;
    size_t count;
};

/* A table ends with a row whose name is NULL. `minimum` == `maximum` == 0
 * means any finite value. */
struct field {
    const char *name;
    enum field_kind kind;
    size_t offset;
    double minimum, maximum;
    const char *help; /* for lists: what it is, units, default */
    bool optional;    /* an argument that may be left out, with all after it */
    const char *const *choices; /* of a FIELD_CHOICE, ending with NULL */
    const char *dark; /* why no light depends on it; NULL: some may, and scenes
                       * that differ in it have different fingerprints */
};

/* Of the rows of a table. */
enum field_width {
    FIELDS_NARROW, /* single numbers, truths and choices */
    FIELDS_WIDE,   /* vectors and colours */
    FIELDS_BOTH,
};

/* The numbers of those fields that light may depend on, in the table's order,
 * into `out`; returns how many. A truth is 0 or 1. Not lists or names. */
size_t field_numbers(const struct field *table, const void *values,
                     enum field_width width, double *out);

/* So many it gives of one row at most. */
enum { FIELD_WIDEST = 5 };

/* The row called `name`, or NULL. A NULL table has no rows. */
const struct field *field_find(const struct field *table, const char *name);

/* The place of `word` among the field's choices, or -1. */
int field_choice(const struct field *field, const char *word);

/* "'soft' or 'sharp'": the choices, into `text`. */
void field_choices(const struct field *field, char *text, size_t size);

/* The field's value in the struct at `from` to the one at `to`. Only kinds of
 * a single value: not vectors, colours or lists. */
void field_copy(const struct field *field, void *to, const void *from);

#endif
