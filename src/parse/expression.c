/* Expressions as the rest of the parser reads them: a number, a vector, a
 * string ... with fast paths for what meshes are full of. */
#include "parse/expression.h"

#include <ctype.h>
#include <limits.h>

#include "base/text.h"
#include "parse/array.h"
#include "parse/function.h"
#include "parse/spline.h"
#include "parse/stream.h"
#include "parse/symbol.h"
#include "parse/user_function.h"
#include "scene/function.h"

enum { VECTOR_LIMIT = 5 }; /* components */

/* A number followed by punctuation is a whole expression. */
static bool float_at_once(struct parser *p, double *out)
{
    if (stream_peek(p)->kind != TOKEN_NUMBER)
        return false;
    size_t available;
    const struct token *after = stream_raw(p, &available);
    if (!available ||
        (after->kind != TOKEN_COMMA && after->kind != TOKEN_RPAREN &&
         after->kind != TOKEN_RBRACE && after->kind != TOKEN_RBRACKET &&
         after->kind != TOKEN_SEMICOLON))
        return false;
    *out = stream_next(p).number;
    return true;
}

/* float = operation . */
bool parse_float(struct parser *p, double *out)
{
    struct value value;
    if (float_at_once(p, out))
        return true;
    struct span start = stream_span(p);
    return parse_operation(p, PRECEDENCE_SUM, "a number", &value) &&
           value_to_float(p, start, &value, out);
}

/* The condition with its ')'; NULL: it is too long to be shown. */
static const char *condition_closed(struct parser *p, struct span open,
                                    struct span last)
{
    size_t length = last.offset + last.length - open.offset;
    bool shown = open.source == last.source && last.offset >= open.offset &&
                 length < 60 &&
                 !memchr(open.source->text + open.offset, '\n', length);
    return shown ? arena_printf(p->arena, "%.*s)", (int)length,
                                open.source->text + open.offset)
                 : NULL;
}

/* The ')' of a condition: where the line ends without it, what follows is not
 * told of. */
static bool condition_closes(struct parser *p, struct span open)
{
    struct span last = p->last_span;
    if (accept(p, TOKEN_RPAREN))
        return true;
    struct span next = p->token_span;
    size_t end = last.offset + last.length;
    bool here = next.source == last.source && next.offset >= end &&
                !memchr(next.source->text + end, '\n', next.offset - end);
    if (here || !last.source || p->token.kind == TOKEN_END)
        return expect(p, TOKEN_RPAREN, open);
    error_at(p, open, condition_closed(p, open, last),
             "the '(' of this condition is not closed");
    p->blamed = p->last_span;
    return false;
}

const char *condition_hint(struct parser *p, struct span start)
{
    const char *text = start.source->text + start.offset;
    size_t length = strcspn(text, "(){}#\r\n"), number = start.length;
    size_t behind = number + strspn(text + number, " ");
    if (stream_peek(p)->kind == TOKEN_NUMBER &&
        (strchr(":\"", text[behind]) || isalpha((unsigned char)text[behind])))
        return arena_printf(p->arena, "(%.*s)", (int)number, text);
    bool whole = text[length] && strchr("#\r\n", text[length]);
    while (length > 0 && text[length - 1] == ' ')
        length--;
    return whole && length < 40
               ? arena_printf(p->arena, "(%.*s)", (int)length, text)
               : "(";
}

/* The directive's parentheses are read here, since they allow comparisons.
 * condition = operation . */
bool parse_condition(struct parser *p, double *out)
{
    struct value value;
    struct span open = stream_span(p);
    if (!accept(p, TOKEN_LPAREN))
        return error_expected_hint(p, "'('", condition_hint(p, open));
    struct cursor *outer = brackets_begin(p);
    struct span start = stream_span(p);
    bool ok = parse_operation(p, PRECEDENCE_CONDITION, "a condition", &value) &&
              condition_closes(p, open);
    if (!brackets_end(p, outer, ok) || !value_to_float(p, start, &value, out))
        return false;
    if (!operator_truth(*out))
        *out = 0;
    return true;
}

/* integer = operation . */
bool parse_integer(struct parser *p, int *out)
{
    double number;
    struct span start = stream_span(p);
    if (!parse_float(p, &number))
        return false;
    if (!(fabs(number) < INT_MAX))
        return error_at(p, span_join(start, p->last_span), NULL,
                        "expected a whole number, found %s",
                        NUMBER_TEXT(number));
    *out = (int)number;
    return true;
}

