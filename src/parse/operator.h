/* The operators of expressions: what they bind, and their arithmetic on
 * floats, vectors, colours and strings. */
#ifndef PARSE_OPERATOR_H
#define PARSE_OPERATOR_H

#include "parse/parser.h"

/* From the loosest; `& |` share a level and so do all comparisons, as in
 * POV-Ray: (1 | 1 & 0) is 0. */
enum precedence {
    PRECEDENCE_CONDITION, /* ?: */
    PRECEDENCE_LOGIC,
    PRECEDENCE_COMPARISON,
    PRECEDENCE_WHOLE, /* no operator; the value of a #declare is read from here:
                       * not even a '>' may follow it */
    PRECEDENCE_SUM,   /* outside parentheses: no comparison may stand here */
    PRECEDENCE_PRODUCT,
    PRECEDENCE_NONE, /* not an operator */
};

/* Numbers closer than this count as equal, and smaller ones as false
 * (measured: (1 = 1 + 0.9e-10) is 1, (1 = 1 + 1.1e-10) is 0). */
#define OPERATOR_EPSILON 1e-10

enum precedence operator_precedence(enum token_kind kind);

static inline bool operator_truth(double x)
{
    return !(fabs(x) <= OPERATOR_EPSILON);
}

/* The arithmetic of two floats; a division by zero is infinite. */
double operator_float(enum token_kind kind, double a, double b);

/* The same as a function, but x / 0 as the machine divides: for functions. */
double (*operator_function(enum token_kind kind))(double, double);

/* left = left OPERATOR right, component by component: a float stands for as
 * many equal components as the other has, a shorter vector is filled with
 * zeros. A mixture that makes no sense is reported at `span` and gives
 * poison. */
void operator_apply(struct parser *p, enum token_kind kind, struct span span,
                    struct value *left, const struct value *right);

/* value = OPERATOR value, for + - ! */
void operator_apply_sign(struct parser *p, enum token_kind kind,
                         struct span span, struct value *value);

#endif
