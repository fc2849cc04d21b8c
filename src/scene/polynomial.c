/* Roots of polynomials: see polynomial.h. */
#include "scene/polynomial.h"

#include <math.h>
#include <stdbool.h>

int quadratic_roots(double a, double b, double c, double roots[2])
{
    if (a == 0) {
        if (b == 0)
            return 0;
        roots[0] = -c / (2 * b);
        return 1;
    }
    double discriminant = b * b - a * c;
    if (!(discriminant > 0))
        return 0;
    double q = -(b + copysign(sqrt(discriminant), b));
    double first = q / a, second = c / q;
    roots[0] = fmin(first, second);
    roots[1] = fmax(first, second);
    return 2;
}

static double value_at(const double *c, int degree, double t)
{
    double value = c[degree];
    for (int i = degree - 1; i >= 0; i--)
        value = value * t + c[i];
    return value;
}

static double value_and_slope(const double *c, int degree, double t,
                              double *slope)
{
    double value = c[degree], derivative = 0;
    for (int i = degree - 1; i >= 0; i--) {
        derivative = derivative * t + value;
        value = value * t + c[i];
    }
    *slope = derivative;
    return value;
}

/* The root between low and high, at which the values have different signs.
 * Newton's steps are taken as long as they stay in the bracket and shrink
 * twofold, else the bracket is halved: never more than some 100 rounds. */
static double root_between(const double *c, int degree, double low, double high,
                           bool low_negative)
{
    double t = (low + high) / 2, step = high - low, last = step;
    for (int round = 0; round < 200; round++) {
        double slope, value = value_and_slope(c, degree, t, &slope);
        if (value == 0)
            return t;
        if ((value < 0) == low_negative)
            low = t;
        else
            high = t;
        double next = t - value / slope;
        bool good = next > low && next < high && fabs(next - t) < last / 2;
        if (!good)
            next = low + (high - low) / 2;
        last = step;
        step = fabs(next - t);
        if (next == t || step <= 1e-16 * fabs(next) || next <= low ||
            next >= high)
            return next;
        t = next;
    }
    return t;
}

/* c's roots, given the points between which it is monotonic. */
static int roots_between(const double *c, int degree, double low, double high,
                         const double *turns, int turn_count, double *roots)
{
    int count = 0;
    double left = low;
    bool left_negative = value_at(c, degree, low) < 0;
    for (int i = 0; i <= turn_count; i++) {
        double right = i < turn_count ? turns[i] : high;
        bool right_negative = value_at(c, degree, right) < 0;
        if (left_negative != right_negative)
            roots[count++] =
                root_between(c, degree, left, right, left_negative);
        left = right;
        left_negative = right_negative;
    }
    return count;
}

/* The k-th derivative divided by k!. */
static void derive(const double *c, int degree, int k, double *out)
{
    double binomial = 1;
    for (int i = k; i <= degree; i++) {
        out[i - k] = c[i] * binomial;
        binomial = binomial * (i + 1) / (i + 1 - k);
    }
}

static int quadratic_roots_between(const double *c, double low, double high,
                                   double *roots)
{
    double both[2];
    int found = quadratic_roots(c[2], c[1] / 2, c[0], both), count = 0;
    for (int i = 0; i < found; i++)
        if (both[i] > low && both[i] < high)
            roots[count++] = both[i];
    return count;
}

int polynomial_roots(const double *c, int degree, double low, double high,
                     double *roots, int limit)
{
    double buffers[2][POLYNOMIAL_DEGREE_MAX + 1];
    double derivative[POLYNOMIAL_DEGREE_MAX + 1];
    double *turns = buffers[0], *found = buffers[1];
    int count = 0, first = 1;
    while (degree > 0 && c[degree] == 0)
        degree--;
    for (int i = 0; i <= degree; i++)
        if (!isfinite(c[i]))
            return 0;
    if (degree == 0 || !(low < high))
        return 0;
    if (degree >= 2) {
        derive(c, degree, degree - 2, derivative);
        count = quadratic_roots_between(derivative, low, high, found);
        first = 3;
    }
    for (int d = first; d <= degree; d++) {
        double *swap = turns;
        turns = found;
        found = swap;
        derive(c, degree, degree - d, derivative);
        count = roots_between(derivative, d, low, high, turns, count, found);
    }
    if (count > limit)
        count = limit;
    for (int i = 0; i < count; i++)
        roots[i] = found[i];
    return count;
}

double polynomial_bound(const double *c, int degree)
{
    if (degree < 1)
        return 0;
    if (c[degree] == 0)
        return HUGE_VAL;
    int lead = ilogb(c[degree]), most = -1000;
    for (int k = 1; k <= degree; k++) {
        if (c[degree - k] == 0)
            continue;
        if (!isfinite(c[degree - k]) || !isfinite(c[degree]))
            return HUGE_VAL;
        /* |c[n-k] / c[n]|^(1/k) < 2^power */
        int ratio = ilogb(c[degree - k]) - lead + 1;
        int power = ratio > 0 ? (ratio + k - 1) / k : ratio / k;
        most = power > most ? power : most;
    }
    return most < -900 ? 0x1p-900 : most > 1000 ? HUGE_VAL : ldexp(2, most);
}
