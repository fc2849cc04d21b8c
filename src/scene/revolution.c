/* Curves turned around the y axis: see revolution.h. */
#include "scene/revolution.h"

#include "scene/hit_search.h"
#include "scene/polynomial.h"

static const struct field revolution_fields[] = {
    { "segments", FIELD_TERMS, offsetof(struct revolution, segments), 0, 0,
      "the curve", false },
    { .name = NULL },
};

static const struct field revolution_items[] = {
    { "sturm", FIELD_BOOL, offsetof(struct revolution, sturm), 0, 0,
      "accepted and needless", false },
    { .name = NULL },
};

/* Inside is what has an odd number of curves farther from the axis. */
const char *revolution_prepare(void *shape, struct arena *arena,
                               const char **warning)
{
    struct revolution *r = shape;
    r->outline =
        outline_of_numbers(arena, r->segments.values, r->segments.count);
    if (r->outline.count == 0)
        *warning = "its curve has no length";
    return NULL;
}

static double revolution_radius(const struct revolution *r)
{
    return fmax(fabs(r->outline.low[0]), fabs(r->outline.high[0]));
}

static struct box3 revolution_bounds(const void *shape)
{
    const struct revolution *r = shape;
    double radius = revolution_radius(r);
    return (struct box3){ { -radius, r->outline.low[1], -radius },
                          { radius, r->outline.high[1], radius } };
}

static bool revolution_inside(const void *shape, vec3 point)
{
    const struct revolution *r = shape;
    return outline_covers(&r->outline, hypot(point.x, point.z), point.y);
}

/* What of the ray the curves need: x^2 + z^2 = a t^2 + 2 b t + c. */
struct spin {
    const struct ray *ray;
    double a, b, c;
    struct hit_search hits;
};

static void spin_add(struct spin *spin, int part, double s, double t)
{
    hit_search_take(&spin->hits, (struct hit){ t, part, s, 0 });
}

/* The ray is level: it meets the curve where that has its height, twice. */
static void spin_level(struct spin *spin, const struct piece *piece, int part)
{
    const double *y = piece->curve.y;
    double c[4] = { y[0] - spin->ray->origin.y, y[1], y[2], y[3] };
    double roots[3], at[2], t[2];
    int count = polynomial_roots(c, 3, 0, 1, roots, 3);
    for (int i = 0; i < count; i++) {
        segment_point(&piece->curve, roots[i], at);
        int found =
            quadratic_roots(spin->a, spin->b, spin->c - at[0] * at[0], t);
        for (int k = 0; k < found; k++)
            spin_add(spin, part, roots[i], t[k]);
    }
}

static void multiply(const double a[4], const double b[4], double scale,
                     double sum[7])
{
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 4; k++)
            sum[i + k] += scale * a[i] * b[k];
}

/* The slope of a ray below which its height says little of where it is. */
static const double spin_flat = 1e-4;

/* Of two t at which the ray is as far from the axis as the curve, the one at
 * which it is as high, too. Near level rays the height alone says little. */
static double spin_place(const struct spin *spin, double radius, double t)
{
    double roots[2];
    int count =
        quadratic_roots(spin->a, spin->b, spin->c - radius * radius, roots);
    double slope = spin->ray->direction.y;
    if (count == 0 || slope * slope > spin_flat * spin->a)
        return t;
    return count == 1 || fabs(roots[0] - t) < fabs(roots[1] - t) ? roots[0]
                                                                 : roots[1];
}

/* With h = y(s) - oy the ray is at this height at t = h / dy, and there as far
 * from the axis as the curve if c dy^2 + 2 b dy h + a h^2 - dy^2 x(s)^2 = 0. */
static void spin_piece(struct spin *spin, const struct piece *piece, int part)
{
    const struct segment *curve = &piece->curve;
    double dy = spin->ray->direction.y, dy2 = dy * dy;
    double h[4] = { curve->y[0] - spin->ray->origin.y, curve->y[1], curve->y[2],
                    curve->y[3] };
    double p[7] = { spin->c * dy2 }, roots[6], at[2];
    for (int i = 0; i < 4; i++)
        p[i] += 2 * spin->b * dy * h[i];
    multiply(h, h, spin->a, p);
    multiply(curve->x, curve->x, -dy2, p);
    int degree = 6;
    while (degree > 1 && p[degree] == 0)
        degree--;
    int count = polynomial_roots(p, degree, 0, 1, roots, 6);
    for (int i = 0; i < count; i++) {
        segment_point(curve, roots[i], at);
        double t = (at[1] - spin->ray->origin.y) / dy;
        spin_add(spin, part, roots[i], spin_place(spin, at[0], t));
    }
}

/* Whether the ray is nearer to the axis than the piece reaches while it is as
 * high as the piece, and where it is looked for. */
