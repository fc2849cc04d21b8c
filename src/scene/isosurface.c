/* Isosurfaces: see isosurface.h. How rays meet them: isosurface_search.c. */
#include "scene/isosurface.h"

#include "scene/function.h"
#include "scene/isosurface_search.h"
#include "scene/spots.h"

/* Crossings of the function by a ray, but the container's two. */
enum { MOST = HITS_MAX - 2 };

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
    { "max_trace", FIELD_INTEGER, offsetof(struct isosurface, max_trace), 0, 0,
      "how many crossings of a ray CSG and clips get to see, 1" },
    { "all_intersections", FIELD_FLAG,
      offsetof(struct isosurface, all_intersections), 0, 0,
      "CSG and clips see them all" },
    { NULL },
};

void isosurface_init(struct isosurface *surface)
{
    surface->container = container_default();
    surface->accuracy = 0.001;
    surface->max_gradient = 1.1;
    surface->max_trace = 1;
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

/* A ray that is to meet it, between two places. */
struct seeker {
    double tmin, tmax;
    struct hit ends[2]; /* of what is in the container */
    struct search_place from, to;
    double crossing; /* if the search is for one */
    struct search search;
};

/* The part of a ray in the container. False: none. */
static inline bool seeker_enters(struct seeker *seeker,
                                 const struct isosurface *s)
{
    vec3 d = seeker->search.ray.direction;
    return vec3_dot(d, d) > 0 &&
           container_interval(&s->container, &seeker->search.ray,
                              ISOSURFACE_CONTAINER, seeker->ends);
}

/* From where to where nothing but the container hides what it seeks. */
static inline bool seeker_begin(struct seeker *seeker,
                                const struct isosurface *s)
{
    if (!seeker_enters(seeker, s))
        return false;
    seeker->from.t = fmax(seeker->ends[0].t, seeker->tmin);
    seeker->to.t = fmin(seeker->ends[1].t, seeker->tmax);
    return seeker->from.t < seeker->to.t;
}

/* The values where searches begin and end. */
static void seekers_find_ends(const struct isosurface *s,
                              struct seeker *const *seekers, int count)
{
    enum { TOGETHER = OCTET / 2 };
    for (int first = 0; first < count; first += TOGETHER) {
        struct seeker *const *here = seekers + first;
        int most = count - first < TOGETHER ? count - first : TOGETHER;
        struct spots spots;
        double values[OCTET];
        spots.count = 0;
        for (int i = 0; i < most; i++) {
            spots_add(&spots, ray_point(&here[i]->search.ray, here[i]->from.t));
            spots_add(&spots, ray_point(&here[i]->search.ray, here[i]->to.t));
        }
        isosurface_values(s, &spots, values);
        for (int i = 0; i < most; i++) {
            here[i]->from.value = values[2 * i];
            here[i]->to.value = values[2 * i + 1];
        }
    }
}

/* Whether it meets the container before all else. */
static inline bool seeker_meets_end(const struct seeker *seeker,
                                    const struct isosurface *s)
{
    return seeker->from.t > seeker->tmin && seeker->from.value < 0 && !s->open;
}

/* What is enough to know. */
struct asking {
    bool any;      /* whether there is a crossing; else the first, */
    double spread; /* and that about: see primitive.h */
};

/* The first crossing for each, or any. */
static void seekers_search(const struct isosurface *s,
                           struct seeker *const *seekers, int count,
                           struct asking asking)
{
    struct search *searches[RAY_LANES];
    int live = 0;
    seekers_find_ends(s, seekers, count);
    for (int i = 0; i < count; i++) {
        struct seeker *seeker = seekers[i];
        search_set_out(&seeker->search, s, &seeker->crossing, 1);
        seeker->search.any = asking.any;
        seeker->search.spread = asking.spread;
        if (seeker_meets_end(seeker, s))
            continue;
        search_stretch(&seeker->search, seeker->from, seeker->to);
        searches[live++] = &seeker->search;
    }
    search_run(s, searches, live);
}

/* From t on, up to `wanted` crossings. Where the container cuts through the
 * inside, it is the surface, but not where rays leave that have entered it: in
 * POV-Ray such a surface is not there, either (measured). */
static void isosurface_hits(const struct isosurface *s, const struct ray *ray,
                            double t, int wanted, bool coarse,
                            struct hits *hits)
{
    struct seeker seeker, *one = &seeker;
    struct search *search = &seeker.search;
    double crossings[MOST];
    search->ray = *ray;
    if (!seeker_enters(&seeker, s))
        return;
    seeker.from.t = fmax(seeker.ends[0].t, t);
    seeker.to.t = seeker.ends[1].t;
    if (seeker.from.t >= seeker.to.t)
        return;
    seekers_find_ends(s, &one, 1);
    bool enters = seeker.ends[0].t > t;
    if (enters && seeker.from.value < 0 && !s->open) {
        hits->at[hits->count++] = seeker.ends[0];
        wanted--;
    }
    search_set_out(search, s, crossings, wanted);
    search->coarse = coarse;
    search_stretch(search, seeker.from, seeker.to);
    search_run(s, &search, 1);
    for (int i = 0; i < search->found; i++)
        hits_add(hits, crossings[i], ISOSURFACE_FUNCTION);
    if (!enters && search->found < wanted && seeker.to.value < 0 && !s->open)
        hits->at[hits->count++] = seeker.ends[1];
}

/* What is nearer is where the ray begins. */
static double isosurface_nearest(const struct isosurface *s,
                                 const struct ray *ray)
{
    return s->accuracy / vec3_length(ray->direction);
}

/* As POV-Ray, which sees no more of it but by request. */
static int isosurface_wanted(const struct isosurface *s)
{
    return s->all_intersections ? MOST : (int)fmax(fmin(s->max_trace, MOST), 1);
}

static void isosurface_intersect(const void *shape, const struct ray *ray,
                                 struct hits *hits)
{
    const struct isosurface *s = shape;
    isosurface_hits(s, ray, isosurface_nearest(s, ray), isosurface_wanted(s),
                    false, hits);
}

static void isosurface_traced(const void *shape, const struct ray *ray,
                              struct hits *hits)
{
    isosurface_hits(shape, ray, 0, MOST, true, hits);
}

/* What its search has found. */
static bool seeker_first(const struct seeker *seeker,
                         const struct isosurface *s, struct hit *hit)
{
    if (seeker_meets_end(seeker, s)) {
        *hit = seeker->ends[0];
        return true;
    }
    if (seeker->search.found > 0)
        *hit = (struct hit){ seeker->crossing, ISOSURFACE_FUNCTION, 0, 0 };
    else if (seeker->to.t < seeker->tmax && seeker->to.value < 0 && !s->open)
        *hit = seeker->ends[1];
    else
        return false;
    return hit->t > seeker->tmin && hit->t < seeker->tmax;
}

/* Nothing is looked for but between tmin and tmax, and up to the first. */
static bool isosurface_seek(const struct isosurface *s, const struct ray *ray,
                            double tmin, double tmax, struct asking asking,
                            struct hit *hit)
{
    struct seeker seeker, *one = &seeker;
    seeker.search.ray = *ray;
    seeker.tmin = tmin;
    seeker.tmax = tmax;
    if (!seeker_begin(&seeker, s))
        return false;
    seekers_search(s, &one, 1, asking);
    return seeker_first(&seeker, s, hit);
}

static bool isosurface_first(const void *shape, const struct ray *ray,
                             double tmin, double tmax, struct hit *hit)
{
    return isosurface_seek(shape, ray, tmin, tmax, (struct asking){ 0 }, hit);
}

static bool isosurface_crosses(const void *shape, const struct ray *ray,
                               double tmin, double tmax)
{
    struct hit hit;
    return isosurface_seek(shape, ray, tmin, tmax,
                           (struct asking){ .any = true }, &hit);
}

static bool isosurface_first_roughly(const void *shape, const struct ray *ray,
                                     double tmin, double tmax, double spread,
                                     struct hit *hit)
{
    const struct asking asking = { .any = !hit, .spread = spread };
    struct hit any;
    return isosurface_seek(shape, ray, tmin, tmax, asking, hit ? hit : &any);
}

/* Those of the run. */
static void isosurface_seek_many(const struct isosurface *s,
                                 struct lane_run run, const struct rays *rays,
                                 const struct rays_span *span,
                                 struct asking asking, struct rays_met *met)
{
    struct seeker all[RAY_LANES], *seekers[RAY_LANES] = { NULL };
    struct hit hit;
    int count = 0;
    for (int i = run.first; i < run.end; i++) {
        struct seeker *seeker = seekers[count] = &all[i];
        seeker->search.ray = rays_at(rays, i);
        seeker->tmin = span->near[i];
        seeker->tmax = span->far[i];
        met->t[i] = (double)INFINITY;
        count += seeker->tmin < seeker->tmax && seeker_begin(seeker, s);
    }
    seekers_search(s, seekers, count, asking);
    for (int i = 0; i < count; i++)
        if (seeker_first(seekers[i], s, &hit)) {
            met->t[seekers[i] - all] = hit.t;
            met->part[seekers[i] - all] = hit.part;
        }
}

static void isosurface_first_many(const void *shape, struct lane_run run,
                                  const struct rays *rays,
                                  const struct rays_span *span,
                                  struct rays_met *met)
{
    isosurface_seek_many(shape, run, rays, span, (struct asking){ 0 }, met);
}

static void isosurface_told_many(const void *shape, struct lane_run run,
                                 const struct rays *rays,
                                 const struct rays_span *span,
                                 struct rays_met *met)
{
    struct rays_span all = *span;
    for (int i = run.first; i < run.end; i++) {
        const struct ray ray = rays_at(rays, i);
        if (span->near[i] < span->far[i])
            all.near[i] = isosurface_nearest(shape, &ray);
    }
    isosurface_first_many(shape, run, rays, &all, met);
}

static void isosurface_crosses_many(const void *shape, struct lane_run run,
                                    const struct rays *rays,
                                    const struct rays_span *span,
                                    lane_flag *crosses)
{
    struct rays_met met;
    isosurface_seek_many(shape, run, rays, span, (struct asking){ .any = true },
                         &met);
    for (int i = run.first; i < run.end; i++)
        crosses[i] = met.t[i] < (double)INFINITY ? -1 : 0;
}

static vec3 isosurface_normal(const void *shape, const vec3 *at,
                              const struct hit *hit)
{
    const vec3 point = *at;
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
    .traced = isosurface_traced,
    .crosses = isosurface_crosses,
    .first = isosurface_first,
    .first_roughly = isosurface_first_roughly,
    .some = true,
    .told_many = isosurface_told_many,
    .crosses_many = isosurface_crosses_many,
    .lane_by_lane = true,
    .first_many = isosurface_first_many,
    .normal = isosurface_normal,
    .inside = isosurface_inside,
    .meets = isosurface_meets,
};
