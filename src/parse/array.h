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

/* The same, with the array that it is an element of: one in an array as well.
 */
bool array_place(struct parser *p, struct array *array, struct value **slot,
                 struct array **owner);

/* Whether the array may get an element of the value's kind, the first deciding
 * which it is; if not, says so at the span. A vector of 5 components counts as
 * a colour. */
bool array_takes(struct parser *p, struct array *array, struct span span,
                 const struct value *value);

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
