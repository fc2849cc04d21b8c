/* Normals: patterns that bend a surface's shading normal. */
#include "parse/rules.h"
#include "parse/tables.h"

/* normal_field = "bump_size" float | "accuracy" float . */
static const struct field normal_names[] = {
    { .name = "bump_size" }, { .name = "accuracy" }, { .name = "normal_map" },
    { .name = "slope_map" }, { .name = NULL },
};

/* normal_start = bump_map | pattern [","] [float] normal_blocks .
 * The float is the bump size. Another pattern keeps the maps (measured). */
enum taken parse_normal_start(struct parser *p, struct normal *normal)
{
    if (stream_keyword(p) == KEYWORD_BUMP_MAP) {
        normal->pattern.kind = NULL;
        return parse_bump_map(p, &normal->bumps, &normal->amount);
    }
    enum taken taken = parse_normal_pattern(p, &normal->pattern);
    if (taken == WRONG)
        return WRONG;
    if (taken == TAKEN) {
        normal->bumps = NULL;
        accept(p, TOKEN_COMMA);
    }
    if (at_expression(p) && !parse_float(p, &normal->amount))
        return WRONG;
    if (taken == NOT_MINE || normal->pattern.kind->blocks == 0)
        return taken;
    return parse_pattern_end(p, &normal->pattern,
                             parse_normal_blocks(p, normal));
}

static bool normal_is_average(const struct normal *normal)
{
    return normal->pattern.kind && normal->pattern.kind->average;
}

static bool normal_can_map(struct parser *p, const struct normal *normal)
{
    const struct pattern *pattern = &normal->pattern;
    if (pattern->kind && pattern->kind->blocks)
        return error_at(p, stream_span(p), NULL,
                        "'%s' takes a list of normals, not a map",
                        pattern_name(pattern));
    return true;
}

/* normal_item = normal_field | normal_map | slope_map | "no_bump_scale"
 *             | pattern_item . */
enum taken parse_normal_item(struct parser *p, struct normal *normal)
{
    const struct field *field = accept_field(p, normal_fields);
    if (field)
        return parse_field(p, field, normal);
    switch (stream_keyword(p)) {
    case KEYWORD_NORMAL_MAP:
        return normal_can_map(p, normal) &&
               parse_normal_map(p, normal_is_average(normal), &normal->map);
    case KEYWORD_NO_BUMP_SCALE:
        stream_next(p);
        return normal->level = true;
    case KEYWORD_SLOPE_MAP:
        return normal_can_map(p, normal) && parse_slope_map(p, &normal->slopes);
    default:
        return parse_pattern_item(p, &normal->pattern);
    }
}

static bool normal_items(struct parser *p, struct normal *normal)
{
    while (!at_body_end(p)) {
        enum taken taken = parse_normal_item(p, normal);
        if (taken == NOT_MINE)
            return error_unknown_thing(p, "normal", normal_names,
                                       "a pattern or a normal");
        if (taken == WRONG)
            return false;
    }
    return normal_count(p, normal);
}

struct normal *normal_begin(struct parser *p, const struct normal *from)
{
    struct normal *normal = ARENA_NEW(p->scene_arena, struct normal);
    if (from)
        *normal = *from;
    else
        *normal = (struct normal){
            .pattern = pattern_new(p->scene_arena, NULL),
            .amount = 0.5,
            .accuracy = 0.02,
        };
    return normal;
}

/* normal_body = ["uv_mapping"] [NORMAL] [normal_start] {normal_item} .
 * Without a pattern it is still what others begin with: their bump_size. */
bool parse_normal_body(struct parser *p, const struct normal **in)
{
    bool mapped = accept_keyword(p, KEYWORD_UV_MAPPING);
    const struct value *value = accept_value(p, VALUE_NORMAL);
    if (value)
        *in = value->normal;
    if (value && !mapped && at_body_end(p))
        return true;
    struct normal *normal = normal_begin(p, *in);
    *in = normal;
    normal->pattern.uv |= mapped;
    if (!parse_normal_start(p, normal) || !normal_items(p, normal))
        return false;
    return !normal_is_average(normal) || normal->map ||
           error_at(p, stream_span(p), "normal_map { [1 bumps 0.5] }",
                    "'average' needs a normal_map");
}

/* normal = "normal" "{" normal_body "}" . */
bool parse_normal_block(struct parser *p, const struct normal **in)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) &&
           block_end(p, open, parse_normal_body(p, in));
}

bool parse_normal(struct parser *p, const struct normal **out)
{
    *out = p->defaults.normal;
    return parse_normal_block(p, out);
}
