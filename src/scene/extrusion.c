/* Outlines with a thickness: see extrusion.h. u and v are the outline's
 * coordinates, w runs along the axis. */
#include "scene/extrusion.h"

#include "scene/hit_search.h"
#include "scene/slab_rays.h"

enum { PART_LOW = -1, PART_HIGH = -2 };

/* What the fingerprint of a scene is made of; the parser has readers of its
 * own, since splines and fonts are no tables. */
static const struct field extrusion_fields[] = {
    { "segments", FIELD_TERMS, offsetof(struct extrusion, segments), 0, 0,
      "the outline", false },
    { "low", FIELD_FLOAT, offsetof(struct extrusion, low), 0, 0, "from here",
      false },
    { "high", FIELD_FLOAT, offsetof(struct extrusion, high), 0, 0, "to here",
      false },
    { "axis", FIELD_INTEGER, offsetof(struct extrusion, axis), 0, 0,
      "along which", false },
    { "conic_sweep", FIELD_FLAG, offsetof(struct extrusion, conic), 0, 0,
      "shrinks to a point", false },
    { .name = NULL },
};

/* May stand among the modifiers. */
static const struct field prism_items[] = {
    { "open", FIELD_FLAG, offsetof(struct extrusion, open), 0, 0, "no caps",
      false },
    { .name = NULL },
};

/* A point of the shape's space as u, v, w, or such a one back. */
static vec3 extrusion_turned(const struct extrusion *e, vec3 p)
{
    return e->axis == 2 ? p : (vec3){ p.x, p.z, p.y };
}

const char *extrusion_prepare(void *shape, struct arena *arena,
                              const char **warning)
{
    struct extrusion *e = shape;
    if (e->low > e->high) {
        double swap = e->low;
        e->low = e->high;
        e->high = swap;
    }
    e->outline =
        outline_of_numbers(arena, e->segments.values, e->segments.count);
    if (e->outline.count == 0)
        *warning = "its outline has no length";
    return NULL;
}

/* How large the outline is at the height w. */
static double extrusion_scale(const struct extrusion *e, double w)
{
    return e->conic ? w : 1;
}

static struct box3 extrusion_bounds(const void *shape)
{
    const struct extrusion *e = shape;
    const struct outline *o = &e->outline;
    struct box3 box = box3_empty();
    const double ends[] = { e->low, e->high };
    for (int i = 0; i < 2; i++) {
        double w = ends[i], s = extrusion_scale(e, w);
        vec3 low = { s * o->low[0], s * o->low[1], w };
        vec3 high = { s * o->high[0], s * o->high[1], w };
        box = box3_add(box, extrusion_turned(e, low));
        box = box3_add(box, extrusion_turned(e, high));
    }
    return box;
}

static bool extrusion_covers(const struct extrusion *e, vec3 p)
{
    double scale = extrusion_scale(e, p.z);
    return scale != 0 && outline_covers(&e->outline, p.x / scale, p.y / scale);
}

struct extrusion_search {
    const struct extrusion *extrusion;
    bool any;       /* whichever is found first is enough */
    struct ray ray; /* in u, v, w */
    /* Seen along the axis the ray is a line in the outline's plane; seen from
     * the tip of a cone, too: the plane through both cuts w = 1 in it. */
    double line[3];
    struct hit_search hits;
};

static void search_cap(struct extrusion_search *search, double w, int part)
{
    const struct ray *ray = &search->ray;
    double t = (w - ray->origin.z) / ray->direction.z;
    vec3 p = { ray->origin.x + t * ray->direction.x,
               ray->origin.y + t * ray->direction.y, w };
    if (hit_search_wants(&search->hits, t) &&
        extrusion_covers(search->extrusion, p))
        hit_search_take(&search->hits, (struct hit){ t, part, 0, 0 });
}

/* The ray meets the line, or the line to the tip, over this point of the
 * outline. */
