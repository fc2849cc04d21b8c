/* Densities along rays are polynomials of the fourth degree, piece by piece:
 * see blob_sweep.h. */
#include "scene/blob_sweep.h"

#include <stdlib.h>

#include "base/clones.h"
#include "base/pair.h"
#include "scene/polynomial.h"

enum { STRETCHES_FEW = 24 }; /* to be sorted by hand */

/* The part of the line where its q is positive, between its limits. */
INLINED void stretch_add(struct stretches *all, struct stretch wanted)
{
    double low = wanted.low, high = wanted.high, nearest = wanted.nearest;
    if (!(wanted.most > 0) || all->count == all->limit)
        return;
    if (wanted.a > 0) {
        double half = sqrt(wanted.most / wanted.a);
        low = low > nearest - half ? low : nearest - half;
        high = high < nearest + half ? high : nearest + half;
    }
    wanted.low = low > all->tmin ? low : all->tmin;
    wanted.high = high < all->tmax ? high : all->tmax;
    if (wanted.low < wanted.high)
        all->items[all->count++] = wanted;
}

CLONES void lane_stretches_of(const struct blob_body *body,
                              const struct rays *restrict rays,
                              const struct rays_span *restrict span,
                              struct lane_stretches *restrict stretches,
                              lane_flag *restrict met)
{
    const vec3 centre = body->centre;
    const double inverse = body->inverse;
    for (int i = 0; i < RAY_LANES; i++) {
        vec3 o = vec3_sub(rays_origin(rays, i), centre);
        vec3 d = rays_direction(rays, i);
        double square = vec3_dot(d, d), nearest = -vec3_dot(o, d) / square;
        vec3 p = vec3_along(o, d, nearest);
        double a = square * inverse, most = 1 - vec3_dot(p, p) * inverse;
        double half = sqrt((most > 0 ? most : 0) / a);
        double low = nearest - half, high = nearest + half;
        double near = span->near[i], far = span->far[i];
        low = low > near ? low : near;
        high = high < far ? high : far;
        stretches->low[i] = low;
        stretches->high[i] = high;
        stretches->a[i] = a;
        stretches->nearest[i] = nearest;
        stretches->most[i] = most;
        met[i] = ((most > 0) & (low < high)) ? -1 : 0;
    }
}

/* A ball of radius 1 around the origin. Part of its callers: to hand on two
 * vectors by value waits for the memory longer than all of this takes. */
INLINED void ball_stretch(struct stretches *all, double strength, vec3 o,
                          vec3 d, double low, double high)
{
    double a = vec3_dot(d, d), nearest = -vec3_dot(o, d) / a;
    vec3 p = vec3_along(o, d, nearest);
    stretch_add(all, (struct stretch){ low, high, strength, a, nearest,
                                       1 - vec3_dot(p, p) });
}

/* The round ends below 0 and beyond the length, and what is between them. */
static void cylinder_stretches(struct stretches *all,
                               const struct blob_part *part, vec3 o, vec3 d)
{
    double top = o.z - part->length, in = -o.z / d.z, out = -top / d.z;
    bool up = d.z > 0;
    if (d.z == 0) {
        in = o.z < 0 ? HUGE_VAL : -HUGE_VAL;
        out = top > 0 ? -HUGE_VAL : HUGE_VAL;
        up = true;
    }
    ball_stretch(all, part->strength, o, d, up ? -HUGE_VAL : in,
                 up ? in : HUGE_VAL);
    double a = d.x * d.x + d.y * d.y;
    double nearest = a > 0 ? -(o.x * d.x + o.y * d.y) / a : 0;
    double x = o.x + nearest * d.x, y = o.y + nearest * d.y;
    stretch_add(all,
                (struct stretch){ fmin(in, out), fmax(in, out), part->strength,
                                  a, nearest, 1 - x * x - y * y });
    o.z = top;
    ball_stretch(all, part->strength, o, d, up ? out : -HUGE_VAL,
                 up ? HUGE_VAL : out);
}

static void body_stretches(struct stretches *all, const struct blob_body *body,
                           const struct ray *ray)
{
    const struct blob_part *part = &body->part;
    vec3 o = affine_point(&part->inward, ray->origin);
    vec3 d = affine_direction(&part->inward, ray->direction);
    if (part->length > 0)
        cylinder_stretches(all, part, o, d);
    else
        ball_stretch(all, part->strength, o, d, -HUGE_VAL, HUGE_VAL);
}

