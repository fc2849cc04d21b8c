/* Algebraic surfaces: see algebraic.h. A ray is put into F by Horner's scheme
 * on polynomials of the ray's parameter. */
#include "scene/algebraic.h"

#include "base/clones.h"
#include "scene/crossings.h"
#include "scene/line_roots.h"
#include "scene/quartic_rays.h"

const struct field algebraic_items[] = {
    { "sturm", FIELD_BOOL, offsetof(struct algebraic, sturm), 0, 0,
      "accepted: the roots are exact anyway", false },
    { .name = NULL },
};

size_t algebraic_terms(int order)
{
    size_t n = (size_t)order;
    return (n + 1) * (n + 2) * (n + 3) / 6;
}

const char *algebraic_check(const struct algebraic *surface,
                            struct arena *arena)
{
    size_t wanted = algebraic_terms(surface->order);
    if (surface->terms.count == wanted)
        return NULL;
    return arena_printf(arena, "order %d needs %zu terms, not %zu",
                        surface->order, wanted, surface->terms.count);
}

enum { ALGEBRAIC_FEW = 4 };

/* A polynomial in the ray's parameter; degree -1: nothing yet. Most terms of
 * most surfaces are 0, and add none. */
struct sum {
    int degree;
    double c[ALGEBRAIC_ORDER_MAX + 1];
};

/* Times (a + b t). */
static inline void sum_times(struct sum *sum, double a, double b)
{
    double *p = sum->c;
    int degree = sum->degree;
    if (degree < 0)
        return;
    p[degree + 1] = b * p[degree];
    for (int i = degree; i > 0; i--)
        p[i] = a * p[i] + b * p[i - 1];
    p[0] *= a;
    sum->degree++;
}

static inline void sum_add(struct sum *sum, const double *c, int degree)
{
    while (sum->degree < degree)
        sum->c[++sum->degree] = 0;
    for (int i = 0; i <= degree; i++)
        sum->c[i] += c[i];
}

/* F along o + t d, of the surface's order. */
static void restrict_many(const struct algebraic *surface, vec3 o, vec3 d,
                          struct sum *all)
{
    int n = surface->order;
    const double *term = surface->terms.values;
    all->degree = -1;
    for (int i = n; i >= 0; i--) {
        struct sum in_y, in_z;
        in_y.degree = -1;
        for (int j = n - i; j >= 0; j--) {
            in_z.degree = -1;
            for (int k = n - i - j; k >= 0; k--, term++) {
                sum_times(&in_z, o.z, d.z);
                if (*term != 0)
                    sum_add(&in_z, term, 0);
            }
            sum_times(&in_y, o.y, d.y);
            sum_add(&in_y, in_z.c, in_z.degree);
        }
        sum_times(all, o.x, d.x);
        sum_add(all, in_y.c, in_y.degree);
    }
}

/* For the degrees that most surfaces have, with all terms and without a loop:
 * quicker than leaving out those that are 0. Compilers take loops of known
 * length apart, if they are in no other; so all of these are INLINED. */

/* p times (a + b t), which makes it of this degree, plus a term. */
INLINED void few_horner(double *p, int degree, double a, double b, double term)
{
    p[degree] = b * p[degree - 1];
    for (int i = degree - 1; i > 0; i--)
        p[i] = a * p[i] + b * p[i - 1];
    p[0] = a * p[0] + term;
}

/* The polynomial in z, of degree n, is added to that in y. */
INLINED const double *few_in_z(const double *term, int n, vec3 o, vec3 d,
                               double *in_y)
{
    double p[ALGEBRAIC_FEW + 1] = { *term++ };
    if (n >= 1)
        few_horner(p, 1, o.z, d.z, *term++);
    if (n >= 2)
        few_horner(p, 2, o.z, d.z, *term++);
    if (n >= 3)
        few_horner(p, 3, o.z, d.z, *term++);
    if (n >= 4)
        few_horner(p, 4, o.z, d.z, *term++);
    if (n >= 1)
        few_horner(in_y, n, o.y, d.y, p[0]);
    else
        in_y[0] = p[0];
    for (int i = 1; i <= n; i++)
        in_y[i] += p[i];
    return term;
}

/* That in y, of degree n, to that in x. */
INLINED const double *few_in_y(const double *term, int n, vec3 o, vec3 d,
                               double *in_x)
{
    double p[ALGEBRAIC_FEW + 1];
    term = few_in_z(term, 0, o, d, p);
    if (n >= 1)
        term = few_in_z(term, 1, o, d, p);
    if (n >= 2)
        term = few_in_z(term, 2, o, d, p);
    if (n >= 3)
        term = few_in_z(term, 3, o, d, p);
    if (n >= 4)
        term = few_in_z(term, 4, o, d, p);
    if (n >= 1)
        few_horner(in_x, n, o.x, d.x, p[0]);
    else
        in_x[0] = p[0];
    for (int i = 1; i <= n; i++)
        in_x[i] += p[i];
    return term;
}

