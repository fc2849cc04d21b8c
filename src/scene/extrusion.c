/* Outlines with a thickness: see extrusion.h. u and v are the outline's
 * coordinates, w runs along the axis. */
#include "scene/extrusion.h"

#include "base/clones.h"
#include "scene/hit_search.h"
#include "scene/slab.h"

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

/* The box is a little larger, as rays along its sides are not told to be in it.
 */
static void extrusion_surround(struct extrusion *e)
{
    const struct box3 box = extrusion_bounds(e);
    double wide = fabs(box.low.x) + fabs(box.high.x) + fabs(box.low.y) +
                  fabs(box.high.y) + fabs(box.low.z) + fabs(box.high.z);
    const vec3 rim = vec3_make(1e-9 * wide, 1e-9 * wide, 1e-9 * wide);
    const double *low = e->outline.low, *high = e->outline.high;
    e->around.low = extrusion_turned(e, vec3_sub(box.low, rim));
    e->around.high = extrusion_turned(e, vec3_add(box.high, rim));
    e->margin =
        1e-9 * (fabs(low[0]) + fabs(low[1]) + fabs(high[0]) + fabs(high[1]));
    e->tipped = e->conic && !(e->low > 1e-6 * wide || e->high < -1e-6 * wide);
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
    else
        extrusion_surround(e);
    return NULL;
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

/* Where a ray from o along d may meet the shape between tmin and tmax: what of
 * the outline's plane it comes over, seen from the tip of a cone. Widened by
 * what rounding may be. */
INLINED struct rectangle ground_of(const struct box3 *around, double margin,
                                   bool conic, vec3 o, vec3 d, double tmin,
                                   double tmax)
{
    const struct slabs slabs = slabs_of(&(struct ray){ o, d });
    slabs_clip(&slabs, around, &tmin, &tmax);
    double near = conic ? 1 / (o.z + tmin * d.z) : 1;
    double far = conic ? 1 / (o.z + tmax * d.z) : 1;
    double first[2] = { (o.x + tmin * d.x) * near, (o.y + tmin * d.y) * near };
    double last[2] = { (o.x + tmax * d.x) * far, (o.y + tmax * d.y) * far };
    double size =
        fabs(first[0]) + fabs(first[1]) + fabs(last[0]) + fabs(last[1]);
    double from = fabs(o.x) + fabs(o.y) + (conic ? fabs(o.z) * size : 0);
    double scale = conic ? greater(fabs(near), fabs(far)) : 1;
    double more = margin + 1e-15 * (scale * from + size);
    /* No rectangle where the box is not met. */
    double none = tmin <= tmax ? 0 : HUGE_VAL;
    struct rectangle ground;
    for (int k = 0; k < 2; k++) {
        ground.low[k] = lesser(first[k], last[k]) - more + none;
        ground.high[k] = greater(first[k], last[k]) + more - none;
    }
    return ground;
}

static struct rectangle ray_ground(const struct extrusion *e,
                                   const struct ray *ray, double tmin,
                                   double tmax)
{
    if (e->tipped)
        return (struct rectangle){ { -HUGE_VAL, -HUGE_VAL },
                                   { HUGE_VAL, HUGE_VAL } };
    return ground_of(&e->around, e->margin, e->conic, ray->origin,
                     ray->direction, tmin, tmax);
}

static inline void search_side(struct extrusion_search *search, size_t index)
{
    outline_cross(&search->extrusion->outline, (int)index, search->line,
                  side_found, search);
}

static void search_sides(struct extrusion_search *search)
{
    const struct extrusion *e = search->extrusion;
    const struct rectangle ground =
        ray_ground(e, &search->ray, search->hits.tmin, search->hits.tmax);
    for (size_t i = 0; i < e->outline.count; i++) {
        if (search->any && search->hits.found)
            return;
        if (rectangle_has(&ground, &e->outline.pieces[i]))
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
    struct outline_lines lines; /* and grounds */
    struct extrusion_search search[RAY_LANES];
    unsigned open; /* those that look for something still */
};

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
    lanes->rays = *rays;
    lanes->span = *span;
    lanes->open = 0;
    for (int i = 0; i < RAY_LANES; i++) {
        struct extrusion_search *search = &lanes->search[i];
        if (!(span->near[i] < span->far[i])) {
            search->hits.found = false;
            continue;
        }
        const struct ray ray = rays_at(rays, i);
        extrusion_search_start(search, e, &ray, span->near[i], span->far[i]);
        search->any = any;
        rays_set(&lanes->rays, i, search->ray.origin, search->ray.direction);
        for (int k = 0; k < 3; k++)
            lanes->lines.line[k][i] = search->line[k];
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

INLINED void ground_put(struct outline_lines *lines, int i,
                        struct rectangle ground)
{
    for (int k = 0; k < 2; k++) {
        lines->low[k][i] = ground.low[k];
        lines->high[k][i] = ground.high[k];
    }
}

/* What an open one comes over where it looks. */
static void lane_ground(struct extrusion_lanes *lanes,
                        const struct extrusion *e, int i)
{
    ground_put(&lanes->lines, i,
               ray_ground(e, &lanes->search[i].ray, lanes->span.near[i],
                          lanes->span.far[i]));
}

INLINED void grounds_find(struct extrusion_lanes *restrict lanes,
                          const struct extrusion *restrict e, bool conic)
{
    const struct box3 around = e->around;
    const double margin = e->margin;
    for (int i = 0; i < RAY_LANES; i++)
        ground_put(&lanes->lines, i,
                   ground_of(&around, margin, conic,
                             rays_origin(&lanes->rays, i),
                             rays_direction(&lanes->rays, i),
                             lanes->span.near[i], lanes->span.far[i]));
}

/* What all of them come over; of those that look for nothing whatever it is. */
CLONES static void lanes_grounds(struct extrusion_lanes *restrict lanes,
                                 const struct extrusion *restrict e)
{
    if (e->conic)
        grounds_find(lanes, e, true);
    else
        grounds_find(lanes, e, false);
}

/* What they come over all together. */
static struct rectangle lanes_ground(struct extrusion_lanes *lanes,
                                     const struct extrusion *e)
{
    struct rectangle all = { { HUGE_VAL, HUGE_VAL }, { -HUGE_VAL, -HUGE_VAL } };
    if (e->tipped)
        for (unsigned left = lanes->open; left; left &= left - 1)
            lane_ground(lanes, e, __builtin_ctz(left));
    else
        lanes_grounds(lanes, e);
    for (unsigned left = lanes->open; left; left &= left - 1) {
        int i = __builtin_ctz(left);
        for (int k = 0; k < 2; k++) {
            all.low[k] = lesser(all.low[k], lanes->lines.low[k][i]);
            all.high[k] = greater(all.high[k], lanes->lines.high[k][i]);
        }
    }
    return all;
}

/* As search_sides, but side after side, each for all of them. */
static void lanes_sides(struct extrusion_lanes *lanes,
                        const struct extrusion *e)
{
    const struct rectangle ground = lanes_ground(lanes, e);
    for (size_t k = 0; k < e->outline.count && lanes->open; k++) {
        const struct piece *piece = &e->outline.pieces[k];
        LANE_LINES lane_flag met[RAY_LANES];
        if (!rectangle_has(&ground, piece))
            continue;
        outline_crosses_many(piece, &lanes->lines, met);
        for (unsigned left = lanes->open & rays_bits(met); left;
             left &= left - 1) {
            int i = __builtin_ctz(left);
            struct extrusion_search *search = &lanes->search[i];
            search_side(search, k);
            if (!search->hits.found || lanes->span.far[i] == search->hits.tmax)
                continue;
            lanes->span.far[i] = search->hits.tmax;
            if (search->any)
                lanes->open &= ~(1u << i);
            else
                lane_ground(lanes, e, i);
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

/* A letter that reaches to the left of where it begins is taken for as much
 * longer to the right. */
static struct box3 text_told(const void *shape, const affine *place)
{
    struct box3 box = extrusion_bounds(shape);
    box.high.x -= lesser(box.low.x, 0);
    return affine_box(place, box);
}

const struct primitive text_primitive = {
    .name = "text",
    .help = "a letter",
    .size = sizeof(struct extrusion),
    .arguments = extrusion_fields,
    .solid = true,
    .prepare = extrusion_prepare,
    .bounds = extrusion_bounds,
    .told = text_told,
    .intersect = extrusion_intersect,
    .crosses = extrusion_crosses,
    .first = extrusion_first,
    .lane_by_lane = true,
    .first_many = extrusion_first_many,
    .crosses_many = extrusion_crosses_many,
    .normal = extrusion_normal,
    .inside = extrusion_inside,
};
