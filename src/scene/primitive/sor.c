/* sor { N, <RADIUS, HEIGHT> ... }: a curve turned around the y axis, its
 * squared radius being a cubic of the height between each two points. A ray
 * meets it where a cubic along the ray has a root. */
#include "scene/polynomial.h"
#include "scene/primitive.h"

struct sor {
    struct points points; /* radius and height; the first and the last only
                           * give directions */
    bool open;            /* without lids */
    bool sturm;
    double (*squares)[4]; /* for each two points: of 1, y - its height, ... */
    double radius;        /* the largest, or more */
};

static const struct field sor_arguments[] = {
    { "points", FIELD_POINTS2, offsetof(struct sor, points), 0, 0,
      "how many points, then each one's radius and height, from below", false },
    { .name = NULL },
};

static const struct field sor_items[] = {
    { "open", FIELD_FLAG, offsetof(struct sor, open), 0, 0, "without lids",
      false },
    { "sturm", FIELD_BOOL, offsetof(struct sor, sturm), 0, 0,
      "accepted and needless", false },
    { .name = NULL },
};

static size_t sor_pieces(const struct sor *sor)
{
    return sor->points.count - 3;
}

/* The squared radius's slope at a point, from those of its neighbours. */
static double sor_slope(const vec3 *p)
{
    return 2 * p[0].x * (p[1].x - p[-1].x) / (p[1].y - p[-1].y);
}

static double sor_square(const double c[4], double h)
{
    return c[0] + h * (c[1] + h * (c[2] + h * c[3]));
}

static double sor_steep(const double c[4], double h)
{
    return c[1] + h * (2 * c[2] + h * 3 * c[3]);
}

/* The largest value of a cubic from 0 to h: at an end, or where its slope is
 * 0; and a little more, for rounding. */
static double sor_most(const double c[4], double h)
{
    double at[4] = { 0, h };
    double a = 3 * c[3], b = c[2], square = b * b - a * c[1], most = 0;
    int count = 2;
    if (square >= 0) {
        double q = -b - copysign(sqrt(square), b);
        at[count++] = q / a;
        at[count++] = c[1] / q;
    }
    for (int i = 0; i < count; i++) {
        if (isfinite(at[i]))
            most = fmax(most, sor_square(c, fmin(fmax(at[i], 0), h)));
    }
    return most * (1 + 1e-9);
}

static void sor_piece(struct sor *sor, size_t i)
{
    const vec3 *a = &sor->points.items[i + 1], *b = a + 1;
    double *c = sor->squares[i], h = b->y - a->y;
    double from = a->x * a->x, to = b->x * b->x;
    double rise = (to - from) / h, first = sor_slope(a), last = sor_slope(b);
    c[0] = from;
    c[1] = first;
    c[2] = (3 * rise - 2 * first - last) / h;
    c[3] = (first + last - 2 * rise) / (h * h);
    sor->radius = fmax(sor->radius, sqrt(sor_most(c, h)));
}

static const char *sor_prepare(void *shape, struct arena *arena,
                               const char **warning)
{
    struct sor *sor = shape;
    const vec3 *p = sor->points.items;
    (void)warning;
    if (sor->points.count < 4)
        return "it needs 4 points at least";
    for (size_t i = 1; i + 2 < sor->points.count; i++)
        if (!(p[i].y < p[i + 1].y))
            return "each point must be higher than the one before";
    for (size_t i = 0; i < sor->points.count; i++)
        if (i + 2 < sor->points.count && p[i].y == p[i + 2].y)
            return "a point is as high as the one after the next";
    sor->squares = arena_alloc(arena, sor_pieces(sor) * sizeof *sor->squares);
    for (size_t i = 0; i < sor_pieces(sor); i++)
        sor_piece(sor, i);
    return NULL;
}

static double sor_low(const struct sor *sor)
{
    return sor->points.items[1].y;
}

static double sor_high(const struct sor *sor)
{
    return sor->points.items[sor->points.count - 2].y;
}

