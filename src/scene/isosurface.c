/* Isosurfaces: see isosurface.h. A stretch of a ray is left out if the values
 * at its ends are too large for the function to reach its threshold between
 * them, by the largest gradient it is said to have; else it is halved, until it
 * is as short as the accuracy. */
#include "scene/isosurface.h"

#include "scene/function.h"

enum {
    ISOSURFACE_STEPS = 200000, /* function calls for one ray */
    ISOSURFACE_ROUNDS = 60,    /* for one crossing */
};

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

enum { PART_FUNCTION, PART_CONTAINER };

/* ---- the function along a ray ---- */

struct search {
    const struct isosurface *surface;
    const struct ray *ray;
    struct hits *hits;
    double gradient; /* of the function by t, at most */
    double accuracy; /* in t */
    int left;        /* calls */
    int wanted;      /* crossings, at most: the nearest */
};

static double surface_value(const struct isosurface *s, vec3 point)
{
    return function_at(s->function, point) - s->threshold;
}

static double search_value(struct search *search, double t)
{
    search->left--;
    return surface_value(search->surface, ray_point(search->ray, t));
}

/* The crossing between a and b, where signs differ: by the secant, an end that
 * stays counting half (the Illinois method), now and then by halving, which
 * jumps need. */
static void search_refine(struct search *search, double a, double at_a,
                          double b, double at_b)
{
    double enough = 1e-6 * search->accuracy;
    for (int i = 1; i < ISOSURFACE_ROUNDS && b - a > enough; i++) {
        double t = a - at_a * (b - a) / (at_b - at_a);
        if (i % 4 == 0 || !(t > a && t < b))
            t = 0.5 * (a + b);
        if (!(t > a && t < b))
            break;
        double at_t = search_value(search, t);
        if ((at_t < 0) == (at_a < 0)) {
            a = t;
            at_a = at_t;
            at_b /= 2;
        } else {
            b = t;
            at_b = at_t;
            at_a /= 2;
        }
    }
    hits_add(search->hits, 0.5 * (a + b), PART_FUNCTION);
}

static void search_stretch(struct search *search, double a, double at_a,
                           double b, double at_b)
{
    bool differ = (at_a < 0) != (at_b < 0);
    if (search->left <= 0 || search->hits->count >= search->wanted)
        return;
    if (!differ && fabs(at_a) + fabs(at_b) > search->gradient * (b - a))
        return;
    double middle = 0.5 * (a + b);
    if (b - a < search->accuracy || middle <= a || middle >= b) {
        if (differ)
            search_refine(search, a, at_a, b, at_b);
        return;
    }
    double at_middle = search_value(search, middle);
    search_stretch(search, a, at_a, middle, at_middle);
    search_stretch(search, middle, at_middle, b, at_b);
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
                               .left = ISOSURFACE_STEPS,
                               .wanted = HITS_MAX - 2 };
    return speed > 0 &&
           container_interval(&s->container, ray, PART_CONTAINER, ends);
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
    double first = search_value(&search, ends[0].t);
    double last = search_value(&search, ends[1].t);
    if (first < 0 && !s->open)
        hits->at[hits->count++] = ends[0];
    search_stretch(&search, ends[0].t, first, ends[1].t, last);
    if (last < 0 && !s->open)
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
    double first = search_value(&search, from),
           last = search_value(&search, to);
    if (from > tmin && first < 0 && !s->open) {
        *hit = ends[0];
        return true;
    }
    search.wanted = 1;
    search_stretch(&search, from, first, to, last);
    if (hits.count > 0)
        *hit = hits.at[0];
    else if (to < tmax && last < 0 && !s->open)
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
    if (hit->part >= PART_CONTAINER)
        return container_normal(&s->container, point,
                                hit->part - PART_CONTAINER);
    double here = surface_value(s, point);
    vec3 n = {
        surface_value(s, vec3_make(point.x + e, point.y, point.z)) - here,
        surface_value(s, vec3_make(point.x, point.y + e, point.z)) - here,
        surface_value(s, vec3_make(point.x, point.y, point.z + e)) - here
    };
    double length = vec3_length(n);
    return length > 0 && isfinite(length) ? n : vec3_make(1, 0, 0);
}

static bool isosurface_inside(const void *shape, vec3 point)
{
    const struct isosurface *s = shape;
    return container_holds(&s->container, point) && surface_value(s, point) < 0;
}

/* Nothing of the surface is nearer to the middle than the value there and the
 * largest gradient allow. */
static unsigned isosurface_meets(const void *shape, const struct cell *cell)
{
    const struct isosurface *s = shape;
    double value = surface_value(s, cell->centre);
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
