/* Pigments: the colour of a surface, plain, by pattern or from an image. */
#include <string.h>

#include "parse/function_field.h"
#include "parse/rules.h"

enum {
    PIGMENT_DEPTH_LIMIT = 10,    /* 2^10 look-ups for a point of a surface */
    PIGMENT_PARTS_LIMIT = 10000, /* all are asked whether they are opaque */
};

static const struct field pigment_names[] = {
    { .name = "colour_map" }, { .name = "pigment_map" },
    { .name = "turbulence" }, { .name = "octaves" },
    { .name = "omega" },      { .name = "lambda" },
    { .name = "frequency" },  { .name = "phase" },
    { .name = "image_map" },  { .name = "quick_colour" },
    { .name = NULL },
};

static bool is_byte(double x)
{
    return x >= 0 && x <= 255 && x == floor(x);
}

/* Colours of other programs go from 0 to 255. */
static void pigment_warn_bytes(struct parser *p, struct span span,
                               const colour *c)
{
    double most = fmax(c->r, fmax(c->g, c->b));
    bool grey = c->r == c->g && c->g == c->b && c->r != 255;
    if (most < 32 || grey || !is_byte(c->r) || !is_byte(c->g) || !is_byte(c->b))
        return;
    warning_at(p, span,
               arena_printf(p->arena, "rgb <%g, %g, %g>/255", c->r, c->g, c->b),
               "colours go from 0 to 1, not to 255");
}

/* pigment_start = colour | image_map | pattern [block_list] .
 * Measured: a pattern in place of another keeps its map, and a list of colours
 * is a map of these at 0, 1, 2. */
enum taken parse_pigment_start(struct parser *p, struct pigment *pigment)
{
    if (stream_keyword(p) == KEYWORD_IMAGE_MAP) {
        pigment->kind = PIGMENT_IMAGE;
        pigment->pattern.kind = NULL;
        return parse_image_map(p, &pigment->image);
    }
    if (at_colour(p)) {
        pigment->kind = PIGMENT_COLOUR;
        struct span span = stream_span(p);
        if (!parse_colour(p, &pigment->colour))
            return WRONG;
        pigment_warn_bytes(p, span_join(span, p->last_span), &pigment->colour);
        return TAKEN;
    }
    enum taken taken = parse_pattern(p, &pigment->pattern);
    if (taken != TAKEN)
        return taken;
    pigment->kind = PIGMENT_PATTERN;
    return pigment->pattern.kind->blocks == 0 ||
           parse_pattern_end(
               p, &pigment->pattern,
               parse_block_list(p, &pigment->pattern, &pigment->map));
}

/* A pigment_map in a pigment_map ... costs twice as much at each level. */
bool pigment_count(struct parser *p, struct pigment *pigment)
{
    pigment->depth = 0;
    pigment->parts = 1;
    pigment->work = pattern_work(&pigment->pattern);
    pigment->levels = pattern_levels(&pigment->pattern);
    for (size_t i = 0; pigment->map && i < pigment->map->count; i++) {
        const struct pigment *part = pigment->map->entries[i].pigment;
        if (part && part->depth >= pigment->depth)
            pigment->depth = part->depth + 1;
        pigment->parts += part ? part->parts : 0;
        pigment->work += part ? part->work : 0;
        if (part && part->levels > pigment->levels)
            pigment->levels = part->levels;
    }
    if (!work_check(p, pigment->work, pigment->levels))
        return false;
    if (pigment->depth > PIGMENT_DEPTH_LIMIT)
        return error_at(p, p->last_span, NULL,
                        "pigments are nested more than %d deep",
                        PIGMENT_DEPTH_LIMIT);
    return pigment->parts <= PIGMENT_PARTS_LIMIT ||
           error_at(p, p->last_span, NULL,
                    "a pigment is made of more than %d others",
                    PIGMENT_PARTS_LIMIT);
}

bool uv_refuse(struct parser *p, struct span span,
               const struct pattern *pattern)
{
    return !pattern->uv ||
           error_at(p, span_join(span, p->last_span), NULL,
                    "'uv_mapping' needs a surface, and here is none");
}

static bool pigment_is_average(const struct pigment *pigment)
{
    return pigment->kind == PIGMENT_PATTERN && pigment->pattern.kind->average;
}

