/* Curves turned around the y axis: see revolution.h. */
#include "scene/revolution.h"

#include "base/lesser.h"
#include "scene/hit_search.h"
#include "scene/polynomial.h"

static const struct field revolution_fields[] = {
    { "segments", FIELD_TERMS, offsetof(struct revolution, segments), 0, 0,
      "the curve", false },
    { "bezier_spline", FIELD_FLAG, offsetof(struct revolution, bezier), 0, 0,
      "its control points are around it", false },
    { .name = NULL },
};

static const struct field revolution_items[] = {
    { "sturm", FIELD_BOOL, offsetof(struct revolution, sturm), 0, 0,
      "accepted and needless", false },
    { .name = NULL },
};

static const struct segment *revolution_segments(const struct revolution *r)
{
    return (const struct segment *)(const void *)r->segments.values;
}

static size_t revolution_count(const struct revolution *r)
{
    return r->segments.count / SEGMENT_NUMBERS;
}

/* What POV-Ray takes for the box around the curve (measured): of Bezier curves
 * that of their control points. */
static struct rectangle revolution_around(const struct revolution *r)
{
    const struct outline *outline = &r->outline;
    struct rectangle around = { { outline->low[0], outline->low[1] },
                                { outline->high[0], outline->high[1] } };
    for (size_t i = 0; r->bezier && i < revolution_count(r); i++)
        for (int k = 0; k < 2; k++) {
            around.low[k] = lesser(around.low[k], r->boxes[i].low[k]);
            around.high[k] = greater(around.high[k], r->boxes[i].high[k]);
        }
    return around;
}

const char *revolution_prepare(void *shape, struct arena *arena,
                               const char **warning)
{
    struct revolution *r = shape;
    size_t count = revolution_count(r);
    r->outline =
        outline_of_numbers(arena, r->segments.values, r->segments.count);
    r->boxes = ARENA_ARRAY(arena, struct rectangle, count);
    for (size_t i = 0; i < count; i++)
        r->boxes[i] = segment_box(&revolution_segments(r)[i]);
    r->around = revolution_around(r);
    if (r->outline.count == 0)
        *warning = "its curve has no length";
    return NULL;
}

static double revolution_radius(const struct revolution *r)
{
    return fmax(fabs(r->outline.low[0]), fabs(r->outline.high[0]));
}

static struct box3 revolution_bounds(const void *shape)
{
    const struct revolution *r = shape;
    double radius = revolution_radius(r);
    return (struct box3){ { -radius, r->outline.low[1], -radius },
                          { radius, r->outline.high[1], radius } };
}

static struct box3 revolution_told(const void *shape, const affine *place)
{
    const struct revolution *r = shape;
    const struct rectangle *around = &r->around;
    double radius = greater(fabs(around->low[0]), fabs(around->high[0]));
    return affine_box(place,
                      (struct box3){ { -radius, around->low[1], -radius },
                                     { radius, around->high[1], radius } });
}

/* Inside is what has an odd number of curves farther from the axis. But a
 * curve that is open leaves a hole: nothing that is nearer to the axis than
 * the box around it is inside (measured). */
static bool revolution_inside(const void *shape, vec3 point)
{
    const struct revolution *r = shape;
    double radius = hypot(point.x, point.z);
    return radius >= r->around.low[0] &&
           outline_covers(&r->outline, radius, point.y);
}

/* What of the ray the curves need: x^2 + z^2 = a t^2 + 2 b t + c. */
struct spin {
    const struct ray *ray;
    double a, b, c;
    struct hit_search hits;
    bool any; /* whichever crossing is found first is enough */
};

static void spin_add(struct spin *spin, int part, double s, double t)
{
    hit_search_take(&spin->hits, (struct hit){ t, part, s, 0 });
}

/* The ray is level: it meets the curve where that has its height, twice. */
static void spin_level(struct spin *spin, const struct piece *piece, int part)
{
    const double *y = piece->curve.y;
    double c[4] = { y[0] - spin->ray->origin.y, y[1], y[2], y[3] };
    double roots[3], at[2], t[2];
    int count = polynomial_roots(c, 3, 0, 1, roots, 3);
    for (int i = 0; i < count; i++) {
        segment_point(&piece->curve, roots[i], at);
        int found =
            quadratic_roots(spin->a, spin->b, spin->c - at[0] * at[0], t);
        for (int k = 0; k < found; k++)
            spin_add(spin, part, roots[i], t[k]);
    }
}

