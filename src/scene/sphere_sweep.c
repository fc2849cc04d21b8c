/* sphere_sweep: see sphere_sweep.h. The curve is cut into pieces so short that
 * the ball moves along each as good as straight on; what a piece passes is
 * convex, and the ray's stretches in all pieces joined are its way through the
 * whole. Their ends are then moved to the true surface. */
#include "scene/sphere_sweep.h"

#include "scene/box_tree.h"
#include "scene/polynomial.h"
#include "scene/sweep_lanes.h"

enum {
    SWEEP_PIECES = 500000, /* of one sweep, more or less */
    SWEEP_CUTS = 512,      /* of one segment */
    SWEEP_STRETCHES = 64,  /* of one ray, apart from each other */
    SWEEP_ROUNDS = 8,      /* of Newton's method */
};

/* The ball for s from 0 to 1 is the sum of s^i powers[i]. */
struct sweep_segment {
    struct ball powers[4];
};

struct sweep_piece {
    struct ball from, to;
    size_t segment;
    double s[2];
};

/* Neighbours, so that a ray meets them together. */
struct sweep_row {
    struct sweep_lanes lanes;
    size_t first, count;
};

static const struct field sphere_sweep_arguments[] = {
    { "kind", FIELD_INTEGER, offsetof(struct sphere_sweep, kind), 0, 0,
      "linear, cubic or b-spline" },
    { "balls", FIELD_TERMS, offsetof(struct sphere_sweep, balls), 0, 0,
      "middles and radii" },
    { NULL },
};

static const struct field sphere_sweep_items[] = {
    { "tolerance", FIELD_FLOAT, offsetof(struct sphere_sweep, tolerance), 0, 0,
      "accepted and needless" },
    { NULL },
};

static struct ball ball_sum(const struct ball *balls, const double *factors,
                            int count)
{
    struct ball sum = { { 0, 0, 0 }, 0 };
    for (int i = 0; i < count; i++) {
        sum.at = vec3_along(sum.at, balls[i].at, factors[i]);
        sum.radius += factors[i] * balls[i].radius;
    }
    return sum;
}

static struct ball segment_at(const struct sweep_segment *segment, double s)
{
    return ball_sum(segment->powers, (double[]){ 1, s, s * s, s * s * s }, 4);
}

static struct ball segment_slope(const struct sweep_segment *segment, double s)
{
    return ball_sum(segment->powers, (double[]){ 0, 1, 2 * s, 3 * s * s }, 4);
}

static struct ball segment_bend(const struct sweep_segment *segment, double s)
{
    return ball_sum(segment->powers, (double[]){ 0, 0, 2, 6 * s }, 4);
}

/* ---- preparation ---- */

/* Rows: what each ball gives to each power of s. */
static const double sweep_matrices[][4][4] = {
    [SWEEP_LINEAR] = { { 1, 0 }, { -1, 1 }, { 0 }, { 0 } },
    [SWEEP_CUBIC] = { { 0, 1, 0, 0 },
                      { -0.5, 0, 0.5, 0 },
                      { 1, -2.5, 2, -0.5 },
                      { -0.5, 1.5, -1.5, 0.5 } },
    [SWEEP_B_SPLINE] = { { 1 / 6.0, 4 / 6.0, 1 / 6.0, 0 },
                         { -0.5, 0, 0.5, 0 },
                         { 0.5, -1, 0.5, 0 },
                         { -1 / 6.0, 0.5, -0.5, 1 / 6.0 } },
};

static void segment_make(struct sphere_sweep *sweep, size_t number)
{
    int count = sweep->kind == SWEEP_LINEAR ? 2 : 4;
    struct ball balls[4];
    for (int i = 0; i < count; i++) {
        const double *v = sweep->balls.values + 4 * (number + (size_t)i);
        balls[i] = (struct ball){ { v[0], v[1], v[2] }, v[3] };
    }
    for (int power = 0; power < 4; power++)
        sweep->segments[number].powers[power] =
            ball_sum(balls, sweep_matrices[sweep->kind][power], count);
}

