/* Orbits and what they are coloured by, as measured: see orbit.h. */
#include "scene/orbit.h"

#include <math.h>

/* (x + iy)^n into *x, *y. */
static void complex_power(double *x, double *y, int n)
{
    double a = *x, b = *y;
    for (int i = 1; i < n; i++) {
        double real = *x * a - *y * b;
        *y = *x * b + *y * a;
        *x = real;
    }
}

/* The ways that exterior and interior share: by the last point. */
static double orbit_end(int way, double x, double y)
{
    switch (way) {
    case 2:
        return x;
    case 3:
        return y;
    case 4:
        return x * x;
    case 5:
        return y * y;
    case 6:
        return sqrt(x * x + y * y);
    default:
        return 1;
    }
}

/* A scene may say any number. */
static int orbit_integer(double number)
{
    return (int)fmax(-1e6, fmin(number, 1e6));
}

/* Left the circle of radius 2 after `steps` that stayed in it. */
static double orbit_exterior(const struct orbit *orbit, int steps, double x,
                             double y)
{
    double factor = orbit->exterior[1];
    int way = orbit_integer(orbit->exterior[0]);
    int period = orbit_integer(factor) + (way == 8);
    switch (way) {
    case 1:
        return (double)steps / orbit->iterations;
    case 7:
    case 8:
        return period > 0 ? steps % period / factor : 0;
    default:
        return factor * orbit_end(way, x, y);
    }
}

double orbit_value(const struct orbit *orbit, double x, double y, double u,
                   double v)
{
    double nearest = x * x + y * y;
    for (int i = 0; i < orbit->iterations; i++) {
        complex_power(&x, &y, orbit->exponent);
        x += u;
        y += v;
        double square = x * x + y * y;
        if (square > 4)
            return orbit_exterior(orbit, i, x, y);
        nearest = fmin(nearest, square);
    }
    int way = orbit_integer(orbit->interior[0]);
    return orbit->interior[1] *
           (way == 1 ? sqrt(nearest) : orbit_end(way, x, y));
}