INLINED void restrict_few(const double *term, int n, vec3 o, vec3 d,
                          double *all)
{
    term = few_in_y(term, 0, o, d, all);
    term = few_in_y(term, 1, o, d, all);
    term = few_in_y(term, 2, o, d, all);
    term = few_in_y(term, 3, o, d, all);
    if (n >= 4)
        few_in_y(term, 4, o, d, all);
}

static void restrict_to_line(const struct algebraic *surface, vec3 o, vec3 d,
                             struct sum *all)
{
    const double *terms = surface->terms.values;
    all->degree = surface->order;
    switch (surface->order) {
    case 3:
        restrict_few(terms, 3, o, d, all->c);
        break;
    case ALGEBRAIC_FEW:
        restrict_few(terms, ALGEBRAIC_FEW, o, d, all->c);
        break;
    default:
        restrict_many(surface, o, d, all);
    }
}

/* Where the line may meet the surface, and F there; false: nowhere. From where
 * it passes the shape's origin: seen from afar, the coefficients would cancel.
 * Nothing is seen beyond 1e7 units of the ray. */
static bool algebraic_part(const struct algebraic *surface,
                           const struct ray *ray, struct line *line,
                           struct sum *f, double *low, double *high)
{
    if (!line_of(line, ray))
        return false;
    restrict_to_line(surface, line->near, line->along, f);
    while (f->degree > 0 && f->c[f->degree] == 0)
        f->degree--;
    double reach = 1e7 * line->length;
    double bound = polynomial_bound(f->c, f->degree);
    *low = fmax(-bound, -reach - line->shift);
    *high = fmin(bound, reach - line->shift);
    return f->degree > 0;
}

void algebraic_shape_crossings(const void *shape, const struct ray *ray,
                               double tmin, double tmax, hit_visit *visit,
                               void *context)
{
    struct line line;
    struct sum f;
    double low, high;
    if (!algebraic_part(shape, ray, &line, &f, &low, &high))
        return;
    struct line_visit found = { &line, tmin, tmax, visit, context };
    low = fmax(low, line_root(&line, tmin));
    high = fmin(high, line_root(&line, tmax));
    const struct root_search search = { low, line_visit_root, &found };
    polynomial_visit(f.c, f.degree, low, high, &search);
}

bool algebraic_shape_crosses(const void *shape, const struct ray *ray,
                             double tmin, double tmax)
{
    struct line line;
    struct sum f;
    double low, high;
    return algebraic_part(shape, ray, &line, &f, &low, &high) &&
           polynomial_crosses(f.c, f.degree, fmax(low, line_root(&line, tmin)),
                              fmin(high, line_root(&line, tmax)));
}

/* F, and its gradient unless NULL. */
static double evaluate(const struct algebraic *surface, vec3 p, vec3 *gradient)
{
    int n = surface->order;
    const double *term = surface->terms.values;
    double value = 0;
    vec3 slope = { 0, 0, 0 };
    for (int i = n; i >= 0; i--) {
        double in_y = 0, in_y_dy = 0, in_y_dz = 0;
        for (int j = n - i; j >= 0; j--) {
            double in_z = 0, in_z_dz = 0;
            for (int k = n - i - j; k >= 0; k--) {
                in_z_dz = in_z_dz * p.z + in_z;
                in_z = in_z * p.z + *term++;
            }
            in_y_dy = in_y_dy * p.y + in_y;
            in_y_dz = in_y_dz * p.y + in_z_dz;
            in_y = in_y * p.y + in_z;
        }
        slope.x = slope.x * p.x + value;
        slope.y = slope.y * p.x + in_y_dy;
        slope.z = slope.z * p.x + in_y_dz;
        value = value * p.x + in_y;
    }
    if (gradient)
        *gradient = slope;
    return value;
}

/* Where the gradient vanishes (an apex, a double line) any direction does. */
vec3 algebraic_normal(const struct algebraic *surface, vec3 point)
{
    vec3 gradient;
    evaluate(surface, point, &gradient);
    if (!(vec3_dot(gradient, gradient) > 0))
        return vec3_make(1, 0, 0);
    return gradient;
}

/* POV-Ray's tolerance, measured: F < 1e-4 is inside. */
bool algebraic_inside(const struct algebraic *surface, vec3 point)
{
    return evaluate(surface, point, NULL) < 1e-4;
}

struct box3 algebraic_shape_bounds(const void *shape)
{
    (void)shape;
    return box3_infinite();
}

void algebraic_shape_intersect(const void *shape, const struct ray *ray,
                               struct hits *hits)
{
    crossings_all(algebraic_shape_crossings, shape, ray, hits);
}

bool algebraic_shape_first(const void *shape, const struct ray *ray,
                           double tmin, double tmax, struct hit *hit)
{
    return crossings_first(algebraic_shape_crossings, shape, ray, tmin, tmax,
                           hit);
}

_Static_assert((int)ALGEBRAIC_FEW == (int)QUARTIC,
               "restrict_few is for quartics, too");

