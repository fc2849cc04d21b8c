/* Reading calls of the built-in functions, by table: see function.h. */
#include "parse/function.h"

#include <stdio.h>

#include "parse/array.h"
#include "parse/expression.h"
#include "parse/mistaken.h"
#include "parse/stream.h"
#include "parse/symbol.h"

static const struct function_row function_rows[KEYWORDS_TOTAL] = {
    [KEYWORD_ABS] = { "f", fabs, NULL, NULL },
    [KEYWORD_ACOS] = { "f", acos, NULL, number_acos },
    [KEYWORD_ACOSH] = { "f", acosh, NULL, NULL },
    [KEYWORD_ASC] = { "s", NULL, NULL, text_asc },
    [KEYWORD_ASIN] = { "f", asin, NULL, number_asin },
    [KEYWORD_ASINH] = { "f", asinh, NULL, NULL },
    [KEYWORD_ATAN] = { "f", atan, NULL, NULL },
    [KEYWORD_ATAN2] = { "ff", NULL, atan2, number_atan2 },
    [KEYWORD_ATANH] = { "f", atanh, NULL, NULL },
    [KEYWORD_BITWISE_AND] = { "f+", NULL, number_and, NULL },
    [KEYWORD_BITWISE_OR] = { "f+", NULL, number_or, NULL },
    [KEYWORD_BITWISE_XOR] = { "f+", NULL, number_xor, NULL },
    [KEYWORD_CEIL] = { "f", ceil, NULL, NULL },
    [KEYWORD_CHR] = { "f", NULL, NULL, text_chr },
    [KEYWORD_CONCAT] = { "s+", NULL, NULL, text_concat },
    [KEYWORD_COS] = { "f", cos, NULL, NULL },
    [KEYWORD_COSH] = { "f", cosh, NULL, NULL },
    [KEYWORD_DATETIME] = { "f|s", NULL, NULL, text_datetime },
    [KEYWORD_DEFINED] = { "d", NULL, NULL, number_defined },
    [KEYWORD_DEGREES] = { "f", number_degrees, NULL, NULL },
    [KEYWORD_DIMENSIONS] = { "a", NULL, NULL, number_dimensions },
    [KEYWORD_DIMENSION_SIZE] = { "af", NULL, NULL, number_dimension_size },
    [KEYWORD_DIV] = { "ff", NULL, number_div, NULL },
    [KEYWORD_EXP] = { "f", exp, NULL, NULL },
    [KEYWORD_FILE_EXISTS] = { "s", NULL, NULL, text_file_exists },
    [KEYWORD_FLOOR] = { "f", floor, NULL, NULL },
    [KEYWORD_INSIDE] = { "ov", NULL, NULL, vector_inside },
    [KEYWORD_INT] = { "f", number_int, NULL, NULL },
    [KEYWORD_LN] = { "f", log, NULL, number_ln },
    [KEYWORD_LOG] = { "f", log10, NULL, number_log },
    [KEYWORD_MAX] = { "f+", NULL, fmax, NULL },
    [KEYWORD_MAX_EXTENT] = { "o", NULL, NULL, vector_max_extent },
    [KEYWORD_MIN] = { "f+", NULL, fmin, NULL },
    [KEYWORD_MIN_EXTENT] = { "o", NULL, NULL, vector_min_extent },
    [KEYWORD_MOD] = { "ff", NULL, number_mod, NULL },
    [KEYWORD_POW] = { "ff", NULL, pow, number_pow },
    [KEYWORD_RADIANS] = { "f", number_radians, NULL, NULL },
    [KEYWORD_RAND] = { "f", NULL, NULL, number_rand },
    [KEYWORD_SEED] = { "f", NULL, NULL, number_seed },
    [KEYWORD_SELECT] = { "fff|f", NULL, NULL, number_select },
    [KEYWORD_SIN] = { "f", sin, NULL, NULL },
    [KEYWORD_SINH] = { "f", sinh, NULL, NULL },
    [KEYWORD_SQRT] = { "f", sqrt, NULL, number_sqrt },
    [KEYWORD_STR] = { "fff", NULL, NULL, text_str },
    [KEYWORD_STRCMP] = { "ss", NULL, NULL, text_strcmp },
    [KEYWORD_STRLEN] = { "s", NULL, NULL, text_strlen },
    [KEYWORD_STRLWR] = { "s", NULL, NULL, text_strlwr },
    [KEYWORD_STRUPR] = { "s", NULL, NULL, text_strupr },
    [KEYWORD_SUBSTR] = { "sff", NULL, NULL, text_substr },
    [KEYWORD_TAN] = { "f", tan, NULL, NULL },
    [KEYWORD_TANH] = { "f", tanh, NULL, NULL },
    [KEYWORD_TRACE] = { "ovv|i", NULL, NULL, vector_trace },
    [KEYWORD_VAL] = { "s", NULL, NULL, text_val },
    [KEYWORD_VAXIS_ROTATE] = { "vvf", NULL, NULL, vector_axis_rotate },
    [KEYWORD_VCROSS] = { "vv", NULL, NULL, vector_cross },
    [KEYWORD_VDOT] = { "vv", NULL, NULL, vector_dot },
    [KEYWORD_VLENGTH] = { "v", NULL, NULL, vector_length },
    [KEYWORD_VNORMALIZE] = { "v", NULL, NULL, vector_normalise },
    [KEYWORD_VROTATE] = { "vv", NULL, NULL, vector_rotate },
    [KEYWORD_VSTR] = { "fnsff", NULL, NULL, text_vstr },
    [KEYWORD_VTURBULENCE] = { "fffv", NULL, NULL, vector_turbulence },
};

