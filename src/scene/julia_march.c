/* See julia_march.h. */
#include "scene/julia_march.h"

#include <string.h>

#include "base/clones.h"
#include "base/octet_math.h"
#include "scene/julia_fate.h"

enum {
    JULIA_ROUNDS = 60, /* for one crossing */
};

void julia_march_put(struct julia_march *march, int lane, const struct ray *ray,
                     double tmin, double tmax)
{
    march->origin[0][lane] = ray->origin.x;
    march->origin[1][lane] = ray->origin.y;
    march->origin[2][lane] = ray->origin.z;
    march->direction[0][lane] = ray->direction.x;
    march->direction[1][lane] = ray->direction.y;
    march->direction[2][lane] = ray->direction.z;
    march->tmin[lane] = tmin;
    march->tmax[lane] = tmax;
}

CLONES void julia_march_points(const struct julia_march *m, const octet *t,
                               struct julia_points *points)
{
    points->x = m->origin[0] + *t * m->direction[0];
    points->y = m->origin[1] + *t * m->direction[1];
    points->z = m->origin[2] + *t * m->direction[2];
}

void julia_march_look(const struct julia_fractal *f,
                      const struct julia_march *m, const octet *t,
                      const octet_bits *open, struct julia_fates *fates)
{
    struct julia_points points;
    julia_march_points(m, t, &points);
    julia_fates_find(f, &points, open, fates);
}

/* Where the rays are in the ball around it, a little within: where the ball
 * cuts through what stays there is no surface (measured). */
CLONES void julia_march_enter(const struct julia_fractal *f,
                              struct julia_march *m)
{
    const octet *o = m->origin, *d = m->direction;
    const octet dd = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    const octet middle = -(o[0] * d[0] + o[1] * d[1] + o[2] * d[2]) / dd;
    const double radius = f->limits[0] * (1 - 1e-6);
    octet rest = dd * 0 + radius * radius, half, speed = dd;
    for (int k = 0; k < 3; k++) {
        const octet nearest = o[k] + middle * d[k];
        rest -= nearest * nearest;
    }
    m->open &= octet_less(rest * 0, rest);
    half = octet_choose(m->open, rest / dd, rest * 0);
    octet_sqrt(&half);
    octet_sqrt(&speed);
    const octet enter = middle - half, leave = middle + half;
    m->tmin = octet_choose(octet_less(enter, m->tmin), m->tmin, enter);
    m->tmax = octet_choose(octet_less(m->tmax, leave), m->tmax, leave);
    m->open &= octet_less(m->tmin, m->tmax);
    m->speed = speed;
    m->t = m->tmin;
}

void julia_march_alone(const struct julia_fractal *fractal,
                       const struct ray *ray, double tmin, double tmax,
                       struct julia_march *march)
{
    memset(march, 0, sizeof *march);
    julia_march_put(march, 0, ray, tmin, tmax);
    march->open[0] = tmin < tmax ? -1 : 0;
    julia_march_enter(fractal, march);
}

/* They have looked at the next place; those of `moving` are there now. */
CLONES static void march_arrive(const struct julia_fractal *f,
                                const struct julia_fates *fates,
                                const octet_bits *moving, const octet *next,
                                struct julia_march *m)
{
    const octet least = *next * 0 + f->least;
    const octet step = octet_choose(octet_less(least, fates->distance),
                                    fates->distance, least);
    m->t = octet_choose(*moving, *next, m->t);
    m->step = octet_choose(*moving, step / m->speed, m->step);
    m->stays = (*moving & ~fates->gone) | (~*moving & m->stays);
}

void julia_march_start(const struct julia_fractal *fractal,
                       struct julia_march *march)
{
    struct julia_fates fates;
    march->steps = 0;
    julia_march_look(fractal, march, &march->t, &march->open, &fates);
    march_arrive(fractal, &fates, &march->open, &march->t, march);
}

CLONES static void march_aim(const struct julia_march *m, octet *next)
{
    const octet beyond = m->t + m->step;
    *next = octet_choose(octet_less(beyond, m->tmax), beyond, m->tmax);
}

/* Steps in which something has changed, where `found` is set. */
struct changes {
    octet a, b;
    octet_bits found;
};

/* Which of `seek` have met a change before `next`, and which seek on. Returns
 * whether there are any. */
CLONES static bool march_judge(struct julia_march *m, const octet *next,
                               const struct julia_fates *fates,
                               octet_bits *seek, struct changes *changes)
{
    const octet_bits met = *seek & ~(m->stays ^ fates->gone);
    const octet_bits on = octet_less(m->t, *next) & octet_less(*next, m->tmax);
    changes->a = octet_choose(met, m->t, changes->a);
    changes->b = octet_choose(met, *next, changes->b);
    changes->found |= met;
    m->open &= on | ~*seek;
    *seek &= on & ~met;
    return octet_any(*seek);
}

