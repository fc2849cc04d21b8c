/* polygon { COUNT, POINT, POINT ... }: flat, with any number of outlines, each
 * closed by repeating its first point. What an odd number of outlines surround
 * is filled. */
#include "base/array.h"
#include "scene/primitive.h"

struct edge {
    double u0, v0, u1, v1;
};

struct polygon {
    struct points points;
    vec3 normal; /* unit */
    double distance;
    int u_axis, v_axis; /* the plane is seen along the third axis */
    struct edge *edges;
    size_t edge_count;
    struct box3 bounds;
    bool open; /* its last outline, as the scene has it */
};

static const struct field polygon_arguments[] = {
    { "points", FIELD_POINTS, offsetof(struct polygon, points), 0, 0,
      "how many points, then the points", false },
    { .name = NULL },
};

/* The normal from the point farthest from the first one and the point
 * farthest from the line through both, towards the side from which the outline
 * runs as POV-Ray's does: false if there is no area. */
static bool polygon_find_plane(struct polygon *polygon)
{
    vec3 first = polygon->points.items[0], along = { 0, 0, 0 };
    vec3 normal = { 0, 0, 0 };
    for (size_t i = 1; i < polygon->points.count; i++) {
        vec3 d = vec3_sub(polygon->points.items[i], first);
        if (vec3_dot(d, d) > vec3_dot(along, along))
            along = d;
    }
    for (size_t i = 1; i < polygon->points.count; i++) {
        vec3 d = vec3_sub(polygon->points.items[i], first);
        vec3 n = vec3_cross(along, d);
        if (vec3_dot(n, n) > vec3_dot(normal, normal))
            normal = n;
    }
    if (!(vec3_dot(normal, normal) > 0))
        return false;
    vec3 area = { 0, 0, 0 };
    for (size_t i = 2; i < polygon->points.count; i++)
        area = vec3_add(
            area, vec3_cross(vec3_sub(polygon->points.items[i - 1], first),
                             vec3_sub(polygon->points.items[i], first)));
    if (vec3_dot(area, normal) < 0)
        normal = vec3_negate(normal);
    polygon->normal = vec3_normalise(normal);
    polygon->distance = vec3_dot(polygon->normal, first);
    return true;
}

static bool polygon_is_flat(const struct polygon *polygon)
{
    double size =
        vec3_length(vec3_sub(polygon->bounds.high, polygon->bounds.low));
    for (size_t i = 0; i < polygon->points.count; i++) {
        double height = vec3_dot(polygon->normal, polygon->points.items[i]);
        if (!(fabs(height - polygon->distance) <= 1e-9 * size + 1e-10))
            return false;
    }
    return true;
}

/* Onto the coordinate plane in which the polygon looks largest. */
static void polygon_project(struct polygon *polygon)
{
    vec3 n = { fabs(polygon->normal.x), fabs(polygon->normal.y),
               fabs(polygon->normal.z) };
    int drop = n.x > n.y && n.x > n.z ? 0 : n.y > n.z ? 1 : 2;
    polygon->u_axis = (drop + 1) % 3;
    polygon->v_axis = (drop + 2) % 3;
}

static void polygon_add_edge(struct polygon *polygon, vec3 a, vec3 b)
{
    int u = polygon->u_axis, v = polygon->v_axis;
    polygon->edges[polygon->edge_count++] =
        (struct edge){ vec3_component(a, u), vec3_component(a, v),
                       vec3_component(b, u), vec3_component(b, v) };
}

/* An outline that the scene leaves open is closed, as POV-Ray does. */
static void polygon_make_edges(struct polygon *polygon, struct arena *arena)
{
    const vec3 *p = polygon->points.items;
    size_t count = polygon->points.count, start = 0;
    polygon->edges = ARENA_ARRAY(arena, struct edge, count + 1);
    for (size_t i = 1; i < count; i++) {
        polygon_add_edge(polygon, p[i - 1], p[i]);
        if (!vec3_same(p[i], p[start]))
            continue;
        start = ++i; /* the next outline begins after the closing point */
    }
    polygon->open = start + 1 < count;
    if (start < count)
        polygon_add_edge(polygon, p[count - 1], p[start]);
}

static const char *polygon_prepare(void *shape, struct arena *arena,
                                   const char **warning)
{
    struct polygon *polygon = shape;
    if (polygon->points.count < 3)
        return "it needs at least three points";
    polygon->bounds = box3_empty();
    for (size_t i = 0; i < polygon->points.count; i++)
        polygon->bounds = box3_add(polygon->bounds, polygon->points.items[i]);
    if (!polygon_find_plane(polygon)) {
        *warning = "its points are on one line";
        return NULL;
    }
    if (!polygon_is_flat(polygon)) {
        *warning = "its points are not in one plane";
        return NULL;
    }
    polygon_project(polygon);
    polygon_make_edges(polygon, arena);
    return NULL;
}

static const char *polygon_remark(const void *shape)
{
    const struct polygon *polygon = shape;
    return polygon->open ? "its last point is not its first; a line to that "
                           "closes it"
                         : NULL;
}

