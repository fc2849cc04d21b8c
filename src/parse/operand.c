/* Operands of expressions: numbers, strings, vectors, parentheses, constants,
 * identifiers, and their components. */
#include <ctype.h>
#include <stdlib.h>

#include <limits.h>

#include "parse/array.h"
#include "parse/expression.h"
#include "parse/function.h"
#include "parse/mistaken.h"
#include "parse/spline.h"
#include "parse/stream.h"
#include "parse/symbol.h"
#include "parse/user_function.h"

enum { VECTOR_LIMIT = 5 }; /* components */

/* ---- values as the types wanted ---- */

const char *value_describe(const struct value *value)
{
    static const char *const vectors[] = { "a vector with 2 components",
                                           "a vector with 3 components",
                                           "a vector with 4 components",
                                           "a vector with 5 components" };
    if (value->kind == VALUE_VECTOR)
        return vectors[value->size - 2];
    return value_kind_name(value->kind);
}

void value_promote(struct value *value, int size)
{
    bool scalar = value->kind == VALUE_FLOAT;
    for (int i = value_size(value); i < size; i++)
        value->number[i] = scalar ? value->number[0] : 0;
    if (size > 1 && value->kind != VALUE_COLOUR) {
        value->kind = VALUE_VECTOR;
        value->size = size;
    }
}

/* `V.0`, `V[0]` or `V(0)` of a vector: its parts are V.x, V.y and V.z. */
static const char *value_as_part(struct parser *p, struct span span,
                                 const struct value *value, const char *wanted)
{
    const char *text = span.source->text + span.offset;
    if (strcmp(wanted, "a number") != 0 || value->kind != VALUE_VECTOR ||
        span.length > 40 || !isalpha((unsigned char)*text) ||
        !strchr(".[(", text[span.length]) || !text[span.length])
        return NULL;
    int part = atoi(text + span.length + 1);
    return arena_printf(p->arena, "%.*s.%c", (int)span.length, text,
                        part == 1   ? 'y'
                        : part == 2 ? 'z'
                                    : 'x');
}

/* A number among arguments, or behind #debug, #warning or #error (whose last
 * letters are looked at), where a string is wanted. */
static const char *value_as_text(struct parser *p, struct span span,
                                 const struct value *value, const char *wanted)
{
    size_t before = span.offset;
    while (before > 0 && span.source->text[before - 1] == ' ')
        before--;
    if (strcmp(wanted, "a string") != 0 || value->kind != VALUE_FLOAT ||
        span.length > 40 || before == 0 ||
        !strchr("(,gr", span.source->text[before - 1]))
        return NULL;
    return arena_printf(p->arena, "str(%.*s, 0, 3)", (int)span.length,
                        span.source->text + span.offset);
}

static bool value_mismatch(struct parser *p, struct span start,
                           const struct value *value, const char *wanted)
{
    if (value_is_poison(value))
        return false;
    struct span span = span_join(start, p->last_span);
    const char *hint = value_as_part(p, span, value, wanted);
    if (!hint)
        hint = wanted_signature(p, 0);
    if (!hint)
        hint = value_as_text(p, span, value, wanted);
    return error_at(p, span, hint, "expected %s, found %s",
                    wanted_field(p, wanted, 0), value_describe(value));
}

bool value_to_float(struct parser *p, struct span start,
                    const struct value *value, double *out)
{
    if (value->kind != VALUE_FLOAT)
        return value_mismatch(p, start, value, "a number");
    *out = value->number[0];
    return true;
}

bool value_to_vector(struct parser *p, struct span start,
                     const struct value *value, vec3 *out)
{
    struct value vector = *value;
    int size = value_size(value);
    if (size < 1 || size > 3)
        return value_mismatch(p, start, value, "a vector");
    if (size < 3 && !(value->kind == VALUE_FLOAT && value->size > 0))
        value_promote(&vector, 3);
    *out = vec3_make(vector.number[0], vector.number[1], vector.number[2]);
    return true;
}

