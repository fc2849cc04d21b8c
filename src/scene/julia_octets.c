/* See julia_octets.h. Functions of circles are those of hyperbolas turned by i,
 * inverse functions are logarithms: with the cuts of C's <complex.h>. */
#include "scene/julia_octets.h"

#include "base/clones.h"
#include "base/octet_math.h"

typedef struct complex_octet number;

/* Beyond it tanh is 1. */
static const double tanh_limit = 20;

/* Its opposite where the bits are set. */
INLINED number mirrored(octet_bits where, number z)
{
    return (number){ octet_choose(where, -z.re, z.re),
                     octet_choose(where, -z.im, z.im) };
}

INLINED number turned(number z)
{
    return (number){ -z.im, z.re };
}

INLINED number turned_back(number z)
{
    return (number){ z.im, -z.re };
}

INLINED number sum(number a, number b)
{
    return (number){ a.re + b.re, a.im + b.im };
}

INLINED number product(number a, number b)
{
    return (number){ a.re * b.re - a.im * b.im, a.re * b.im + a.im * b.re };
}

/* z + x */
INLINED number beside(number z, double x)
{
    return (number){ z.re + x, z.im };
}

CLONES static void number_exp(number *z)
{
    octet size = z->re, sine = z->im, cosine = z->im;
    octet_exp(&size);
    octet_sin(&sine);
    octet_cos(&cosine);
    *z = (number){ size * cosine, size * sine };
}

CLONES static void number_ln(number *z)
{
    octet size2 = z->re * z->re + z->im * z->im, angle = z->im;
    octet_ln(&size2);
    octet_atan2(&angle, &z->re);
    *z = (number){ 0.5 * size2, angle };
}

/* The root whose real part is not below 0. */
CLONES static void number_root(number *z)
{
    octet size = z->re * z->re + z->im * z->im, real = z->re;
    const octet none = size * 0;
    octet_sqrt(&size);
    octet_abs(&real);
    octet large = 0.5 * (size + real);
    octet_sqrt(&large);
    const octet small =
        octet_choose(octet_less(none, large), 0.5 * z->im / large, none);
    octet small_size = small;
    octet_abs(&small_size);
    const octet signed_large =
        octet_choose(octet_less(z->im, none), -large, large);
    *z = (number){ octet_choose(octet_less(z->re, none), small_size, large),
                   octet_choose(octet_less(z->re, none), signed_large, small) };
}

/* sinh z and cosh z by the same e^x, cos y and sin y. */
CLONES static void number_hyperbolic(const number *z, number *sinh_z,
                                     number *cosh_z)
{
    octet size = z->re, sine = z->im, cosine = z->im;
    octet_exp(&size);
    octet_sin(&sine);
    octet_cos(&cosine);
    const octet rise = 0.5 * size, fall = 0.5 / size;
    *sinh_z = (number){ (rise - fall) * cosine, (rise + fall) * sine };
    *cosh_z = (number){ (rise + fall) * cosine, (rise - fall) * sine };
}

CLONES static void number_tanh(number *z)
{
    number over, under, in = *z;
    const octet most = in.re * 0 + tanh_limit;
    in.re = octet_choose(octet_less(most, in.re), most, in.re);
    in.re = octet_choose(octet_less(in.re, -most), -most, in.re);
    number_hyperbolic(&in, &over, &under);
    const octet part = 1 / (under.re * under.re + under.im * under.im);
    const number conjugate = { under.re * part, -under.im * part };
    *z = product(over, conjugate);
}

/* ln(z + root(1 + z^2)): of what lies left of the imaginary axis as of its
 * opposite, where nothing cancels. */
CLONES static void number_asinh(number *z)
{
    const octet_bits left = octet_less(z->re, z->re * 0);
    const number in = mirrored(left, *z);
    number root = beside(product(in, in), 1);
    number_root(&root);
    root = sum(in, root);
    number_ln(&root);
    *z = mirrored(left, root);
}

/* (ln(1 + z) - ln(1 - z)) / 2 */
CLONES static void number_atanh(number *z)
{
    number more = beside(*z, 1), less = { 1 - z->re, -z->im };
    number_ln(&more);
    number_ln(&less);
    *z = (number){ 0.5 * (more.re - less.re), 0.5 * (more.im - less.im) };
}

CLONES static void number_asin(number *z)
{
    *z = turned(*z);
    number_asinh(z);
    *z = turned_back(*z);
}

/* ---- by name ---- */

#define OCTETS(name) CLONES void octets_##name(number *z, const double power[2])

OCTETS(sqr)
{
    (void)power;
    *z = product(*z, *z);
}

OCTETS(reciprocal)
{
    (void)power;
    const octet part = 1 / (z->re * z->re + z->im * z->im);
    *z = (number){ z->re * part, -z->im * part };
}

OCTETS(exp)
{
    (void)power;
    number_exp(z);
}

OCTETS(ln)
{
    (void)power;
    number_ln(z);
}

OCTETS(pwr)
{
    number_ln(z);
    *z = (number){ power[0] * z->re - power[1] * z->im,
                   power[0] * z->im + power[1] * z->re };
    number_exp(z);
}

OCTETS(sinh)
{
    number other, in = *z;
    (void)power;
    number_hyperbolic(&in, z, &other);
}

OCTETS(cosh)
{
    number other, in = *z;
    (void)power;
    number_hyperbolic(&in, &other, z);
}

OCTETS(sin)
{
    number value, other, in = turned(*z);
    (void)power;
    number_hyperbolic(&in, &value, &other);
    *z = turned_back(value);
}

OCTETS(cos)
{
    number other, in = turned(*z);
    (void)power;
    number_hyperbolic(&in, &other, z);
}

OCTETS(tanh)
{
    (void)power;
    number_tanh(z);
}

OCTETS(tan)
{
    (void)power;
    *z = turned(*z);
    number_tanh(z);
    *z = turned_back(*z);
}

OCTETS(asinh)
{
    (void)power;
    number_asinh(z);
}

OCTETS(asin)
{
    (void)power;
    number_asin(z);
}

OCTETS(acos)
{
    const double right = 1.57079632679489661923;
    (void)power;
    number_asin(z);
    *z = (number){ right - z->re, -z->im };
}

OCTETS(acosh)
{
    number less = beside(*z, -1), more = beside(*z, 1);
    (void)power;
    number_root(&less);
    number_root(&more);
    *z = sum(*z, product(less, more));
    number_ln(z);
}

OCTETS(atanh)
{
    (void)power;
    number_atanh(z);
}

OCTETS(atan)
{
    (void)power;
    *z = turned(*z);
    number_atanh(z);
    *z = turned_back(*z);
}
