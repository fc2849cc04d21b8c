/* Isosurfaces: see isosurface.h. How rays meet them: isosurface_search.c. */
#include "scene/isosurface.h"

#include "scene/function.h"
#include "scene/isosurface_search.h"
#include "scene/spots.h"

static const struct field isosurface_arguments[] = {
    { "samples", FIELD_TERMS, offsetof(struct isosurface, samples), 0, 0,
      "values of the function" },
    CONTAINER_FIELDS(struct isosurface),
    { NULL },
};

static const struct field isosurface_items[] = {
    { "threshold", FIELD_FLOAT, offsetof(struct isosurface, threshold), 0, 0,
      "the function's value at the surface, 0" },
    { "accuracy", FIELD_FLOAT, offsetof(struct isosurface, accuracy), 0, 0,
      "crossings nearer to each other may be missed, 0.001" },
    { "max_gradient", FIELD_FLOAT, offsetof(struct isosurface, max_gradient), 0,
      0, "how fast the function changes at most, 1.1" },
    { "open", FIELD_FLAG, offsetof(struct isosurface, open), 0, 0,
      "without the box or ball around it" },
    { NULL },
};

void isosurface_init(struct isosurface *surface)
{
    surface->container = container_default();
    surface->accuracy = 0.001;
    surface->max_gradient = 1.1;
}

static const char *isosurface_prepare(void *shape, struct arena *arena,
                                      const char **warning)
{
    struct isosurface *s = shape;
    const char *problem = container_prepare(&s->container);
    (void)arena;
    (void)warning;
    if (problem)
        return problem;
    if (!(s->accuracy > 0))
        return "its accuracy must be above 0";
    if (!(s->max_gradient > 0))
        return "its max_gradient must be above 0";
    return NULL;
}

static struct box3 isosurface_bounds(const void *shape)
{
    const struct isosurface *s = shape;
    return s->container.box;
}

double isosurface_value(const struct isosurface *s, vec3 point)
{
    return function_at(s->function, point) - s->threshold;
}

void isosurface_values(const struct isosurface *s, const struct spots *spots,
                       double *values)
{
    function_values_at(s->function, spots, values);
    for (int i = 0; i < spots->count; i++)
        values[i] -= s->threshold;
}

/* The part of a ray in the container. False: none. */
static bool search_start(struct search *search, const struct isosurface *s,
                         const struct ray *ray, struct hits *hits,
                         struct hit ends[2])
{
    double speed = vec3_length(ray->direction);
    *search = (struct search){ .surface = s,
                               .ray = ray,
                               .hits = hits,
                               .gradient = s->max_gradient * speed,
                               .accuracy = s->accuracy / speed,
                               .wanted = HITS_MAX - 2 };
    return speed > 0 &&
           container_interval(&s->container, ray, ISOSURFACE_CONTAINER, ends);
}

/* The values where a search begins and ends. */
static inline void search_ends(const struct search *search, double a, double b,
                               double at[2])
{
    struct spots ends = spots_of(ray_point(search->ray, a));
    spots_add(&ends, ray_point(search->ray, b));
    isosurface_values(search->surface, &ends, at);
}

/* Where the container cuts through the inside, it is the surface. */
static void isosurface_intersect(const void *shape, const struct ray *ray,
                                 struct hits *hits)
{
    const struct isosurface *s = shape;
    struct hit ends[2];
    struct search search;
    if (!search_start(&search, s, ray, hits, ends))
        return;
    double at[2];
    search_ends(&search, ends[0].t, ends[1].t, at);
    if (at[0] < 0 && !s->open)
        hits->at[hits->count++] = ends[0];
    search_crossings(&search, ends[0].t, at[0], ends[1].t, at[1]);
    if (at[1] < 0 && !s->open)
        hits->at[hits->count++] = ends[1];
}

/* Nothing is looked for but between tmin and tmax, and up to the first. */
static bool isosurface_first(const void *shape, const struct ray *ray,
                             double tmin, double tmax, struct hit *hit)
{
    const struct isosurface *s = shape;
    struct hit ends[2];
    struct hits hits;
    struct search search;
    hits.count = 0;
    if (!search_start(&search, s, ray, &hits, ends))
        return false;
    double from = fmax(ends[0].t, tmin), to = fmin(ends[1].t, tmax);
    if (!(from < to))
        return false;
    double at[2];
    search_ends(&search, from, to, at);
    if (from > tmin && at[0] < 0 && !s->open) {
        *hit = ends[0];
        return true;
    }
    search.wanted = 1;
    search_crossings(&search, from, at[0], to, at[1]);
    if (hits.count > 0)
        *hit = hits.at[0];
    else if (to < tmax && at[1] < 0 && !s->open)
        *hit = ends[1];
    else
        return false;
    return hit->t > tmin && hit->t < tmax;
}

static bool isosurface_crosses(const void *shape, const struct ray *ray,
                               double tmin, double tmax)
{
    struct hit hit;
    return isosurface_first(shape, ray, tmin, tmax, &hit);
}

static vec3 isosurface_normal(const void *shape, vec3 point,
                              const struct hit *hit)
{
    const struct isosurface *s = shape;
    double e = s->accuracy;
    if (hit->part >= ISOSURFACE_CONTAINER)
        return container_normal(&s->container, point,
                                hit->part - ISOSURFACE_CONTAINER);
    struct spots spots = spots_of(point);
    double values[4];
    spots_add(&spots, vec3_make(point.x + e, point.y, point.z));
    spots_add(&spots, vec3_make(point.x, point.y + e, point.z));
    spots_add(&spots, vec3_make(point.x, point.y, point.z + e));
    isosurface_values(s, &spots, values);
    vec3 n = { values[1] - values[0], values[2] - values[0],
               values[3] - values[0] };
    double length = vec3_length(n);
    return length > 0 && isfinite(length) ? n : vec3_make(1, 0, 0);
}

static bool isosurface_inside(const void *shape, vec3 point)
{
    const struct isosurface *s = shape;
    return container_holds(&s->container, point) &&
           isosurface_value(s, point) < 0;
}

/* Nothing of the surface is nearer to the middle than the value there and the
 * largest gradient allow. */
static unsigned isosurface_meets(const void *shape, const struct cell *cell)
{
    const struct isosurface *s = shape;
    double value = isosurface_value(s, cell->centre);
    double reach = s->max_gradient * cell->radius;
    if (value > reach || !container_meets(&s->container, cell))
        return 0;
    if (value >= -reach)
        return CELL_SURFACE | CELL_BORDER;
    bool deep = container_covers(&s->container, cell);
    return deep ? 0 : s->open ? CELL_BORDER : CELL_SURFACE | CELL_BORDER;
}

const struct primitive isosurface_primitive = {
    .name = "isosurface",
    .help = "where a function of space has a value",
    .size = sizeof(struct isosurface),
    .arguments = isosurface_arguments,
    .items = isosurface_items,
    .solid = true,
    .prepare = isosurface_prepare,
    .bounds = isosurface_bounds,
    .intersect = isosurface_intersect,
    .crosses = isosurface_crosses,
    .first = isosurface_first,
    .normal = isosurface_normal,
    .inside = isosurface_inside,
    .meets = isosurface_meets,
};
