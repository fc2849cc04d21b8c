/* Bodies of functions that are no formulas: see function_field.h. */
#include "parse/function_field.h"

#include "parse/rules.h"
#include "parse/spline.h"
#include "scene/function_field.h"
#include "scene/internal.h"

bool work_check(struct parser *p, double work, unsigned levels)
{
    if (levels > WORK_LEVELS)
        return error_at(p, p->last_span, NULL,
                        "functions, pigments and patterns are made of each "
                        "other more than %d deep",
                        WORK_LEVELS);
    return work <= WORK_LIMIT ||
           error_at(p, p->last_span, NULL,
                    "with all that this is made of it takes more than %d "
                    "steps at each point, glim's limit",
                    WORK_LIMIT);
}

bool at_field_body(struct parser *p)
{
    enum keyword keyword = stream_keyword(p);
    return keyword == KEYWORD_PATTERN || keyword == KEYWORD_PIGMENT ||
           keyword == KEYWORD_INTERNAL || keyword == KEYWORD_SPLINE ||
           keyword == KEYWORD_TRANSFORM;
}

static struct step *field_step(struct parser *p, struct function *function,
                               enum step_kind kind)
{
    struct step *step = ARRAY_PUSH(p->scene_arena, &function->steps);
    *step = (struct step){ .kind = kind };
    return step;
}

/* All parameters on the stack, as many as the field takes. */
static void field_locals(struct parser *p, struct function *function, int count)
{
    for (int i = 0; i < count; i++)
        field_step(p, function, STEP_LOCAL)->slot = i;
    function->parameter_count = function->slots = count;
    function->height = (unsigned)count;
}

static bool field_pattern(struct parser *p, struct pattern *pattern)
{
    *pattern = pattern_new(p->scene_arena, NULL);
    enum taken taken = parse_pattern(p, pattern);
    if (taken == NOT_MINE)
        return error_expected(p, "a pattern");
    if (taken == TAKEN && !parse_pattern_end(p, pattern, true))
        return false;
    while (taken == TAKEN && stream_peek(p)->kind != TOKEN_RBRACE)
        taken = parse_pattern_item(p, pattern);
    return taken != NOT_MINE ? taken : error_unknown_item(p, "pattern", NULL);
}

static bool field_function(struct parser *p, struct function *function,
                           const struct pattern *pattern)
{
    field_locals(p, function, 3);
    field_step(p, function, STEP_FIELD)->field =
        field_of_pattern(p->scene_arena, pattern);
    function->work = 4 + pattern_work(pattern);
    function->levels = pattern_levels(pattern);
    return work_check(p, function->work, function->levels);
}

/* f_noise3d: by whatever noise_generator the scene says. */
static bool noise_function(struct parser *p, struct function *function)
{
    field_locals(p, function, 3);
    field_step(p, function, STEP_FIELD)->field =
        field_of_noise(p->scene_arena, &p->scene->noise);
    function->work = 5;
    return true;
}

/* pattern_body = "pattern" "{" pattern {pattern_item} "}" . */
static bool parse_pattern_body(struct parser *p, struct function *function)
{
    struct pattern pattern;
    struct span open;
    stream_next(p);
    if (!block_begin(p, &open) ||
        !block_end(p, open, field_pattern(p, &pattern)))
        return false;
    return field_function(p, function, &pattern);
}

/* internal_body = "internal" "(" float ")" .
 * How functions.inc declares its functions. */
static bool parse_internal_body(struct parser *p, struct function *function)
{
    int number;
    stream_next(p);
    struct span open = stream_span(p);
    if (!expect(p, TOKEN_LPAREN, span_none()) || !parse_integer(p, &number) ||
        !expect(p, TOKEN_RPAREN, open))
        return false;
    if (number == INTERNAL_NOISE3D)
        return noise_function(p, function);
    const struct internal_function *internal = internal_find(number);
    if (!internal)
        return error_at(p, span_join(open, p->last_span), NULL,
                        "there is no function internal(%d); functions.inc has "
                        "names for those there are",
                        number);
    field_locals(p, function, internal->arguments);
    struct step *step = field_step(p, function, STEP_MANY);
    step->many = internal->value;
    step->manys = internal->values;
    step->slot = internal->arguments;
    function->work = 1 + internal->arguments;
    return true;
}

static bool pigment_body(struct parser *p, struct function *function)
{
    const struct pigment *pigment;
    struct span span = stream_span(p);
    if (!parse_plain_pigment(p, &pigment) ||
        !uv_refuse(p, span, &pigment->pattern))
        return false;
    function->values = values_of_pigment(p->scene_arena, pigment);
    function->work = 1 + pigment->work;
    function->levels = 1 + pigment->levels;
    return work_check(p, function->work, function->levels);
}

static bool spline_body(struct parser *p, struct function *function)
{
    enum { SPLINE_WORK = 20 };
    const struct spline *spline;
    if (!parse_spline(p, &spline))
        return false;
    function->parameter_count = 1;
    function->values = values_of_spline(p->scene_arena, spline);
    function->work = SPLINE_WORK;
    return true;
}

/* transform_body = transform . */
static bool parse_transform_body(struct parser *p, struct function *function)
{
    affine transform = affine_identity();
    if (!parse_transformation(p, &transform))
        return false;
    function->values = values_of_affine(p->scene_arena, &transform);
    function->work = 4;
    return true;
}

/* field_body = pattern_body | pigment | spline | transform_body
 *            | internal_body . */
bool parse_field_body(struct parser *p, struct function *function)
{
    enum keyword keyword = stream_keyword(p);
    if (keyword == KEYWORD_PATTERN)
        return parse_pattern_body(p, function);
    if (keyword == KEYWORD_INTERNAL)
        return parse_internal_body(p, function);
    function->parameter_count = function->slots = 3;
    function->height = 3;
    if (keyword == KEYWORD_SPLINE)
        return spline_body(p, function);
    if (keyword == KEYWORD_TRANSFORM)
        return parse_transform_body(p, function);
    return pigment_body(p, function);
}

/* colour_part = "." ( "x" | "y" | "z" | "t" | "u" | "v" | "red" | "green"
 *             | "blue" | "filter" | "transmit" | "gray" | "grey" | "hf" ) . */
bool parse_colour_part(struct parser *p, int *part)
{
    static const struct {
        const char *word;
        int part;
    } parts[] = {
        { "x", 0 },
        { "u", 0 },
        { "red", 0 },
        { "y", 1 },
        { "v", 1 },
        { "green", 1 },
        { "z", 2 },
        { "blue", 2 },
        { "t", 3 },
        { "filter", 3 },
        { "transmit", 4 },
        { "gray", FIELD_GREY },
        { "grey", FIELD_GREY },
        { "hf", FIELD_HEIGHT },
    };
    if (!expect(p, TOKEN_DOT, span_none()))
        return false;
    for (size_t i = 0; i < sizeof parts / sizeof *parts; i++)
        if (accept_word(p, parts[i].word)) {
            *part = parts[i].part;
            return true;
        }
    return error_expected(p, "red, green, blue, filter, transmit or gray");
}
