/* Functions made of a pattern, a pigment, or one of functions.inc: bodies that
 * are no formula. */
#ifndef PARSE_FUNCTION_FIELD_H
#define PARSE_FUNCTION_FIELD_H

#include "parse/parser.h"
#include "scene/function.h"

enum {
    WORK_LIMIT = 1000000, /* steps for one point: functions that call two
                           * functions that call two ... */
    WORK_LEVELS = 20,     /* functions of pigments of functions ... */
};

/* Refuses what is made of too much. */
bool work_check(struct parser *p, double work, unsigned levels);

/* Whether such a body is next. */
bool at_field_body(struct parser *p);

/* Reads it and makes the function's steps, or gives it its pigment. */
bool parse_field_body(struct parser *p, struct function *function);

/* After a call of a pigment's function: which part, 0 to 5. */
bool parse_colour_part(struct parser *p, int *part);

#endif
