/* Long lists of vectors, cut as a whole: the million points of a mesh2 would
 * be eight tokens each, most of the time and memory of reading it. */
#ifndef TOKEN_NUMBERS_H
#define TOKEN_NUMBERS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "base/arena.h"

/* { COUNT, <a, b, c>, <a, b, c>, ... } */
struct number_list {
    double said; /* COUNT */
    size_t count;
    double (*vectors)[3];
};

/* Shorter lists become ordinary tokens. */
enum { NUMBERS_LEAST = 256 };

/* The list at the start of `text` (`size` bytes and a NUL), if it is one, is
 * written plainly (numbers and commas only) and is long; *length is then how
 * far it reaches. NULL otherwise: it is to be cut into ordinary tokens. */
const struct number_list *numbers_cut(struct arena *arena, const char *text,
                                      size_t size, size_t *length);

/* The number at `text`, unsigned; *end is put behind it, or at `text` if
 * there is none. */
double number_read(const char *text, const char **end);

/* For lists that are cut at once, of text ending in NUL. */
const char *numbers_skip_space(const char *text);
/* Takes the character and the space around it, if it is next. */
bool numbers_take(const char **at, char c);
/* Takes <a, b, c> and the space around it; false if it isn't one. */
bool numbers_take_vector(const char **at, double v[3]);

#endif