/* A string where a colour or a picture was meant. */
static bool error_pigment_string(struct parser *p)
{
    const char *text = stream_peek(p)->text;
    if (strchr(text, '.'))
        return error_at(p, stream_span(p),
                        arena_printf(p->arena, "image_map { \"%s\" }", text),
                        "a picture stands in an image_map");
    return error_at(p, stream_span(p), "rgb <1, 0, 0>",
                    "a colour has no quotes: it is rgb and its parts, or a "
                    "name such as Red after #include \"colors.inc\"");
}

/* What stands next is none of a pigment. */
static bool error_pigment(struct parser *p, const struct pigment *pigment)
{
    int blocks =
        pigment->kind == PIGMENT_PATTERN ? pigment->pattern.kind->blocks : 0;
    if (blocks && at_colour(p))
        return error_at(p, stream_span(p), NULL,
                        "'%s' takes %d colours, and this is one more",
                        pattern_name(&pigment->pattern), blocks);
    if (stream_peek(p)->kind == TOKEN_STRING)
        return error_pigment_string(p);
    return error_unknown_thing(p, "pigment", pigment_names,
                               "a colour, a pattern or a pigment");
}

static bool pigment_can_map(struct parser *p, const struct pigment *pigment)
{
    if (pigment->kind == PIGMENT_PATTERN && pigment->pattern.kind->blocks)
        return error_at(p, stream_span(p), NULL,
                        "'%s' takes a list of colours, not a map",
                        pattern_name(&pigment->pattern));
    return true;
}

/* pigment_item = colour_map | pigment_map | density_map
 *              | "quick_colour" colour | pattern_item .
 * A density_map only in a density. */
enum taken parse_pigment_item(struct parser *p, struct pigment *pigment)
{
    switch (stream_keyword(p)) {
    case KEYWORD_COLOUR_MAP:
        return pigment_can_map(p, pigment) &&
               parse_colour_map(p, &pigment->map);
    case KEYWORD_PIGMENT_MAP:
        return pigment_can_map(p, pigment) &&
               parse_pigment_map(p, pigment_is_average(pigment), &pigment->map);
    case KEYWORD_DENSITY_MAP:
        if (!p->density)
            return NOT_MINE;
        return pigment_can_map(p, pigment) &&
               parse_density_entries(p, pigment_is_average(pigment),
                                     &pigment->map);
    case KEYWORD_QUICK_COLOUR:
        stream_next(p);
        pigment->has_quick_colour = true;
        return parse_colour(p, &pigment->quick_colour);
    default:
        return parse_pattern_item(p, &pigment->pattern);
    }
}

/* pigment_body = ["uv_mapping"] [PIGMENT | DENSITY] [pigment_start]
 *                {pigment_item} . */
bool parse_pigment_body(struct parser *p, const struct pigment **in)
{
    bool mapped = accept_keyword(p, KEYWORD_UV_MAPPING);
    const struct value *value =
        accept_value(p, p->density ? VALUE_DENSITY : VALUE_PIGMENT);
    if (value)
        *in = value->pigment;
    if (value && !mapped && at_body_end(p))
        return true;
    struct pigment *pigment = ARENA_NEW(p->scene_arena, struct pigment);
    *pigment = **in;
    *in = pigment;
    /* Of a declared one that has them already nothing is moved (measured). */
    bool settled = value && pigment->pattern.uv && !mapped;
    const affine place = pigment->pattern.inverse;
    pigment->pattern.uv |= mapped;
    if (!parse_pigment_start(p, pigment))
        return false;
    while (!at_body_end(p)) {
        enum taken taken = parse_pigment_item(p, pigment);
        if (taken == NOT_MINE)
            return error_pigment(p, pigment);
        if (taken == WRONG)
            return false;
    }
    if (settled)
        pigment->pattern.inverse = place;
    if (pigment_is_average(pigment) && !pigment->map)
        return error_at(p, stream_span(p), "pigment_map { [1 ...] [1 ...] }",
                        "'average' needs a pigment_map");
    return pigment_count(p, pigment);
}

/* pigment = "pigment" "{" pigment_body "}" . */
bool parse_pigment_block(struct parser *p, const struct pigment **in)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) &&
           block_end(p, open, parse_pigment_body(p, in));
}

bool parse_plain_pigment(struct parser *p, const struct pigment **out)
{
    *out = p->plain;
    return parse_pigment_block(p, out);
}

bool parse_pigment(struct parser *p, const struct pigment **out)
{
    *out = p->defaults.pigment;
    return parse_pigment_block(p, out);
}