static void side_found(void *context, int index, double s)
{
    struct extrusion_search *search = context;
    const struct extrusion *e = search->extrusion;
    vec3 o = search->ray.origin, d = search->ray.direction;
    double at[2];
    segment_point(&e->outline.pieces[index].curve, s, at);
    double a, b, c, f;
    if (e->conic) {
        a = d.x - at[0] * d.z;
        b = d.y - at[1] * d.z;
        c = at[0] * o.z - o.x;
        f = at[1] * o.z - o.y;
    } else {
        a = d.x;
        b = d.y;
        c = at[0] - o.x;
        f = at[1] - o.y;
    }
    double t = fabs(a) > fabs(b) ? c / a : f / b;
    double w = o.z + t * d.z;
    if (w >= e->low && w <= e->high)
        hit_search_take(&search->hits, (struct hit){ t, index, s, 0 });
}

/* Around the piece, which is raised along the axis. The box is a little larger,
 * as a ray along one of its sides isn't told to be in it. */
static struct box3 side_box(const struct extrusion *e,
                            const struct piece *piece)
{
    const double *low = piece->low, *high = piece->high;
    double more = 1e-9 * (fabs(low[0]) + fabs(low[1]) + fabs(high[0]) +
                          fabs(high[1]) + fabs(e->low) + fabs(e->high));
    return (struct box3){ { low[0] - more, low[1] - more, e->low - more },
                          { high[0] + more, high[1] + more, e->high + more } };
}

/* Whether the ray meets that box where it is looked for. */
static bool side_is_met(const struct extrusion_search *search,
                        const struct slabs *slabs, const struct piece *piece)
{
    const struct box3 box = side_box(search->extrusion, piece);
    double enter = search->hits.tmin, leave = search->hits.tmax;
    slabs_clip(slabs, &box, &enter, &leave);
    return enter <= leave;
}

static inline void search_side(struct extrusion_search *search, size_t index)
{
    outline_cross(&search->extrusion->outline, (int)index, search->line,
                  side_found, search);
}

static void search_sides(struct extrusion_search *search)
{
    const struct extrusion *e = search->extrusion;
    struct slabs slabs = slabs_of(&search->ray);
    for (size_t i = 0; i < e->outline.count; i++) {
        if (search->any && search->hits.found)
            return;
        if (e->conic || side_is_met(search, &slabs, &e->outline.pieces[i]))
            search_side(search, i);
    }
}

/* The nearer first, unless both are the same. */
static void search_caps(struct extrusion_search *search)
{
    const struct extrusion *e = search->extrusion;
    bool down =
        search->ray.direction.z < 0 && e->low < e->high && !search->hits.all;
    if (e->open || search->ray.direction.z == 0)
        return;
    if (down)
        search_cap(search, e->high, PART_HIGH);
    search_cap(search, e->low, PART_LOW);
    if (!down)
        search_cap(search, e->high, PART_HIGH);
}

/* Behind the nearest cap no side is looked for: a side that ends there is taken
 * before it, though. */
static void search_past_caps(struct extrusion_search *search)
{
    struct hit_search *hits = &search->hits;
    if (hits->found)
        hits->tmax = nextafter(hits->tmax, HUGE_VAL);
}

static void extrusion_search(struct extrusion_search *search)
{
    struct hit_search *hits = &search->hits;
    if (!hits->all) {
        search_caps(search);
        search_past_caps(search);
    }
    if (!(search->any && hits->found))
        search_sides(search);
    if (hits->all)
        search_caps(search);
}

/* Into its place: to copy what was only just written number by number waits for
 * the memory. */
static void extrusion_search_start(struct extrusion_search *search,
                                   const void *shape, const struct ray *ray,
                                   double tmin, double tmax)
{
    const struct extrusion *e = shape;
    vec3 o = extrusion_turned(e, ray->origin);
    vec3 d = extrusion_turned(e, ray->direction);
    vec3 n = e->conic ? vec3_cross(o, d)
                      : (vec3){ d.y, -d.x, d.x * o.y - d.y * o.x };
    *search = (struct extrusion_search){ .extrusion = e };
    search->ray.origin = o;
    search->ray.direction = d;
    search->line[0] = n.x;
    search->line[1] = n.y;
    search->line[2] = n.z;
    search->hits.tmin = tmin;
    search->hits.tmax = tmax;
}

static void extrusion_intersect(const void *shape, const struct ray *ray,
                                struct hits *hits)
{
    struct extrusion_search search;
    extrusion_search_start(&search, shape, ray, -HUGE_VAL, HUGE_VAL);
    search.hits.all = hits;
    extrusion_search(&search);
}

