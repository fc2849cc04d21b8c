/* Roots of polynomials of degree 4 side by side, as polynomial.h finds those of
 * one, to the bit; what takes long to tell is left to it. */
#ifndef SCENE_QUARTICS_H
#define SCENE_QUARTICS_H

#include "scene/rays.h"

enum { QUARTIC = 4 };

/* Of each lane the coefficients of 1, t, t^2 ..., and where its roots are
 * looked for: nowhere, unless low < high. */
struct quartics {
    double c[QUARTIC + 1][RAY_LANES];
    double low[RAY_LANES], high[RAY_LANES];
};

/* What is known of a lane. */
enum quartic_fate { QUARTIC_NONE, QUARTIC_ROOT, QUARTIC_UNKNOWN };

struct quartic_roots {
    double fate[RAY_LANES]; /* an enum quartic_fate, as wide as the roots */
    double root[RAY_LANES];
};

/* The first root above `least`. */
void quartics_first(const struct quartics *quartics, const double *least,
                    struct quartic_roots *out);

/* Whether there is a root. */
void quartics_cross(const struct quartics *quartics, double *fate);

#endif
