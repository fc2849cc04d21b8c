/* A root between two places where a function's signs differ: by the secant, an
 * end that stays counting half (regula falsi, the Illinois variant: Dowell and
 * Jarratt 1971), now and then by halving, which jumps need. */
#ifndef SCENE_BRACKET_H
#define SCENE_BRACKET_H

#include <stdbool.h>

struct bracket {
    double a, at_a, b, at_b; /* a < b */
};

/* Where to ask next, in round 1, 2 ...; false: no number is between. */
static inline bool bracket_next(const struct bracket *k, int round, double *t)
{
    *t = k->a - k->at_a * (k->b - k->a) / (k->at_b - k->at_a);
    if (round % 4 == 0 || !(*t > k->a && *t < k->b))
        *t = 0.5 * (k->a + k->b);
    return *t > k->a && *t < k->b;
}

/* The value there, whose sign is that at a, or that at b. */
static inline void bracket_narrow(struct bracket *k, double t, double at_t,
                                  bool like_a)
{
    if (like_a) {
        k->a = t;
        k->at_a = at_t;
        k->at_b /= 2;
    } else {
        k->b = t;
        k->at_b = at_t;
        k->at_a /= 2;
    }
}

#endif
