/* User functions: `#declare f = function(x, r) { x * x - r }`. The body is
 * compiled when it is declared, so identifiers in it have the values they had
 * then, as in POV-Ray. */
#ifndef PARSE_USER_FUNCTION_H
#define PARSE_USER_FUNCTION_H

#include "parse/parser.h"

/* Reads `function [(names)] { body }`, the keyword being next. One that
 * has an error is read whole. */
bool parse_function(struct parser *p, struct value *value);

/* Reads `function WIDTH, HEIGHT { body }`, the keyword being next: a picture of
 * which x and y from 0 to 1 are given to the body. */
bool parse_function_image(struct parser *p, int *width, int *height,
                          const struct function **out);

/* Reads the arguments of a call, whose name was taken, and computes it; may
 * give poison. */
bool function_call(struct parser *p, const struct function *function,
                   const struct word *name, struct value *value);

#endif
