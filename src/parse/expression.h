/* What the files of the expression half of the parser share.
 *
 * Two kinds of failure: a rule that can't go on reading returns false, as
 * everywhere; a value that can't be computed (a function of nothing, the
 * root of -1) is reported and becomes *poison*, which every operator passes
 * on, so that the rest of the expression is read and nothing is said twice.
 * No public function gives poison away: they return false instead. */
#ifndef PARSE_EXPRESSION_H
#define PARSE_EXPRESSION_H

#include "parse/operator.h"

static inline struct value value_poison(void)
{
    return (struct value){ .kind = VALUE_POISON };
}

static inline bool value_is_poison(const struct value *value)
{
    return value->kind == VALUE_POISON;
}

static inline struct value value_float(double number)
{
    return (struct value){ .kind = VALUE_FLOAT, .number = { number } };
}

/* The same in place: a whole value would wait for its parts to be written. */
static inline void value_set_float(struct value *value, double number)
{
    value->kind = VALUE_FLOAT;
    value->size = 0;
    value->number[0] = number;
}

/* From here a float is no component of anything: see value_to_vector. */
static inline void value_settle(struct value *value)
{
    if (value->kind == VALUE_FLOAT)
        value->size = 0;
}

static inline struct value value_vector(vec3 v)
{
    return (struct value){ .kind = VALUE_VECTOR,
                           .size = 3,
                           .number = { v.x, v.y, v.z } };
}

static inline struct value value_text(const char *text)
{
    return (struct value){ .kind = VALUE_STRING, .text = text };
}

/* Components of a float, vector or colour; 0 of anything else. */
static inline int value_size(const struct value *value)
{
    return value->kind == VALUE_FLOAT    ? 1
           : value->kind == VALUE_VECTOR ? value->size
           : value->kind == VALUE_COLOUR ? 5
                                         : 0;
}

/* "a number", "a vector with 2 components" ...: for messages. */
const char *value_describe(const struct value *value);

/* A float to `size` equal components, a vector filled up with zeros. */
void value_promote(struct value *value, int size);

/* What value was read, from `start` to the last token, as the type wanted;
 * false after reporting "expected a vector, found a string". Poison gives
 * false silently. A colour is no vector, a float is one of equal
 * components. A component V.y, though, alone or on the left of what is done
 * with it, keeps V's others where a vector is wanted: scale V.y is
 * <V.y, V.y, V.z> (measured). */
bool value_to_float(struct parser *p, struct span start,
                    const struct value *value, double *out);
bool value_to_vector(struct parser *p, struct span start,
                     const struct value *value, vec3 *out);
bool value_to_text(struct parser *p, struct span start,
                   const struct value *value, const char **out);

/* A float to an int: cut off, out of range INT_MIN as in POV-Ray. */
int float_to_int(double x);

/* One level deeper into brackets; the caller subtracts 1 from p->nesting when
 * it leaves. False after reporting that the limit is reached. */
bool expression_enter(struct parser *p);

/* Inside brackets the directives run, even in a directive's own value: between
 * these two stream_peek_infix is stream_peek. */
static inline struct cursor *brackets_begin(struct parser *p)
{
    struct cursor *outer = p->directive;
    p->directive = NULL;
    return outer;
}

static inline bool brackets_end(struct parser *p, struct cursor *outer, bool ok)
{
    p->directive = outer;
    return ok;
}

/* Reads a value whose operators bind at least as tightly as `lowest`; may be
 * poison. `wanted` is for "expected WANTED, found ...". */
bool parse_operation(struct parser *p, enum precedence lowest,
                     const char *wanted, struct value *value);
/* One operand without operators, ".x" included; may be poison. */
bool parse_operand(struct parser *p, const char *wanted, struct value *value);
/* Any value that #declare can name, and copies of arrays and functions. */
bool parse_value(struct parser *p, struct value *value);

/* Whether the next token is ^ or %, operators of other languages; reports. */
bool operator_unknown(struct parser *p);

/* The tokens up to the bracket that closes this one, which is next; reports
 * a missing one. */
bool skip_brackets(struct parser *p);

/* What to type where the last number that was read and the minus before it look
 * like a value of their own and are none, `0 -1`; *minus is where. Else NULL.
 */
const char *subtracted_hint(struct parser *p, struct span *minus);

/* constant.c: the keyword's value, if it is one like `pi` or `x`; the token is
 * not taken. */
bool parse_constant(struct parser *p, enum keyword keyword,
                    struct value *value);
/* If the next token begins a string in single quotes or in none: reports it,
 * takes it all, and goes on with the string that is meant. */
bool string_unquoted(struct parser *p, const char **out);

bool constant_is(struct parser *p, enum keyword keyword);
bool constant_is_number(struct parser *p, enum keyword keyword);

/* colour.c: whether the keyword begins a colour: color, rgb, red ... */
bool colour_begins(enum keyword keyword);
bool parse_channels(struct parser *p, struct value *value);

#endif