static void multiply(const double a[4], const double b[4], double scale,
                     double sum[7])
{
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 4; k++)
            sum[i + k] += scale * a[i] * b[k];
}

/* The slope of a ray below which its height says little of where it is. */
static const double spin_flat = 1e-4;

/* Of two t at which the ray is as far from the axis as the curve, the one at
 * which it is as high, too. Near level rays the height alone says little. */
static double spin_place(const struct spin *spin, double radius, double t)
{
    double roots[2];
    int count =
        quadratic_roots(spin->a, spin->b, spin->c - radius * radius, roots);
    double slope = spin->ray->direction.y;
    if (count == 0 || slope * slope > spin_flat * spin->a)
        return t;
    return count == 1 || fabs(roots[0] - t) < fabs(roots[1] - t) ? roots[0]
                                                                 : roots[1];
}

/* Whether the ray is looked at all the while it is as high as the piece: then
 * each crossing counts, wherever it is. */
static bool spin_counts(const struct spin *spin, const struct piece *piece)
{
    double dy = spin->ray->direction.y, oy = spin->ray->origin.y;
    double low = (piece->low[1] - oy) / dy, high = (piece->high[1] - oy) / dy;
    double margin = 1e-9 * (fabs(low) + fabs(high));
    return dy * dy > spin_flat * spin->a &&
           lesser(low, high) - margin > spin->hits.tmin &&
           greater(low, high) + margin < spin->hits.tmax;
}

/* With h = y(s) - oy the ray is at this height at t = h / dy, and there as far
 * from the axis as the curve if c dy^2 + 2 b dy h + a h^2 - dy^2 x(s)^2 = 0. */
static void spin_piece(struct spin *spin, const struct piece *piece, int part)
{
    const struct segment *curve = &piece->curve;
    double dy = spin->ray->direction.y, dy2 = dy * dy;
    double h[4] = { curve->y[0] - spin->ray->origin.y, curve->y[1], curve->y[2],
                    curve->y[3] };
    double p[7] = { spin->c * dy2 }, roots[6], at[2];
    for (int i = 0; i < 4; i++)
        p[i] += 2 * spin->b * dy * h[i];
    multiply(h, h, spin->a, p);
    multiply(curve->x, curve->x, -dy2, p);
    int degree = 6;
    while (degree > 1 && p[degree] == 0)
        degree--;
    if (spin->any && spin_counts(spin, piece)) {
        spin->hits.found = polynomial_crosses(p, degree, 0, 1);
        return;
    }
    int count = polynomial_roots(p, degree, 0, 1, roots, 6);
    for (int i = 0; i < count; i++) {
        segment_point(curve, roots[i], at);
        double t = (at[1] - spin->ray->origin.y) / dy;
        spin_add(spin, part, roots[i], spin_place(spin, at[0], t));
    }
}

/* Whether a ray from the height `oy` is nearer to the axis than the piece
 * reaches while it is as high as the piece, and where it is looked for. */
static inline bool piece_is_met(const struct piece *piece, double oy, double dy,
                                const double abc[3], double tmin, double tmax)
{
    double low = (piece->low[1] - oy) / dy, high = (piece->high[1] - oy) / dy;
    double enter = lesser(low, high), leave = greater(low, high);
    double margin = 1e-9 * (fabs(enter) + fabs(leave));
    bool beyond = (leave + margin < tmin) | (enter - margin > tmax);
    double t = greater(enter, lesser(-abc[1] / abc[0], leave));
    double radius = greater(fabs(piece->low[0]), fabs(piece->high[0]));
    double nearest = (abc[0] * t + 2 * abc[1]) * t + abc[2];
    return !((dy * dy > spin_flat * abc[0]) & beyond) &
           !(nearest > radius * radius * (1 + 1e-9) + 1e-12);
}

