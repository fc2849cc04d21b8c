/* prism and lathe: shapes made of curves through points in a plane. */
#include "base/hash.h"
#include "parse/rules.h"
#include "scene/extrusion.h"
#include "scene/revolution.h"

enum curve { CURVE_LINEAR, CURVE_QUADRATIC, CURVE_CUBIC, CURVE_BEZIER };

static const struct field curve_points[] = {
    { "points", FIELD_POINTS2, 0, 0, 0, "how many points, then the points" },
    { .name = NULL },
};

struct curve_builder {
    enum curve curve;
    struct span span; /* of the points, for errors */
    struct points points;
    struct {
        struct segment *items;
        size_t count, capacity;
    } segments;
};

/* curve = "linear_spline" | "quadratic_spline" | "cubic_spline"
 *       | "bezier_spline" . */
static bool parse_curve(struct parser *p, enum curve *curve)
{
    static const enum keyword keywords[] = {
        [CURVE_LINEAR] = KEYWORD_LINEAR_SPLINE,
        [CURVE_QUADRATIC] = KEYWORD_QUADRATIC_SPLINE,
        [CURVE_CUBIC] = KEYWORD_CUBIC_SPLINE,
        [CURVE_BEZIER] = KEYWORD_BEZIER_SPLINE,
    };
    for (int i = CURVE_LINEAR; i <= CURVE_BEZIER; i++)
        if (accept_keyword(p, keywords[i])) {
            *curve = (enum curve)i;
            return true;
        }
    return false;
}

static bool parse_curve_points(struct parser *p, struct curve_builder *b)
{
    struct span start = stream_span(p);
    bool ok = parse_field(p, curve_points, &b->points);
    b->span = span_join(start, p->last_span);
    return ok;
}

/* From point i on, as far as the curve's kind looks. */
static void curve_add(struct parser *p, struct curve_builder *b, size_t i)
{
    double at[4][2];
    struct segment segment;
    for (size_t k = 0; k < 4 && i + k < b->points.count; k++) {
        at[k][0] = b->points.items[i + k].x;
        at[k][1] = b->points.items[i + k].y;
    }
    switch (b->curve) {
    case CURVE_LINEAR:
        segment = segment_line(at[0], at[1]);
        break;
    case CURVE_QUADRATIC:
        segment = segment_parabola(at[0], at[1], at[2]);
        break;
    case CURVE_CUBIC:
        segment = segment_spline(at[0], at[1], at[2], at[3]);
        break;
    default:
        segment = segment_cubic(at[0], at[1], at[2], at[3]);
        break;
    }
    *ARRAY_PUSH(p->scene_arena, &b->segments) = segment;
}

/* How many points a piece of the curve needs; the one it begins at. */
static size_t curve_reach(enum curve curve)
{
    return curve == CURVE_LINEAR ? 2 : curve == CURVE_QUADRATIC ? 3 : 4;
}

static size_t curve_start(enum curve curve)
{
    return curve == CURVE_QUADRATIC || curve == CURVE_CUBIC ? 1 : 0;
}

/* How many points an outline needs: a Bezier piece may close itself. */
static size_t curve_closes(enum curve curve)
{
    return curve_reach(curve) + (curve == CURVE_BEZIER ? 0 : 1);
}

static bool curve_check(struct parser *p, const struct curve_builder *b,
                        size_t least)
{
    if (b->points.count < least)
        return error_at(p, b->span, NULL,
                        "this curve needs at least %zu points, found %zu",
                        least, b->points.count);
    return b->curve != CURVE_BEZIER || b->points.count % 4 == 0 ||
           error_at(p, b->span, NULL,
                    "a bezier_spline has 4 points for each piece, found %zu",
                    b->points.count);
}

/* One piece after the other. */
static void curve_open(struct parser *p, struct curve_builder *b)
{
    size_t step = b->curve == CURVE_BEZIER ? 4 : 1;
    for (size_t i = 0; i + curve_reach(b->curve) <= b->points.count; i += step)
        curve_add(p, b, i);
}

static bool point_same(vec3 a, vec3 b)
{
    return a.x == b.x && a.y == b.y;
}

/* Outlines of Bezier curves end where they began. A prism with one that does
 * not POV-Ray leaves out. */
static void curve_leave_open(struct parser *p, struct curve_builder *b)
{
    const vec3 *points = b->points.items;
    size_t closed = 0;
    for (size_t i = 0; i < b->segments.count; i++)
        if (point_same(points[4 * i + 3], points[4 * closed]))
            closed = i + 1;
    if (closed == b->segments.count)
        return;
    warning_at(p, b->span, NULL,
               "an outline is not closed, so that the prism is left out, as by "
               "POV-Ray: its last point must be its first");
    b->segments.count = 0;
}

/* POV-Ray closes polygons, and only those. */
static void curve_close(struct parser *p, struct curve_builder *b, size_t first)
{
    const vec3 *begin = &b->points.items[first];
    const vec3 *end = &b->points.items[b->points.count - 1];
    *ARRAY_PUSH(p->scene_arena, &b->segments) = segment_line(
        (double[]){ end->x, end->y }, (double[]){ begin->x, begin->y });
    warning_at(p, b->span, NULL,
               "an outline is not closed; a line to its first point closes it");
}

