/* Parametric surfaces: see parametric.h and parametric_sheet.h. */
#include "scene/parametric.h"

#include "scene/function.h"
#include "scene/parametric_sheet.h"

static const struct field parametric_arguments[] = {
    { "from", FIELD_VECTOR2, offsetof(struct parametric, from), 0, 0,
      "u and v begin" },
    { "to", FIELD_VECTOR2, offsetof(struct parametric, to), 0, 0,
      "u and v end" },
    { "samples", FIELD_TERMS, offsetof(struct parametric, samples), 0, 0,
      "some of its points" },
    CONTAINER_FIELDS(struct parametric),
    { NULL },
};

static const struct field parametric_items[] = {
    { "accuracy", FIELD_FLOAT, offsetof(struct parametric, accuracy), 0, 0,
      "read over: crossings are exact" },
    { "max_gradient", FIELD_FLOAT, offsetof(struct parametric, max_gradient), 0,
      0, "read over" },
    { NULL },
};

void parametric_init(struct parametric *surface)
{
    surface->container = container_default();
    surface->to[0] = surface->to[1] = 1;
}

bool parametric_point(const struct parametric *surface, const double uv[2],
                      unsigned long *steps_left, vec3 *point)
{
    const double arguments[] = { uv[0], uv[1], 0 };
    double at[3];
    for (int k = 0; k < 3; k++)
        at[k] =
            function_evaluate(surface->coordinate[k], arguments, steps_left);
    *point = vec3_make(at[0], at[1], at[2]);
    return *steps_left > 0 && vec3_finite(*point);
}

/* Some of its points, to tell it from others. */
static struct terms parametric_samples(const struct parametric *s,
                                       struct arena *arena)
{
    enum { SIDE = 5, STEPS = 1000 };
    double *values = ARENA_ARRAY(arena, double, SIDE *SIDE * 3);
    for (int i = 0; i < SIDE * SIDE; i++) {
        unsigned long steps = STEPS;
        double part[2] = { (i % SIDE + 0.5) / SIDE, (i / SIDE + 0.5) / SIDE };
        double uv[2] = { s->from[0] + part[0] * (s->to[0] - s->from[0]),
                         s->from[1] + part[1] * (s->to[1] - s->from[1]) };
        vec3 point;
        if (!parametric_point(s, uv, &steps, &point))
            continue;
        values[3 * i] = point.x;
        values[3 * i + 1] = point.y;
        values[3 * i + 2] = point.z;
    }
    return (struct terms){ values, SIDE * SIDE * 3 };
}

/* The ends may stand in either order (measured). */
static const char *parametric_prepare(void *shape, struct arena *arena,
                                      const char **warning)
{
    struct parametric *s = shape;
    (void)warning;
    for (int k = 0; k < 2; k++) {
        double from = fmin(s->from[k], s->to[k]);
        s->to[k] = fmax(s->from[k], s->to[k]);
        s->from[k] = from;
        if (!isfinite(s->to[k] - from))
            return "where u and v begin and end must be finite";
    }
    const char *problem = container_prepare(&s->container);
    if (problem)
        return problem;
    s->samples = parametric_samples(s, arena);
    s->sheet = parametric_sheet_new(s, arena);
    return s->sheet ? NULL
                    : arena_printf(arena,
                                   "its functions take more than %d million "
                                   "steps, glim's limit",
                                   PARAMETRIC_STEPS / 1000000);
}

static struct box3 parametric_bounds(const void *shape)
{
    const struct parametric *s = shape;
    return box3_intersection(s->sheet->bounds, s->container.box);
}

/* ---- rays ---- */

struct parametric_search {
    const struct parametric *surface;
    const struct ray *ray;
    double tmin, tmax;
    struct hits *hits; /* all; NULL: the first, whose t becomes tmax */
    struct hit *first;
    bool found;
    int looks_left;
};

/* Where two cells meet, both may have found it. */
static bool search_knows(const struct parametric_search *search, double t)
{
    double near = 1e-9 * (1 + fabs(t));
    for (int i = 0; i < search->hits->count; i++)
        if (fabs(search->hits->at[i].t - t) < near)
            return true;
    return false;
}

static bool search_cell(void *context, size_t item)
{
    struct parametric_search *search = context;
    double found[PARAMETRIC_CROSSINGS][3];
    int count = parametric_cell_cross(search->surface,
                                      &search->surface->sheet->cells[item],
                                      search->ray, &search->looks_left, found);
    for (int i = 0; i < count; i++) {
        struct hit hit = { found[i][0], 0, found[i][1], found[i][2] };
        if (!(hit.t > search->tmin && hit.t < search->tmax))
            continue;
        if (!search->hits) {
            search->tmax = hit.t;
            *search->first = hit;
            search->found = true;
        } else if (search->hits->count < HITS_MAX &&
                   !search_knows(search, hit.t)) {
            search->hits->at[search->hits->count++] = hit;
        }
    }
    return search->looks_left < 0;
}

/* False: the ray passes the container, or there is nothing. */
static bool search_run(struct parametric_search *search)
{
    struct hit ends[2];
    const struct parametric *s = search->surface;
    if (!s->sheet->tree ||
        !container_interval(&s->container, search->ray, 0, ends))
        return false;
    search->looks_left = PARAMETRIC_LOOKS;
    search->tmin = fmax(search->tmin, ends[0].t);
    search->tmax = fmin(search->tmax, ends[1].t);
    if (search->tmin < search->tmax)
        box_tree_ray(s->sheet->tree, search->ray, search->tmin, &search->tmax,
                     search_cell, search);
    return search->found;
}