static bool spin_meets(const struct spin *spin, const struct piece *piece)
{
    double dy = spin->ray->direction.y, y = spin->ray->origin.y;
    double low = (piece->low[1] - y) / dy, high = (piece->high[1] - y) / dy;
    double enter = fmin(low, high), leave = fmax(low, high);
    double margin = 1e-9 * (fabs(enter) + fabs(leave));
    if (dy * dy > spin_flat * spin->a &&
        (leave + margin < spin->hits.tmin || enter - margin > spin->hits.tmax))
        return false;
    double t = -spin->b / spin->a;
    t = fmax(enter, fmin(t, leave));
    double radius = fmax(fabs(piece->low[0]), fabs(piece->high[0]));
    double nearest = (spin->a * t + 2 * spin->b) * t + spin->c;
    return !(nearest > radius * radius * (1 + 1e-9) + 1e-12);
}

static struct spin spin_new(const struct ray *ray, double tmin, double tmax)
{
    vec3 o = ray->origin, d = ray->direction;
    return (struct spin){
        .ray = ray,
        .a = d.x * d.x + d.z * d.z,
        .b = o.x * d.x + o.z * d.z,
        .c = o.x * o.x + o.z * o.z,
        .hits = { .tmin = tmin, .tmax = tmax },
    };
}

static void spin_all(struct spin *spin, const struct revolution *r)
{
    double dy = spin->ray->direction.y;
    bool level = dy * dy < 1e-16 * spin->a;
    for (size_t i = 0; i < r->outline.count; i++) {
        const struct piece *piece = &r->outline.pieces[i];
        if (level)
            spin_level(spin, piece, (int)i);
        else if (spin_meets(spin, piece))
            spin_piece(spin, piece, (int)i);
    }
}

static void revolution_intersect(const void *shape, const struct ray *ray,
                                 struct hits *hits)
{
    struct spin spin = spin_new(ray, -HUGE_VAL, HUGE_VAL);
    spin.hits.all = hits;
    spin_all(&spin, shape);
}

static bool revolution_first(const void *shape, const struct ray *ray,
                             double tmin, double tmax, struct hit *hit)
{
    struct spin spin = spin_new(ray, tmin, tmax);
    spin_all(&spin, shape);
    *hit = spin.hits.first;
    return spin.hits.found;
}

static bool revolution_crosses(const void *shape, const struct ray *ray,
                               double tmin, double tmax)
{
    struct hit hit;
    return revolution_first(shape, ray, tmin, tmax, &hit);
}

static vec3 revolution_normal(const void *shape, vec3 point,
                              const struct hit *hit)
{
    const struct revolution *r = shape;
    const struct piece *piece = &r->outline.pieces[hit->part];
    double along[2], radius = hypot(point.x, point.z);
    segment_tangent(&piece->curve, hit->u, along);
    double out = piece->outward * along[1];
    double up = -piece->outward * along[0];
    if (!(radius > 0))
        return (vec3){ 0, up, 0 };
    return (vec3){ out * point.x / radius, up, out * point.z / radius };
}

/* How far the curve is from a point at s, squared. */
static double segment_away(const struct segment *segment, double s,
                           const double p[2])
{
    double at[2];
    segment_point(segment, s, at);
    double x = at[0] - p[0], y = at[1] - p[1];
    return x * x + y * y;
}

/* The nearest place of a segment: of a few tried, and then between its
 * neighbours. */
static double segment_nearest(const struct segment *segment, const double p[2])
{
    enum { TRIES = 32, STEPS = 40 };
    double best = 0, least = segment_away(segment, 0, p);
    for (int i = 1; i <= TRIES; i++) {
        double s = (double)i / TRIES, away = segment_away(segment, s, p);
        if (away < least) {
            least = away;
            best = s;
        }
    }
    double low = fmax(0, best - 1.0 / TRIES),
           high = fmin(1, best + 1.0 / TRIES);
    for (int i = 0; i < STEPS; i++) {
        double third = (high - low) / 3;
        if (segment_away(segment, low + third, p) <
            segment_away(segment, high - third, p))
            high -= third;
        else
            low += third;
    }
    return (low + high) / 2;
}

/* Along the curve each segment is as long as the others (measured). */
static void revolution_uv(const void *shape, vec3 point, double uv[2])
{
    const struct revolution *r = shape;
    const struct segment *segments = (const struct segment *)r->segments.values;
    size_t count = r->segments.count / SEGMENT_NUMBERS;
    const double p[2] = { hypot(point.x, point.z), point.y };
    double least = (double)INFINITY;
    uv[0] = ray_turn(point.x, point.z);
    uv[1] = 0;
    for (size_t i = 0; i < count; i++) {
        double s = segment_nearest(&segments[i], p);
        double away = segment_away(&segments[i], s, p);
        if (away < least) {
            least = away;
            uv[1] = ((double)i + s) / (double)count;
        }
    }
}

const struct primitive lathe_primitive = {
    .name = "lathe",
    .help = "a curve turned around y",
    .size = sizeof(struct revolution),
    .arguments = revolution_fields,
    .items = revolution_items,
    .solid = true,
    .alike = true,
    .prepare = revolution_prepare,
    .bounds = revolution_bounds,
    .intersect = revolution_intersect,
    .crosses = revolution_crosses,
    .first = revolution_first,
    .normal = revolution_normal,
    .uv = revolution_uv,
    .inside = revolution_inside,
};