bool value_to_text(struct parser *p, struct span start,
                   const struct value *value, const char **out)
{
    if (value->kind != VALUE_STRING)
        return value_mismatch(p, start, value, "a string");
    *out = value->text;
    return true;
}

int float_to_int(double x)
{
    return x > -2147483649.0 && x < 2147483648.0 ? (int)x : INT_MIN;
}

/* ---- brackets ---- */

bool skip_brackets(struct parser *p)
{
    struct span open = stream_span(p);
    unsigned depth = 0;
    do {
        enum token_kind kind = stream_next(p).kind;
        if (kind == TOKEN_LPAREN || kind == TOKEN_LBRACE ||
            kind == TOKEN_LBRACKET)
            depth++;
        else if (kind == TOKEN_RPAREN || kind == TOKEN_RBRACE ||
                 kind == TOKEN_RBRACKET)
            depth--;
        else if (kind == TOKEN_END)
            return error_at(p, open, NULL, "this bracket is never closed");
    } while (depth > 0);
    return true;
}

/* After an error in brackets: to the one that closes them, so that the rest of
 * the text makes sense again. Poison is then the value. */
static bool operand_recover(struct parser *p, enum token_kind close, bool ok,
                            struct value *value)
{
    if (ok)
        return true;
    *value = value_poison();
    for (unsigned depth = 0;; stream_next(p)) {
        enum token_kind kind = stream_peek(p)->kind;
        if (kind == close && depth == 0)
            break;
        if (kind == TOKEN_END || kind == TOKEN_SEMICOLON ||
            kind == TOKEN_LBRACE || kind == TOKEN_RBRACE ||
            (depth == 0 && (kind == TOKEN_RPAREN || kind == TOKEN_RBRACKET)))
            return false;
        depth += kind == TOKEN_LPAREN || kind == TOKEN_LBRACKET;
        depth -= kind == TOKEN_RPAREN || kind == TOKEN_RBRACKET;
    }
    stream_next(p);
    return true;
}

/* The same of <1 -1 0>, which is <0, 0>. */
static void vector_subtracted_first(struct parser *p, struct span open)
{
    const char *text = open.source->text;
    size_t at = open.offset + 1 + strspn(text + open.offset + 1, " ");
    size_t blank = at + strspn(text + at, "0123456789.");
    size_t length = text[blank] == ' ' && text[blank + 1] == '-'
                        ? 1 + strspn(text + blank + 2, "0123456789.")
                        : 0;
    if (blank == at || length < 2)
        return;
    struct span minus = { open.source, (uint32_t)(blank + 1),
                          (uint32_t)length };
    warning_at(p, minus,
               arena_printf(p->arena, ", %.*s", (int)length, text + blank + 1),
               "this is subtracted from what stands before it, which leaves "
               "a vector of 2 components; a comma makes it the second");
}

const char *subtracted_hint(struct parser *p, struct span *minus)
{
    struct span last = p->last_span;
    const char *text = last.source ? last.source->text : NULL;
    if (!text || last.offset < 2 || text[last.offset - 1] != '-' ||
        text[last.offset - 2] != ' ')
        return NULL;
    last.offset--;
    last.length++;
    *minus = last;
    return arena_printf(p->arena, ", %.*s", (int)last.length,
                        text + last.offset);
}

/* Where no comma stands between the components <0 0 -1> has two, and <1 -1> is
 * no vector. */
static bool vector_subtracted(struct parser *p, int size)
{
    struct span minus;
    const char *hint = subtracted_hint(p, &minus);
    if (!hint)
        return false;
    if (size == 1)
        error_at(p, minus, hint,
                 "this is subtracted from what stands before it; a comma makes "
                 "it a component");
    else
        warning_at(
            p, minus, hint,
            "this is subtracted from what stands before it, which leaves "
            "a vector of 2 components; a comma makes it the third");
    return true;
}

/* Enough components, and then none. */
static bool vector_unclosed(struct parser *p, struct span open)
{
    error_expected(p, "a number or '>'");
    note_at(p, open, "to match this '<'");
    return false;
}