/* Whether the next token is on, off ... mistyped, rather than an item of the
 * block mistyped; reports. Which of both is told from what comes after it:
 * items have blocks and values. */
static bool bool_mistyped(struct parser *p)
{
    static const char *const words[] = { "off",   "on",  "true",
                                         "false", "yes", "no" };
    size_t available;
    const struct token *token = stream_peek(p);
    if (token->kind != TOKEN_WORD || token->word->reserved ||
        symbol_lookup(p, token->word))
        return false;
    struct text_nearest nearest = text_nearest_start(token->word->text);
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        text_nearest_try(&nearest, words[i]);
    const struct token *after = stream_raw(p, &available);
    if (!nearest.best ||
        (available && after->kind != TOKEN_RBRACE && after->kind != TOKEN_WORD))
        return false;
    error_at(p, stream_span(p), nearest.best,
             "expected 'on' or 'off', found '%s'", token->word->text);
    return true;
}

/* bool = [operation] . */
bool parse_bool(struct parser *p, bool *out)
{
    double number = 1;
    *out = true; /* also after an error: callers may put it away unseen */
    if (bool_mistyped(p))
        return false;
    if (at_number(p) && !parse_float(p, &number))
        return false;
    *out = operator_truth(number);
    return true;
}

/* [sign] number, as written, from raw token *i on. */
static bool raw_number(const struct token *tokens, size_t available, size_t *i,
                       double *out)
{
    bool minus = *i < available && tokens[*i].kind == TOKEN_MINUS;
    *i += minus;
    if (*i >= available || tokens[*i].kind != TOKEN_NUMBER)
        return false;
    *out = minus ? -tokens[*i].number : tokens[*i].number;
    ++*i;
    return true;
}

/* The fast path of meshes: `<1, -2, 3>` written with plain numbers and commas,
 * and nothing after it that could be an operator or become one. Returns the
 * number of components, 0 if the slow path has to look. */
static int vector_at_once(struct parser *p, double numbers[VECTOR_LIMIT])
{
    if (stream_peek(p)->kind != TOKEN_LESS)
        return 0;
    size_t available, i = 0;
    int size = 0;
    const struct token *tokens = stream_raw(p, &available);
    while (size < VECTOR_LIMIT) {
        if (!raw_number(tokens, available, &i, &numbers[size++]) ||
            i + 1 >= available)
            return 0;
        if (tokens[i++].kind != TOKEN_COMMA)
            break;
    }
    if (size < 2 || tokens[i - 1].kind != TOKEN_GREATER)
        return 0;
    enum token_kind after = tokens[i].kind;
    if (after != TOKEN_COMMA && after != TOKEN_RBRACE && after != TOKEN_LESS &&
        after != TOKEN_NUMBER && after != TOKEN_SEMICOLON)
        return 0;
    stream_skip_raw(p, i);
    return size;
}

/* vector = operation . */
bool parse_vector(struct parser *p, vec3 *out)
{
    struct value value = { .kind = VALUE_VECTOR };
    struct span start = stream_span(p);
    value.size = vector_at_once(p, value.number);
    if (!value.size && !parse_operation(p, PRECEDENCE_SUM, "a vector", &value))
        return false;
    return value_to_vector(p, start, &value, out);
}

/* components = operation . */
bool parse_components(struct parser *p, double *out, int size)
{
    struct value value = { .kind = VALUE_VECTOR };
    struct span start = stream_span(p);
    value.size = vector_at_once(p, value.number);
    if (!value.size && !parse_operation(p, PRECEDENCE_SUM, "a vector", &value))
        return false;
    if (value_is_poison(&value))
        return false;
    if (value_size(&value) == 0 || value_size(&value) > size)
        return error_at(p, span_join(start, p->last_span), NULL,
                        "expected a vector with %d components, found %s", size,
                        value_describe(&value));
    value_promote(&value, size);
    memcpy(out, value.number, sizeof *out * (size_t)size);
    return true;
}

/* The length of the name of a file without quotes, told by its dot, or of a
 * string in single quotes; 0: the next token begins neither. */