/* As line_of and restrict_to_line, of order 4. */
CLONES static void lanes_restrict(const double *terms, struct lane_run run,
                                  const struct rays *restrict rays,
                                  const struct rays_span *restrict span,
                                  struct quartic_rays *restrict out)
{
    EACH_LANE(i, run) {
        vec3 d = rays_direction(rays, i), o = rays_origin(rays, i);
        double length = vec3_length(d), c[QUARTIC + 1];
        vec3 along = vec3_scale(d, 1 / length);
        double shift = -vec3_dot(o, along);
        restrict_few(terms, QUARTIC, vec3_along(o, along, shift), along, c);
        for (int k = 0; k <= QUARTIC; k++)
            out->quartics.c[k][i] = c[k];
        out->length[i] = length;
        out->shift[i] = shift;
        out->least[i] = span->near[i] * length - shift;
        out->most[i] = span->far[i] * length - shift;
    }
}

/* Where roots are looked for, as algebraic_part has it. */
static void lanes_limit(struct lane_run run, struct quartic_rays *lanes)
{
    for (int i = run.first; i < run.end; i++) {
        double c[QUARTIC + 1];
        for (int k = 0; k <= QUARTIC; k++)
            c[k] = lanes->quartics.c[k][i];
        double reach = 1e7 * lanes->length[i], shift = lanes->shift[i];
        double bound = polynomial_bound(c, QUARTIC);
        double low = fmax(-bound, -reach - shift);
        double high = fmin(bound, reach - shift);
        lanes->least[i] = fmax(low, lanes->least[i]);
        lanes->quartics.low[i] = lanes->least[i];
        lanes->quartics.high[i] = fmin(high, lanes->most[i]);
    }
}

static struct quartic_rays *algebraic_lanes(const struct algebraic *surface,
                                            const struct quartic_asked *asked,
                                            struct quartic_rays *lanes)
{
    if (surface->order != QUARTIC)
        return NULL;
    lanes_restrict(surface->terms.values, asked->run, asked->rays, asked->span,
                   lanes);
    lanes_limit(asked->run, lanes);
    return lanes;
}

void algebraic_shape_first_many(const void *shape, struct lane_run run,
                                const struct rays *rays,
                                const struct rays_span *span,
                                struct rays_met *met)
{
    const struct quartic_asked asked = {
        shape, algebraic_shape_first, algebraic_shape_crosses, run, rays, span
    };
    struct quartic_rays lanes;
    quartic_rays_first(algebraic_lanes(shape, &asked, &lanes), &asked, met);
}

void algebraic_shape_crosses_many(const void *shape, struct lane_run run,
                                  const struct rays *rays,
                                  const struct rays_span *span, lane_flag *met)
{
    const struct quartic_asked asked = {
        shape, algebraic_shape_first, algebraic_shape_crosses, run, rays, span
    };
    struct quartic_rays lanes;
    quartic_rays_cross(algebraic_lanes(shape, &asked, &lanes), &asked, met);
}

vec3 algebraic_shape_normal(const void *shape, const vec3 *at,
                            const struct hit *hit)
{
    const vec3 point = *at;
    (void)hit;
    return algebraic_normal(shape, point);
}

bool algebraic_shape_inside(const void *shape, vec3 point)
{
    return algebraic_inside(shape, point);
}

/* A polynomial near the middle of a cell: value + slope.d, give or take
 * `rest` (a Taylor model of order 1, Makino and Berz 2003). */
struct model {
    double value;
    double slope[3];
    double rest;
};

/* Times the coordinate at + d[axis], where |d[i]| <= half[i], plus `more`. */
static void model_times(struct model *m, int axis, double at,
                        const double *half, const struct model *more)
{
    double curve = 0;
    for (int i = 0; i < 3; i++)
        curve += fabs(m->slope[i]) * half[i];
    m->rest = m->rest * (fabs(at) + half[axis]) + curve * half[axis];
    for (int i = 0; i < 3; i++)
        m->slope[i] *= at;
    m->slope[axis] += m->value;
    m->value *= at;
    m->value += more->value;
    m->rest += more->rest;
    for (int i = 0; i < 3; i++)
        m->slope[i] += more->slope[i];
}

/* Horner's scheme as in evaluate(). The inside ends at 1e-4, not at 0. */
unsigned algebraic_shape_meets(const void *shape, const struct cell *cell)
{
    const struct algebraic *surface = shape;
    const double *term = surface->terms.values;
    const double half[3] = { cell->half.x, cell->half.y, cell->half.z };
    vec3 c = cell->centre;
    int n = surface->order;
    struct model all = { 0 };
    for (int i = n; i >= 0; i--) {
        struct model in_y = { 0 };
        for (int j = n - i; j >= 0; j--) {
            struct model in_z = { 0 };
            for (int k = n - i - j; k >= 0; k--)
                model_times(&in_z, 2, c.z, half,
                            &(struct model){ .value = *term++ });
            model_times(&in_y, 1, c.y, half, &in_z);
        }
        model_times(&all, 0, c.x, half, &in_y);
    }
    vec3 slope = { all.slope[0], all.slope[1], all.slope[2] };
    double reach = cell_reach(cell, slope) + all.rest;
    bool apart = all.value - reach > 1e-4 || all.value + reach < 0;
    return apart ? 0 : CELL_SURFACE | CELL_BORDER;
}
