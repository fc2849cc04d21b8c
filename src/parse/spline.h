/* spline { }: curves that are called as functions of time. */
#ifndef PARSE_SPLINE_H
#define PARSE_SPLINE_H

#include "parse/parser.h"

struct spline;

/* Reads `spline { ... }`, the keyword being next; in the scene's arena. */
bool parse_spline(struct parser *p, const struct spline **out);

/* Reads what follows the name of a spline that was taken, `(time)` or `(time,
 * cubic_spline)`: the place then, a vector; may give poison. */
bool spline_call(struct parser *p, const struct spline *spline,
                 const struct word *name, struct value *value);

#endif