static bool extrusion_first(const void *shape, const struct ray *ray,
                            double tmin, double tmax, struct hit *hit)
{
    struct extrusion_search search;
    extrusion_search_start(&search, shape, ray, tmin, tmax);
    extrusion_search(&search);
    *hit = search.hits.first;
    return search.hits.found;
}

static bool extrusion_crosses(const void *shape, const struct ray *ray,
                              double tmin, double tmax)
{
    struct extrusion_search search;
    extrusion_search_start(&search, shape, ray, tmin, tmax);
    search.any = true;
    extrusion_search(&search);
    return search.hits.found;
}

/* Rays side by side, in u, v, w. */
struct extrusion_lanes {
    struct rays rays;
    struct rays_span span;
    double inverse[3][RAY_LANES]; /* of the directions, but of a cone's */
    double line[3][RAY_LANES];    /* as of a search, of a cone */
    struct extrusion_search search[RAY_LANES];
    unsigned open; /* those that look for something still */
};

/* Those that meet the shape's box where they are looked for. Only of a cone, as
 * others have a box for each side. */
static unsigned lanes_within(const struct extrusion *e, const struct rays *rays,
                             const struct rays_span *span)
{
    unsigned within = 0;
    for (int i = 0; i < RAY_LANES; i++)
        within |= (unsigned)(span->near[i] < span->far[i]) << i;
    if (!e->conic || !within)
        return within;
    double inverse[3][RAY_LANES];
    const struct rays_boxed boxed = { rays, (const double(*)[RAY_LANES])inverse,
                                      span };
    struct box3 box = extrusion_bounds(e);
    double more = 1e-9 * (vec3_length(box.low) + vec3_length(box.high));
    vec3 rim = vec3_make(more, more, more);
    LANE_LINES lane_flag met[RAY_LANES];
    box.low = vec3_sub(box.low, rim);
    box.high = vec3_add(box.high, rim);
    rays_inverse(rays, lane_run_all(), inverse);
    rays_meet_box(&boxed, &box, lane_run_all(), met);
    return within & rays_bits(met);
}

/* Where rays meet a cap's plane, the outline's size times `scale`, and whether
 * it is where they look. */
CLONES static void cap_points(const struct extrusion_lanes *restrict lanes,
                              double w, double scale,
                              struct lane_points *restrict points,
                              lane_flag *restrict wanted)
{
    const struct rays *rays = &lanes->rays;
    const struct rays_span *span = &lanes->span;
    const struct lane_run run = lane_run_all();
    EACH_LANE(i, run) {
        double t = (w - rays->origin[2][i]) / rays->direction[2][i];
        points->at[0][i] =
            (rays->origin[0][i] + t * rays->direction[0][i]) / scale;
        points->at[1][i] =
            (rays->origin[1][i] + t * rays->direction[1][i]) / scale;
        points->at[2][i] = t;
        wanted[i] = (t > span->near[i] ? -1 : 0) & (t < span->far[i] ? -1 : 0);
    }
}

/* As search_cap, of those of the bits `asked`. */
static void lanes_cap(struct extrusion_lanes *lanes, const struct extrusion *e,
                      double w, int part, unsigned asked)
{
    struct lane_points points;
    LANE_LINES lane_flag wanted[RAY_LANES];
    const double scale = extrusion_scale(e, w);
    if (!asked || scale == 0)
        return;
    cap_points(lanes, w, scale, &points, wanted);
    asked = outline_covers_many(&e->outline, points.at[0], points.at[1],
                                asked & rays_bits(wanted));
    for (; asked; asked &= asked - 1) {
        int i = __builtin_ctz(asked);
        struct hit_search *hits = &lanes->search[i].hits;
        hit_search_take(hits, (struct hit){ points.at[2][i], part, 0, 0 });
        lanes->span.far[i] = hits->tmax;
    }
}

/* As search_caps, of the open ones. */
static void lanes_caps(struct extrusion_lanes *lanes, const struct extrusion *e)
{
    const unsigned open = lanes->open;
    unsigned down = 0;
    if (e->open)
        return;
    for (int i = 0; i < RAY_LANES && e->low < e->high; i++)
        down |= (unsigned)(lanes->rays.direction[2][i] < 0) << i;
    lanes_cap(lanes, e, e->high, PART_HIGH, open & down);
    lanes_cap(lanes, e, e->low, PART_LOW, open);
    lanes_cap(lanes, e, e->high, PART_HIGH, open & ~down);
}