/* Each up to a change, or to its end. */
static void march_seek(const struct julia_fractal *f, struct julia_march *m,
                       struct changes *changes)
{
    octet_bits seek = m->open;
    bool more = true;
    memset(changes, 0, sizeof *changes);
    for (; more && m->steps < JULIA_STEPS; m->steps++) {
        const octet_bits moving = seek;
        struct julia_fates fates;
        octet next;
        march_aim(m, &next);
        julia_march_look(f, m, &next, &moving, &fates);
        more = march_judge(m, &next, &fates, &seek, changes);
        march_arrive(f, &fates, &moving, &next, m);
    }
    if (m->steps == JULIA_STEPS)
        m->open &= 0;
}

/* Brackets of bracket.h. */
struct brackets {
    octet a, at_a, b, at_b, enough;
    octet_bits open;
};

static void brackets_ask(const struct julia_fractal *f,
                         const struct julia_march *m, const octet *t,
                         const octet_bits *open, octet *value)
{
    struct julia_points points;
    julia_march_points(m, t, &points);
    julia_fates_beyond(f, &points, open, value);
}

/* Returns whether there is anything to ask. Values that are both 0 have no
 * secant: it is said to be at a, where none is taken. */
CLONES static bool brackets_next(struct brackets *k, int round, octet *t)
{
    const octet rise = k->at_b - k->at_a, none = { 0 };
    const octet_bits flat = ~(octet_less(rise, none) | octet_less(none, rise));
    const octet part = k->at_a / octet_choose(flat, none + 1, rise);
    const octet secant = k->a - part * (k->b - k->a);
    const octet middle = 0.5 * (k->a + k->b);
    octet_bits good = octet_less(k->a, secant) & octet_less(secant, k->b);
    if (round % 4 == 0)
        good &= 0;
    *t = octet_choose(good, secant, middle);
    k->open &= octet_less(k->enough, k->b - k->a) & octet_less(k->a, *t) &
               octet_less(*t, k->b);
    return octet_any(k->open);
}

CLONES static void brackets_narrow(struct brackets *k, const octet *t,
                                   const octet *at_t)
{
    const octet none = { 0 };
    const octet_bits like_a =
        ~(octet_less(none, *at_t) ^ octet_less(none, k->at_a));
    const octet_bits low = k->open & like_a, high = k->open & ~like_a;
    const octet half_a = octet_choose(high, k->at_a / 2, k->at_a);
    const octet half_b = octet_choose(low, k->at_b / 2, k->at_b);
    k->a = octet_choose(low, *t, k->a);
    k->at_a = octet_choose(low, *at_t, half_a);
    k->b = octet_choose(high, *t, k->b);
    k->at_b = octet_choose(high, *at_t, half_b);
}

CLONES static void brackets_start(const struct julia_fractal *f,
                                  const struct julia_march *m,
                                  const struct changes *changes,
                                  struct brackets *k)
{
    k->a = changes->a;
    k->b = changes->b;
    k->enough = 1e-7 * f->radius / m->speed;
    k->open = changes->found;
}

/* Of the two ends that which stays: its slope is the last's. */
CLONES static void brackets_end(const struct brackets *k, octet *at)
{
    *at = octet_choose(octet_less(k->at_a * 0, k->at_a), k->b, k->a);
}

static void march_refine(const struct julia_fractal *f,
                         const struct julia_march *m,
                         const struct changes *changes, octet *at)
{
    struct brackets k;
    octet t, value;
    brackets_start(f, m, changes, &k);
    brackets_ask(f, m, &k.a, &k.open, &k.at_a);
    brackets_ask(f, m, &k.b, &k.open, &k.at_b);
    for (int i = 1; i < JULIA_ROUNDS && brackets_next(&k, i, &t); i++) {
        brackets_ask(f, m, &t, &k.open, &value);
        brackets_narrow(&k, &t, &value);
    }
    brackets_end(&k, at);
}

CLONES static void changes_between(const struct changes *changes, octet *at)
{
    *at = (changes->a + changes->b) / 2;
}

/* Those within the part that counts. */
CLONES static void march_count(const struct julia_march *m, const octet *at,
                               octet_bits *met)
{
    *met &= octet_less(m->tmin, *at) & octet_less(*at, m->tmax);
}

void julia_march_next(const struct julia_fractal *fractal,
                      struct julia_march *march, bool rough, octet *at,
                      octet_bits *met)
{
    struct changes changes;
    march_seek(fractal, march, &changes);
    *met = changes.found;
    if (!octet_any(*met))
        return;
    if (rough)
        changes_between(&changes, at);
    else
        march_refine(fractal, march, &changes, at);
    march_count(march, at, met);
}