static struct box3 polygon_bounds(const void *shape)
{
    const struct polygon *polygon = shape;
    return polygon->bounds;
}

static void thicken(double *low, double *high)
{
    const double least = 0.001;
    if (*high - *low < least) {
        *low -= least;
        *high += least;
    }
}

/* Around its corners, and thicker where that is flat (measured). */
static struct box3 polygon_told(const void *shape, const affine *place)
{
    const struct polygon *polygon = shape;
    struct box3 box = box3_empty();
    for (size_t i = 0; i < polygon->points.count; i++)
        box = box3_add(box, affine_point(place, polygon->points.items[i]));
    thicken(&box.low.x, &box.high.x);
    thicken(&box.low.y, &box.high.y);
    thicken(&box.low.z, &box.high.z);
    return box;
}

/* Edges crossed by the line from (u, v) to the right, ends counted once. */
static bool polygon_covers(const struct polygon *polygon, double u, double v)
{
    bool odd = false;
    for (size_t i = 0; i < polygon->edge_count; i++) {
        const struct edge *e = &polygon->edges[i];
        if ((e->v0 > v) == (e->v1 > v))
            continue;
        if (u < e->u0 + (v - e->v0) * (e->u1 - e->u0) / (e->v1 - e->v0))
            odd = !odd;
    }
    return odd;
}

static void polygon_intersect(const void *shape, const struct ray *ray,
                              struct hits *hits)
{
    const struct polygon *polygon = shape;
    double slope = vec3_dot(polygon->normal, ray->direction);
    if (slope == 0)
        return;
    double height = vec3_dot(polygon->normal, ray->origin);
    double t = (polygon->distance - height) / slope;
    vec3 p = ray_point(ray, t);
    if (polygon_covers(polygon, vec3_component(p, polygon->u_axis),
                       vec3_component(p, polygon->v_axis)))
        hits_add(hits, t, 0);
}

static vec3 polygon_normal(const void *shape, const vec3 *at,
                           const struct hit *hit)
{
    const struct polygon *polygon = shape;
    (void)at;
    (void)hit;
    return polygon->normal;
}

static double edge_distance(const struct edge *e, double u, double v)
{
    double du = e->u1 - e->u0, dv = e->v1 - e->v0, dd = du * du + dv * dv;
    double t = dd > 0 ? ((u - e->u0) * du + (v - e->v0) * dv) / dd : 0;
    t = fmax(0, fmin(1, t));
    return hypot(u - e->u0 - t * du, v - e->v0 - t * dv);
}

/* Within the cell's radius of where its centre is seen from above; the
 * projection shortens distances. */
static unsigned polygon_meets(const void *shape, const struct cell *cell)
{
    const struct polygon *polygon = shape;
    vec3 n = polygon->normal;
    double height = vec3_dot(n, cell->centre) - polygon->distance;
    if (fabs(height) > cell_reach(cell, n))
        return 0;
    vec3 below = vec3_along(cell->centre, n, -height);
    double u = vec3_component(below, polygon->u_axis);
    double v = vec3_component(below, polygon->v_axis);
    if (polygon_covers(polygon, u, v))
        return CELL_SURFACE;
    for (size_t i = 0; i < polygon->edge_count; i++)
        if (edge_distance(&polygon->edges[i], u, v) <= cell->radius)
            return CELL_SURFACE;
    return 0;
}

/* The rectangle around it, along its first edge. */
static int polygon_patches(const void *shape, struct patch *patches)
{
    const struct polygon *polygon = shape;
    const vec3 *p = polygon->points.items;
    vec3 n = polygon->normal, a = vec3_sub(p[1], p[0]);
    for (size_t i = 2; vec3_dot(a, a) == 0 && i < polygon->points.count; i++)
        a = vec3_sub(p[i], p[0]);
    a = vec3_normalise(a);
    vec3 b = vec3_cross(n, a);
    double low[2] = { 0, 0 }, high[2] = { 0, 0 };
    for (size_t i = 1; i < polygon->points.count; i++) {
        vec3 d = vec3_sub(p[i], p[0]);
        double x = vec3_dot(d, a), y = vec3_dot(d, b);
        low[0] = fmin(low[0], x), high[0] = fmax(high[0], x);
        low[1] = fmin(low[1], y), high[1] = fmax(high[1], y);
    }
    vec3 at = vec3_along(vec3_along(p[0], a, low[0]), b, low[1]);
    patches[0] = (struct patch){ .kind = PATCH_PARALLELOGRAM,
                                 .at = at,
                                 .a = vec3_scale(a, high[0] - low[0]),
                                 .b = vec3_scale(b, high[1] - low[1]) };
    return 1;
}

const struct primitive polygon_primitive = {
    .name = "polygon",
    .help = "a flat shape with straight edges",
    .size = sizeof(struct polygon),
    .arguments = polygon_arguments,
    .bounded = BOUNDS_IGNORED,
    .prepare = polygon_prepare,
    .remark = polygon_remark,
    .bounds = polygon_bounds,
    .told = polygon_told,
    .intersect = polygon_intersect,
    .normal = polygon_normal,
    .meets = polygon_meets,
    .patches = polygon_patches,
};
