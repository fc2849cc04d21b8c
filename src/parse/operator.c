/* Operators: see operator.h. */
#include "parse/operator.h"

#include "parse/expression.h"

/* From the loosest to the tightest.
 * operator = "&" | "|" | "<" | "<=" | ">" | ">=" | "=" | "!=" | "+" | "-"
 *          | "*" | "/" . */
enum precedence operator_precedence(enum token_kind kind)
{
    switch (kind) {
    case TOKEN_QUESTION:
        return PRECEDENCE_CONDITION;
    case TOKEN_AND:
    case TOKEN_OR:
        return PRECEDENCE_LOGIC;
    case TOKEN_LESS:
    case TOKEN_LESS_EQUAL:
    case TOKEN_GREATER:
    case TOKEN_GREATER_EQUAL:
    case TOKEN_EQUAL:
    case TOKEN_NOT_EQUAL:
        return PRECEDENCE_COMPARISON;
    case TOKEN_PLUS:
    case TOKEN_MINUS:
        return PRECEDENCE_SUM;
    case TOKEN_STAR:
    case TOKEN_SLASH:
        return PRECEDENCE_PRODUCT;
    default:
        return PRECEDENCE_NONE;
    }
}

static bool operator_equal(double a, double b)
{
    return a == b || fabs(a - b) <= OPERATOR_EPSILON;
}

/* < and > are exact, <= and >= as forgiving as =. */
double operator_float(enum token_kind kind, double a, double b)
{
    switch (kind) {
    case TOKEN_PLUS:
        return a + b;
    case TOKEN_MINUS:
        return a - b;
    case TOKEN_STAR:
        return a * b;
    case TOKEN_SLASH:
        return b == 0 ? HUGE_VAL : a / b;
    case TOKEN_AND:
        return operator_truth(a) && operator_truth(b);
    case TOKEN_OR:
        return operator_truth(a) || operator_truth(b);
    case TOKEN_LESS:
        return a < b;
    case TOKEN_LESS_EQUAL:
        return a < b || operator_equal(a, b);
    case TOKEN_GREATER:
        return a > b;
    case TOKEN_GREATER_EQUAL:
        return a > b || operator_equal(a, b);
    case TOKEN_EQUAL:
        return operator_equal(a, b);
    case TOKEN_NOT_EQUAL:
        return !operator_equal(a, b);
    default:
        return 0;
    }
}

#define OPERATOR(name, kind)                                                   \
    static double operator_##name(double a, double b)                          \
    {                                                                          \
        return operator_float(kind, a, b);                                     \
    }
OPERATOR(plus, TOKEN_PLUS)
OPERATOR(minus, TOKEN_MINUS)
OPERATOR(times, TOKEN_STAR)
OPERATOR(and, TOKEN_AND)
OPERATOR(or, TOKEN_OR)
OPERATOR(less, TOKEN_LESS)
OPERATOR(less_equal, TOKEN_LESS_EQUAL)
OPERATOR(greater, TOKEN_GREATER)
OPERATOR(greater_equal, TOKEN_GREATER_EQUAL)
OPERATOR(same, TOKEN_EQUAL)
OPERATOR(different, TOKEN_NOT_EQUAL)

static double operator_divided(double a, double b)
{
    return a / b;
}

double (*operator_function(enum token_kind kind))(double, double)
{
    switch (kind) {
    case TOKEN_PLUS:
        return operator_plus;
    case TOKEN_MINUS:
        return operator_minus;
    case TOKEN_STAR:
        return operator_times;
    case TOKEN_SLASH:
        return operator_divided;
    case TOKEN_AND:
        return operator_and;
    case TOKEN_OR:
        return operator_or;
    case TOKEN_LESS:
        return operator_less;
    case TOKEN_LESS_EQUAL:
        return operator_less_equal;
    case TOKEN_GREATER:
        return operator_greater;
    case TOKEN_GREATER_EQUAL:
        return operator_greater_equal;
    case TOKEN_EQUAL:
        return operator_same;
    default:
        return operator_different;
    }
}

static void operator_apply_text(struct parser *p, enum token_kind kind,
                                struct span span, struct value *left,
                                const struct value *right)
{
    if (operator_precedence(kind) != PRECEDENCE_COMPARISON) {
        error_at(p, span, "concat(A, B)",
                 "strings can only be compared and joined with concat()");
        *left = value_poison();
        return;
    }
    int order = strcmp(left->text, right->text);
    *left = value_float(operator_float(kind, order, 0));
}

/* Floats, vectors and colours to as many components as the larger has. */
static void operator_promote(struct value *value, const struct value *other)
{
    int size = value_size(value), wanted = value_size(other);
    if (wanted > size)
        value_promote(value, wanted);
    if (other->kind == VALUE_COLOUR)
        value->kind = VALUE_COLOUR;
}

/* Numbers, vectors and colours. */
static void operator_apply_numbers(struct parser *p, enum token_kind kind,
                                   struct span span, struct value *left,
                                   const struct value *right)
{
    struct value other = *right;
    operator_promote(left, right);
    operator_promote(&other, left);
    bool infinite = false;
    for (int i = 0; i < value_size(left); i++) {
        infinite |= kind == TOKEN_SLASH && other.number[i] == 0 &&
                    i < value_size(right);
        left->number[i] =
            operator_float(kind, left->number[i], other.number[i]);
    }
    if (infinite)
        warning_at(p, span, NULL, "division by zero");
}

void operator_apply(struct parser *p, enum token_kind kind, struct span span,
                    struct value *left, const struct value *right)
{
    if (left->kind == VALUE_FLOAT && right->kind == VALUE_FLOAT &&
        kind != TOKEN_SLASH) {
        left->number[0] =
            operator_float(kind, left->number[0], right->number[0]);
        return;
    }
    if (value_is_poison(left) || value_is_poison(right)) {
        *left = value_poison();
        return;
    }
    if (left->kind == VALUE_STRING && right->kind == VALUE_STRING) {
        operator_apply_text(p, kind, span, left, right);
        return;
    }
    if (left->kind == VALUE_STRING || right->kind == VALUE_STRING) {
        bool joins = kind == TOKEN_PLUS && left->kind != right->kind &&
                     (left->kind == VALUE_FLOAT || right->kind == VALUE_FLOAT);
        error_at(p, span, joins ? "concat(TEXT, str(NUMBER, 0, 3)) ..." : NULL,
                 "this operator has %s on its left and %s on "
                 "its right",
                 value_kind_name(left->kind), value_kind_name(right->kind));
        *left = value_poison();
        return;
    }
    operator_apply_numbers(p, kind, span, left, right);
}

void operator_apply_sign(struct parser *p, enum token_kind kind,
                         struct span span, struct value *value)
{
    if (value_is_poison(value))
        return;
    if (value->kind == VALUE_STRING) {
        error_at(p, span, NULL, "expected a number, found a string");
        *value = value_poison();
        return;
    }
    for (int i = 0; i < value_size(value); i++)
        if (kind == TOKEN_MINUS)
            value->number[i] = -value->number[i];
        else if (kind == TOKEN_NOT)
            value->number[i] = !operator_truth(value->number[i]);
}
