/* Functions of Julia sets: see julia_function.h. Each bound is from the
 * function's addition formula or, of an inverse function, from its derivative
 * at its largest. `cube` is sqr in POV-Ray 3.7's hypercomplex sets (measured).
 */
#include "scene/julia_function.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <string.h>

typedef double complex number;

#define ONE(name, formula)                                                     \
    static number name(number z, number power)                                 \
    {                                                                          \
        (void)power;                                                           \
        return formula;                                                        \
    }

ONE(sqr_value, z *z)
ONE(sqr_slope, 2 * z)
ONE(reciprocal_value, 1 / z)
ONE(reciprocal_slope, -1 / (z * z))
ONE(exp_value, cexp(z))
ONE(ln_value, clog(z))
ONE(ln_slope, 1 / z)
ONE(sin_value, csin(z))
ONE(cos_value, ccos(z))
ONE(cos_slope, -csin(z))
ONE(tan_value, ctan(z))
ONE(tan_slope, 1 / (ccos(z) * ccos(z)))
ONE(sinh_value, csinh(z))
ONE(cosh_value, ccosh(z))
ONE(tanh_value, ctanh(z))
ONE(tanh_slope, 1 / (ccosh(z) * ccosh(z)))
ONE(asin_value, casin(z))
ONE(asin_slope, 1 / csqrt(1 - z * z))
ONE(acos_value, cacos(z))
ONE(acos_slope, -1 / csqrt(1 - z * z))
ONE(atan_value, catan(z))
ONE(atan_slope, 1 / (1 + z * z))
ONE(asinh_value, casinh(z))
ONE(asinh_slope, 1 / csqrt(1 + z * z))
ONE(acosh_value, cacosh(z))
ONE(acosh_slope, 1 / (csqrt(z - 1) * csqrt(z + 1)))
ONE(atanh_value, catanh(z))
ONE(atanh_slope, 1 / (1 - z * z))

static number pwr_value(number z, number power)
{
    return cexp(power * clog(z));
}

static number pwr_slope(number z, number power)
{
    return power * cexp((power - 1) * clog(z));
}

static double sqr_spread(number z, double e, number power)
{
    (void)power;
    return (2 * cabs(z) + e) * e;
}

static double reciprocal_spread(number z, double e, number power)
{
    double size = cabs(z);
    (void)power;
    return e < size ? e / (size * (size - e)) : HUGE_VAL;
}

static double exp_spread(number z, double e, number power)
{
    (void)power;
    return exp(creal(z)) * expm1(e);
}

static double ln_spread(number z, double e, number power)
{
    bool cut = fabs(cimag(z)) <= e && creal(z) <= e;
    (void)power;
    return cut ? HUGE_VAL : -log1p(-e / cabs(z));
}

static double pwr_spread(number z, double e, number power)
{
    double ln = ln_spread(z, e, power);
    return cabs(pwr_value(z, power)) * expm1(cabs(power) * ln);
}

/* f(z + h) = f(z) g(h) + g(z) f(h) or the like, |g(h)| <= cosh e. */
static double sum_spread(number f, number g, double e)
{
    return cabs(f) * (cosh(e) - 1) + cabs(g) * sinh(e);
}

static double circular_spread(number z, double e, number power)
{
    (void)power;
    return fmax(sum_spread(csin(z), ccos(z), e),
                sum_spread(ccos(z), csin(z), e));
}

static double hyperbolic_spread(number z, double e, number power)
{
    (void)power;
    return fmax(sum_spread(csinh(z), ccosh(z), e),
                sum_spread(ccosh(z), csinh(z), e));
}

/* tan(z + h) - tan z = sin h / (cos z cos(z + h)) */
static double quotient_spread(number over, number under, double e)
{
    double size = cabs(under);
    double least = size - sum_spread(under, over, e);
    return least > 0 ? sinh(e) / (size * least) : HUGE_VAL;
}

static double tan_spread(number z, double e, number power)
{
    (void)power;
    return quotient_spread(csin(z), ccos(z), e);
}

static double tanh_spread(number z, double e, number power)
{
    (void)power;
    return quotient_spread(csinh(z), ccosh(z), e);
}

/* A derivative that is 1 by the root, or not, of `under`, which changes by no
 * more than (2 |z| + e) e. */
static double inverse_spread(number z, double e, double under, bool root)
{
    double least = under - (2 * cabs(z) + e) * e;
    if (!(least > 0))
        return HUGE_VAL;
    return e / (root ? sqrt(least) : least);
}

/* Cuts along the real axis, outwards from -1 and 1. */
static bool real_cuts(number z, double e)
{
    return fabs(cimag(z)) <= e && fabs(creal(z)) + e >= 1;
}

static bool imaginary_cuts(number z, double e)
{
    return fabs(creal(z)) <= e && fabs(cimag(z)) + e >= 1;
}

static double asin_spread(number z, double e, number power)
{
    (void)power;
    return real_cuts(z, e) ? HUGE_VAL
                           : inverse_spread(z, e, cabs(1 - z * z), true);
}

static double atanh_spread(number z, double e, number power)
{
    (void)power;
    return real_cuts(z, e) ? HUGE_VAL
                           : inverse_spread(z, e, cabs(1 - z * z), false);
}

static double asinh_spread(number z, double e, number power)
{
    (void)power;
    return imaginary_cuts(z, e) ? HUGE_VAL
                                : inverse_spread(z, e, cabs(1 + z * z), true);
}

static double atan_spread(number z, double e, number power)
{
    (void)power;
    return imaginary_cuts(z, e) ? HUGE_VAL
                                : inverse_spread(z, e, cabs(1 + z * z), false);
}

static double acosh_spread(number z, double e, number power)
{
    bool cut = fabs(cimag(z)) <= e && creal(z) - e <= 1;
    (void)power;
    return cut ? HUGE_VAL : inverse_spread(z, e, cabs(z * z - 1), true);
}

static const struct julia_function functions[] = {
    { "sqr", sqr_value, sqr_slope, sqr_spread },
    { "cube", sqr_value, sqr_slope, sqr_spread },
    { "exp", exp_value, exp_value, exp_spread },
    { "reciprocal", reciprocal_value, reciprocal_slope, reciprocal_spread },
    { "sin", sin_value, cos_value, circular_spread },
    { "asin", asin_value, asin_slope, asin_spread },
    { "sinh", sinh_value, cosh_value, hyperbolic_spread },
    { "asinh", asinh_value, asinh_slope, asinh_spread },
    { "cos", cos_value, cos_slope, circular_spread },
    { "acos", acos_value, acos_slope, asin_spread },
    { "cosh", cosh_value, sinh_value, hyperbolic_spread },
    { "acosh", acosh_value, acosh_slope, acosh_spread },
    { "tan", tan_value, tan_slope, tan_spread },
    { "atan", atan_value, atan_slope, atan_spread },
    { "tanh", tanh_value, tanh_slope, tanh_spread },
    { "atanh", atanh_value, atanh_slope, atanh_spread },
    { "ln", ln_value, ln_slope, ln_spread },
    { "pwr", pwr_value, pwr_slope, pwr_spread },
};

const struct julia_function *julia_function_at(int index)
{
    int count = (int)(sizeof functions / sizeof *functions);
    return index < count ? &functions[index] : NULL;
}

const struct julia_function *julia_function_find(const char *name)
{
    const struct julia_function *f;
    for (int i = 0; (f = julia_function_at(i)); i++)
        if (strcmp(f->name, name) == 0)
            return f;
    return NULL;
}