/* A comma between components is optional, one after the last allowed.
 * vector_value = "<" float [","] float {[","] float} [","] ">" . */
static bool parse_vector_value(struct parser *p, struct value *value)
{
    double numbers[VECTOR_LIMIT] = { 0 };
    int size = 0;
    bool comma = false, commas = false;
    struct span open = stream_span(p);
    stream_next(p);
    while (size < VECTOR_LIMIT &&
           (size < 2 || stream_peek(p)->kind != TOKEN_GREATER)) {
        if (size > 1 && !comma && !at_number(p))
            break;
        if (size > 2 && !at_number(p))
            return vector_unclosed(p, open);
        if (size == 1 && stream_peek(p)->kind == TOKEN_GREATER)
            return comma ? error_expected(p, "a number")
                   : !commas && vector_subtracted(p, size)
                       ? false
                       : error_at(p, stream_span(p), NULL,
                                  "a vector has two components at least; a "
                                  "number stands without '<' and '>'");
        if (!parse_float(p, &numbers[size++]))
            return false;
        comma = accept(p, TOKEN_COMMA);
        commas |= comma;
    }
    if (size == 2 && stream_peek(p)->kind == TOKEN_GREATER && !commas &&
        !vector_subtracted(p, size))
        vector_subtracted_first(p, open);
    if (stream_peek(p)->kind == TOKEN_GREATER_EQUAL)
        return error_at(p, p->token_span, "> =",
                        "'>=' is one operator; put a space between the '>' "
                        "that closes the vector and '='");
    if (size == VECTOR_LIMIT && stream_peek(p)->kind != TOKEN_GREATER)
        return error_at(p, stream_span(p), NULL,
                        "a vector has %d components at most", VECTOR_LIMIT);
    if (!expect(p, TOKEN_GREATER, open))
        return false;
    *value = (struct value){ .kind = VALUE_VECTOR, .size = size };
    memcpy(value->number, numbers, sizeof numbers);
    return true;
}

/* What stands in round brackets in angular ones, if it is short. */
static const char *parentheses_hint(struct parser *p, struct span open)
{
    const char *text = open.source->text + open.offset + 1;
    size_t length = strcspn(text, "()<>{}\n");
    return text[length] == ')' && length < 60
               ? arena_printf(p->arena, "<%.*s>", (int)length, text)
               : NULL;
}

/* parentheses = "(" operation ")" . */
static bool parse_parentheses(struct parser *p, const char *wanted,
                              struct value *value)
{
    struct span open = stream_span(p);
    stream_next(p);
    if (!parse_operation(p, PRECEDENCE_CONDITION, wanted, value))
        return false;
    value_settle(value);
    if (stream_peek(p)->kind != TOKEN_COMMA)
        return expect(p, TOKEN_RPAREN, open);
    error_at(p, stream_span(p), parentheses_hint(p, open),
             "expected ')', found ','; a vector is written <1, 2, 3>");
    note_at(p, open, "to match this '('");
    return false;
}

/* ---- identifiers ---- */

/* Subscripts and arguments of what was reported. */
static bool operand_skip_call(struct parser *p)
{
    for (;;) {
        enum token_kind kind = stream_peek_infix(p)->kind;
        if (kind != TOKEN_LPAREN && kind != TOKEN_LBRACKET)
            return true;
        if (!skip_brackets(p))
            return false;
    }
}

/* An identifier without a value, reported by now: it and what belongs to it
 * is read over. */
static bool operand_skip_identifier(struct parser *p, struct value *value)
{
    stream_next(p);
    *value = value_poison();
    return operand_skip_call(p);
}