/* So many that the curve is nowhere far from its pieces: an arc is as high as
 * its second derivative times an eighth of its length's square. */
static size_t segment_cuts(const struct sweep_segment *segment, double extent,
                           size_t segments)
{
    double bend = 0,
           most = fmin(SWEEP_CUTS, (double)SWEEP_PIECES / (double)segments);
    for (int end = 0; end < 2; end++) {
        struct ball b = segment_bend(segment, end);
        bend = fmax(bend, vec3_length(b.at) + fabs(b.radius));
    }
    double cuts = ceil(sqrt(bend / (8 * 1e-5 * extent)));
    return (size_t)fmax(1, fmin(cuts, most));
}

static struct box3 ball_box(const struct ball *ball)
{
    vec3 r = { ball->radius, ball->radius, ball->radius };
    return (struct box3){ vec3_sub(ball->at, r), vec3_add(ball->at, r) };
}

static double sweep_extent(const struct sphere_sweep *sweep)
{
    struct box3 box = box3_empty();
    for (size_t i = 0; i < sweep->balls.count; i += 4) {
        const double *v = sweep->balls.values + i;
        struct ball ball = { { v[0], v[1], v[2] }, fabs(v[3]) };
        box = box3_union(box, ball_box(&ball));
    }
    return vec3_length(vec3_sub(box.high, box.low));
}

static void row_make(const struct sphere_sweep *sweep, size_t first,
                     size_t count, struct sweep_row *row, struct box3 *box)
{
    row->first = first;
    row->count = count;
    *box = box3_empty();
    for (size_t i = 0; i < OCTET; i++) {
        size_t number = first + (i < count ? i : 0);
        const struct sweep_piece *piece = &sweep->pieces[number];
        sweep_lanes_set(&row->lanes, i, &piece->from, &piece->to, number == 0);
        *box = box3_union(*box, ball_box(&piece->from));
        *box = box3_union(*box, ball_box(&piece->to));
    }
}

static void sweep_rows(struct sphere_sweep *sweep, struct arena *arena,
                       size_t pieces)
{
    size_t count = (pieces + OCTET - 1) / OCTET;
    struct box3 *boxes = ARENA_ARRAY(arena, struct box3, count);
    sweep->rows = ARENA_ARRAY(arena, struct sweep_row, count);
    sweep->bounds = box3_empty();
    for (size_t i = 0; i < count; i++) {
        size_t first = i * OCTET, rest = pieces - first;
        row_make(sweep, first, rest < OCTET ? rest : OCTET, &sweep->rows[i],
                 &boxes[i]);
        sweep->bounds = box3_union(sweep->bounds, boxes[i]);
    }
    sweep->tree = box_tree_new(arena, boxes, count);
}

static void sweep_cut(struct sphere_sweep *sweep, struct arena *arena,
                      size_t segments)
{
    double extent = sweep_extent(sweep);
    size_t count = 0, number = 0;
    for (size_t i = 0; i < segments; i++)
        count += segment_cuts(&sweep->segments[i], extent, segments);
    sweep->pieces = ARENA_ARRAY(arena, struct sweep_piece, count);
    for (size_t i = 0; i < segments; i++) {
        const struct sweep_segment *segment = &sweep->segments[i];
        size_t cuts = segment_cuts(segment, extent, segments);
        for (size_t k = 0; k < cuts; k++) {
            double a = (double)k / (double)cuts;
            double b = (double)(k + 1) / (double)cuts;
            struct sweep_piece piece = {
                segment_at(segment, a), segment_at(segment, b), i, { a, b }
            };
            piece.from.radius = fmax(piece.from.radius, 0);
            piece.to.radius = fmax(piece.to.radius, 0);
            sweep->pieces[number++] = piece;
        }
    }
    sweep_rows(sweep, arena, count);
}

