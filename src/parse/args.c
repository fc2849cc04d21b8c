/* Values by field table: reading, promotion, ranges and the words of errors
 * all come from one row (base/field.h). */
#include <limits.h>

#include "base/text.h"
#include "parse/expression.h"
#include "parse/stream.h"

enum { TERMS_LIMIT = 100000, POINTS_LIMIT = 10000000 };

static bool field_has_range(const struct field *field)
{
    return field->minimum != 0 || field->maximum != 0;
}

static const char *field_range(struct parser *p, const struct field *field)
{
    if (field->maximum >= HUGE_VAL)
        return arena_printf(p->arena, "at least %s",
                            NUMBER_TEXT(field->minimum));
    if (field->minimum <= -HUGE_VAL)
        return arena_printf(p->arena, "at most %s",
                            NUMBER_TEXT(field->maximum));
    return arena_printf(p->arena, "from %s to %s", NUMBER_TEXT(field->minimum),
                        NUMBER_TEXT(field->maximum));
}

static bool field_check(struct parser *p, const struct field *field,
                        struct span start, double number)
{
    struct span span = span_join(start, p->last_span);
    if (!isfinite(number) && p->shape) {
        p->infinite = p->infinite ? p->infinite : field->name;
        return true;
    }
    if (!isfinite(number))
        return error_at(p, span, NULL, "'%s' is not a finite number",
                        field->name);
    if (!field_has_range(field) ||
        (number >= field->minimum && number <= field->maximum))
        return true;
    return error_at(p, span, NULL, "'%s' must be %s, found %s", field->name,
                    field_range(p, field), NUMBER_TEXT(number));
}

static bool field_check_all(struct parser *p, const struct field *field,
                            struct span start, const double *numbers,
                            size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!field_check(p, field, start, numbers[i]))
            return false;
    return true;
}

static bool field_float(struct parser *p, const struct field *field,
                        double *out)
{
    struct span start = stream_span(p);
    return parse_float(p, out) && field_check(p, field, start, *out);
}

static bool field_integer(struct parser *p, const struct field *field, int *out)
{
    struct span start = stream_span(p);
    return parse_integer(p, out) && field_check(p, field, start, *out);
}

static bool field_components(struct parser *p, const struct field *field,
                             double *out, int size)
{
    struct span start = stream_span(p);
    return parse_components(p, out, size) &&
           field_check_all(p, field, start, out, (size_t)size);
}

static bool field_pair(struct parser *p, const struct field *field,
                       double out[2])
{
    if (!field_float(p, field, &out[0]))
        return false;
    accept(p, TOKEN_COMMA);
    return field_float(p, field, &out[1]);
}

static bool field_vector(struct parser *p, const struct field *field, vec3 *out)
{
    struct span start = stream_span(p);
    vec3 v;
    if (!parse_vector(p, &v))
        return false;
    *out = v;
    return field_check_all(p, field, start, (double[]){ v.x, v.y, v.z }, 3);
}

static bool field_colour(struct parser *p, const struct field *field,
                         colour *out)
{
    struct span start = stream_span(p);
    if (!parse_colour(p, out))
        return false;
    double numbers[] = { out->r, out->g, out->b, out->filter, out->transmit };
    return field_check_all(p, field, start, numbers, 5);
}

/* terms = "<" float {[","] float} ">" . */
static bool parse_terms(struct parser *p, const struct field *field,
                        struct terms *terms)
{
    struct {
        double *items;
        size_t count, capacity;
    } values = { 0 };
    struct span open = stream_span(p), start;
    if (!expect(p, TOKEN_LESS, span_none()))
        return false;
    do {
        double number;
        start = stream_span(p);
        if (!parse_float(p, &number) || !field_check(p, field, start, number))
            return false;
        if (values.count == TERMS_LIMIT)
            return error_at(p, start, NULL,
                            "'%s' has more than %d numbers, glim's limit",
                            field->name, TERMS_LIMIT);
        *ARRAY_PUSH(p->scene_arena, &values) = number;
        accept(p, TOKEN_COMMA);
    } while (stream_peek(p)->kind != TOKEN_GREATER &&
             stream_peek(p)->kind != TOKEN_END &&
             stream_peek(p)->kind != TOKEN_RBRACE);
    ARRAY_FIT(p->scene_arena, &values);
    *terms = (struct terms){ values.items, values.count };
    return expect(p, TOKEN_GREATER, open);
}

