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

/* With the vector from the centre to the point where the ray passes nearest
 * nothing cancels, however far the ray comes from (Haines, Gunther and
 * Akenine-Moller, Ray Tracing Gems, 2019, chapter 7). */
static bool sphere_roots(const struct sphere *sphere, const struct ray *ray,
                         double t[2])
{
    vec3 o = vec3_sub(ray->origin, sphere->centre);
    double dd = vec3_dot(ray->direction, ray->direction);
    double b = -vec3_dot(o, ray->direction), inverse = 1 / dd;
    vec3 nearest = vec3_along(o, ray->direction, b * inverse);
    double r2 = sphere->radius * sphere->radius;
    double rest = r2 - vec3_dot(nearest, nearest);
    if (!(rest > 0) || !(dd > 0))
        return false;
    double q = b + copysign(sqrt(dd * rest), b);
    t[0] = q * inverse;
    t[1] = (vec3_dot(o, o) - r2) / q;
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

/* A negative radius turns the normal, as in POV-Ray. */
static vec3 sphere_normal(const void *shape, vec3 point, const struct hit *hit)
{
    const struct sphere *sphere = shape;
    (void)hit;
    vec3 normal = vec3_sub(point, sphere->centre);
    return sphere->radius < 0 ? vec3_negate(normal) : normal;
}

static bool sphere_inside(const void *shape, vec3 point)
{
    const struct sphere *sphere = shape;
    vec3 p = vec3_sub(point, sphere->centre);
    return vec3_dot(p, p) < sphere->radius * sphere->radius;
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
    .intersect = sphere_intersect,
    .crosses = sphere_crosses,
    .first = sphere_first,
    .normal = sphere_normal,
    .uv = sphere_uv,
    .inside = sphere_inside,
    .meets = sphere_meets,
    .patches = sphere_patches,
};