static struct box3 sor_bounds(const void *shape)
{
    const struct sor *sor = shape;
    double r = sor->radius;
    return (struct box3){ { -r, sor_low(sor), -r }, { r, sor_high(sor), r } };
}

/* The part of the ray in the cylinder around it all. */
static bool sor_clip(const struct sor *sor, const struct ray *ray, double *from,
                     double *to)
{
    vec3 o = ray->origin, d = ray->direction;
    double roots[2], a = d.x * d.x + d.z * d.z;
    double c = o.x * o.x + o.z * o.z - sor->radius * sor->radius;
    if (a == 0)
        return c <= 0;
    if (quadratic_roots(a, o.x * d.x + o.z * d.z, c, roots) != 2)
        return false;
    *from = fmax(*from, roots[0]);
    *to = fmin(*to, roots[1]);
    return *from < *to;
}

/* x^2 + z^2 - square(y) along a part of the ray, which is within the heights of
 * the piece: in Bernstein form by its values and slopes at both ends. */
static void sor_cross(const struct sor *sor, size_t i, const struct ray *ray,
                      double from, double to, struct hits *hits)
{
    double low = sor->points.items[i + 1].y;
    const double *c = sor->squares[i];
    vec3 d = ray->direction;
    vec3 p = ray_point(ray, from), q = ray_point(ray, to);
    double h = p.y - low, k = q.y - low, third = (to - from) / 3;
    double first = p.x * p.x + p.z * p.z - sor_square(c, h);
    double last = q.x * q.x + q.z * q.z - sor_square(c, k);
    double rise = 2 * (p.x * d.x + p.z * d.z) - d.y * sor_steep(c, h);
    double fall = 2 * (q.x * d.x + q.z * d.z) - d.y * sor_steep(c, k);
    double b[4] = { first, first + third * rise, last - third * fall, last };
    int below = (b[0] < 0) + (b[1] < 0) + (b[2] < 0) + (b[3] < 0);
    if (below == 0 || below == 4)
        return;
    double roots[2 * BERNSTEIN_DEGREE];
    int count = polynomial_bernstein_roots(b, 3, roots);
    for (int n = 0; n < count; n++)
        hits_add(hits, from + (to - from) * roots[n], (int)i);
}

/* The pieces, from each one's lower end to the next one's. */
static void sor_climb(const struct sor *sor, const struct ray *ray, double from,
                      double to, struct hits *hits)
{
    const vec3 *p = sor->points.items + 1;
    double y = ray->origin.y, rate = ray->direction.y;
    double below = (p[0].y - y) / rate;
    for (size_t i = 0; i < sor_pieces(sor); i++) {
        double above = (p[i + 1].y - y) / rate;
        double near = rate > 0 ? below : above;
        double far = rate > 0 ? above : below;
        near = near > from ? near : from;
        far = far < to ? far : to;
        below = above;
        if (near < far)
            sor_cross(sor, i, ray, near, far, hits);
    }
}

/* The piece that a level ray is in. */
static void sor_level(const struct sor *sor, const struct ray *ray, double from,
                      double to, struct hits *hits)
{
    const vec3 *p = sor->points.items + 1;
    double y = ray->origin.y;
    for (size_t i = 0; i < sor_pieces(sor) && from < to; i++)
        if (y >= p[i].y && y < p[i + 1].y)
            sor_cross(sor, i, ray, from, to, hits);
}

/* Parts after the pieces are the lids. */
static void sor_lid(const struct sor *sor, int lid, const struct ray *ray,
                    struct hits *hits)
{
    const vec3 *p = sor->points.items;
    vec3 edge = lid ? p[sor->points.count - 2] : p[1];
    double t = (edge.y - ray->origin.y) / ray->direction.y;
    vec3 at = ray_point(ray, t);
    if (ray->direction.y != 0 && at.x * at.x + at.z * at.z < edge.x * edge.x)
        hits_add(hits, t, (int)sor_pieces(sor) + lid);
}

