/* torus { MAJOR, MINOR }, around the y axis. */
#include "scene/crossings.h"
#include "scene/line_roots.h"
#include "scene/primitive.h"
#include "scene/quartic_rays.h"

struct torus {
    double major, minor;
    bool sturm;
    bool unseen; /* of a negative minor radius: inside stays (measured) */
};

static const struct field torus_arguments[] = {
    { "major radius", FIELD_FLOAT, offsetof(struct torus, major), 0, 0,
      "from the middle of the hole to the middle of the tube", false },
    { "minor radius", FIELD_FLOAT, offsetof(struct torus, minor), 0, 0,
      "of the tube", false },
    { .name = NULL },
};

static const struct field torus_items[] = {
    { "sturm", FIELD_BOOL, offsetof(struct torus, sturm), 0, 0,
      "accepted: the roots are exact anyway", false },
    { .name = NULL },
};

static const char *torus_prepare(void *shape, struct arena *arena,
                                 const char **warning)
{
    struct torus *torus = shape;
    (void)arena;
    (void)warning;
    torus->unseen = torus->minor < 0;
    torus->minor = fabs(torus->minor);
    return NULL;
}

static struct box3 torus_bounds(const void *shape)
{
    const struct torus *torus = shape;
    double reach = torus->major + torus->minor, r = torus->minor;
    if (reach < 0)
        return box3_empty();
    return (struct box3){ { -reach, -r, -reach }, { reach, r, reach } };
}

/* (t^2 + k)^2 = 4 R^2 (distance from the axis)^2, where k = |o|^2 + R^2 - r^2
 * and the ray starts where it passes nearest the middle (then o.d = 0 and there
 * is no t^3). The constant term is a product so that it doesn't cancel. */
static inline void torus_quartic(const struct torus *torus, vec3 o, vec3 d,
                                 double *c)
{
    double R = torus->major, r = torus->minor;
    double rho = sqrt(o.x * o.x + o.z * o.z), out = rho - R, far = rho + R;
    double k = vec3_dot(o, o) + R * R - r * r;
    double y2 = o.y * o.y - r * r;
    c[0] = (out * out + y2) * (far * far + y2);
    c[1] = -8 * R * R * (o.x * d.x + o.z * d.z);
    c[2] = 2 * k - 4 * R * R * (d.x * d.x + d.z * d.z);
    c[3] = 0;
    c[4] = 1;
}

/* The part of the line within minor of the plane of the ring. */
static void torus_clip(const struct torus *torus, double y, double dy,
                       double *low, double *high)
{
    double r = torus->minor * (1 + 1e-9);
    if (fabs(dy) < 1e-9) {
        if (fabs(y) > r)
            *low = *high;
        return;
    }
    double a = (-r - y) / dy, b = (r - y) / dy;
    *low = fmax(*low, fmin(a, b));
    *high = fmin(*high, fmax(a, b));
}

/* Without a major radius all roots are double: it is a ball. */
static void torus_ball(const struct torus *torus, double nearest, double *roots)
{
    double half = sqrt(torus->minor * torus->minor - nearest);
    roots[0] = -half;
    roots[1] = half;
}

/* The part of the line that may meet the tube, false if there is none. */
static bool torus_part(const struct torus *torus, const struct ray *ray,
                       struct line *line, double *low, double *high)
{
    double reach = fabs(torus->major) + torus->minor;
    if (torus->unseen || !(torus->major + torus->minor > 0) ||
        !line_of(line, ray))
        return false;
    double nearest = vec3_dot(line->near, line->near);
    if (nearest >= reach * reach)
        return false;
    double limit = sqrt(reach * reach - nearest) * (1 + 1e-12);
    *low = -limit;
    *high = limit;
    torus_clip(torus, line->near.y, line->along.y, low, high);
    return *low < *high;
}

/* A negative major radius leaves the part where the tube overlaps itself. */
struct lens_visit {
    struct line_visit line; /* first */
    const struct torus *torus;
};

static bool lens_visit_root(void *context, double root)
{
    const struct lens_visit *visit = context;
    const struct torus *torus = visit->torus;
    const struct line *line = visit->line.line;
    vec3 p = vec3_along(line->near, line->along, root);
    return sqrt(p.x * p.x + p.z * p.z) <= torus->major + torus->minor &&
           line_visit_root(context, root);
}