/* At what ends the values before it: a '}', or the word of an item. */
static bool at_no_value(struct parser *p)
{
    const struct token *token = stream_peek(p);
    if (token->kind == TOKEN_WORD && token->word->reserved)
        return !at_expression(p) && !at_colour(p);
    return token->kind == TOKEN_RBRACE;
}

static bool field_point(struct parser *p, const struct field *field, vec3 *out)
{
    double flat[2];
    if (field->kind == FIELD_POINTS)
        return field_vector(p, field, out);
    if (!field_components(p, field, flat, 2))
        return false;
    *out = vec3_make(flat[0], flat[1], 0);
    return true;
}

bool points_flagged(struct parser *p)
{
    const struct token *token = stream_peek(p);
    size_t left;
    if (token->kind != TOKEN_WORD || (token->word->keyword != KEYWORD_OPEN &&
                                      token->word->keyword != KEYWORD_STURM))
        return false;
    enum token_kind next = stream_raw(p, &left)->kind;
    if (left == 0 || (next != TOKEN_LESS && next != TOKEN_COMMA &&
                      next != TOKEN_NUMBER && next != TOKEN_MINUS))
        return false;
    error_at(p, stream_span(p), NULL, "'%s' comes behind the last point",
             token->word->text);
    return true;
}

/* Whether another point follows. */
static bool points_go_on(struct parser *p)
{
    size_t left;
    const struct token *token = stream_peek(p), *next = stream_raw(p, &left);
    return token->kind == TOKEN_LESS ||
           (token->kind == TOKEN_COMMA && left > 0 && next->kind == TOKEN_LESS);
}

/* points = float {[","] vector} . */
static bool parse_points(struct parser *p, const struct field *field,
                         struct points *points)
{
    struct {
        vec3 *items;
        size_t count, capacity;
    } values = { 0 };
    struct span start = stream_span(p);
    double count;
    if (stream_peek(p)->kind == TOKEN_LESS)
        return error_at(p, start, "4, <point>, <point> ...",
                        "first comes how many points there are, then the "
                        "points");
    if (points_flagged(p) || !parse_float(p, &count) ||
        !field_check(p, field, start, count))
        return false;
    if (!(count >= 0 && count <= POINTS_LIMIT))
        return error_at(p, start, NULL,
                        "the number of points must be from 0 to %d, found %s",
                        POINTS_LIMIT, NUMBER_TEXT(count));
    while (values.count < (size_t)count) {
        vec3 point;
        accept(p, TOKEN_COMMA);
        if (points_flagged(p))
            return false;
        if (at_no_value(p))
            return error_at(p, start,
                            arena_printf(p->arena, "%zu", values.count),
                            "%s points are announced here, but only %zu follow",
                            NUMBER_TEXT(count), values.count);
        if (!field_point(p, field, &point))
            return false;
        *ARRAY_PUSH(p->scene_arena, &values) = point;
    }
    ARRAY_FIT(p->scene_arena, &values);
    *points = (struct points){ values.items, values.count };
    return !points_go_on(p) ||
           error_at(p, start, NULL,
                    "%s points are announced here, but more follow",
                    NUMBER_TEXT(count));
}

/* The next token as a word, kept as long as the scene; NULL after an error. */
static const char *field_word(struct parser *p, const char *wanted)
{
    if (stream_peek(p)->kind != TOKEN_WORD) {
        error_expected(p, wanted);
        return NULL;
    }
    return arena_printf(p->scene_arena, "%s", stream_next(p).word->text);
}