static const char *sphere_sweep_prepare(void *shape, struct arena *arena,
                                        const char **warning)
{
    struct sphere_sweep *sweep = shape;
    size_t balls = sweep->balls.count / 4;
    size_t least = sweep->kind == SWEEP_LINEAR ? 2 : 4;
    (void)warning;
    if (balls < least)
        return sweep->kind == SWEEP_LINEAR
                   ? "it needs 2 balls at least"
                   : "a curved one needs 4 balls at least";
    size_t segments = balls - least + 1;
    sweep->segments = ARENA_ARRAY(arena, struct sweep_segment, segments);
    for (size_t i = 0; i < segments; i++)
        segment_make(sweep, i);
    sweep_cut(sweep, arena, segments);
    return box3_is_finite(sweep->bounds) ? NULL : "it reaches to infinity";
}

static struct box3 sphere_sweep_bounds(const void *shape)
{
    return ((const struct sphere_sweep *)shape)->bounds;
}

/* Around the balls that are named, those of cubic splines twice as large. */
static struct box3 sphere_sweep_told(const void *shape, const affine *place)
{
    const struct sphere_sweep *sweep = shape;
    const double(*m)[4] = place->m;
    struct box3 box = box3_empty();
    for (size_t i = 0; i < sweep->balls.count; i += 4) {
        const double *v = sweep->balls.values + i;
        double radius = fabs(v[3]) * (sweep->kind == SWEEP_CUBIC ? 2 : 1);
        vec3 at = affine_point(place, vec3_make(v[0], v[1], v[2]));
        vec3 r = { radius * hypot(hypot(m[0][0], m[0][1]), m[0][2]),
                   radius * hypot(hypot(m[1][0], m[1][1]), m[1][2]),
                   radius * hypot(hypot(m[2][0], m[2][1]), m[2][2]) };
        box =
            box3_union(box, (struct box3){ vec3_sub(at, r), vec3_add(at, r) });
    }
    return box;
}

/* ---- all pieces ---- */

struct stretch_end {
    double t;
    size_t piece;
};

struct stretch {
    struct stretch_end ends[2];
};

struct sweep_search {
    const struct sphere_sweep *sweep;
    const struct ray *ray;
    struct stretch stretches[SWEEP_STRETCHES]; /* apart, in order */
    int count;
};

static void stretch_join(struct stretch *to, const struct stretch *other)
{
    if (other->ends[0].t < to->ends[0].t)
        to->ends[0] = other->ends[0];
    if (other->ends[1].t > to->ends[1].t)
        to->ends[1] = other->ends[1];
}

/* Joins a stretch with those that it meets; true: there is no more room. */
static bool search_join(struct sweep_search *search, struct stretch one)
{
    struct stretch *all = search->stretches;
    int first = 0, kept;
    while (first < search->count && all[first].ends[1].t < one.ends[0].t)
        first++;
    for (kept = first;
         kept < search->count && all[kept].ends[0].t <= one.ends[1].t; kept++)
        stretch_join(&one, &all[kept]);
    int grown = search->count - (kept - first) + 1;
    if (grown > SWEEP_STRETCHES)
        return true;
    memmove(all + first + 1, all + kept,
            (size_t)(search->count - kept) * sizeof *all);
    all[first] = one;
    search->count = grown;
    return false;
}

/* Of neighbours, most meet each other. */
static bool search_row(void *context, size_t number)
{
    struct sweep_search *search = context;
    const struct sweep_row *row = &search->sweep->rows[number];
    struct sweep_stretches found;
    struct stretch joined;
    bool any = false;
    if (!sweep_lanes_meet(&row->lanes, search->ray, &found))
        return false;
    for (size_t i = 0; i < row->count; i++) {
        size_t piece = row->first + i;
        struct stretch one = { { { found.near[i], piece },
                                 { found.far[i], piece } } };
        if (!(found.near[i] < found.far[i]))
            continue;
        if (any && one.ends[0].t <= joined.ends[1].t &&
            joined.ends[0].t <= one.ends[1].t) {
            stretch_join(&joined, &one);
            continue;
        }
        if (any && search_join(search, joined))
            return true;
        joined = one;
        any = true;
    }
    return any && search_join(search, joined);
}

