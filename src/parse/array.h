/* Arrays: `array[3][2] { ... }`, elements of any kind. */
#ifndef PARSE_ARRAY_H
#define PARSE_ARRAY_H

#include "parse/parser.h"

/* The kind of an element that has a value, VALUE_NONE if none has. Of an array
 * of arrays it is an element of one of them. */
enum value_kind array_kind(const struct array *array);

/* That element, or NULL. */
const struct value *array_sample(const struct array *array);

bool array_of_arrays(const struct array *array);

/* Reads one "[index]" for each dimension (fewer give the sub-array's place),
 * the next token being '['. *slot is the element's place, valid as long as the
 * parse; its kind is VALUE_NONE if it was never set. */
bool array_element(struct parser *p, struct array *array, struct value **slot);

/* Reads `array[3][2] { ... }`, the keyword being next. */
bool parse_array(struct parser *p, struct value *value);

int array_dimensions(const struct array *array);
/* Of dimension 1, 2 ...; 0 if there is none. */
int array_dimension_size(const struct array *array, int dimension);

/* A copy that shares no element; false after reporting at `span` that it is
 * too big. */
bool array_copy(struct parser *p, struct span span, struct array *array,
                struct array **copy);

/* Where the subscripts that begin at `i` of `left` raw tokens end; `i` if there
 * are none. */
size_t array_subscripts_end(const struct token *tokens, size_t left, size_t i);

#endif
