/* sphere { CENTRE, RADIUS } */
#include "scene/primitive.h"

struct sphere {
    vec3 centre;
    double radius;
};

static const struct field sphere_arguments[] = {
    { "centre", FIELD_VECTOR, offsetof(struct sphere, centre), 0, 0,
      "the middle", false },
    { "radius", FIELD_FLOAT, offsetof(struct sphere, radius), 0, 0,
      "the radius", false },
    { .name = NULL },
};

static bool sphere_unseen(const void *shape)
{
    return ((const struct sphere *)shape)->radius < 0;
}

static struct box3 sphere_bounds(const void *shape)
{
    const struct sphere *sphere = shape;
    double r = fabs(sphere->radius);
    vec3 half = { r, r, r };
    return (struct box3){ vec3_sub(sphere->centre, half),
                          vec3_add(sphere->centre, half) };
}

static struct box3 sphere_ball(const void *shape, const affine *place)
{
    struct sphere moved = *(const struct sphere *)shape;
    moved.centre = affine_point(place, moved.centre);
    moved.radius *=
        vec3_length(vec3_make(place->m[0][0], place->m[1][0], place->m[2][0]));
    return sphere_bounds(&moved);
}

static bool sphere_move(void *shape, const affine *outward,
                        const affine *inward)
{
    struct sphere *sphere = shape;
    double scale = outward->m[0][0];
    (void)inward;
    if (!affine_is_along_axes(*outward) || outward->m[1][1] != scale ||
        outward->m[2][2] != scale)
        return false;
    sphere->centre = affine_point(outward, sphere->centre);
    sphere->radius *= scale;
    return true;
}

/* With the vector from the centre to the point where the ray passes nearest
 * nothing cancels, however far the ray comes from (Haines, Gunther and
 * Akenine-Moller, Ray Tracing Gems, 2019, chapter 7). A unit ray from not so
 * far away has POV-Ray's crossings to the last bit (measured): a pattern may
 * change its colour in the very surface, as `onion` does at a radius of 1. */
struct passing {
    double oo, dd, b, inverse; /* of the origin, from the centre */
    double rest;               /* of the radius's square, there, times dd */
    bool plain;
};

static inline struct passing sphere_passing(const struct sphere *sphere,
                                            vec3 origin, vec3 direction)
{
    const double rounding = 1e-15, far = 1e8;
    vec3 o = vec3_sub(sphere->centre, origin);
    double dd = vec3_dot(direction, direction);
    double b = vec3_dot(o, direction), inverse = 1 / dd;
    vec3 nearest = vec3_along(o, direction, -b * inverse);
    double r2 = sphere->radius * sphere->radius, oo = vec3_dot(o, o);
    bool plain = (fabs(dd - 1) < rounding) & (oo < far * r2);
    double rest = dd * (r2 - vec3_dot(nearest, nearest));
    oo -= r2;
    return (struct passing){ oo,   dd, b, inverse, plain ? b * b - oo : rest,
                             plain };
}

static inline void passing_roots(const struct passing *passing, double t[2])
{
    double b = passing->b, root = sqrt(passing->rest);
    double q = b + copysign(root, b);
    t[0] = passing->plain ? b - root : q * passing->inverse;
    t[1] = passing->plain ? b + root : passing->oo / q;
}

static bool sphere_roots(const struct sphere *sphere, const struct ray *ray,
                         double t[2])
{
    struct passing passing =
        sphere_passing(sphere, ray->origin, ray->direction);
    if (!(passing.rest > 0) || !(passing.dd > 0))
        return false;
    passing_roots(&passing, t);
    return true;
}

static void sphere_intersect(const void *shape, const struct ray *ray,
                             struct hits *hits)
{
    double t[2];
    if (!sphere_roots(shape, ray, t))
        return;
    hits_add(hits, t[0], 0);
    hits_add(hits, t[1], 0);
}

static bool sphere_crosses(const void *shape, const struct ray *ray,
                           double tmin, double tmax)
{
    double t[2];
    return sphere_roots(shape, ray, t) &&
           ((t[0] > tmin && t[0] < tmax) || (t[1] > tmin && t[1] < tmax));
}

static bool sphere_first(const void *shape, const struct ray *ray, double tmin,
                         double tmax, struct hit *hit)
{
    double t[2];
    if (!sphere_roots(shape, ray, t))
        return false;
    double near = t[0] < t[1] ? t[0] : t[1], far = t[0] < t[1] ? t[1] : t[0];
    *hit = (struct hit){ near > tmin ? near : far, 0, 0, 0 };
    return hit->t > tmin && hit->t < tmax;
}