/* ---- the true surface ---- */

/* What of the ball at s is nearest to touching the point, by Newton's method on
 * (p - c) c' + r r' = 0. Where balls grow faster than they move, one of the
 * piece's ends has all the others within it. */
static double touch_share(const struct sweep_segment *segment,
                          const struct sweep_piece *piece, vec3 point, double s)
{
    for (int i = 0; i < SWEEP_ROUNDS; i++) {
        struct ball c = segment_at(segment, s), v = segment_slope(segment, s);
        struct ball a = segment_bend(segment, s);
        if (vec3_dot(v.at, v.at) <= v.radius * v.radius)
            return piece->s[v.radius > 0];
        vec3 w = vec3_sub(point, c.at);
        double f = vec3_dot(w, v.at) + c.radius * v.radius;
        double slope = vec3_dot(w, a.at) - vec3_dot(v.at, v.at) +
                       v.radius * v.radius + c.radius * a.radius;
        if (!(slope < 0))
            break;
        double next = fmin(fmax(s - f / slope, 0), 1);
        bool still = fabs(next - s) < 1e-12;
        s = next;
        if (still)
            break;
    }
    return s;
}

/* The end of a stretch where the ball that the ray touches there, and not the
 * piece, is met: by turns the ball and the ray's place on it. */
static double end_refine(const struct sphere_sweep *sweep,
                         const struct ray *ray, const struct stretch_end *end,
                         int side)
{
    const struct sweep_piece *piece = &sweep->pieces[end->piece];
    const struct sweep_segment *segment = &sweep->segments[piece->segment];
    double s = 0.5 * (piece->s[0] + piece->s[1]), t = end->t, roots[2];
    double dd = vec3_dot(ray->direction, ray->direction);
    double near = 0.01 * (piece->from.radius + piece->to.radius) / sqrt(dd);
    for (int i = 0; i < SWEEP_ROUNDS; i++) {
        s = touch_share(segment, piece, ray_point(ray, t), s);
        struct ball c = segment_at(segment, s);
        vec3 w = vec3_sub(ray_point(ray, end->t), c.at);
        if (quadratic_roots(dd, vec3_dot(w, ray->direction),
                            vec3_dot(w, w) - c.radius * c.radius, roots) != 2)
            return end->t;
        double next = end->t + roots[side];
        bool still = fabs(next - t) < 1e-9 * near;
        t = next;
        if (still)
            break;
    }
    return fabs(t - end->t) < near ? t : end->t;
}

static void sphere_sweep_intersect(const void *shape, const struct ray *ray,
                                   struct hits *hits)
{
    const struct sphere_sweep *sweep = shape;
    struct sweep_search search;
    double far = HUGE_VAL;
    search.sweep = sweep;
    search.ray = ray;
    search.count = 0;
    box_tree_ray(sweep->tree, ray, -HUGE_VAL, &far, search_row, &search);
    for (int i = 0; i < search.count; i++)
        for (int side = 0; side < 2; side++) {
            const struct stretch_end *end = &search.stretches[i].ends[side];
            double t = sweep->kind == SWEEP_LINEAR
                           ? end->t
                           : end_refine(sweep, ray, end, side);
            hits_add(hits, t, (int)end->piece);
        }
}

static vec3 sphere_sweep_normal(const void *shape, const vec3 *at,
                                const struct hit *hit)
{
    const vec3 point = *at;
    const struct sphere_sweep *sweep = shape;
    const struct sweep_piece *piece = &sweep->pieces[hit->part];
    const struct sweep_segment *segment = &sweep->segments[piece->segment];
    double s =
        touch_share(segment, piece, point, 0.5 * (piece->s[0] + piece->s[1]));
    vec3 normal = vec3_sub(point, segment_at(segment, s).at);
    return vec3_dot(normal, normal) > 0 ? normal : vec3_make(0, 1, 0);
}