static struct spin spin_new(const struct ray *ray, double tmin, double tmax)
{
    vec3 o = ray->origin, d = ray->direction;
    return (struct spin){
        .ray = ray,
        .a = d.x * d.x + d.z * d.z,
        .b = o.x * d.x + o.z * d.z,
        .c = o.x * o.x + o.z * o.z,
        .hits = { .tmin = tmin, .tmax = tmax },
    };
}

static inline bool spin_is_level(double a, double dy)
{
    return dy * dy < 1e-16 * a;
}

static void spin_all(struct spin *spin, const struct revolution *r)
{
    const double abc[3] = { spin->a, spin->b, spin->c };
    double oy = spin->ray->origin.y, dy = spin->ray->direction.y;
    bool level = spin_is_level(spin->a, dy);
    for (size_t i = 0; i < r->outline.count; i++) {
        const struct piece *piece = &r->outline.pieces[i];
        if (spin->any && spin->hits.found)
            return;
        if (level)
            spin_level(spin, piece, (int)i);
        else if (piece_is_met(piece, oy, dy, abc, spin->hits.tmin,
                              spin->hits.tmax))
            spin_piece(spin, piece, (int)i);
    }
}

static void revolution_intersect(const void *shape, const struct ray *ray,
                                 struct hits *hits)
{
    struct spin spin = spin_new(ray, -HUGE_VAL, HUGE_VAL);
    spin.hits.all = hits;
    spin_all(&spin, shape);
}

static bool revolution_first(const void *shape, const struct ray *ray,
                             double tmin, double tmax, struct hit *hit)
{
    struct spin spin = spin_new(ray, tmin, tmax);
    spin_all(&spin, shape);
    *hit = spin.hits.first;
    return spin.hits.found;
}

static bool revolution_crosses(const void *shape, const struct ray *ray,
                               double tmin, double tmax)
{
    struct spin spin = spin_new(ray, tmin, tmax);
    spin.any = true;
    spin_all(&spin, shape);
    return spin.hits.found;
}

/* Rays side by side. Most meet no piece's surroundings: only those that do look
 * for themselves. */
struct spin_lanes {
    const struct rays *rays;
    struct rays_span span; /* `far` is where the nearest crossing is */
    LANE_LINES double a[RAY_LANES], b[RAY_LANES], c[RAY_LANES];
    struct ray ray[RAY_LANES];
    struct spin spin[RAY_LANES];
    unsigned open;  /* those that look for something still */
    unsigned level; /* those that are */
    unsigned begun; /* those that have looked */
    bool any;       /* whichever crossing is found first is enough */
};

CLONES static void lanes_squares(struct spin_lanes *restrict lanes,
                                 lane_flag *restrict open,
                                 lane_flag *restrict level)
{
    for (int i = 0; i < RAY_LANES; i++) {
        vec3 o = rays_origin(lanes->rays, i),
             d = rays_direction(lanes->rays, i);
        double a = d.x * d.x + d.z * d.z;
        lanes->a[i] = a;
        lanes->b[i] = o.x * d.x + o.z * d.z;
        lanes->c[i] = o.x * o.x + o.z * o.z;
        open[i] = lanes->span.near[i] < lanes->span.far[i] ? -1 : 0;
        level[i] = spin_is_level(a, d.y) ? -1 : 0;
    }
}

static void lanes_begin(struct spin_lanes *lanes, const struct rays *rays,
                        const struct rays_span *span, bool any)
{
    LANE_LINES lane_flag open[RAY_LANES], level[RAY_LANES];
    lanes->rays = rays;
    lanes->span = *span;
    lanes->begun = 0;
    lanes->any = any;
    lanes_squares(lanes, open, level);
    lanes->open = rays_bits(open);
    lanes->level = rays_bits(level);
}

/* The search of a lane, which begins when it is asked for. */
static struct spin *lane_spin(struct spin_lanes *lanes, unsigned i)
{
    struct spin *spin = &lanes->spin[i];
    if (lanes->begun >> i & 1)
        return spin;
    lanes->begun |= 1u << i;
    lanes->ray[i] = rays_at(lanes->rays, (int)i);
    spin->ray = &lanes->ray[i];
    spin->a = lanes->a[i];
    spin->b = lanes->b[i];
    spin->c = lanes->c[i];
    spin->any = lanes->any;
    spin->hits = (struct hit_search){ .tmin = lanes->span.near[i],
                                      .tmax = lanes->span.far[i] };
    return spin;
}

