/* Arrays: `array[3][2] { ... }`, elements of any kind. */
#ifndef PARSE_ARRAY_H
#define PARSE_ARRAY_H

#include "parse/parser.h"

/* The kind of the first element that has a value, VALUE_NONE if none has. */
enum value_kind array_kind(const struct array *array);

/* Reads one "[index]" for each dimension (fewer give the sub-array's place),
 * the next token being '['. *slot is the element's place, valid as long as the
 * parse; its kind is VALUE_NONE if it was never set. */
bool array_element(struct parser *p, struct array *array, struct value **slot);

/* array = "array" {"[" float "]"} [array_values], the keyword being next. */
bool parse_array(struct parser *p, struct value *value);

#endif