const struct function_row *function_find(enum keyword keyword)
{
    const struct function_row *row = &function_rows[keyword];
    return row->signature ? row : NULL;
}

bool function_is(enum keyword keyword)
{
    return function_find(keyword) || keyword == KEYWORD_SUM ||
           keyword == KEYWORD_PROD;
}

enum value_kind function_gives(enum keyword keyword)
{
    switch (keyword) {
    case KEYWORD_CHR:
    case KEYWORD_CONCAT:
    case KEYWORD_DATETIME:
    case KEYWORD_STR:
    case KEYWORD_STRLWR:
    case KEYWORD_STRUPR:
    case KEYWORD_SUBSTR:
    case KEYWORD_VSTR:
        return VALUE_STRING;
    case KEYWORD_MAX_EXTENT:
    case KEYWORD_MIN_EXTENT:
    case KEYWORD_TRACE:
    case KEYWORD_VAXIS_ROTATE:
    case KEYWORD_VCROSS:
    case KEYWORD_VNORMALIZE:
    case KEYWORD_VROTATE:
    case KEYWORD_VTURBULENCE:
        return VALUE_VECTOR;
    default:
        return function_is(keyword) ? VALUE_FLOAT : VALUE_NONE;
    }
}

void call_error(struct parser *p, const struct call *call, struct value *result,
                const char *hint, const char *format, ...)
{
    char text[200];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    error_at(p, call->span, hint, "%s", text);
    *result = value_poison();
}

/* Functions that are read but not computed. */
static bool call_refuse(struct parser *p, const struct word *word,
                        struct value *value)
{
    struct span name = stream_span(p);
    stream_next(p);
    if (stream_peek(p)->kind != TOKEN_LPAREN)
        return error_expected(p, "'('");
    if (!skip_brackets(p))
        return false;
    *value = value_poison();
    error_at(p, name, NULL,
             "%s() can be used inside function { } only; use a #for loop",
             word->text);
    return true;
}

/* ---- arguments ---- */

static bool argument_name(struct parser *p, struct value *value)
{
    const struct token *token = stream_peek(p);
    if (token->kind != TOKEN_WORD)
        return error_expected(p, "a name");
    const struct value *named =
        token->word->reserved ? NULL : symbol_find(p, token->word);
    stream_next(p);
    bool element = named && named->kind == VALUE_ARRAY &&
                   stream_peek(p)->kind == TOKEN_LBRACKET;
    struct value *slot;
    if (element && !array_element(p, named->array, &slot))
        return false;
    *value = value_float(element ? slot->kind != VALUE_NONE : named != NULL);
    return true;
}

static bool argument_array(struct parser *p, const struct array **array)
{
    const struct token *token = stream_peek(p);
    const struct value *value =
        token->kind == TOKEN_WORD ? symbol_find(p, token->word) : NULL;
    if (!value || value->kind != VALUE_ARRAY)
        return error_expected(p, "the name of an array");
    stream_next(p);
    *array = value->array;
    if (stream_peek(p)->kind != TOKEN_LBRACKET)
        return true;
    struct value *slot;
    if (!array_element(p, value->array, &slot))
        return false;
    if (slot->kind != VALUE_ARRAY)
        return error_at(p, p->last_span, NULL, "expected an array, found %s",
                        value_kind_name(slot->kind));
    *array = slot->array;
    return true;
}

static bool argument_object(struct parser *p, const struct object **object)
{
    const struct value *value = accept_value(p, VALUE_OBJECT);
    if (!value)
        return error_expected(p, "the name of an object");
    *object = value->object;
    return true;
}

static bool argument_target(struct parser *p, struct symbol **target)
{
    const struct token *token = stream_peek(p);
    struct symbol *symbol = token->kind == TOKEN_WORD && !token->word->reserved
                                ? symbol_lookup(p, token->word)
                                : NULL;
    if (!symbol || symbol->value.kind != VALUE_VECTOR)
        return error_expected(p, "the name of a declared vector");
    stream_next(p);
    *target = symbol;
    return true;
}