static bool operand_element(struct parser *p, const char *wanted,
                            const struct word *word, struct value *value)
{
    struct span start = p->last_span;
    struct value *slot;
    if (stream_peek_infix(p)->kind != TOKEN_LBRACKET) {
        size_t left;
        const char *which = stream_peek_infix(p)->kind == TOKEN_DOT &&
                                    stream_raw(p, &left)->kind == TOKEN_WORD
                                ? "dimension_size(%s, 1) ..."
                                : "%s[0]";
        error_at(p, start, arena_printf(p->arena, which, word->text),
                 "expected %s, found '%s', which is an array", wanted,
                 word->text);
        *value = value_poison();
        return true;
    }
    if (!array_element(p, value->array, &slot))
        return false;
    start = span_join(start, p->last_span);
    *value = *slot;
    if (slot->kind == VALUE_NONE) {
        error_at(p, start, NULL, "this element of '%s' was never set",
                 word->text);
        *value = value_poison();
    }
    if (slot->kind == VALUE_SPLINE &&
        stream_peek_infix(p)->kind == TOKEN_LPAREN)
        return spline_call(p, slot->spline, word, value);
    if (slot->kind == VALUE_FUNCTION &&
        stream_peek_infix(p)->kind == TOKEN_LPAREN)
        return function_call(p, slot->function, word, value);
    if (slot->kind == VALUE_NONE || slot->kind == VALUE_POISON ||
        value_size(value) || slot->kind == VALUE_STRING ||
        slot->kind == VALUE_SPLINE)
        return true;
    return error_at(p, start, NULL, "expected %s, found %s", wanted,
                    value_kind_name(slot->kind));
}

/* identifier = word [subscripts] [argument_list] | spline_call . */
static bool parse_identifier(struct parser *p, const char *wanted,
                             struct value *value)
{
    const struct word *word = stream_peek(p)->word;
    struct symbol *symbol = symbol_lookup(p, word);
    if (!symbol || symbol->value.kind == VALUE_NONE) {
        error_expected(p, wanted);
        return operand_skip_identifier(p, value);
    }
    value_copy(value, &symbol->value);
    switch (value->kind) {
    case VALUE_POISON:
        return operand_skip_identifier(p, value);
    case VALUE_FLOAT:
    case VALUE_VECTOR:
    case VALUE_COLOUR:
    case VALUE_STRING:
    case VALUE_ARRAY:
    case VALUE_FUNCTION:
    case VALUE_SPLINE:
        break;
    default:
        return error_expected(p, wanted);
    }
    symbol_warn(p, symbol, p->token_span);
    stream_next(p);
    if (value->kind == VALUE_ARRAY)
        return operand_element(p, wanted, word, value);
    if (value->kind == VALUE_FUNCTION)
        return function_call(p, value->function, word, value);
    if (value->kind == VALUE_SPLINE)
        return spline_call(p, value->spline, word, value);
    return true;
}

/* ---- operands ---- */

/* Number of components there must be, by the component's name; -1: gray. */
static int component_index(const struct word *word)
{
    switch (word->keyword) {
    case KEYWORD_X:
    case KEYWORD_U:
    case KEYWORD_RED:
        return 0;
    case KEYWORD_Y:
    case KEYWORD_V:
    case KEYWORD_GREEN:
        return 1;
    case KEYWORD_Z:
    case KEYWORD_BLUE:
        return 2;
    case KEYWORD_T:
    case KEYWORD_FILTER:
        return 3;
    case KEYWORD_TRANSMIT:
        return 4;
    case KEYWORD_GRAY:
        return -1;
    default:
        return -2;
    }
}

/* V.X is meant as V.x. */
static const char *component_other_case(struct parser *p, struct span span)
{
    const struct word *word =
        mistaken_case(p, span.source->text + span.offset, span.length);
    return component_index(word) != -2 ? word->text : NULL;
}

/* The grey of a colour has POV-Ray's weights (measured). A float has the
 * component x, as in POV-Ray.
 * component = "x" | "y" | "z" | "t" | "u" | "v" | "red" | "green" | "blue"
 *           | "filter" | "transmit" | "gray" . */
