/* warp{}: bends of space that a pattern is seen through. */
#include "scene/warp.h"

#include "parse/rules.h"
#include "parse/tables.h"
#include "scene/noise.h"

enum { WARP_LIMIT = 1000 }; /* of one pattern: each is work at each point */

const struct field turbulence_fields[] = {
    { "octaves", FIELD_INTEGER, offsetof(struct warp, turbulence.octaves), 0, 0,
      "steps of the walk, 1 to 10, 6" },
    { "omega", FIELD_FLOAT, offsetof(struct warp, turbulence.omega), 0, 0,
      "each step is so much shorter, 0.5" },
    { "lambda", FIELD_FLOAT, offsetof(struct warp, turbulence.lambda), 0, 0,
      "and turns so much faster, 2" },
    { NULL },
};

const struct field repeat_fields[] = {
    { "offset", FIELD_VECTOR, offsetof(struct warp, offset), 0, 0,
      "of each repetition from the one before" },
    { "flip", FIELD_VECTOR, offsetof(struct warp, flip), 0, 0,
      "axes along which every other one is mirrored" },
    { NULL },
};

const struct field hole_fields[] = {
    { "falloff", FIELD_FLOAT, offsetof(struct warp, falloff), 0, 0,
      "how fast the pull gets weaker outward, 2" },
    { "strength", FIELD_FLOAT, offsetof(struct warp, strength), 0, 0,
      "of the pull at the middle, 1" },
    { "repeat", FIELD_VECTOR, offsetof(struct warp, period), 0, 0,
      "sizes of the cells, each with a hole" },
    { "turbulence", FIELD_VECTOR, offsetof(struct warp, turbulence.amount), 0,
      0, "how far repeated holes are moved at random, at most" },
    { "inverse", FIELD_FLAG, offsetof(struct warp, push), 0, 0,
      "pushes instead of pulling" },
    { NULL },
};

/* The first is toroidal's only. */
const struct field laid_fields[] = {
    { "major_radius", FIELD_FLOAT, offsetof(struct warp, major), 0, 0,
      "of the ring, 1" },
    { "orientation", FIELD_VECTOR, offsetof(struct warp, orientation), 0, 0,
      "where the pattern's z points, z" },
    { "dist_exp", FIELD_FLOAT, offsetof(struct warp, stretch), 0, 0,
      "how the pattern grows with the distance, 0" },
    { NULL },
};

static bool warp_items(struct parser *p, struct warp *warp,
                       const struct field *fields)
{
    const struct field *field;
    while ((field = accept_field(p, fields)) != NULL) {
        if (!parse_field(p, field, warp))
            return false;
        accept(p, TOKEN_COMMA);
    }
    return true;
}

/* turbulence_warp = "turbulence" vector {"octaves" float | "omega" float
 *                 | "lambda" float} . */
static bool parse_turbulence_warp(struct parser *p, struct warp *warp)
{
    warp->kind = WARP_TURBULENCE;
    warp->turbulence = (struct turbulence){ { 0, 0, 0 }, 6, 0.5, 2 };
    stream_next(p);
    if (!parse_vector(p, &warp->turbulence.amount) ||
        !warp_items(p, warp, turbulence_fields))
        return false;
    warp->turbulence.octaves = turbulence_octaves(&warp->turbulence);
    return true;
}

/* repeat_warp = "repeat" vector {"offset" vector | "flip" vector} . */
static bool parse_repeat_warp(struct parser *p, struct warp *warp)
{
    warp->kind = WARP_REPEAT;
    stream_next(p);
    struct span span = stream_span(p);
    if (!parse_vector(p, &warp->period))
        return false;
    int axes =
        (warp->period.x != 0) + (warp->period.y != 0) + (warp->period.z != 0);
    if (axes != 1)
        return error_at(p, span_join(span, p->last_span), "2*x",
                        "a repeat goes along one axis");
    accept(p, TOKEN_COMMA);
    return warp_items(p, warp, repeat_fields);
}

/* hole_warp = "black_hole" vector [","] float {"falloff" float
 *           | "strength" float | "repeat" vector | "turbulence" vector
 *           | "inverse"} . */
