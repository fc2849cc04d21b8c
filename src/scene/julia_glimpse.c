/* See julia_glimpse.h. Near a surface a ray goes on by the shortest steps, and
 * to look at the next seven of these as well takes no longer. */
#include "scene/julia_glimpse.h"

#include <string.h>

#include "scene/julia_fate.h"
#include "scene/julia_march.h"

enum {
    GLIMPSE_ROUNDS = 20, /* for one crossing */
};

static const double glimpse_enough = 0.25; /* of the cone's radius */
static const double glimpse_apart = 0.25;  /* of a step, places after it */
static const double glimpse_before = 0.1;  /* of what is left to be known */

struct glimpse {
    const struct julia_fractal *fractal;
    const struct julia_cone *cone;
    struct julia_march march; /* all of its lanes are the ray */
    double tmin, tmax, speed;
    bool begun;  /* something is known, */
    bool stays;  /* and that of what is at a; */
    double next; /* nothing else is before that */
    double a, b; /* at last the step in which something has changed */
};

/* Returns whether any of the ray is in the ball around the set. */
static bool glimpse_enter(struct glimpse *glimpse)
{
    const struct julia_cone *cone = glimpse->cone;
    struct julia_march *march = &glimpse->march;
    memset(march, 0, sizeof *march);
    for (int k = 0; k < OCTET; k++) {
        julia_march_put(march, k, cone->ray, cone->tmin, cone->tmax);
        march->open[k] = cone->tmin < cone->tmax ? -1 : 0;
    }
    julia_march_enter(glimpse->fractal, march);
    glimpse->tmin = march->tmin[0];
    glimpse->tmax = march->tmax[0];
    glimpse->speed = march->speed[0];
    return march->open[0];
}

/* Places at hand, so far apart, and what is there. */
struct places {
    octet t;
    struct julia_fates fates;
};

/* Up to the end of the ray. */
static void places_look(const struct glimpse *glimpse, double from,
                        double apart, struct places *places)
{
    octet_bits open;
    for (int k = 0; k < OCTET; k++) {
        const double t = from + k * apart;
        places->t[k] = fmin(t, glimpse->tmax);
        open[k] = t - apart < glimpse->tmax ? -1 : 0;
    }
    julia_march_look(glimpse->fractal, &glimpse->march, &places->t, &open,
                     &places->fates);
}

/* So far nothing changes from place k on, or nothing that the cone is not
 * larger than. */
static double places_reach(const struct glimpse *glimpse,
                           const struct places *places, int k)
{
    const double t = places->t[k];
    const double least = fmax(glimpse->fractal->least / glimpse->speed,
                              glimpse->cone->spread * t);
    const double step = fmax(places->fates.distance[k] / glimpse->speed, least);
    return t + step * (1 + 1e-9);
}

/* The last of them that is no farther; those after the ray's end aren't known.
 */
static int places_before(const struct places *places, int k, double reach)
{
    while (k + 1 < OCTET && places->t[k + 1] <= reach &&
           places->t[k] < places->t[k + 1])
        k++;
    return k;
}

/* Goes on along these places. Returns whether something has changed. */
static bool glimpse_pass(struct glimpse *glimpse, const struct places *places)
{
    int last, k = 0;
    do {
        const bool stays = !places->fates.gone[k];
        glimpse->b = places->t[k];
        if (glimpse->begun && stays != glimpse->stays)
            return true;
        glimpse->begun = true;
        glimpse->stays = stays;
        glimpse->a = glimpse->b;
        glimpse->next = fmin(places_reach(glimpse, places, k), glimpse->tmax);
        last = k;
        k = places_before(places, k, glimpse->next);
    } while (k > last);
    return false;
}

/* Finds the first step in which something changes. */
static bool glimpse_seek(struct glimpse *glimpse)
{
    const double least = glimpse->fractal->least / glimpse->speed;
    double apart = least;
    glimpse->next = glimpse->tmin;
    for (int steps = 0; steps < JULIA_STEPS; steps++) {
        struct places places;
        places_look(glimpse, glimpse->next, apart, &places);
        if (glimpse_pass(glimpse, &places))
            return true;
        if (glimpse->a >= glimpse->tmax)
            return false;
        apart = fmax(least, glimpse_apart * (glimpse->next - glimpse->a));
    }
    return false;
}

/* Narrows the step between places where `beyond` has a value: by those from
 * just before to just behind the change. Returns where the line between their
 * values says it is, and a little before that. */
static double glimpse_narrow(struct glimpse *glimpse, const octet *t,
                             const octet *beyond)
{
    const bool gone = (*beyond)[0] > 0;
    int k = 1;
    while (k + 1 < OCTET && ((*beyond)[k] > 0) == gone)
        k++;
    const double a = glimpse->a = (*t)[k - 1], b = glimpse->b = (*t)[k];
    const double rise = (*beyond)[k] - (*beyond)[k - 1];
    const double part = rise != 0 ? -(*beyond)[k - 1] / rise : 0.5;
    const double there = fmin(fmax(part, 0), 1) - glimpse_before;
    return a + fmax(there, 0) * (b - a);
}

/* Where in that step it changes. */
static double glimpse_refine(struct glimpse *glimpse)
{
    const double least = 1e-7 * glimpse->fractal->radius / glimpse->speed;
    double found = glimpse->a;
    for (int round = 0; round < GLIMPSE_ROUNDS; round++) {
        struct julia_points points;
        octet t, beyond;
        octet_bits open;
        for (int k = 0; k < OCTET; k++) {
            const double part = k / (OCTET - 1.0);
            t[k] = (1 - part) * glimpse->a + part * glimpse->b;
            open[k] = -1;
        }
        julia_march_points(&glimpse->march, &t, &points);
        julia_fates_beyond(glimpse->fractal, &points, &open, &beyond);
        found = glimpse_narrow(glimpse, &t, &beyond);
        if (glimpse->b - glimpse->a <=
            fmax(least, glimpse_enough * glimpse->cone->spread * glimpse->b))
            break;
    }
    return found;
}

double julia_glimpse(const struct julia_fractal *fractal,
                     const struct julia_cone *cone)
{
    struct glimpse glimpse = { .fractal = fractal, .cone = cone };
    if (!glimpse_enter(&glimpse) || !glimpse_seek(&glimpse))
        return HUGE_VAL;
    if (cone->any)
        return 0.5 * (glimpse.a + glimpse.b);
    const double t = glimpse_refine(&glimpse);
    return t > glimpse.tmin ? t : 0.5 * (glimpse.a + glimpse.b);
}