static void lanes_begin(struct extrusion_lanes *lanes,
                        const struct extrusion *e, const struct rays *rays,
                        const struct rays_span *span, bool any)
{
    const unsigned within = lanes_within(e, rays, span);
    lanes->rays = *rays;
    lanes->span = *span;
    lanes->open = 0;
    for (int i = 0; i < RAY_LANES; i++) {
        struct extrusion_search *search = &lanes->search[i];
        if (!(within >> i & 1)) {
            search->hits.found = false;
            continue;
        }
        const struct ray ray = rays_at(rays, i);
        extrusion_search_start(search, e, &ray, span->near[i], span->far[i]);
        search->any = any;
        rays_set(&lanes->rays, i, search->ray.origin, search->ray.direction);
        for (int k = 0; k < 3; k++)
            lanes->line[k][i] = search->line[k];
        lanes->open |= 1u << i;
    }
    lanes_caps(lanes, e);
    for (unsigned left = lanes->open; left; left &= left - 1) {
        int i = __builtin_ctz(left);
        struct extrusion_search *search = &lanes->search[i];
        search_past_caps(search);
        lanes->span.far[i] = search->hits.tmax;
        if (any && search->hits.found)
            lanes->open &= ~(1u << i);
    }
}

/* Those that may meet the side. */
static unsigned lanes_met(const struct extrusion_lanes *lanes,
                          const struct extrusion *e, const struct piece *piece)
{
    LANE_LINES lane_flag met[RAY_LANES];
    if (e->conic) {
        outline_crosses_many(piece, (const double(*)[RAY_LANES])lanes->line,
                             met);
    } else {
        const struct rays_boxed boxed = {
            &lanes->rays, (const double(*)[RAY_LANES])lanes->inverse,
            &lanes->span
        };
        const struct box3 box = side_box(e, piece);
        rays_meet_box(&boxed, &box, lane_run_all(), met);
    }
    return lanes->open & rays_bits(met);
}

/* A rectangle in the outline's plane. */
struct ground {
    double low[2], high[2];
};

static bool ground_has(const struct ground *ground, const struct piece *piece)
{
    return ground->low[0] <= piece->high[0] &&
           ground->high[0] >= piece->low[0] &&
           ground->low[1] <= piece->high[1] && ground->high[1] >= piece->low[1];
}

/* What the ray comes over where it may meet the box. */
static void ground_take(struct ground *ground,
                        const struct extrusion_lanes *lanes, int i,
                        const struct box3 *box)
{
    const double *low = &box->low.x, *high = &box->high.x;
    double enter = lanes->span.near[i], leave = lanes->span.far[i];
    for (int k = 0; k < 3; k++)
        slab_clip(low[k], high[k], lanes->rays.origin[k][i],
                  lanes->inverse[k][i], &enter, &leave);
    for (int k = 0; k < 2 && enter <= leave; k++) {
        double o = lanes->rays.origin[k][i], d = lanes->rays.direction[k][i];
        double a = o + enter * d, b = o + leave * d;
        double rounding = 1e-15 * (fabs(o) + fabs(a) + fabs(b));
        ground->low[k] = lesser(ground->low[k], lesser(a, b) - rounding);
        ground->high[k] = greater(ground->high[k], greater(a, b) + rounding);
    }
}

/* What the open ones come over where they look; of a cone nothing is known. */
static struct ground lanes_ground(struct extrusion_lanes *lanes,
                                  const struct extrusion *e)
{
    const struct outline *o = &e->outline;
    struct ground all = { { HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL } };
    double more = 1e-9 * (fabs(o->low[0]) + fabs(o->low[1]) + fabs(o->high[0]) +
                          fabs(o->high[1]) + fabs(e->low) + fabs(e->high));
    const struct box3 box = {
        { o->low[0] - more, o->low[1] - more, e->low - more },
        { o->high[0] + more, o->high[1] + more, e->high + more }
    };
    if (e->conic)
        return (struct ground){ { -HUGE_VAL, -HUGE_VAL },
                                { HUGE_VAL, HUGE_VAL } };
    rays_inverse(&lanes->rays, lane_run_all(), lanes->inverse);
    for (unsigned left = lanes->open; left; left &= left - 1)
        ground_take(&all, lanes, __builtin_ctz(left), &box);
    for (int k = 0; k < 2; k++) {
        all.low[k] -= more;
        all.high[k] += more;
    }
    return all;
}

