/* plane { NORMAL, DISTANCE }: the half space dot(NORMAL, p) <= DISTANCE. */
#include "scene/primitive.h"

struct plane {
    vec3 normal;     /* unit */
    double distance; /* from the origin, along the normal */
};

static const struct field plane_arguments[] = {
    { "normal", FIELD_VECTOR, offsetof(struct plane, normal), 0, 0,
      "the direction that is outside; any length", false },
    { "distance", FIELD_FLOAT, offsetof(struct plane, distance), 0, 0,
      "how far from the origin along the normal", false },
    { .name = NULL },
};

static const char *plane_prepare(void *shape, struct arena *arena,
                                 const char **warning)
{
    struct plane *plane = shape;
    double length = vec3_length(plane->normal);
    (void)arena;
    (void)warning;
    if (!(length > 0) || !isfinite(length))
        return "its normal has no direction";
    plane->normal = vec3_scale(plane->normal, 1 / length);
    return NULL;
}

/* A half space is bounded on one side if its normal is along an axis. */
static struct box3 plane_bounds(const void *shape)
{
    const struct plane *plane = shape;
    struct box3 box = box3_infinite();
    vec3 n = plane->normal;
    double d = plane->distance;
    if (n.y == 0 && n.z == 0)
        *(n.x > 0 ? &box.high.x : &box.low.x) = n.x > 0 ? d : -d;
    if (n.x == 0 && n.z == 0)
        *(n.y > 0 ? &box.high.y : &box.low.y) = n.y > 0 ? d : -d;
    if (n.x == 0 && n.y == 0)
        *(n.z > 0 ? &box.high.z : &box.low.z) = n.z > 0 ? d : -d;
    return box;
}

static void plane_half_space(const void *shape, vec3 *normal, double *distance)
{
    const struct plane *plane = shape;
    *normal = plane->normal;
    *distance = plane->distance;
}

static bool plane_move(void *shape, const affine *outward, const affine *inward)
{
    struct plane *plane = shape;
    vec3 origin = { inward->m[0][3], inward->m[1][3], inward->m[2][3] };
    vec3 normal = affine_normal(inward, plane->normal);
    const double rounding = 1e-15;
    double length = vec3_length(normal);
    double distance = plane->distance - vec3_dot(plane->normal, origin);
    (void)outward;
    if (fabs(length - 1) < rounding)
        length = 1;
    plane->normal =
        vec3_make(normal.x / length, normal.y / length, normal.z / length);
    plane->distance = distance / length;
    return length > 0 && isfinite(length) && isfinite(plane->distance);
}

static void plane_intersect(const void *shape, const struct ray *ray,
                            struct hits *hits)
{
    const struct plane *plane = shape;
    double slope = vec3_dot(plane->normal, ray->direction);
    if (slope == 0)
        return;
    double height = vec3_dot(plane->normal, ray->origin) - plane->distance;
    hits_add(hits, -height / slope, 0);
}

/* Of a ray along the plane it is no number, or infinite. */
static inline double plane_distance(const struct plane *plane, vec3 origin,
                                    vec3 direction)
{
    double height = vec3_dot(plane->normal, origin) - plane->distance;
    return -height / vec3_dot(plane->normal, direction);
}

static bool plane_first(const void *shape, const struct ray *ray, double tmin,
                        double tmax, struct hit *hit)
{
    double t = plane_distance(shape, ray->origin, ray->direction);
    *hit = (struct hit){ t, 0, 0, 0 };
    return t > tmin && t < tmax;
}

static bool plane_crosses(const void *shape, const struct ray *ray, double tmin,
                          double tmax)
{
    struct hit hit;
    return plane_first(shape, ray, tmin, tmax, &hit);
}

CLONES static void plane_crosses_many(const void *shape, struct lane_run run,
                                      const struct rays *restrict rays,
                                      const struct rays_span *restrict span,
                                      lane_flag *restrict met)
{
    const struct plane plane = *(const struct plane *)shape;
    EACH_LANE(i, run) {
        double t = plane_distance(&plane, rays_origin(rays, i),
                                  rays_direction(rays, i));
        met[i] = ((t > span->near[i]) & (t < span->far[i])) ? -1 : 0;
    }
}

CLONES static void plane_first_many(const void *shape, struct lane_run run,
                                    const struct rays *restrict rays,
                                    const struct rays_span *restrict span,
                                    struct rays_met *restrict met)
{
    const struct plane plane = *(const struct plane *)shape;
    EACH_LANE(i, run) {
        double t = plane_distance(&plane, rays_origin(rays, i),
                                  rays_direction(rays, i));
        bool is = (t > span->near[i]) & (t < span->far[i]);
        met->t[i] = is ? t : (double)INFINITY;
        met->part[i] = 0;
    }
}

CLONES static void plane_all_many(const void *shape, struct lane_run run,
                                  const struct rays *restrict rays,
                                  struct rays_crossings *restrict all)
{
    const struct plane plane = *(const struct plane *)shape;
    all->count = 1;
    EACH_LANE(i, run) {
        vec3 d = rays_direction(rays, i);
        double t = plane_distance(&plane, rays_origin(rays, i), d);
        bool along = vec3_dot(plane.normal, d) == 0;
        all->t[0][i] = along ? (double)INFINITY : t;
        all->part[0][i] = 0;
    }
}

static vec3 plane_normal(const void *shape, const vec3 *at,
                         const struct hit *hit)
{
    const struct plane *plane = shape;
    (void)at;
    (void)hit;
    return plane->normal;
}

static inline bool plane_holds(const struct plane *plane, vec3 point)
{
    return vec3_dot(plane->normal, point) - plane->distance <= 0;
}

static bool plane_inside(const void *shape, vec3 point)
{
    return plane_holds(shape, point);
}

CLONES static void plane_inside_many(const void *shape, struct lane_run run,
                                     const struct lane_points *restrict points,
                                     lane_flag *restrict inside)
{
    const struct plane plane = *(const struct plane *)shape;
    EACH_LANE(i, run)
        inside[i] = plane_holds(&plane, lane_get(points->at, i)) ? -1 : 0;
}

static unsigned plane_meets(const void *shape, const struct cell *cell)
{
    const struct plane *plane = shape;
    double height = vec3_dot(plane->normal, cell->centre) - plane->distance;
    bool apart = fabs(height) > cell_reach(cell, plane->normal);
    return apart ? 0 : CELL_SURFACE | CELL_BORDER;
}

const struct primitive plane_primitive = {
    .name = "plane",
    .help = "an infinite plane; inside is the side its normal points from",
    .size = sizeof(struct plane),
    .arguments = plane_arguments,
    .solid = true,
    .convex = true,
    .prepare = plane_prepare,
    .bounds = plane_bounds,
    .half_space = plane_half_space,
    .move = plane_move,
    .intersect = plane_intersect,
    .crosses = plane_crosses,
    .first = plane_first,
    .crosses_many = plane_crosses_many,
    .first_many = plane_first_many,
    .all_many = plane_all_many,
    .normal = plane_normal,
    .inside = plane_inside,
    .inside_many = plane_inside_many,
    .meets = plane_meets,
};
