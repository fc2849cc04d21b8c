/* Functions whose value is a number. Where POV-Ray stops the parse there is
 * an error, where it warns a warning, and its odd values are kept (measured:
 * acos(2) is 0, int(1e30) is -2147483648). */
#include "base/text.h"
#include "parse/array.h"
#include "parse/expression.h"
#include "parse/function.h"
#include "parse/random.h"

static double argument(const struct call *call, int i)
{
    return call->arguments[i].number[0];
}

double number_int(double x)
{
    return float_to_int(x);
}

double number_div(double a, double b)
{
    return float_to_int(a / b);
}

double number_degrees(double x)
{
    return x * (180 / M_PI);
}

double number_radians(double x)
{
    return x * (M_PI / 180);
}

double number_and(double a, double b)
{
    return float_to_int(a) & float_to_int(b);
}

double number_or(double a, double b)
{
    return float_to_int(a) | float_to_int(b);
}

double number_xor(double a, double b)
{
    return float_to_int(a) ^ float_to_int(b);
}

/* The sign is the dividend's. */
double number_mod(double a, double b)
{
    return fmod(a, b);
}

void number_sqrt(struct parser *p, const struct call *call,
                 struct value *result)
{
    double x = argument(call, 0);
    *result = value_float(sqrt(x));
    if (x < 0)
        call_error(p, call, result, NULL, "%s has no square root",
                   NUMBER_TEXT(x));
}

void number_ln(struct parser *p, const struct call *call, struct value *result)
{
    double x = argument(call, 0);
    *result = value_float(log(x));
    if (x <= 0)
        call_error(p, call, result, NULL, "%s has no logarithm",
                   NUMBER_TEXT(x));
}

void number_log(struct parser *p, const struct call *call, struct value *result)
{
    double x = argument(call, 0);
    *result = value_float(log10(x));
    if (x <= 0)
        call_error(p, call, result, NULL, "%s has no logarithm",
                   NUMBER_TEXT(x));
}

static double number_clamp(struct parser *p, const struct call *call)
{
    double x = argument(call, 0);
    if (x >= -1 && x <= 1)
        return x;
    warning_at(p, call->span, NULL,
               "%s is outside the range of this function, -1 to 1",
               NUMBER_TEXT(x));
    return x < 0 ? -1 : 1;
}

void number_asin(struct parser *p, const struct call *call,
                 struct value *result)
{
    *result = value_float(asin(number_clamp(p, call)));
}

void number_acos(struct parser *p, const struct call *call,
                 struct value *result)
{
    *result = value_float(acos(number_clamp(p, call)));
}

void number_atan2(struct parser *p, const struct call *call,
                  struct value *result)
{
    double y = argument(call, 0), x = argument(call, 1);
    *result = value_float(atan2(y, x));
    if (x == 0 && y == 0)
        call_error(p, call, result, NULL, "atan2(0, 0) has no value");
}

void number_pow(struct parser *p, const struct call *call, struct value *result)
{
    double x = argument(call, 0), y = argument(call, 1);
    *result = value_float(pow(x, y));
    if (x == 0 && y == 0)
        call_error(p, call, result, NULL, "pow(0, 0) has no value");
}

/* select(x, negative, zero, positive); the last two may be one. */
void number_select(struct parser *p, const struct call *call,
                   struct value *result)
{
    (void)p;
    double x = argument(call, 0);
    int chosen = x < 0 ? 1 : x > 0 && call->count == 4 ? 3 : 2;
    *result = call->arguments[chosen];
}

void number_seed(struct parser *p, const struct call *call,
                 struct value *result)
{
    if (!p->randoms)
        p->randoms = ARENA_NEW(p->arena, struct random_streams);
    p->changes++;
    int seed = float_to_int(argument(call, 0));
    *result = value_float((double)random_seed(p->arena, p->randoms, seed));
}

void number_rand(struct parser *p, const struct call *call,
                 struct value *result)
{
    double stream = argument(call, 0);
    size_t count = p->randoms ? p->randoms->count : 0;
    if (!(stream > -1 && stream < (double)count)) {
        call_error(p, call, result, "rand(seed(1))",
                   "rand() wants what seed() gave, found %s",
                   NUMBER_TEXT(stream));
        return;
    }
    p->changes++;
    *result = value_float(random_next(p->randoms, (size_t)fabs(stream)));
}

void number_defined(struct parser *p, const struct call *call,
                    struct value *result)
{
    (void)p;
    *result = call->arguments[0];
}

void number_dimensions(struct parser *p, const struct call *call,
                       struct value *result)
{
    (void)p;
    *result = value_float(array_dimensions(call->array));
}

void number_dimension_size(struct parser *p, const struct call *call,
                           struct value *result)
{
    (void)p;
    int dimension = float_to_int(argument(call, 1));
    *result = value_float(array_dimension_size(call->array, dimension));
}