/* As search_sides, but side after side, each for all of them. */
static void lanes_sides(struct extrusion_lanes *lanes,
                        const struct extrusion *e)
{
    const struct ground ground = lanes_ground(lanes, e);
    for (size_t k = 0; k < e->outline.count && lanes->open; k++) {
        if (!ground_has(&ground, &e->outline.pieces[k]))
            continue;
        unsigned meet = lanes_met(lanes, e, &e->outline.pieces[k]);
        for (; meet; meet &= meet - 1) {
            unsigned i = (unsigned)__builtin_ctz(meet);
            struct extrusion_search *search = &lanes->search[i];
            search_side(search, k);
            lanes->span.far[i] = search->hits.tmax;
            if (search->any && search->hits.found)
                lanes->open &= ~(1u << i);
        }
    }
}

static void extrusion_first_many(const void *shape, struct lane_run run,
                                 const struct rays *rays,
                                 const struct rays_span *span,
                                 struct rays_met *met)
{
    struct extrusion_lanes lanes;
    lanes_begin(&lanes, shape, rays, span, false);
    lanes_sides(&lanes, shape);
    for (int i = run.first; i < run.end; i++)
        rays_met_take(met, i, &lanes.search[i].hits);
}

static void extrusion_crosses_many(const void *shape, struct lane_run run,
                                   const struct rays *rays,
                                   const struct rays_span *span, lane_flag *met)
{
    struct extrusion_lanes lanes;
    lanes_begin(&lanes, shape, rays, span, true);
    lanes_sides(&lanes, shape);
    for (int i = run.first; i < run.end; i++)
        met[i] = lanes.search[i].hits.found ? -1 : 0;
}

/* Of a side: across the outline, and for cones across the line to the tip. */
static vec3 extrusion_normal(const void *shape, const vec3 *place,
                             const struct hit *hit)
{
    const struct extrusion *e = shape;
    vec3 n = { 0, 0, hit->part == PART_LOW ? -1 : 1 };
    if (hit->part >= 0) {
        const struct piece *piece = &e->outline.pieces[hit->part];
        double at[2], along[2];
        segment_point(&piece->curve, hit->u, at);
        segment_tangent(&piece->curve, hit->u, along);
        double side = piece->outward;
        if (e->conic && extrusion_turned(e, *place).z < 0)
            side = -side;
        n = (vec3){ side * along[1], -side * along[0], 0 };
        if (e->conic)
            n.z = -(n.x * at[0] + n.y * at[1]);
    }
    return extrusion_turned(e, n);
}

static bool extrusion_inside(const void *shape, vec3 point)
{
    const struct extrusion *e = shape;
    vec3 p = extrusion_turned(e, point);
    return p.z > e->low && p.z < e->high && extrusion_covers(e, p);
}

const struct primitive prism_primitive = {
    .name = "prism",
    .alike = true,
    .help = "an outline along y",
    .size = sizeof(struct extrusion),
    .arguments = extrusion_fields,
    .items = prism_items,
    .solid = true,
    .prepare = extrusion_prepare,
    .bounds = extrusion_bounds,
    .intersect = extrusion_intersect,
    .crosses = extrusion_crosses,
    .first = extrusion_first,
    .lane_by_lane = true,
    .first_many = extrusion_first_many,
    .crosses_many = extrusion_crosses_many,
    .normal = extrusion_normal,
    .inside = extrusion_inside,
};

const struct primitive text_primitive = {
    .name = "text",
    .help = "a letter",
    .size = sizeof(struct extrusion),
    .arguments = extrusion_fields,
    .solid = true,
    .prepare = extrusion_prepare,
    .bounds = extrusion_bounds,
    .intersect = extrusion_intersect,
    .crosses = extrusion_crosses,
    .first = extrusion_first,
    .lane_by_lane = true,
    .first_many = extrusion_first_many,
    .crosses_many = extrusion_crosses_many,
    .normal = extrusion_normal,
    .inside = extrusion_inside,
};
