/* Real roots of polynomials in one variable, for rays that meet algebraic
 * surfaces. */
#ifndef SCENE_POLYNOMIAL_H
#define SCENE_POLYNOMIAL_H

#include <math.h>
#include <stdbool.h>

enum {
    POLYNOMIAL_DEGREE_MAX = 35,
    BERNSTEIN_DEGREE = 8,
    POLYNOMIAL_BERNSTEIN_WIDTH = 1000, /* wider, coefficients lose digits */
};

/* Both roots of a t^2 + 2 b t + c, increasing, without cancellation; note the
 * 2. Returns how many: 0, 1 (a is 0) or 2; a double root counts as none. */
int quadratic_roots(double a, double b, double c, double roots[2]);

/* The same without branches, for many side by side; INFINITY where there is no
 * root. */
static inline void quadratic_roots_lane(double a, double b, double c,
                                        double roots[2])
{
    double discriminant = b * b - a * c;
    double q = -(b + copysign(sqrt(discriminant), b));
    double first = q / a, second = c / q, single = -c / (2 * b);
    bool linear = a == 0, one = linear & (b != 0);
    bool two = !linear & (discriminant > 0);
    double low = first < second ? first : second;
    double high = first < second ? second : first;
    roots[0] = two ? low : one ? single : (double)INFINITY;
    roots[1] = two ? high : (double)INFINITY;
}

/* The roots in [low, high] at which the polynomial c[0] + c[1] t + ...
 * + c[degree] t^degree changes sign, increasing, at most `limit`. Touching
 * zero without crossing it is no root. `degree` 0 to POLYNOMIAL_DEGREE_MAX.
 *
 * Between neighbouring roots of its derivative a polynomial is monotonic, so
 * each interval holds at most one root, which bracketed steps find; the
 * derivative's roots are found in the same way. */
int polynomial_roots(const double *c, int degree, double low, double high,
                     double *roots, int limit);

/* Who is told the roots: those that are larger than `least`, until `visit`
 * returns true. */
struct root_search {
    double least;
    bool (*visit)(void *context, double root);
    void *context;
};

/* Tells these roots, increasing: what nobody wants isn't even looked for. */
void polynomial_visit(const double *c, int degree, double low, double high,
                      const struct root_search *search);

/* Whether there is any of them in [low, high], without its place: sooner. */
bool polynomial_crosses(const double *c, int degree, double low, double high);

/* The same as polynomial_roots between 0 and 1 of b[0] B(0) + ... + b[degree]
 * B(degree), where B(i) is the Bernstein polynomial i of that degree, at most
 * BERNSTEIN_DEGREE. There is room for twice as many roots as that. */
int polynomial_bernstein_roots(const double *b, int degree, double *roots);

/* A bound on the magnitude of every root (Fujiwara 1916, rounded up to a
 * power of two); HUGE_VAL when c[degree] is 0. */
double polynomial_bound(const double *c, int degree);

#endif