static bool field_name(struct parser *p, const struct field *field,
                       const char **out)
{
    const char *word =
        field_word(p, arena_printf(p->arena, "a name for '%s'", field->name));
    if (word)
        *out = word;
    return word;
}

static bool field_chosen(struct parser *p, const struct field *field, int *out)
{
    char choices[128];
    struct span span = stream_span(p);
    field_choices(field, choices, sizeof choices);
    const char *word = field_word(p, choices);
    if (!word)
        return false;
    int choice = field_choice(field, word);
    if (choice >= 0) {
        *out = choice;
        return true;
    }
    struct text_nearest nearest = text_nearest_start(word);
    for (int i = 0; field->choices[i]; i++)
        text_nearest_try(&nearest, field->choices[i]);
    return error_at(p, span, nearest.best, "'%s' is %s, not '%s'", field->name,
                    choices, word);
}

/* A value is missing since `0 -1` without a comma is one number. */
static bool field_subtracted(struct parser *p)
{
    struct span minus;
    const char *hint = subtracted_hint(p, &minus);
    if (!hint)
        return false;
    error_at(p, minus, hint,
             "this is subtracted from what stands before it; a comma makes it "
             "'%s'",
             p->field->name);
    return true;
}

/* The error where a value is left out names what it is for. */
static bool field_missing(struct parser *p, const struct field *field)
{
    static const char *const kinds[] = {
        [FIELD_FLOAT] = "a number",   [FIELD_INTEGER] = "a number",
        [FIELD_VECTOR2] = "a vector", [FIELD_VECTOR] = "a vector",
        [FIELD_VECTOR5] = "a vector", [FIELD_COLOUR] = "a colour",
        [FIELD_RGB] = "a colour",
    };
    if (!at_no_value(p) || field->kind >= sizeof kinds / sizeof *kinds ||
        !kinds[field->kind])
        return false;
    if (!field_subtracted(p))
        error_expected(p, kinds[field->kind]);
    return true;
}

static bool field_read(struct parser *p, const struct field *field, void *base)
{
    void *at = (char *)base + field->offset;
    struct cursor *outer;
    colour c;
    if (field_missing(p, field))
        return false;
    switch (field->kind) {
    case FIELD_FLOAT:
        return field_float(p, field, at);
    case FIELD_INTEGER:
        return field_integer(p, field, at);
    case FIELD_BOOL:
        return parse_bool(p, at);
    case FIELD_FLAG:
        *(bool *)at = true;
        return true;
    case FIELD_PAIR:
        return field_pair(p, field, at);
    case FIELD_VECTOR2:
        return field_components(p, field, at, 2);
    case FIELD_VECTOR:
        return field_vector(p, field, at);
    case FIELD_VECTOR5:
        return field_components(p, field, at, 5);
    case FIELD_COLOUR:
        return field_colour(p, field, at);
    case FIELD_RGB:
        if (!field_colour(p, field, &c))
            return false;
        *(rgb *)at = colour_rgb(c);
        return true;
    case FIELD_NAME:
        return field_name(p, field, at);
    case FIELD_CHOICE:
        return field_chosen(p, field, at);
    case FIELD_TERMS:
        outer = brackets_begin(p);
        return brackets_end(p, outer, parse_terms(p, field, at));
    case FIELD_POINTS:
    case FIELD_POINTS2:
        return parse_points(p, field, at);
    }
    return false;
}

bool parse_field(struct parser *p, const struct field *field, void *base)
{
    const struct field *outer = p->field;
    unsigned nesting = p->field_nesting;
    p->field = field;
    p->field_nesting = p->nesting;
    bool ok = field_read(p, field, base);
    p->field = outer;
    p->field_nesting = nesting;
    return ok;
}

bool parse_arguments(struct parser *p, const struct field *table, void *base)
{
    for (const struct field *field = table; field && field->name; field++) {
        bool comma = field != table && accept(p, TOKEN_COMMA);
        if (field->optional && !comma && !at_expression(p))
            return true;
        if (!parse_field(p, field, base))
            return false;
    }
    return true;
}
