/* See julia_steps.h. Depths of POV-Ray's pictures are mostly multiples of
 * 1 / precision from where the ray meets the ball or begins, which is the step
 * here. With `reciprocal` all surfaces were where POV-Ray has them; it leaves
 * out some of `exp`, `sinh` and `cosh`, and its places are one end of the step
 * where here they are between: why isn't known. */
#include "scene/julia_steps.h"

#include "base/clones.h"
#include "base/octet.h"
#include "scene/julia_march.h"
#include "scene/julia_octets.h"

enum {
    JULIA_ROUNDS = 20, /* for one crossing */
};

struct octet_halves {
    struct complex_octet a, b;
};

/* The two complex numbers of the points at t: see julia_orbit.c. */
CLONES static void halves_at(const struct julia_fractal *f,
                             const struct ray *ray, const octet *t,
                             struct octet_halves *h)
{
    const octet x = ray->origin.x + *t * ray->direction.x;
    const octet y = ray->origin.y + *t * ray->direction.y;
    const octet z = ray->origin.z + *t * ray->direction.z;
    const octet w = f->w[0] * x + f->w[1] * y + f->w[2] * z + f->w[3];
    h->a = (struct complex_octet){ x - w, y + z };
    h->b = (struct complex_octet){ x + w, y - z };
}

/* Takes those out of `stays` that are gone, and makes them zero, with which
 * every function is quickly done; returns whether any is left. */
CLONES static bool halves_sift(const struct julia_fractal *f,
                               struct octet_halves *h, octet_bits *stays)
{
    const octet size2 = 0.5 * (h->a.re * h->a.re + h->a.im * h->a.im +
                               h->b.re * h->b.re + h->b.im * h->b.im);
    const octet most = size2 * 0 + f->radius * f->radius;
    const octet_bits left = *stays & ~octet_less(most, size2);
    h->a.re = (octet)(left & (octet_bits)h->a.re);
    h->a.im = (octet)(left & (octet_bits)h->a.im);
    h->b.re = (octet)(left & (octet_bits)h->b.re);
    h->b.im = (octet)(left & (octet_bits)h->b.im);
    *stays = left;
    return octet_any(left);
}

CLONES static void halves_add(const struct julia_fractal *f,
                              struct octet_halves *h)
{
    h->a.re += f->c[0] - f->c[3];
    h->a.im += f->c[1] + f->c[2];
    h->b.re += f->c[0] + f->c[3];
    h->b.im += f->c[1] - f->c[2];
}

/* Which of the points at t stay. */
static void octet_look(const struct julia_fractal *f, const struct ray *ray,
                       const octet *t, octet_bits *stays)
{
    struct octet_halves h;
    halves_at(f, ray, t, &h);
    for (int i = 0; i < OCTET; i++)
        (*stays)[i] = -1;
    for (int i = 1; halves_sift(f, &h, stays) && i < f->iterations; i++) {
        f->function->octets(&h.a, f->power);
        f->function->octets(&h.b, f->power);
        halves_add(f, &h);
    }
}

/* The place between a and b where what is so at a, `stays`, changes: that of
 * its sides that stays. */
static double steps_refine(const struct julia_fractal *f, const struct ray *ray,
                           double a, double b, bool stays, double enough)
{
    for (int round = 0; round < JULIA_ROUNDS && b - a > enough; round++) {
        octet t;
        octet_bits there;
        double part = (b - a) / (OCTET + 1);
        int i = 0;
        for (int k = 0; k < OCTET; k++)
            t[k] = a + (k + 1) * part;
        octet_look(f, ray, &t, &there);
        while (i < OCTET && (there[i] != 0) == stays)
            i++;
        b = i < OCTET ? t[i] : b;
        a = i > 0 ? t[i - 1] : a;
    }
    return stays ? a : b;
}

void julia_steps_visit(const struct julia_fractal *f,
                       const struct julia_walk *walk, hit_visit *visit,
                       void *context)
{
    struct julia_march part;
    julia_march_alone(f, walk->ray, walk->tmin, walk->tmax, &part);
    double tmin = part.tmin[0], tmax = part.tmax[0], last = tmin;
    double step = f->least / part.speed[0];
    double pace = fmax(step, (tmax - tmin) / JULIA_STEPS);
    double enough = walk->rough ? step : 1e-7 * f->radius / part.speed[0];
    if (!part.open[0])
        return;
    bool stayed = false, begun = false;
    for (int n = 0; last < tmax; n += OCTET) {
        octet t;
        octet_bits stays;
        for (int k = 0; k < OCTET; k++)
            t[k] = fmin(tmin + (n + k) * pace, tmax);
        octet_look(f, walk->ray, &t, &stays);
        for (int k = 0; k < OCTET; k++) {
            bool stay = stays[k] != 0;
            if (begun && stay != stayed) {
                struct hit hit = { .t = steps_refine(f, walk->ray, last, t[k],
                                                     stayed, enough) };
                if (hit.t > tmin && hit.t < tmax && visit(context, &hit))
                    return;
            }
            begun = true;
            stayed = stay;
            last = t[k];
        }
    }
}