static bool parse_component(struct parser *p, struct value *value)
{
    const struct token *token = stream_peek(p);
    int index = token->kind == TOKEN_WORD ? component_index(token->word) : -2;
    if (token->kind != TOKEN_WORD)
        return error_expected(p, "a component, as in V.x");
    struct span span = p->token_span;
    stream_next(p);
    if (value_is_poison(value))
        return operand_skip_call(p);
    if (index == -2) {
        error_at(p, span, component_other_case(p, span),
                 "'%.*s' is not a component; there are x, y, z, t, u, v, red, "
                 "green, blue, filter, transmit and gray",
                 (int)span.length, span.source->text + span.offset);
        *value = value_poison();
        return true;
    }
    if (index >= value_size(value) || (index < 0 && value_size(value) < 3)) {
        error_at(p, span, NULL, "%s has no component '%.*s'",
                 value_describe(value), (int)span.length,
                 span.source->text + span.offset);
        *value = value_poison();
        return true;
    }
    bool scalar = value->kind == VALUE_FLOAT;
    value_promote(value, VECTOR_LIMIT);
    double *n = value->number;
    n[0] = index >= 0 ? n[index] : grey_of(n[0], n[1], n[2]);
    value->kind = VALUE_FLOAT;
    value->size = scalar ? 0 : VECTOR_LIMIT;
    return true;
}

/* Whether nothing of the expression has been read, as its value is the first
 * in a block. */
static bool operand_is_first(const struct parser *p)
{
    struct span last = p->last_span;
    return last.source && last.source->text[last.offset] == '{';
}

static bool parse_word_operand(struct parser *p, const char *wanted,
                               struct value *value)
{
    const struct word *word = stream_peek(p)->word;
    if (!word->reserved)
        return parse_identifier(p, wanted, value);
    if (parse_constant(p, word->keyword, value)) {
        stream_next(p);
        return true;
    }
    if (function_is(word->keyword)) {
        struct cursor *outer = brackets_begin(p);
        bool ok = operand_recover(p, TOKEN_RPAREN, parse_call(p, value), value);
        return brackets_end(p, outer, ok);
    }
    if (colour_begins(word->keyword) && strcmp(wanted, "a number") == 0 &&
        isalpha((unsigned char)p->last_span.source->text[p->last_span.offset]))
        return error_expected(p, wanted);
    if (colour_begins(word->keyword) && !operand_is_first(p))
        return error_at(p, p->token_span, NULL,
                        "'%s' is only allowed at the beginning of a colour, "
                        "as in: rgb 0.5 * <1, 0.8, 0>",
                        word->text);
    return error_expected(p, wanted);
}

/* primary = number | string | vector_value | parentheses | constant | call
 *         | identifier . */
static bool parse_primary(struct parser *p, const char *wanted,
                          struct value *value)
{
    const struct token *token = stream_peek(p);
    struct cursor *outer;
    bool ok;
    switch (token->kind) {
    case TOKEN_NUMBER:
        value_set_float(value, stream_next(p).number);
        return true;
    case TOKEN_STRING:
        *value = value_text(stream_next(p).text);
        return true;
    case TOKEN_LESS:
        outer = brackets_begin(p);
        ok = operand_recover(p, TOKEN_GREATER, parse_vector_value(p, value),
                             value);
        return brackets_end(p, outer, ok);
    case TOKEN_LPAREN:
        outer = brackets_begin(p);
        ok = operand_recover(p, TOKEN_RPAREN,
                             parse_parentheses(p, wanted, value), value);
        return brackets_end(p, outer, ok);
    case TOKEN_WORD:
        return parse_word_operand(p, wanted, value);
    default:
        if (!string_unquoted(p, &value->text))
            return error_expected(p, wanted);
        *value = value_text(value->text);
        return true;
    }
}

/* operand = primary ["." component] . */
bool parse_operand(struct parser *p, const char *wanted, struct value *value)
{
    if (!parse_primary(p, wanted, value))
        return false;
    if (stream_peek_infix(p)->kind != TOKEN_DOT)
        return true;
    struct span dot = p->token_span;
    if (value->kind == VALUE_STRING)
        return error_at(p, dot, NULL, "a string has no components");
    stream_next(p);
    return parse_component(p, value);
}