static size_t string_misquoted(struct parser *p)
{
    const struct token *token = stream_peek_infix(p);
    if (token->kind == TOKEN_END)
        return 0;
    const char *text = p->token_span.source->text + p->token_span.offset;
    size_t inside = *text == '\'' ? strcspn(text + 1, "'\n") : 0;
    if (inside && text[1 + inside] == '\'')
        return inside + 2;
    inside = *text == '<' ? strcspn(text + 1, " ,>\n") : 0;
    if (inside && text[1 + inside] == '>' && isalpha((unsigned char)text[1]) &&
        memchr(text, '.', inside))
        return inside + 2; /* <colors.inc>, as C has it */
    size_t length = strcspn(text, " \t\r\n;,(){}\"");
    bool name = token->kind == TOKEN_WORD &&
                (token->word->reserved ? !function_is(token->word->keyword)
                                       : !symbol_lookup(p, token->word));
    return name && memchr(text, '.', length) ? length : 0;
}

bool string_unquoted(struct parser *p, const char **out)
{
    size_t length = string_misquoted(p);
    struct span span = p->token_span;
    if (length == 0)
        return false;
    const char *text = span.source->text + span.offset;
    bool quoted = *text == '\'' || *text == '<';
    span.length = (uint32_t)length;
    *out = arena_copy_text(p->arena, text + quoted, length - 2 * quoted);
    error_at(p, span, arena_printf(p->arena, "\"%s\"", *out),
             "a string stands in double quotes");
    if (text[length] == '"') {
        note_at(p, span_none(),
                "the rest is not read: which quotes belong together is unknown "
                "without this one");
        stream_abort(p);
        return true;
    }
    do
        stream_next(p);
    while (stream_peek_infix(p)->kind != TOKEN_END &&
           p->token_span.source == span.source &&
           p->token_span.offset < span.offset + span.length);
    return true;
}

bool parse_string(struct parser *p, const char **out)
{
    struct value value;
    if (string_unquoted(p, out))
        return true;
    struct span start = stream_span(p);
    return parse_operand(p, "a string", &value) &&
           value_to_text(p, start, &value, out);
}

static bool expression_colour(struct parser *p, struct value *value)
{
    colour c;
    if (!parse_colour(p, &c))
        return false;
    *value =
        (struct value){ .kind = VALUE_COLOUR,
                        .number = { c.r, c.g, c.b, c.filter, c.transmit } };
    return true;
}

/* What is copied whole: no operators apply to it. */
static bool kind_is_thing(enum value_kind kind)
{
    return kind >= VALUE_OBJECT && kind <= VALUE_SKY_SPHERE;
}

/* Whether no operator follows. */
static bool kind_ends(const struct token *tokens, size_t available, size_t i)
{
    enum token_kind kind = i < available ? tokens[i].kind : TOKEN_END;
    return operator_precedence(kind) == PRECEDENCE_NONE && kind != TOKEN_DOT;
}

/* Whether the identifier that is next, whose value is `value`, and the token
 * after it stand for a texture, a whole array ... rather than an operand. */
static bool expression_is_thing(struct parser *p, const struct value *value)
{
    size_t available;
    const struct token *after = stream_raw(p, &available);
    enum token_kind kind = available ? after->kind : TOKEN_END;
    bool ends = kind_ends(after, available, 0);
    if (value->kind == VALUE_ARRAY && kind == TOKEN_LBRACKET)
        return kind_is_thing(array_kind(value->array)) ||
               (array_of_arrays(value->array) &&
                kind_ends(after, available,
                          array_subscripts_end(after, available, 0)));
    if (value->kind == VALUE_ARRAY)
        return ends;
    if (value->kind == VALUE_FUNCTION || value->kind == VALUE_SPLINE)
        return ends && kind != TOKEN_LPAREN;
    return kind_is_thing(value->kind);
}

static bool thing_element(struct parser *p, const struct word *word,
                          struct value *value)
{
    struct value *slot;
    struct span at = p->last_span;
    if (!array_element(p, value->array, &slot))
        return false;
    *value = *slot;
    if (slot->kind == VALUE_NONE)
        error_at(p, span_join(at, p->last_span), NULL,
                 "this element of '%s' was never set", word->text);
    if (slot->kind == VALUE_ARRAY)
        return array_copy(p, span_join(at, p->last_span), slot->array,
                          &value->array);
    return slot->kind != VALUE_POISON && slot->kind != VALUE_NONE;
}

/* The name of a whole array, of a function, of a texture ...
 * thing_name = word [subscripts] . */
