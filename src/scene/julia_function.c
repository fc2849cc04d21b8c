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

/* sinh z and cosh z by the same e^x, cos y and sin y. */
static void hyperbolic_both(number z, number *sinh_z, number *cosh_z)
{
    double e = exp(creal(z)), less = 1 / e;
    double c = cos(cimag(z)) / 2, s = sin(cimag(z)) / 2;
    *sinh_z = CMPLX((e - less) * c, (e + less) * s);
    *cosh_z = CMPLX((e + less) * c, (e - less) * s);
}

static number sinh_value(number z, number power)
{
    number sinh_z, cosh_z;
    (void)power;
    hyperbolic_both(z, &sinh_z, &cosh_z);
    return sinh_z;
}

static number cosh_value(number z, number power)
{
    number sinh_z, cosh_z;
    (void)power;
    hyperbolic_both(z, &sinh_z, &cosh_z);
    return cosh_z;
}

/* sin z = -i sinh iz, cos z = cosh iz. */
static number sin_value(number z, number power)
{
    number value = sinh_value(CMPLX(-cimag(z), creal(z)), power);
    return CMPLX(cimag(value), -creal(value));
}

static number cos_value(number z, number power)
{
    return cosh_value(CMPLX(-cimag(z), creal(z)), power);
}

ONE(sqr_value, z *z)
ONE(sqr_slope, 2 * z)
/* Without what the machine does about overflow: a number as small as that is
 * gone with the next step in any case. */
static number inverse(number z)
{
    return conj(z) * (1 / complex_square(z));
}

ONE(reciprocal_value, inverse(z))
ONE(reciprocal_slope, -inverse(z *z))
ONE(exp_value, cexp(z))
ONE(ln_value, clog(z))
ONE(ln_slope, 1 / z)
ONE(cos_slope, -sin_value(z, power))
ONE(tan_value, ctan(z))
ONE(tan_slope, 1 / (ccos(z) * ccos(z)))
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

/* ---- bounds ---- */

static double sqr_spread(number z, double e, number power)
{
    (void)power;
    return (2 * complex_size(z) + e) * e;
}

static double reciprocal_spread(number z, double e, number power)
{
    double size = complex_size(z);
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
    return cut ? HUGE_VAL : -log1p(-e / complex_size(z));
}

static double pwr_spread(number z, double e, number power)
{
    double ln = ln_spread(z, e, power);
    return complex_size(pwr_value(z, power)) * expm1(complex_size(power) * ln);
}

/* f(z + h) = f(z) g(h) + g(z) f(h) or the like, |g(h)| <= cosh e. */
static double sum_spread(number f, number g, double e)
{
    return complex_size(f) * (cosh(e) - 1) + complex_size(g) * sinh(e);
}

/* Of either, by the other: the larger counts more, as sinh e > cosh e - 1. */
static double sums_spread(number f, number g, double e)
{
    double a = complex_size(f), b = complex_size(g);
    double rise = expm1(e), fall = rise / (1 + rise); /* e^e - 1, 1 - e^-e */
    return 0.5 * (fmin(a, b) * (rise - fall) + fmax(a, b) * (rise + fall));
}

static double circular_spread(number z, double e, number power)
{
    (void)power;
    number sinh_iz, cosh_iz;
    hyperbolic_both(CMPLX(-cimag(z), creal(z)), &sinh_iz, &cosh_iz);
    return sums_spread(sinh_iz, cosh_iz, e);
}

static double hyperbolic_spread(number z, double e, number power)
{
    (void)power;
    number sinh_z, cosh_z;
    hyperbolic_both(z, &sinh_z, &cosh_z);
    return sums_spread(sinh_z, cosh_z, e);
}

/* tan(z + h) - tan z = sin h / (cos z cos(z + h)) */
static double quotient_spread(number over, number under, double e)
{
    double size = complex_size(under);
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
    double least = under - (2 * complex_size(z) + e) * e;
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
    return real_cuts(z, e)
               ? HUGE_VAL
               : inverse_spread(z, e, complex_size(1 - z * z), true);
}

static double atanh_spread(number z, double e, number power)
{
    (void)power;
    return real_cuts(z, e)
               ? HUGE_VAL
               : inverse_spread(z, e, complex_size(1 - z * z), false);
}

static double asinh_spread(number z, double e, number power)
{
    (void)power;
    return imaginary_cuts(z, e)
               ? HUGE_VAL
               : inverse_spread(z, e, complex_size(1 + z * z), true);
}

static double atan_spread(number z, double e, number power)
{
    (void)power;
    return imaginary_cuts(z, e)
               ? HUGE_VAL
               : inverse_spread(z, e, complex_size(1 + z * z), false);
}

static double acosh_spread(number z, double e, number power)
{
    bool cut = fabs(cimag(z)) <= e && creal(z) - e <= 1;
    (void)power;
    return cut ? HUGE_VAL : inverse_spread(z, e, complex_size(z * z - 1), true);
}

static const struct julia_function functions[] = {
    { "sqr", sqr_value, sqr_slope, sqr_spread, octets_sqr },
    { "cube", sqr_value, sqr_slope, sqr_spread, octets_sqr },
    { "exp", exp_value, exp_value, exp_spread, octets_exp },
    { "reciprocal", reciprocal_value, reciprocal_slope, reciprocal_spread,
      octets_reciprocal },
    { "sin", sin_value, cos_value, circular_spread, octets_sin },
    { "asin", asin_value, asin_slope, asin_spread, octets_asin },
    { "sinh", sinh_value, cosh_value, hyperbolic_spread, octets_sinh },
    { "asinh", asinh_value, asinh_slope, asinh_spread, octets_asinh },
    { "cos", cos_value, cos_slope, circular_spread, octets_cos },
    { "acos", acos_value, acos_slope, asin_spread, octets_acos },
    { "cosh", cosh_value, sinh_value, hyperbolic_spread, octets_cosh },
    { "acosh", acosh_value, acosh_slope, acosh_spread, octets_acosh },
    { "tan", tan_value, tan_slope, tan_spread, octets_tan },
    { "atan", atan_value, atan_slope, atan_spread, octets_atan },
    { "tanh", tanh_value, tanh_slope, tanh_spread, octets_tanh },
    { "atanh", atanh_value, atanh_slope, atanh_spread, octets_atanh },
    { "ln", ln_value, ln_slope, ln_spread, octets_ln },
    { "pwr", pwr_value, pwr_slope, pwr_spread, octets_pwr },
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