CLONES static void sphere_crosses_many(const void *shape, struct lane_run run,
                                       const struct rays *restrict rays,
                                       const struct rays_span *restrict span,
                                       lane_flag *restrict met)
{
    const struct sphere sphere = *(const struct sphere *)shape;
    EACH_LANE(i, run) {
        struct passing passing = sphere_passing(&sphere, rays_origin(rays, i),
                                                rays_direction(rays, i));
        double near = span->near[i], far = span->far[i], t[2];
        passing_roots(&passing, t);
        bool either =
            ((t[0] > near) & (t[0] < far)) | ((t[1] > near) & (t[1] < far));
        met[i] = ((passing.rest > 0) & (passing.dd > 0) & either) ? -1 : 0;
    }
}

CLONES static void sphere_first_many(const void *shape, struct lane_run run,
                                     const struct rays *restrict rays,
                                     const struct rays_span *restrict span,
                                     struct rays_met *restrict met)
{
    const struct sphere sphere = *(const struct sphere *)shape;
    EACH_LANE(i, run) {
        struct passing passing = sphere_passing(&sphere, rays_origin(rays, i),
                                                rays_direction(rays, i));
        double near = span->near[i], far = span->far[i], t[2];
        passing_roots(&passing, t);
        double least = t[0] < t[1] ? t[0] : t[1];
        double most = t[0] < t[1] ? t[1] : t[0];
        double first = least > near ? least : most;
        bool is = (passing.rest > 0) & (passing.dd > 0) & (first > near) &
                  (first < far);
        met->t[i] = is ? first : (double)INFINITY;
        met->part[i] = 0;
    }
}

CLONES static void sphere_all_many(const void *shape, struct lane_run run,
                                   const struct rays *restrict rays,
                                   struct rays_crossings *restrict all)
{
    const struct sphere sphere = *(const struct sphere *)shape;
    all->count = 2;
    EACH_LANE(i, run) {
        struct passing passing = sphere_passing(&sphere, rays_origin(rays, i),
                                                rays_direction(rays, i));
        double t[2];
        passing_roots(&passing, t);
        bool is = (passing.rest > 0) & (passing.dd > 0);
        all->t[0][i] = is ? t[0] : (double)INFINITY;
        all->t[1][i] = is ? t[1] : (double)INFINITY;
        all->part[0][i] = all->part[1][i] = 0;
    }
}

/* A negative radius turns the normal, as in POV-Ray. */
static vec3 sphere_normal(const void *shape, const vec3 *at,
                          const struct hit *hit)
{
    const vec3 point = *at;
    const struct sphere *sphere = shape;
    (void)hit;
    vec3 normal = vec3_sub(point, sphere->centre);
    return sphere->radius < 0 ? vec3_negate(normal) : normal;
}

static inline bool sphere_holds(const struct sphere *sphere, vec3 point)
{
    vec3 p = vec3_sub(point, sphere->centre);
    return vec3_dot(p, p) < sphere->radius * sphere->radius;
}

static bool sphere_inside(const void *shape, vec3 point)
{
    return sphere_holds(shape, point);
}

CLONES static void sphere_inside_many(const void *shape, struct lane_run run,
                                      const struct lane_points *restrict points,
                                      lane_flag *restrict inside)
{
    const struct sphere sphere = *(const struct sphere *)shape;
    EACH_LANE(i, run)
        inside[i] = sphere_holds(&sphere, lane_get(points->at, i)) ? -1 : 0;
}

static unsigned sphere_meets(const void *shape, const struct cell *cell)
{
    const struct sphere *sphere = shape;
    double radius = fabs(sphere->radius);
    bool apart = cell_nearest(cell, sphere->centre) > radius ||
                 cell_farthest(cell, sphere->centre) < radius;
    return apart ? 0 : CELL_SURFACE | CELL_BORDER;
}

static int sphere_patches(const void *shape, struct patch *patches)
{
    const struct sphere *sphere = shape;
    patches[0] = (struct patch){ .kind = PATCH_BALL,
                                 .at = sphere->centre,
                                 .radius = fabs(sphere->radius) };
    return 1;
}

static void sphere_uv(const void *shape, vec3 point, double uv[2])
{
    const struct sphere *sphere = shape;
    vec3 p = vec3_normalise(vec3_sub(point, sphere->centre));
    uv[0] = ray_turn(p.x, p.z);
    uv[1] = 0.5 + asin(fmax(-1, fmin(p.y, 1))) / M_PI;
}

const struct primitive sphere_primitive = {
    .name = "sphere",
    .help = "a ball",
    .size = sizeof(struct sphere),
    .arguments = sphere_arguments,
    .solid = true,
    .convex = true,
    .unseen = sphere_unseen,
    .bounds = sphere_bounds,
    .ball = sphere_ball,
    .move = sphere_move,
    .intersect = sphere_intersect,
    .crosses = sphere_crosses,
    .first = sphere_first,
    .crosses_many = sphere_crosses_many,
    .first_many = sphere_first_many,
    .all_many = sphere_all_many,
    .normal = sphere_normal,
    .uv = sphere_uv,
    .inside = sphere_inside,
    .inside_many = sphere_inside_many,
    .meets = sphere_meets,
    .patches = sphere_patches,
};