static void torus_crossings(const void *shape, const struct ray *ray,
                            double tmin, double tmax, hit_visit *visit,
                            void *context)
{
    const struct torus *torus = shape;
    struct line line;
    double c[5], low, high, ends[2];
    if (!torus_part(torus, ray, &line, &low, &high))
        return;
    struct lens_visit found = { { &line, tmin, tmax, visit, context }, torus };
    if (torus->major == 0) {
        torus_ball(torus, vec3_dot(line.near, line.near), ends);
        if (!line_visit_root(&found, ends[0]))
            line_visit_root(&found, ends[1]);
        return;
    }
    torus_quartic(torus, line.near, line.along, c);
    const struct root_search search = { line_root(&line, tmin),
                                        torus->major < 0 ? lens_visit_root
                                                         : line_visit_root,
                                        &found };
    polynomial_visit(c, 4, low, high, &search);
}

static void torus_intersect(const void *shape, const struct ray *ray,
                            struct hits *hits)
{
    crossings_all(torus_crossings, shape, ray, hits);
}

static bool torus_first(const void *shape, const struct ray *ray, double tmin,
                        double tmax, struct hit *hit)
{
    return crossings_first(torus_crossings, shape, ray, tmin, tmax, hit);
}

static bool torus_crosses(const void *shape, const struct ray *ray, double tmin,
                          double tmax)
{
    const struct torus *torus = shape;
    struct line line;
    double c[5], low, high;
    struct hit hit;
    if (!(torus->major > 0))
        return torus_first(shape, ray, tmin, tmax, &hit);
    if (!torus_part(torus, ray, &line, &low, &high))
        return false;
    low = fmax(low, line_root(&line, tmin));
    high = fmin(high, line_root(&line, tmax));
    if (!(low < high))
        return false;
    torus_quartic(torus, line.near, line.along, c);
    return polynomial_crosses(c, 4, low, high);
}

/* As torus_part and torus_quartic. */
CLONES static void torus_restrict(const struct torus *shape,
                                  struct lane_run run,
                                  const struct rays *restrict rays,
                                  const struct rays_span *restrict span,
                                  struct quartic_rays *restrict out)
{
    const struct torus torus = *shape;
    double reach = fabs(torus.major) + torus.minor;
    double r = torus.minor * (1 + 1e-9);
    EACH_LANE(i, run) {
        vec3 d = rays_direction(rays, i), o = rays_origin(rays, i);
        double length = vec3_length(d), c[QUARTIC + 1];
        vec3 along = vec3_scale(d, 1 / length);
        double shift = -vec3_dot(o, along);
        vec3 near = vec3_along(o, along, shift);
        double rest = reach * reach - vec3_dot(near, near);
        double high = sqrt(rest) * (1 + 1e-12), low = -high;
        double a = (-r - near.y) / along.y, b = (r - near.y) / along.y;
        bool level = fabs(along.y) < 1e-9;
        double first = a < b ? a : b, last = a < b ? b : a;
        low = (!level & (first > low)) ? first : low;
        high = (!level & (last < high)) ? last : high;
        bool meets = (length > 0) & (rest > 0) & !(level & (fabs(near.y) > r));
        torus_quartic(&torus, near, along, c);
        for (int k = 0; k <= QUARTIC; k++)
            out->quartics.c[k][i] = c[k];
        out->quartics.low[i] = low;
        out->quartics.high[i] = meets ? high : -(double)INFINITY;
        out->length[i] = length;
        out->shift[i] = shift;
        out->least[i] = span->near[i] * length - shift;
        out->most[i] = span->far[i] * length - shift;
    }
}

/* Those of rays side by side; NULL: its major radius makes it none, or a part
 * of a tube. */
static struct quartic_rays *torus_lanes(const struct torus *torus,
                                        const struct quartic_asked *asked,
                                        struct quartic_rays *lanes)
{
    if (torus->unseen || !(torus->major > 0) ||
        !(torus->major + torus->minor > 0))
        return NULL;
    torus_restrict(torus, asked->run, asked->rays, asked->span, lanes);
    return lanes;
}