/* With the lids' beyond tmin and tmax. */
static void sor_meet(const struct sor *sor, const struct ray *ray, double tmin,
                     double tmax, struct hits *hits)
{
    if (!sor_clip(sor, ray, &tmin, &tmax))
        return;
    if (ray->direction.y != 0)
        sor_climb(sor, ray, tmin, tmax, hits);
    else
        sor_level(sor, ray, tmin, tmax, hits);
    for (int lid = 0; lid < 2 && !sor->open; lid++)
        sor_lid(sor, lid, ray, hits);
}

static void sor_intersect(const void *shape, const struct ray *ray,
                          struct hits *hits)
{
    sor_meet(shape, ray, -HUGE_VAL, HUGE_VAL, hits);
}

static bool sor_first(const void *shape, const struct ray *ray, double tmin,
                      double tmax, struct hit *hit)
{
    struct hits hits = { .count = 0 };
    sor_meet(shape, ray, tmin, tmax, &hits);
    return hits_first(&hits, tmin, tmax, hit);
}

static bool sor_crosses(const void *shape, const struct ray *ray, double tmin,
                        double tmax)
{
    struct hit hit;
    return sor_first(shape, ray, tmin, tmax, &hit);
}

static vec3 sor_normal(const void *shape, const vec3 *at, const struct hit *hit)
{
    const vec3 point = *at;
    const struct sor *sor = shape;
    int lid = hit->part - (int)sor_pieces(sor);
    if (lid >= 0)
        return vec3_make(0, lid ? 1 : -1, 0);
    const double *c = sor->squares[hit->part];
    double h = point.y - sor->points.items[hit->part + 1].y;
    vec3 normal = { 2 * point.x, -sor_steep(c, h), 2 * point.z };
    return vec3_length(normal) > 0 ? normal : vec3_make(0, 1, 0);
}

static bool sor_inside(const void *shape, vec3 point)
{
    const struct sor *sor = shape;
    const vec3 *p = sor->points.items;
    if (!(point.y >= sor_low(sor) && point.y < sor_high(sor)))
        return false;
    size_t i = 0;
    while (point.y >= p[i + 2].y)
        i++;
    return point.x * point.x + point.z * point.z <
           sor_square(sor->squares[i], point.y - p[i + 1].y);
}

/* Up the sides by pieces, each as high as the others; beyond them the lids,
 * from their middles (measured). */
static void sor_uv(const void *shape, vec3 point, double uv[2])
{
    const struct sor *sor = shape;
    const vec3 *p = sor->points.items + 1;
    size_t count = sor_pieces(sor), i = 0;
    double low = p[0].y, high = p[count].y, radius = hypot(point.x, point.z);
    double near = 1e-6 * (high - low);
    uv[0] = ray_turn(point.x, point.z);
    while (i + 1 < count && point.y > p[i + 1].y)
        i++;
    uv[1] = ((double)i + (point.y - p[i].y) / (p[i + 1].y - p[i].y)) /
            (double)count;
    if (!sor->open && point.y > high - near && p[count].x > 0 &&
        radius < p[count].x * (1 - 1e-9))
        uv[1] = 2 - radius / p[count].x;
    if (!sor->open && point.y < low + near && p[0].x > 0 &&
        radius < p[0].x * (1 - 1e-9))
        uv[1] = radius / p[0].x - 1;
}

const struct primitive sor_primitive = {
    .name = "sor",
    .help = "a curve turned around the y axis, through points by height",
    .size = sizeof(struct sor),
    .arguments = sor_arguments,
    .items = sor_items,
    .solid = true,
    .alike = true,
    .prepare = sor_prepare,
    .bounds = sor_bounds,
    .intersect = sor_intersect,
    .first = sor_first,
    .crosses = sor_crosses,
    .normal = sor_normal,
    .uv = sor_uv,
    .inside = sor_inside,
};
