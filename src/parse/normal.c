/* Normals: patterns that bend a surface's shading normal. */
#include "parse/rules.h"

static const struct unsupported_word normal_unsupported[] = {
    { KEYWORD_BUMP_MAP, "'bump_map'" },
    { KEYWORD_NO_BUMP_SCALE, "'no_bump_scale'" },
    { KEYWORD_NORMAL, "a list of normals" },
    { KEYWORD_NORMAL_MAP, "'normal_map'" },
    { KEYWORD_SLOPE_MAP, "'slope_map'" },
    { KEYWORD_UV_MAPPING, "'uv_mapping'" },
    { KEYWORD_NONE, NULL },
};

/* normal_item = "bump_size" float | "accuracy" float . */
static const struct field normal_fields[] = {
    { "bump_size", FIELD_FLOAT, offsetof(struct normal, amount), 0, 0,
      "how strong, 0.5" },
    { "accuracy", FIELD_FLOAT, offsetof(struct normal, accuracy), 0, 0,
      "step by which the slope is measured, 0.02" },
    { NULL },
};

/* normal_start = pattern [","] [float] .
 * The float is the bump size. */
static bool parse_normal_start(struct parser *p, struct normal *normal,
                               bool *found)
{
    if (!parse_pattern(p, &normal->pattern, found))
        return false;
    if (*found)
        accept(p, TOKEN_COMMA);
    return !at_expression(p) || parse_float(p, &normal->amount);
}

static bool normal_items(struct parser *p, struct normal *normal)
{
    while (stream_peek(p)->kind != TOKEN_RBRACE) {
        bool found = true;
        const struct field *field = accept_field(p, normal_fields);
        if (field ? !parse_field(p, field, normal)
                  : !check_supported(p, normal_unsupported) ||
                        !parse_pattern_item(p, &normal->pattern, &found))
            return false;
        if (!found)
            return error_unknown_thing(p, "normal", normal_fields,
                                       "a pattern or a normal");
    }
    return true;
}

/* normal_body = [NORMAL] [normal_start] {normal_item | pattern_item} . */
static bool parse_normal_body(struct parser *p, const struct normal **in)
{
    const struct value *value = accept_value(p, VALUE_NORMAL);
    if (value)
        *in = value->normal;
    if (value && stream_peek(p)->kind == TOKEN_RBRACE)
        return true;
    struct normal *normal = ARENA_NEW(p->scene_arena, struct normal);
    bool found;
    if (*in)
        *normal = **in;
    else
        *normal = (struct normal){
            .pattern = pattern_new(p->scene_arena, NULL),
            .amount = 0.5,
            .accuracy = 0.02,
        };
    *in = normal;
    if (!check_supported(p, normal_unsupported) ||
        !parse_normal_start(p, normal, &found) || !normal_items(p, normal))
        return false;
    if (!normal->pattern.kind) {
        warning_at(p, stream_span(p), "bumps 0.5",
                   "a normal without a pattern changes nothing");
        *in = NULL;
    }
    return true;
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