/* Outlines, each closed by its first point, which for splines is the second
 * that is written; cubic ones have another point after that. */
static bool curve_closed(struct parser *p, struct curve_builder *b)
{
    const vec3 *points = b->points.items;
    size_t first = 0, start = curve_start(b->curve);
    size_t reach = curve_reach(b->curve), count = b->points.count;
    for (size_t i = 0; i + reach <= count; i++) {
        curve_add(p, b, i);
        size_t end = i + start + 1;
        if (!point_same(points[end], points[first + start]))
            continue;
        first = i + reach;
        i = first - 1;
    }
    if (first == count)
        return true;
    if (b->curve == CURVE_LINEAR) {
        curve_close(p, b, first);
        return true;
    }
    if (first + start == count) {
        warning_at(p, b->span, NULL,
                   "the last point begins no outline: it is left out");
        return true;
    }
    return error_at(p, b->span, NULL,
                    "an outline is not closed: its second point, where the "
                    "curve begins, must come again as its last%s",
                    b->curve == CURVE_CUBIC ? " but one" : "");
}

enum { CURVE_SLOTS = 256 };

/* Curves made last, by their hashes. */
struct curves_made {
    struct terms slots[CURVE_SLOTS];
};

/* The curve, or the same one if it was made not long ago: the memory of this
 * one is then given back. */
static struct terms curve_terms(struct parser *p, struct curve_builder *b)
{
    ARRAY_FIT(p->scene_arena, &b->segments);
    struct terms made = { (double *)b->segments.items,
                          b->segments.count * SEGMENT_NUMBERS };
    size_t size = made.count * sizeof *made.values;
    if (!p->curves)
        p->curves = ARENA_NEW(p->arena, struct curves_made);
    uint64_t hash = hash_numbers(0, made.values, made.count);
    struct terms *slot = &p->curves->slots[hash % CURVE_SLOTS];
    if (made.count > 0 && slot->count == made.count &&
        memcmp(slot->values, made.values, size) == 0)
        arena_resize(p->scene_arena, made.values, size, 0);
    else
        *slot = made;
    return *slot;
}

/* prism_kind = curve | "linear_sweep" | "conic_sweep" . */
static bool parse_prism_kind(struct parser *p, struct extrusion *prism,
                             enum curve *curve)
{
    bool conic = accept_keyword(p, KEYWORD_CONIC_SWEEP);
    if (!conic && !accept_keyword(p, KEYWORD_LINEAR_SWEEP))
        return parse_curve(p, curve);
    prism->conic = conic; /* the last word counts */
    return true;
}

/* prism_arguments = {prism_kind} float [","] float [","] float
 *                   {[","] vector} . */
static bool parse_prism_arguments(struct parser *p, void *shape)
{
    struct extrusion *prism = shape;
    struct curve_builder b = { .curve = CURVE_LINEAR };
    prism->axis = 1;
    while (parse_prism_kind(p, prism, &b.curve))
        continue;
    if (points_flagged(p))
        return false;
    if (stream_peek(p)->kind == TOKEN_LESS)
        return error_expected_hint(
            p, "how low and how high the prism is and its number of points",
            "0, 1, 4, <0, 0>, <1, 0>, <1, 1>, <0, 0>");
    if (!parse_float(p, &prism->low))
        return false;
    accept(p, TOKEN_COMMA);
    if (!parse_float(p, &prism->high))
        return false;
    accept(p, TOKEN_COMMA);
    if (!parse_curve_points(p, &b) ||
        !curve_check(p, &b, curve_closes(b.curve)))
        return false;
    if (b.curve == CURVE_BEZIER) {
        curve_open(p, &b);
        curve_leave_open(p, &b);
    } else if (!curve_closed(p, &b)) {
        return false;
    }
    prism->segments = curve_terms(p, &b);
    return true;
}

/* prism = "prism" "{" prism_arguments {modifier} "}" . */
bool parse_prism(struct parser *p, struct object **out)
{
    return parse_shape(p, out, &prism_primitive, parse_prism_arguments);
}

/* lathe_arguments = [curve] float {[","] vector} . */
static bool parse_lathe_arguments(struct parser *p, void *shape)
{
    struct revolution *lathe = shape;
    struct curve_builder b = { .curve = CURVE_LINEAR };
    parse_curve(p, &b.curve);
    accept(p, TOKEN_COMMA);
    if (!parse_curve_points(p, &b) || !curve_check(p, &b, curve_reach(b.curve)))
        return false;
    curve_open(p, &b);
    lathe->segments = curve_terms(p, &b);
    lathe->bezier = b.curve == CURVE_BEZIER;
    return true;
}

/* lathe = "lathe" "{" lathe_arguments {modifier} "}" . */
bool parse_lathe(struct parser *p, struct object **out)
{
    return parse_shape(p, out, &lathe_primitive, parse_lathe_arguments);
}
