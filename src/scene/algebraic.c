/* Algebraic surfaces: see algebraic.h. A ray is put into F by Horner's scheme
 * on polynomials of the ray's parameter. */
#include "scene/algebraic.h"

#include "scene/polynomial.h"

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

/* p, of this degree, times (a + b t). */
static void times_linear(double *p, int degree, double a, double b)
{
    p[degree + 1] = b * p[degree];
    for (int i = degree; i > 0; i--)
        p[i] = a * p[i] + b * p[i - 1];
    p[0] *= a;
}

/* F along origin + t direction: its coefficients in t into c. */
static void restrict_to_line(const struct algebraic *surface, vec3 o, vec3 d,
                             double *c)
{
    int n = surface->order;
    const double *term = surface->terms.values;
    for (int i = n; i >= 0; i--) {
        double in_y[ALGEBRAIC_ORDER_MAX + 1];
        for (int j = n - i; j >= 0; j--) {
            int top = n - i - j;
            double in_z[ALGEBRAIC_ORDER_MAX + 1];
            in_z[0] = *term++;
            for (int k = 0; k < top; k++) {
                times_linear(in_z, k, o.z, d.z);
                in_z[0] += *term++;
            }
            if (top > 0)
                times_linear(in_y, top - 1, o.y, d.y);
            else
                in_y[0] = 0;
            for (int k = 0; k <= top; k++)
                in_y[k] += in_z[k];
        }
        if (i < n)
            times_linear(c, n - i - 1, o.x, d.x);
        else
            c[0] = 0;
        for (int k = 0; k <= n - i; k++)
            c[k] += in_y[k];
    }
}

/* The ray's origin is first moved to where it passes the shape's origin and
 * its direction made unit: seen from afar, the coefficients would cancel. */
void algebraic_intersect(const struct algebraic *surface, const struct ray *ray,
                         struct hits *hits)
{
    double c[ALGEBRAIC_ORDER_MAX + 1], roots[HITS_MAX];
    double length = vec3_length(ray->direction);
    if (!(length > 0))
        return;
    vec3 direction = vec3_scale(ray->direction, 1 / length);
    double shift = -vec3_dot(ray->origin, direction);
    restrict_to_line(surface, vec3_along(ray->origin, direction, shift),
                     direction, c);
    int degree = surface->order;
    while (degree > 0 && c[degree] == 0)
        degree--;
    /* Nothing is seen beyond 1e7 units of the ray. */
    double reach = 1e7 * length;
    double bound = polynomial_bound(c, degree);
    double low = fmax(-bound, -reach - shift);
    double high = fmin(bound, reach - shift);
    int count = polynomial_roots(c, degree, low, high, roots, HITS_MAX);
    for (int i = 0; i < count; i++)
        hits_add(hits, (roots[i] + shift) / length, 0);
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
    algebraic_intersect(shape, ray, hits);
}

vec3 algebraic_shape_normal(const void *shape, vec3 point,
                            const struct hit *hit)
{
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