/* ---- places ---- */

/* |p - c(s)|^2 - r(s)^2 at its least. */
static double piece_depth(const struct sweep_piece *piece, vec3 point)
{
    vec3 axis = vec3_sub(piece->to.at, piece->from.at);
    vec3 w = vec3_sub(point, piece->from.at);
    double growth = piece->to.radius - piece->from.radius;
    double a = vec3_dot(axis, axis) - growth * growth;
    double along = vec3_dot(w, axis) + piece->from.radius * growth;
    double s = a > 0 ? fmin(fmax(along / a, 0), 1) : growth > 0;
    double radius = piece->from.radius + s * growth;
    w = vec3_along(w, axis, -s);
    return vec3_dot(w, w) - radius * radius;
}

struct place_search {
    const struct sphere_sweep *sweep;
    vec3 point;
    bool inside;
};

static bool place_visit(void *context, size_t number)
{
    struct place_search *search = context;
    const struct sweep_row *row = &search->sweep->rows[number];
    const struct sweep_piece *pieces = search->sweep->pieces + row->first;
    for (size_t i = 0; i < row->count && !search->inside; i++)
        search->inside = piece_depth(&pieces[i], search->point) < 0;
    return search->inside;
}

static bool sphere_sweep_inside(const void *shape, vec3 point)
{
    const struct sphere_sweep *sweep = shape;
    struct place_search search = { sweep, point, false };
    box_tree_box(sweep->tree, (struct box3){ point, point }, place_visit,
                 &search);
    return search.inside;
}

struct cell_search {
    const struct sphere_sweep *sweep;
    const struct cell *cell;
    bool met, within; /* some piece; altogether in one */
};

static bool cell_takes(struct cell_search *search,
                       const struct sweep_piece *piece)
{
    vec3 axis = vec3_sub(piece->to.at, piece->from.at);
    vec3 w = vec3_sub(search->cell->centre, piece->from.at);
    double length2 = vec3_dot(axis, axis);
    double s = length2 > 0 ? fmin(fmax(vec3_dot(w, axis) / length2, 0), 1) : 0;
    double distance = vec3_length(vec3_along(w, axis, -s));
    double least = fmin(piece->from.radius, piece->to.radius);
    double most = fmax(piece->from.radius, piece->to.radius);
    search->met |= distance - most <= search->cell->radius;
    search->within = distance + search->cell->radius < 0.999 * least;
    return search->within;
}

static bool cell_visit(void *context, size_t number)
{
    struct cell_search *search = context;
    const struct sweep_row *row = &search->sweep->rows[number];
    for (size_t i = 0; i < row->count; i++)
        if (cell_takes(search, &search->sweep->pieces[row->first + i]))
            return true;
    return false;
}

static unsigned sphere_sweep_meets(const void *shape, const struct cell *cell)
{
    const struct sphere_sweep *sweep = shape;
    struct cell_search search = { sweep, cell, false, false };
    box_tree_box(sweep->tree, cell_box(cell), cell_visit, &search);
    return search.met && !search.within ? CELL_SURFACE | CELL_BORDER : 0;
}

const struct primitive sphere_sweep_primitive = {
    .name = "sphere_sweep",
    .help = "what a ball passes that moves along a curve",
    .size = sizeof(struct sphere_sweep),
    .arguments = sphere_sweep_arguments,
    .items = sphere_sweep_items,
    .solid = true,
    .prepare = sphere_sweep_prepare,
    .bounds = sphere_sweep_bounds,
    .told = sphere_sweep_told,
    .intersect = sphere_sweep_intersect,
    .normal = sphere_sweep_normal,
    .inside = sphere_sweep_inside,
    .meets = sphere_sweep_meets,
};