/* Of two round bodies, which may be the same one, both at once. */
static void round_stretches(struct stretches *all,
                            const struct blob_body *const two[PAIR], int count,
                            const struct ray *ray)
{
    const struct blob_body *a = two[0], *b = two[1];
    vec3 o = ray->origin, d = ray->direction;
    double square = vec3_dot(d, d);
    pair x = o.x - (pair){ a->centre.x, b->centre.x };
    pair y = o.y - (pair){ a->centre.y, b->centre.y };
    pair z = o.z - (pair){ a->centre.z, b->centre.z };
    pair inverse = { a->inverse, b->inverse };
    pair nearest = -(x * d.x + y * d.y + z * d.z) / square;
    x = x + nearest * d.x;
    y = y + nearest * d.y;
    z = z + nearest * d.z;
    pair most = 1 - (x * x + y * y + z * z) * inverse;
    for (int i = 0; i < count; i++)
        stretch_add(
            all, (struct stretch){ -HUGE_VAL, HUGE_VAL, two[i]->part.strength,
                                   square * inverse[i], nearest[i], most[i] });
}

void stretches_add(struct stretches *all, const struct blob_body *bodies,
                   size_t count, const struct ray *ray)
{
    const struct blob_body *round[PAIR] = { NULL, NULL };
    int waiting = 0;
    for (size_t i = 0; i < count; i++) {
        if (!bodies[i].round) {
            body_stretches(all, &bodies[i], ray);
            continue;
        }
        round[waiting++] = &bodies[i];
        if (waiting == PAIR) {
            round_stretches(all, round, PAIR, ray);
            waiting = 0;
        }
    }
    if (waiting > 0) {
        round[1] = round[0];
        round_stretches(all, round, 1, ray);
    }
}

static int stretch_order(const void *a, const void *b)
{
    const struct stretch *x = a, *y = b;
    return (x->low > y->low) - (x->low < y->low);
}

static void stretches_sort(struct stretches *all)
{
    if (all->count > STRETCHES_FEW) {
        qsort(all->items, (size_t)all->count, sizeof *all->items,
              stretch_order);
        return;
    }
    for (int i = 1; i < all->count; i++) {
        struct stretch s = all->items[i];
        int k = i;
        for (; k > 0 && all->items[k - 1].low > s.low; k--)
            all->items[k] = all->items[k - 1];
        all->items[k] = s;
    }
}

/* Those that there are at some place of the ray, as it goes along. */
struct sweep {
    const struct stretch *now[STRETCHES_MAX];
    int count;
    double at;
    bool known;  /* the ray was followed to there: */
    double last; /* the density there less the threshold */
};

/* Takes out what ends here, and returns where the next one does. */
static double sweep_end(struct sweep *sweep)
{
    double end = HUGE_VAL;
    int kept = 0;
    for (int i = 0; i < sweep->count; i++) {
        const struct stretch *s = sweep->now[i];
        if (!(s->high > sweep->at))
            continue;
        sweep->now[kept++] = s;
        end = s->high < end ? s->high : end;
    }
    sweep->count = kept;
    return end;
}

/* The density less the threshold as Bernstein polynomials over a piece: the
 * product of two of the second degree each. Its sign where the piece begins is
 * what it was where the last one ended. */
static int sweep_piece(struct sweep *sweep, double threshold, double end,
                       double *roots)
{
    double width = end - sweep->at;
    double b[5] = { -threshold, -threshold, -threshold, -threshold,
                    -threshold };
    for (int i = 0; i < sweep->count; i++) {
        const struct stretch *s = sweep->now[i];
        double from = sweep->at - s->nearest, to = end - s->nearest;
        double q0 = s->most - s->a * from * from;
        double q1 = q0 - s->a * from * width;
        double q2 = s->most - s->a * to * to;
        b[0] += s->strength * q0 * q0;
        b[1] += s->strength * q0 * q1;
        b[2] += s->strength * (2 * q1 * q1 + q0 * q2) * (1.0 / 3);
        b[3] += s->strength * q1 * q2;
        b[4] += s->strength * q2 * q2;
    }
    if (sweep->known && (b[0] < 0) != (sweep->last < 0))
        b[0] = sweep->last;
    sweep->last = b[4];
    return polynomial_bernstein_roots(b, 4, roots);
}

void stretches_sweep(struct stretches *all, double threshold, hit_visit *visit,
                     void *context)
{
    struct sweep sweep;
    int next = 0;
    stretches_sort(all);
    sweep.count = 0;
    sweep.at = 0;
    sweep.last = -1;
    while (sweep.count > 0 || next < all->count) {
        double roots[2 * BERNSTEIN_DEGREE];
        if (sweep.count == 0)
            sweep.at = all->items[next].low;
        for (; next < all->count && all->items[next].low <= sweep.at; next++)
            sweep.now[sweep.count++] = &all->items[next];
        double end = sweep_end(&sweep);
        if (next < all->count && all->items[next].low < end)
            end = all->items[next].low;
        if (sweep.count == 0) {
            sweep.last = -1;
            continue;
        }
        sweep.known = sweep.at > all->tmin;
        int count = sweep_piece(&sweep, threshold, end, roots);
        for (int i = 0; i < count; i++) {
            double t = sweep.at + (end - sweep.at) * roots[i];
            struct hit hit = { t, 0, 0, 0 };
            if (t > all->tmin && t < all->tmax && visit(context, &hit))
                return;
        }
        sweep.at = end;
    }
}
