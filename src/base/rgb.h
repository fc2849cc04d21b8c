/* Linear-light colours: `rgb` is light, `colour` is a pigment's value, light
 * with POV-Ray's two kinds of transparency. Never clipped. */
#ifndef BASE_RGB_H
#define BASE_RGB_H

#include <math.h>
#include <stdbool.h>

typedef struct {
    double r, g, b;
} rgb;

typedef struct {
    double r, g, b;
    double filter;   /* transmitted, tinted by the colour */
    double transmit; /* transmitted, untinted */
} colour;

static inline rgb rgb_make(double r, double g, double b)
{
    return (rgb){ r, g, b };
}

static inline rgb rgb_grey(double v)
{
    return (rgb){ v, v, v };
}

static inline rgb rgb_add(rgb a, rgb b)
{
    return (rgb){ a.r + b.r, a.g + b.g, a.b + b.b };
}

static inline rgb rgb_sub(rgb a, rgb b)
{
    return (rgb){ a.r - b.r, a.g - b.g, a.b - b.b };
}

static inline rgb rgb_mul(rgb a, rgb b)
{
    return (rgb){ a.r * b.r, a.g * b.g, a.b * b.b };
}

static inline rgb rgb_scale(rgb a, double s)
{
    return (rgb){ a.r * s, a.g * s, a.b * s };
}

/* a + s b */
static inline rgb rgb_add_scaled(rgb a, rgb b, double s)
{
    return (rgb){ a.r + s * b.r, a.g + s * b.g, a.b + s * b.b };
}

static inline rgb rgb_mix(rgb a, rgb b, double t)
{
    return rgb_add_scaled(rgb_scale(a, 1 - t), b, t);
}

static inline bool rgb_is_black(rgb a)
{
    return fabs(a.r) + fabs(a.g) + fabs(a.b) == 0;
}

/* The largest component by magnitude: how much a ray of this weight matters. */
static inline double rgb_peak(rgb a)
{
    double r = fabs(a.r), g = fabs(a.g), b = fabs(a.b);
    double peak = r > g ? r : g;
    return peak > b ? peak : b;
}

/* What is grey of a colour, with POV-Ray's weights (measured). */
static inline double grey_of(double r, double g, double b)
{
    return 0.297 * r + 0.589 * g + 0.114 * b;
}

static inline rgb colour_rgb(colour c)
{
    return (rgb){ c.r, c.g, c.b };
}

static inline colour colour_opaque(rgb c)
{
    return (colour){ c.r, c.g, c.b, 0, 0 };
}

static inline colour colour_mix(colour a, colour b, double t)
{
    double s = 1 - t;
    return (colour){ s * a.r + t * b.r, s * a.g + t * b.g, s * a.b + t * b.b,
                     s * a.filter + t * b.filter,
                     s * a.transmit + t * b.transmit };
}

/* What passes straight through: filter * colour + transmit
 * (tests/povray.md, section 5.1: measured). */
static inline rgb colour_transmittance(colour c)
{
    return (rgb){ c.filter * c.r + c.transmit, c.filter * c.g + c.transmit,
                  c.filter * c.b + c.transmit };
}

#endif