CLONES static void lanes_meet(const struct spin_lanes *restrict lanes,
                              const struct piece *piece,
                              lane_flag *restrict met)
{
    const struct piece of = *piece;
    for (int i = 0; i < RAY_LANES; i++) {
        const double abc[3] = { lanes->a[i], lanes->b[i], lanes->c[i] };
        bool is = piece_is_met(&of, lanes->rays->origin[1][i],
                               lanes->rays->direction[1][i], abc,
                               lanes->span.near[i], lanes->span.far[i]);
        met[i] = is ? -1 : 0;
    }
}

/* As spin_all, but piece after piece, each for all of them. */
static void lanes_all(struct spin_lanes *lanes, const struct revolution *r)
{
    for (size_t k = 0; k < r->outline.count && lanes->open; k++) {
        const struct piece *piece = &r->outline.pieces[k];
        LANE_LINES lane_flag flags[RAY_LANES];
        lanes_meet(lanes, piece, flags);
        unsigned met = (rays_bits(flags) | lanes->level) & lanes->open;
        for (; met; met &= met - 1) {
            unsigned i = (unsigned)__builtin_ctz(met);
            struct spin *spin = lane_spin(lanes, i);
            if (lanes->level >> i & 1)
                spin_level(spin, piece, (int)k);
            else
                spin_piece(spin, piece, (int)k);
            lanes->span.far[i] = spin->hits.tmax;
            if (lanes->any && spin->hits.found)
                lanes->open &= ~(1u << i);
        }
    }
}

static void revolution_first_many(const void *shape, struct lane_run run,
                                  const struct rays *rays,
                                  const struct rays_span *span,
                                  struct rays_met *met)
{
    const struct hit_search none = { .found = false };
    struct spin_lanes lanes;
    lanes_begin(&lanes, rays, span, false);
    lanes_all(&lanes, shape);
    for (int i = run.first; i < run.end; i++)
        rays_met_take(met, i,
                      lanes.begun >> i & 1 ? &lanes.spin[i].hits : &none);
}

static void revolution_crosses_many(const void *shape, struct lane_run run,
                                    const struct rays *rays,
                                    const struct rays_span *span,
                                    lane_flag *met)
{
    struct spin_lanes lanes;
    lanes_begin(&lanes, rays, span, true);
    lanes_all(&lanes, shape);
    for (int i = run.first; i < run.end; i++)
        met[i] = lanes.begun >> i & 1 && lanes.spin[i].hits.found ? -1 : 0;
}

static vec3 revolution_normal(const void *shape, const vec3 *at,
                              const struct hit *hit)
{
    const vec3 point = *at;
    const struct revolution *r = shape;
    const struct piece *piece = &r->outline.pieces[hit->part];
    double along[2], radius = hypot(point.x, point.z);
    segment_tangent(&piece->curve, hit->u, along);
    double out = piece->outward * along[1];
    double up = -piece->outward * along[0];
    if (!(radius > 0))
        return (vec3){ 0, up, 0 };
    return (vec3){ out * point.x / radius, up, out * point.z / radius };
}

/* How far the curve is from a point at s, squared. */
static double segment_away(const struct segment *segment, double s,
                           const double p[2])
{
    double at[2];
    segment_point(segment, s, at);
    double x = at[0] - p[0], y = at[1] - p[1];
    return x * x + y * y;
}

/* Half of how fast that changes with s. */
static double segment_parts(const struct segment *segment, double s,
                            const double p[2])
{
    double at[2], along[2];
    segment_point(segment, s, at);
    segment_tangent(segment, s, along);
    return (at[0] - p[0]) * along[0] + (at[1] - p[1]) * along[1];
}

/* Where between low and high the curve neither comes nearer nor goes away, by
 * regula falsi, of which the end that stays counts half as much each time; an
 * end, if it only does one of the two. */