static bool parse_hole_warp(struct parser *p, struct warp *warp)
{
    warp->kind = WARP_BLACK_HOLE;
    warp->falloff = 2;
    warp->strength = 1;
    stream_next(p);
    if (!parse_vector(p, &warp->centre))
        return false;
    accept(p, TOKEN_COMMA);
    if (!parse_float(p, &warp->radius))
        return false;
    accept(p, TOKEN_COMMA);
    return warp_items(p, warp, hole_fields);
}

static bool laid_orientation(struct parser *p, struct warp *warp,
                             struct span span)
{
    double length = vec3_length(warp->orientation);
    if (!(length > 0))
        return error_at(p, span_join(span, p->last_span), "orientation y",
                        "the orientation of a warp has no length");
    warp->orientation = vec3_scale(warp->orientation, 1 / length);
    return true;
}

/* planar_warp = "planar" [vector [","] float] . */
static bool parse_planar_warp(struct parser *p, struct warp *warp)
{
    stream_next(p);
    warp->kind = WARP_PLANAR;
    warp->orientation = vec3_make(0, 0, 1);
    if (!at_expression(p))
        return true;
    struct span span = stream_span(p);
    if (!parse_vector(p, &warp->orientation) ||
        !laid_orientation(p, warp, span))
        return false;
    accept(p, TOKEN_COMMA);
    return parse_float(p, &warp->distance);
}

/* laid_warp = ( "cylindrical" | "spherical" | "toroidal" )
 *             {"orientation" vector | "dist_exp" float | "major_radius" float}
 * .
 */
static bool parse_laid_warp(struct parser *p, struct warp *warp,
                            enum warp_kind kind)
{
    stream_next(p);
    warp->kind = kind;
    warp->orientation = vec3_make(0, 0, 1);
    warp->major = 1;
    struct span span = stream_span(p);
    return warp_items(p, warp,
                      kind == WARP_TOROIDAL ? laid_fields : laid_fields + 1) &&
           laid_orientation(p, warp, span);
}

static bool parse_cubic_warp(struct parser *p, struct warp *warp)
{
    stream_next(p);
    warp->kind = WARP_CUBIC;
    return true;
}

static bool warp_body(struct parser *p, struct warp *warp)
{
    static const struct field names[] = {
        { .name = "turbulence" },  { .name = "repeat" },
        { .name = "black_hole" },  { .name = "planar" },
        { .name = "cylindrical" }, { .name = "spherical" },
        { .name = "toroidal" },    { .name = "cubic" },
        { .name = NULL }
    };
    bool ok;
    if (stream_keyword(p) == KEYWORD_TURBULENCE)
        ok = parse_turbulence_warp(p, warp);
    else if (at_word(p, "repeat"))
        ok = parse_repeat_warp(p, warp);
    else if (at_word(p, "black_hole"))
        ok = parse_hole_warp(p, warp);
    else if (at_word(p, "planar"))
        ok = parse_planar_warp(p, warp);
    else if (at_word(p, "cylindrical"))
        ok = parse_laid_warp(p, warp, WARP_CYLINDRICAL);
    else if (at_word(p, "spherical"))
        ok = parse_laid_warp(p, warp, WARP_SPHERICAL);
    else if (at_word(p, "toroidal"))
        ok = parse_laid_warp(p, warp, WARP_TOROIDAL);
    else if (at_word(p, "cubic"))
        ok = parse_cubic_warp(p, warp);
    else
        return error_unknown_item(p, "warp", names);
    return ok && (stream_peek(p)->kind == TOKEN_RBRACE ||
                  error_unknown_item(p, "warp", names));
}

/* warp = "warp" "{" ( turbulence_warp | repeat_warp | hole_warp | planar_warp
 *      | laid_warp | "cubic" ) "}" . */
bool parse_warp(struct parser *p, struct pattern *pattern)
{
    struct warp *warp = ARENA_NEW(p->scene_arena, struct warp);
    struct span span = stream_span(p), open;
    size_t count = 0;
    for (const struct warp *w = pattern->warps; w; w = w->inner)
        count++;
    if (count >= WARP_LIMIT)
        return error_at(p, span, NULL, "a pattern has at most %d warps",
                        WARP_LIMIT);
    stream_next(p);
    if (!block_begin(p, &open) || !block_end(p, open, warp_body(p, warp)))
        return false;
    warp->inverse = pattern->inverse;
    warp->inner = pattern->warps;
    pattern->warps = warp;
    pattern_lay(pattern, affine_identity());
    return true;
}