static enum taken parse_thing_name(struct parser *p, struct value *value)
{
    const struct token *token = stream_peek(p);
    const struct word *word = token->word;
    struct span at = p->token_span;
    struct symbol *symbol = token->kind == TOKEN_WORD && !word->reserved
                                ? symbol_lookup(p, word)
                                : NULL;
    if (!symbol || !expression_is_thing(p, &symbol->value))
        return NOT_MINE;
    symbol_warn(p, symbol, at);
    stream_next(p);
    *value = symbol->value;
    if (value->kind != VALUE_ARRAY)
        return TAKEN;
    if (stream_peek_infix(p)->kind == TOKEN_LBRACKET)
        return thing_element(p, word, value);
    return array_copy(p, at, value->array, &value->array);
}

/* expression = colour | array | function | spline | thing_name
 *            | operation [channels] . */
bool parse_expression(struct parser *p, struct value *value)
{
    double number;
    if (float_at_once(p, &number)) {
        value_set_float(value, number);
        return true;
    }
    enum keyword keyword = stream_keyword(p);
    if (colour_begins(keyword))
        return expression_colour(p, value);
    if (keyword == KEYWORD_ARRAY)
        return parse_array(p, value);
    if (keyword == KEYWORD_FUNCTION)
        return parse_function(p, value);
    if (keyword == KEYWORD_SPLINE) {
        value->kind = VALUE_SPLINE;
        return parse_spline(p, &value->spline);
    }
    enum taken taken = parse_thing_name(p, value);
    if (taken != NOT_MINE)
        return taken;
    bool whole = p->directive && p->directive == p->cursor;
    if (!parse_operation(p, whole ? PRECEDENCE_WHOLE : PRECEDENCE_SUM,
                         "a value", value) ||
        value_is_poison(value))
        return false;
    value_settle(value);
    return value->kind != VALUE_COLOUR || parse_channels(p, value);
}

/* ---- what follows, told without reading it ---- */

/* What a declared name, subscribed or called if it can be, gives. */
static enum value_kind name_gives(struct parser *p, const struct word *word)
{
    const struct value *value = symbol_find(p, word);
    if (!value)
        return VALUE_NONE;
    switch (value->kind) {
    case VALUE_ARRAY:
        return array_kind(value->array);
    case VALUE_FUNCTION:
        return value->function->values ? VALUE_VECTOR : VALUE_FLOAT;
    case VALUE_SPLINE:
        return VALUE_VECTOR;
    default:
        return value->kind;
    }
}

/* What the word that is peeked gives; VALUE_NONE: it begins no expression. */
static enum value_kind word_gives(struct parser *p, const struct word *word)
{
    if (!word->reserved)
        return name_gives(p, word);
    if (constant_is(p, word->keyword))
        return constant_is_number(p, word->keyword) ? VALUE_FLOAT
                                                    : VALUE_VECTOR;
    if (colour_begins(word->keyword))
        return VALUE_COLOUR;
    return function_gives(word->keyword);
}

/* Whether a '.' follows the name that is peeked, its subscripts and its
 * arguments. */
static bool at_component(struct parser *p)
{
    size_t left, at = 0;
    unsigned depth = 0;
    const struct token *tokens = stream_raw(p, &left);
    for (; at < left; at++) {
        enum token_kind kind = tokens[at].kind;
        if (kind == TOKEN_LPAREN || kind == TOKEN_LBRACKET)
            depth++;
        else if (depth == 0)
            break;
        else if (kind == TOKEN_RPAREN || kind == TOKEN_RBRACKET)
            depth--;
    }
    return at < left && tokens[at].kind == TOKEN_DOT;
}

bool at_number(struct parser *p)
{
    const struct token *token = stream_peek(p);
    switch (token->kind) {
    case TOKEN_NUMBER:
    case TOKEN_LPAREN:
    case TOKEN_PLUS:
    case TOKEN_MINUS:
    case TOKEN_NOT:
        return true;
    case TOKEN_WORD:
        break;
    default:
        return false;
    }
    enum value_kind kind = word_gives(p, token->word);
    return kind == VALUE_FLOAT ||
           ((kind == VALUE_VECTOR || kind == VALUE_COLOUR) && at_component(p));
}

bool at_expression(struct parser *p)
{
    const struct token *token = stream_peek(p);
    if (token->kind == TOKEN_LESS || token->kind == TOKEN_STRING ||
        at_number(p))
        return true;
    enum value_kind kind =
        token->kind == TOKEN_WORD ? word_gives(p, token->word) : VALUE_NONE;
    return kind == VALUE_VECTOR || kind == VALUE_COLOUR || kind == VALUE_STRING;
}