static double segment_foot(const struct segment *segment, double low,
                           double high, const double p[2])
{
    enum { STEPS = 40 };
    double nearer = segment_parts(segment, low, p);
    double farther = segment_parts(segment, high, p);
    if (!(nearer < 0 && farther > 0))
        return nearer < 0 ? high : low;
    double s = low, last = high;
    int stays = 0;
    for (int i = 0; i < STEPS && fabs(s - last) > 1e-14; i++) {
        last = s;
        s = low + (high - low) * (nearer / (nearer - farther));
        double parts = segment_parts(segment, s, p);
        if (parts < 0) {
            low = s;
            nearer = parts;
            farther *= stays > 0 ? 0.5 : 1;
            stays = 1;
        } else {
            high = s;
            farther = parts;
            nearer *= stays < 0 ? 0.5 : 1;
            stays = -1;
        }
    }
    return s;
}

/* The nearest place of a segment: of a few tried, and then between its
 * neighbours. */
static double segment_nearest(const struct segment *segment, const double p[2])
{
    enum { TRIES = 32 };
    double best = 0, least = segment_away(segment, 0, p);
    for (int i = 1; i <= TRIES; i++) {
        double s = (double)i / TRIES, away = segment_away(segment, s, p);
        if (away < least) {
            least = away;
            best = s;
        }
    }
    return segment_foot(segment, fmax(0, best - 1.0 / TRIES),
                        fmin(1, best + 1.0 / TRIES), p);
}

/* How far a box is from a point, squared. */
static double rectangle_away(const struct rectangle *box, const double p[2])
{
    double x = greater(greater(box->low[0] - p[0], p[0] - box->high[0]), 0);
    double y = greater(greater(box->low[1] - p[1], p[1] - box->high[1]), 0);
    return x * x + y * y;
}

/* The place of a curve that is nearest to a point: of those as near the first
 * one. */
struct nearest {
    double away, s;
    size_t segment;
};

static void nearest_take(const struct revolution *r, size_t i,
                         const double p[2], struct nearest *nearest)
{
    const struct segment *segment = &revolution_segments(r)[i];
    double s = segment_nearest(segment, p);
    double away = segment_away(segment, s, p);
    if (away < nearest->away || (away == nearest->away && i < nearest->segment))
        *nearest = (struct nearest){ away, s, i };
}

/* Searches the segment whose box is nearest, and then what others may have
 * something as near. */
static struct nearest revolution_nearest(const struct revolution *r,
                                         const double p[2])
{
    struct nearest nearest = { .away = HUGE_VAL };
    size_t count = revolution_count(r), first = 0;
    double least = HUGE_VAL;
    for (size_t i = 0; i < count && least > 0; i++) {
        double away = rectangle_away(&r->boxes[i], p);
        if (away < least) {
            least = away;
            first = i;
        }
    }
    nearest_take(r, first, p, &nearest);
    for (size_t i = 0; i < count; i++)
        if (i != first && rectangle_away(&r->boxes[i], p) <= nearest.away)
            nearest_take(r, i, p, &nearest);
    return nearest;
}

/* Along the curve each segment is as long as the others (measured). */
static void revolution_uv(const void *shape, vec3 point, double uv[2])
{
    const struct revolution *r = shape;
    const double p[2] = { hypot(point.x, point.z), point.y };
    uv[0] = ray_turn(point.x, point.z);
    uv[1] = 0;
    if (revolution_count(r) > 0) {
        struct nearest nearest = revolution_nearest(r, p);
        uv[1] =
            ((double)nearest.segment + nearest.s) / (double)revolution_count(r);
    }
}

const struct primitive lathe_primitive = {
    .name = "lathe",
    .help = "a curve turned around y",
    .size = sizeof(struct revolution),
    .arguments = revolution_fields,
    .items = revolution_items,
    .solid = true,
    .alike = true,
    .prepare = revolution_prepare,
    .bounds = revolution_bounds,
    .told = revolution_told,
    .intersect = revolution_intersect,
    .crosses = revolution_crosses,
    .first = revolution_first,
    .lane_by_lane = true,
    .first_many = revolution_first_many,
    .crosses_many = revolution_crosses_many,
    .normal = revolution_normal,
    .uv = revolution_uv,
    .inside = revolution_inside,
};