static bool argument_value(struct parser *p, char kind, struct value *value)
{
    static const char *const wanted[128] = { ['f'] = "a number",
                                             ['v'] = "a vector",
                                             ['n'] = "a vector",
                                             ['s'] = "a string" };
    struct span start = stream_span(p);
    vec3 v;
    double number;
    const char *text;
    if (!parse_operation(p, PRECEDENCE_WHOLE, wanted[(int)kind], value))
        return false;
    if (value_is_poison(value))
        return true;
    bool ok = kind == 'f'   ? value_to_float(p, start, value, &number)
              : kind == 's' ? value_to_text(p, start, value, &text)
              : kind == 'v'
                  ? value_to_vector(p, start, value, &v)
                  : value_size(value) || value_to_vector(p, start, value, &v);
    if (!ok)
        *value = value_poison();
    else if (kind == 'v')
        *value = value_vector(v);
    return true;
}

/* What it must be stands in the function's signature.
 * argument = operation | thing_name . */
static bool parse_argument(struct parser *p, char kind, struct call *call)
{
    struct value *value = &call->arguments[call->count++];
    *value = value_float(0);
    return kind == 'd'   ? argument_name(p, value)
           : kind == 'a' ? argument_array(p, &call->array)
           : kind == 'o' ? argument_object(p, &call->object)
           : kind == 'i' ? argument_target(p, &call->target)
                         : argument_value(p, kind, value);
}

/* ---- the call ---- */

static bool call_is_poisoned(const struct call *call)
{
    for (int i = 0; i < call->count; i++)
        if (value_is_poison(&call->arguments[i]))
            return true;
    return false;
}

static void call_run(struct parser *p, const struct function_row *row,
                     const struct call *call, struct value *value)
{
    const struct value *a = call->arguments;
    if (call_is_poisoned(call))
        *value = value_poison();
    else if (row->run)
        row->run(p, call, value);
    else if (row->one)
        *value = value_float(row->one(a[0].number[0]));
    else
        *value = value_float(row->two(a[0].number[0], a[1].number[0]));
}

/* min(a, b, c): the function of two, again and again. */
static bool call_fold(struct parser *p, const struct function_row *row,
                      struct call *call, struct value *value)
{
    char kind = row->signature[0];
    if (!parse_argument(p, kind, call))
        return false;
    *value = call->arguments[0];
    while (accept(p, TOKEN_COMMA) || stream_peek(p)->kind == TOKEN_STRING) {
        call->arguments[0] = *value;
        call->count = 1;
        if (!parse_argument(p, kind, call))
            return false;
        call->span = span_join(call->span, p->last_span);
        call_run(p, row, call, value);
    }
    return true;
}

/* Random numbers come from streams, which other languages hide. */
static const char *call_example(const char *name)
{
    return strcmp(name, "rand") == 0 ? "#declare R = seed(1); ... rand(R) ..."
                                     : NULL;
}

static bool call_arguments(struct parser *p, const char *signature,
                           struct call *call, const char *name)
{
    int required = (int)strcspn(signature, "|");
    int most = (int)strlen(signature) - (signature[required] == '|');
    while (call->count < most) {
        bool comma = call->count > 0 && accept(p, TOKEN_COMMA);
        if (stream_peek(p)->kind == TOKEN_RPAREN && !comma) {
            if (call->count >= required)
                break;
            return error_at(p, span_join(call->span, p->token_span),
                            call_example(name),
                            "%s() wants %d argument%s, found %d", name,
                            required, required == 1 ? "" : "s", call->count);
        }
        char kind = signature[call->count + (call->count >= required)];
        if (!parse_argument(p, kind, call))
            return false;
    }
    if (stream_peek(p)->kind == TOKEN_COMMA)
        return error_at(p, p->token_span, call_example(name),
                        "%s() wants no more than %d argument%s", name, most,
                        most == 1 ? "" : "s");
    return true;
}

/* Commas between arguments are optional, as in POV-Ray.
 * call = FUNCTION "(" argument {[","] argument} ")" . */
bool parse_call(struct parser *p, struct value *value)
{
    const struct word *word = stream_peek(p)->word;
    const struct function_row *row = function_find(word->keyword);
    if (mistaken_degrees(p))
        return false;
    if (!row)
        return call_refuse(p, word, value);
    struct call call = { .span = p->token_span };
    stream_next(p);
    struct span open = stream_span(p);
    if (stream_peek(p)->kind != TOKEN_LPAREN)
        return error_expected_hint(
            p, arena_printf(p->arena, "'(' after '%s'", word->text),
            p->token.kind == TOKEN_NUMBER
                ? arena_printf(p->arena, "(%.*s)", (int)open.length,
                               open.source->text + open.offset)
                : NULL);
    stream_next(p);
    bool fold = row->signature[1] == '+';
    bool ok = fold ? call_fold(p, row, &call, value)
                   : call_arguments(p, row->signature, &call, word->text);
    if (!ok || !expect(p, TOKEN_RPAREN, open))
        return false;
    call.span = span_join(call.span, p->last_span);
    if (!fold)
        call_run(p, row, &call, value);
    return true;
}