static void torus_first_many(const void *shape, struct lane_run run,
                             const struct rays *rays,
                             const struct rays_span *span, struct rays_met *met)
{
    const struct quartic_asked asked = { shape, torus_first, torus_crosses,
                                         run,   rays,        span };
    struct quartic_rays lanes;
    quartic_rays_first(torus_lanes(shape, &asked, &lanes), &asked, met);
}

static void torus_crosses_many(const void *shape, struct lane_run run,
                               const struct rays *rays,
                               const struct rays_span *span, lane_flag *met)
{
    const struct quartic_asked asked = { shape, torus_first, torus_crosses,
                                         run,   rays,        span };
    struct quartic_rays lanes;
    quartic_rays_cross(torus_lanes(shape, &asked, &lanes), &asked, met);
}

static vec3 torus_normal(const void *shape, const vec3 *at,
                         const struct hit *hit)
{
    const vec3 point = *at;
    const struct torus *torus = shape;
    double rho = sqrt(point.x * point.x + point.z * point.z);
    (void)hit;
    if (!(rho > 0))
        return vec3_make(0, point.y < 0 ? -1 : 1, 0);
    double k = 1 - torus->major / rho;
    return vec3_make(point.x * k, point.y, point.z * k);
}

static bool torus_inside(const void *shape, vec3 point)
{
    const struct torus *torus = shape;
    double rho = sqrt(point.x * point.x + point.z * point.z);
    double out = rho - torus->major;
    return out * out + point.y * point.y <= torus->minor * torus->minor;
}

/* The least and the largest |x| for x in centre -+ half. */
static struct range range_of_magnitude(double centre, double half)
{
    return (struct range){ fmax(0, fabs(centre) - half), fabs(centre) + half };
}

/* Whether a circle across the tube, so far off the axis, may be met by a cell
 * whose distances from the axis these are. Distances from the circle's middle
 * change no faster than the way gone, and in the box around the cell they are
 * those of a rectangle. */
static bool tube_meets(const struct torus *torus, const struct cell *cell,
                       double off, struct range rho)
{
    const vec3 c = cell->centre;
    const double r = torus->minor, middle = hypot(hypot(c.x, c.z) - off, c.y);
    struct range y = range_of_magnitude(c.y, cell->half.y);
    struct range out = range_of_magnitude((rho.low + rho.high) / 2 - off,
                                          (rho.high - rho.low) / 2);
    return fabs(middle - r) <= cell->radius && hypot(out.low, y.low) <= r &&
           hypot(out.high, y.high) >= r;
}

/* Where it is thicker than wide, the tube's other side is within. */
static unsigned torus_meets(const void *shape, const struct cell *cell)
{
    const struct torus *torus = shape;
    struct range x = range_of_magnitude(cell->centre.x, cell->half.x);
    struct range z = range_of_magnitude(cell->centre.z, cell->half.z);
    struct range rho = { hypot(x.low, z.low), hypot(x.high, z.high) };
    unsigned surface = torus->unseen ? 0 : CELL_SURFACE;
    return tube_meets(torus, cell, torus->major, rho) ||
                   (torus->minor > torus->major &&
                    tube_meets(torus, cell, -torus->major, rho))
               ? surface | CELL_BORDER
               : 0;
}

/* Measured: both turn the other way than a sphere's. */
static void torus_uv(const void *shape, vec3 point, double uv[2])
{
    const struct torus *torus = shape;
    double out = hypot(point.x, point.z) - torus->major;
    uv[0] = 0.5 - atan2(point.z, point.x) / (2 * M_PI);
    uv[1] = 0.5 + atan2(point.y, out) / (2 * M_PI);
}

const struct primitive torus_primitive = {
    .name = "torus",
    .help = "a ring around the y axis",
    .size = sizeof(struct torus),
    .arguments = torus_arguments,
    .items = torus_items,
    .solid = true,
    .prepare = torus_prepare,
    .bounds = torus_bounds,
    .intersect = torus_intersect,
    .crossings = torus_crossings,
    .crosses = torus_crosses,
    .first = torus_first,
    .crosses_many = torus_crosses_many,
    .first_many = torus_first_many,
    .normal = torus_normal,
    .uv = torus_uv,
    .inside = torus_inside,
    .meets = torus_meets,
};