static void parametric_intersect(const void *shape, const struct ray *ray,
                                 struct hits *hits)
{
    struct parametric_search search = { .surface = shape,
                                        .ray = ray,
                                        .tmin = -HUGE_VAL,
                                        .tmax = HUGE_VAL,
                                        .hits = hits };
    search_run(&search);
}

static bool parametric_first(const void *shape, const struct ray *ray,
                             double tmin, double tmax, struct hit *hit)
{
    struct parametric_search search = {
        .surface = shape, .ray = ray, .tmin = tmin, .tmax = tmax, .first = hit
    };
    return search_run(&search);
}

static bool parametric_crosses(const void *shape, const struct ray *ray,
                               double tmin, double tmax)
{
    struct hit hit;
    return parametric_first(shape, ray, tmin, tmax, &hit);
}

/* ---- the surface ---- */

/* The derivative by u (0) or v (1), within the surface. */
static vec3 parametric_slope(const struct parametric *s, const double uv[2],
                             int which)
{
    enum { STEPS = 1000000 };
    unsigned long steps = STEPS;
    double small = 1e-5 * (s->to[which] - s->from[which]);
    double low[2] = { uv[0], uv[1] }, high[2] = { uv[0], uv[1] };
    vec3 a, b;
    low[which] = fmax(uv[which] - small, s->from[which]);
    high[which] = fmin(uv[which] + small, s->to[which]);
    if (!parametric_point(s, low, &steps, &a) ||
        !parametric_point(s, high, &steps, &b))
        return vec3_make(0, 0, 0);
    return vec3_scale(vec3_sub(b, a), 1 / (high[which] - low[which]));
}

/* At a point where all u or all v meet, as at a pole, it is that of a place
 * near by. */
static vec3 parametric_normal(const void *shape, const vec3 *at,
                              const struct hit *hit)
{
    const struct parametric *s = shape;
    double uv[2] = { hit->u, hit->v };
    (void)at;
    for (int i = 0; i < 2; i++) {
        vec3 u = parametric_slope(s, uv, 0), v = parametric_slope(s, uv, 1);
        vec3 n = vec3_cross(u, v);
        if (vec3_length(n) > 1e-9 * vec3_length(u) * vec3_length(v) &&
            vec3_finite(vec3_normalise(n)))
            return n;
        for (int k = 0; k < 2; k++)
            uv[k] += 1e-3 * (0.5 * (s->from[k] + s->to[k]) - uv[k]);
    }
    return vec3_make(0, 1, 0);
}

struct place_search {
    const struct parametric *surface;
    vec3 point;
    double best, *uv;
};

/* The cell's own normal leads from the point to the surface. */
static bool place_cell(void *context, size_t item)
{
    struct place_search *search = context;
    const struct parametric_cell *cell = &search->surface->sheet->cells[item];
    double found[PARAMETRIC_CROSSINGS][3];
    struct ray ray = {
        search->point,
        vec3_normalise(vec3_cross(cell->across[0], cell->across[1])),
    };
    int looks_left = PARAMETRIC_LOOKS;
    int count =
        parametric_cell_cross(search->surface, cell, &ray, &looks_left, found);
    for (int i = 0; i < count; i++)
        if (fabs(found[i][0]) < search->best) {
            search->best = fabs(found[i][0]);
            search->uv[0] = found[i][1];
            search->uv[1] = found[i][2];
        }
    return false;
}

static void parametric_uv(const void *shape, vec3 point, double uv[2])
{
    const struct parametric *s = shape;
    struct place_search search = { s, point, HUGE_VAL, uv };
    uv[0] = s->from[0];
    uv[1] = s->from[1];
    box_tree_box(s->sheet->tree, (struct box3){ point, point }, place_cell,
                 &search);
}

/* ---- places ---- */

struct meet_search {
    const struct parametric *surface;
    const struct cell *cell;
    bool met;
};

static bool meet_cell(void *context, size_t item)
{
    struct meet_search *search = context;
    const struct parametric_cell *part = &search->surface->sheet->cells[item];
    vec3 w = vec3_sub(part->centre, search->cell->centre);
    vec3 n = vec3_normalise(vec3_cross(part->across[0], part->across[1]));
    search->met =
        !vec3_finite(n) ||
        fabs(vec3_dot(w, n)) <= 2 * part->bend + cell_reach(search->cell, n);
    return search->met;
}

static unsigned parametric_meets(const void *shape, const struct cell *cell)
{
    const struct parametric *s = shape;
    struct meet_search search = { s, cell, false };
    if (s->sheet->tree && container_meets(&s->container, cell))
        box_tree_box(s->sheet->tree, cell_box(cell), meet_cell, &search);
    return search.met ? CELL_SURFACE : 0;
}

const struct primitive parametric_primitive = {
    .name = "parametric",
    .help = "a surface by functions of two coordinates",
    .size = sizeof(struct parametric),
    .arguments = parametric_arguments,
    .items = parametric_items,
    .prepare = parametric_prepare,
    .bounds = parametric_bounds,
    .intersect = parametric_intersect,
    .crosses = parametric_crosses,
    .first = parametric_first,
    .normal = parametric_normal,
    .uv = parametric_uv,
    .meets = parametric_meets,
};
