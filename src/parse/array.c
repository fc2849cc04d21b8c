/* Arrays: see array.h. */
#include "parse/array.h"

#include "base/text.h"
#include "parse/expression.h"
#include "parse/stream.h"

enum {
    ARRAY_DIMENSIONS = 5, /* as POV-Ray */
    ARRAY_LIMIT = 10000000,
    ARRAY_LARGE = 1000,      /* elements: is there memory for more? */
    ARRAY_DEPTH_LIMIT = 100, /* arrays in elements of arrays */
};

struct array {
    int dimensions;
    int size[ARRAY_DIMENSIONS];
    size_t count;
    enum value_kind kind;   /* of all elements that have a value */
    int vector_size;        /* the same of vectors, else 0 */
    struct value *elements; /* the last subscript runs fastest */
    struct value *touched;  /* the one last asked for, or NULL */
};

int array_dimensions(const struct array *array)
{
    return array->dimensions;
}

int array_dimension_size(const struct array *array, int dimension)
{
    return dimension >= 1 && dimension <= array->dimensions
               ? array->size[dimension - 1]
               : 0;
}

/* The one last asked for, or the first that has a value; or NULL. */
static const struct value *array_example(const struct array *array)
{
    if (array->touched && array->touched->kind != VALUE_NONE)
        return array->touched;
    for (size_t i = 0; i < array->count; i++)
        if (array->elements[i].kind != VALUE_NONE)
            return &array->elements[i];
    return NULL;
}

bool array_of_arrays(const struct array *array)
{
    const struct value *example = array_example(array);
    return example && example->kind == VALUE_ARRAY;
}

const struct value *array_sample(const struct array *array)
{
    const struct value *example = array_example(array);
    while (example && example->kind == VALUE_ARRAY)
        example = array_example(example->array);
    return example;
}

enum value_kind array_kind(const struct array *array)
{
    const struct value *first = array_sample(array);
    return first ? first->kind : VALUE_NONE;
}

/* ---- subscripts ---- */

/* "[" number "]"; the place of the number into *start. */
static bool array_number(struct parser *p, double *number, struct span *start)
{
    struct span open = stream_span(p);
    if (!expect(p, TOKEN_LBRACKET, span_none()))
        return false;
    struct cursor *outer = brackets_begin(p);
    *start = stream_span(p);
    bool ok = parse_float(p, number);
    if (ok && stream_peek(p)->kind == TOKEN_COMMA)
        ok = error_at(p, p->token_span, "][",
                      "expected ']', found ','; each dimension has its own "
                      "brackets");
    else
        ok = ok && expect(p, TOKEN_RBRACKET, open);
    return brackets_end(p, outer, ok);
}

/* Rounding errors of 0.1 * 30 are forgiven as POV-Ray does (measured). */
static bool array_index(struct parser *p, int size, size_t *index)
{
    double number;
    struct span start;
    if (!array_number(p, &number, &start))
        return false;
    number = floor(number + OPERATOR_EPSILON);
    if (!(number >= 0 && number < size))
        return error_at(p, start, NULL,
                        size == 1 ? "this subscript is %s, but the only "
                                    "element has number %d"
                                  : "this subscript is %s, but elements are "
                                    "numbered from 0 to %d",
                        NUMBER_TEXT(number), size - 1);
    *index = (size_t)number;
    return true;
}

/* Arrays that are elements of arrays take the subscripts that are left.
 * subscripts = "[" float "]" {"[" float "]"} . */
static bool parse_subscripts(struct parser *p, struct array *array,
                             struct value **slot, struct array **owner)
{
    for (;;) {
        size_t place = 0;
        for (int i = 0; i < array->dimensions; i++) {
            size_t index = 0;
            if (i > 0 && stream_peek_infix(p)->kind != TOKEN_LBRACKET)
                return error_at(p, p->last_span, NULL,
                                "this array has %d dimensions, but only %d "
                                "subscript%s given",
                                array->dimensions, i, i == 1 ? " is" : "s are");
            if (!array_index(p, array->size[i], &index))
                return false;
            place = place * (size_t)array->size[i] + index;
        }
        *slot = array->touched = &array->elements[place];
        *owner = array;
        if ((*slot)->kind != VALUE_ARRAY ||
            stream_peek_infix(p)->kind != TOKEN_LBRACKET)
            return true;
        array = (*slot)->array;
    }
}

size_t array_subscripts_end(const struct token *tokens, size_t left, size_t i)
{
    unsigned depth = 0;
    for (size_t at = i; at < left && tokens[at].kind != TOKEN_SEMICOLON; at++) {
        enum token_kind kind = tokens[at].kind;
        if (depth == 0 && kind != TOKEN_LBRACKET)
            return at;
        depth += kind == TOKEN_LBRACKET;
        depth -= kind == TOKEN_RBRACKET;
    }
    return i;
}

bool array_place(struct parser *p, struct array *array, struct value **slot,
                 struct array **owner)
{
    if (!expression_enter(p))
        return false;
    bool ok = parse_subscripts(p, array, slot, owner);
    p->nesting--;
    return ok;
}

bool array_element(struct parser *p, struct array *array, struct value **slot)
{
    struct array *owner;
    return array_place(p, array, slot, &owner);
}

bool array_takes(struct parser *p, struct array *array, struct span span,
                 const struct value *value)
{
    int size = value->kind == VALUE_VECTOR ? value->size : 0;
    enum value_kind kind = size == 5 ? VALUE_COLOUR : value->kind;
    if (size == 5)
        size = 0;
    if (kind == VALUE_NONE || kind == VALUE_POISON)
        return true;
    if (array->kind == VALUE_NONE) {
        array->kind = kind;
        array->vector_size = size;
    }
    if (array->kind == kind && array->vector_size == size)
        return true;
    struct value other = { .kind = array->kind, .size = array->vector_size };
    return error_at(p, span, NULL,
                    "all elements of an array are of one kind: expected %s, "
                    "found %s",
                    value_describe(&other), value_describe(value));
}

/* ---- copies ---- */

/* Counts the elements of an array and of all arrays in it; false if they are
 * too many or too deep. */
static bool array_measure(const struct array *array, unsigned depth,
                          size_t *total)
{
    *total += array->count;
    if (depth > ARRAY_DEPTH_LIMIT || *total > ARRAY_LIMIT)
        return false;
    for (size_t i = 0; i < array->count; i++)
        if (array->elements[i].kind == VALUE_ARRAY &&
            !array_measure(array->elements[i].array, depth + 1, total))
            return false;
    return true;
}

static struct array *array_duplicate(struct parser *p,
                                     const struct array *array)
{
    struct array *copy = ARENA_NEW(p->arena, struct array);
    *copy = *array;
    copy->touched = NULL;
    copy->elements = ARENA_ARRAY(p->arena, struct value, array->count);
    memcpy(copy->elements, array->elements,
           array->count * sizeof *array->elements);
    for (size_t i = 0; i < copy->count; i++)
        if (copy->elements[i].kind == VALUE_ARRAY)
            copy->elements[i].array =
                array_duplicate(p, copy->elements[i].array);
    return copy;
}

bool array_copy(struct parser *p, struct span span, struct array *array,
                struct array **copy)
{
    size_t total = 0;
    if (!array_measure(array, 0, &total))
        return error_at(p, span, NULL,
                        "this array has more than %d elements, or arrays in "
                        "it are nested more than %d deep",
                        ARRAY_LIMIT, ARRAY_DEPTH_LIMIT);
    *copy = array_duplicate(p, array);
    if (total >= ARRAY_LARGE)
        stream_ask(p);
    return true;
}

/* ---- declaration ---- */

/* Why there are fewer values than somebody counted. */
static const char *array_layers(const struct array *array, int dimension,
                                const struct value *next)
{
    bool layers =
        dimension + 1 == array->dimensions && next[-1].kind == VALUE_TEXTURE;
    return layers ? "; textures without a comma between them are the layers "
                    "of one"
                  : "";
}

/* How the values of a small array of two dimensions are written. */
static const char *array_braces(struct parser *p, const struct array *array)
{
    if (array->dimensions != 2 || array->count > 12)
        return "{{1, 2}, {3, 4}}";
    const char *text = "{";
    for (int i = 0, n = 0; i < array->size[0]; i++) {
        text = arena_printf(p->arena, "%s%s{", text, i ? ", " : "");
        for (int j = 0; j < array->size[1]; j++)
            text = arena_printf(p->arena, "%s%s%d", text, j ? ", " : "", ++n);
        text = arena_printf(p->arena, "%s}", text);
    }
    return arena_printf(p->arena, "%s}", text);
}

static bool array_value(struct parser *p, struct array *array,
                        struct value *value)
{
    struct span start = stream_span(p);
    return parse_value(p, value) &&
           array_takes(p, array, span_join(start, p->last_span), value);
}

/* All values must be there; a comma between two is optional.
 * array_values = "{" ( array_values {[","] array_values}
 *              | value {[","] value} ) [","] "}" . */
static bool parse_array_values(struct parser *p, struct array *array,
                               int dimension, struct value **next)
{
    struct span open;
    if (stream_peek(p)->kind != TOKEN_LBRACE)
        return error_at(p, stream_span(p), array_braces(p, array),
                        "an array of %d dimensions has braces around each row",
                        array->dimensions);
    if (!block_begin(p, &open))
        return false;
    bool ok = true;
    for (int i = 0; ok && i < array->size[dimension]; i++) {
        if (i > 0)
            accept(p, TOKEN_COMMA);
        if (stream_peek(p)->kind == TOKEN_RBRACE)
            ok = error_at(p, p->token_span, NULL,
                          "expected %d values in these braces, found %d%s",
                          array->size[dimension], i,
                          i > 0 ? array_layers(array, dimension, *next) : "");
        else if (dimension + 1 < array->dimensions)
            ok = parse_array_values(p, array, dimension + 1, next);
        else
            ok = array_value(p, array, (*next)++);
    }
    if (ok) {
        accept(p, TOKEN_COMMA);
        enum token_kind kind = stream_peek(p)->kind;
        if (kind == TOKEN_SEMICOLON || kind == TOKEN_END)
            ok = expect(p, TOKEN_RBRACE, open);
        else if (kind != TOKEN_RBRACE)
            ok = error_at(p, p->token_span, NULL,
                          "these braces have more values than the %d the "
                          "array has room for",
                          array->size[dimension]);
    }
    return block_end(p, open, ok);
}

static bool array_add_dimension(struct parser *p, struct array *array)
{
    double number;
    struct span start;
    if (!array_number(p, &number, &start))
        return false;
    if (array->dimensions == ARRAY_DIMENSIONS)
        return error_at(p, start, NULL, "an array has %d dimensions at most",
                        ARRAY_DIMENSIONS);
    if (!(number >= 1))
        return error_at(p, start, NULL,
                        "the size of an array must be at least 1, found %s",
                        NUMBER_TEXT(number));
    if (number * (double)array->count >= ARRAY_LIMIT + 1.0)
        return error_at(p, start, NULL,
                        "an array has %d elements at most, glim's limit",
                        ARRAY_LIMIT);
    array->size[array->dimensions++] = (int)number;
    array->count *= (size_t)number;
    return true;
}

/* `array[3] mixed { ... }`, of a later version. */
static bool array_is_mixed(struct parser *p)
{
    const struct token *token = stream_peek_infix(p);
    return token->kind == TOKEN_WORD && !token->word->reserved &&
           error_later_word(p, token->word, "array");
}

/* How many values stand from the token on to the '}' they end with. */
static int array_values_counted(const struct token *token)
{
    int count = 1;
    for (int depth = 0; depth >= 0; token++) {
        enum token_kind kind = token->kind;
        if (kind == TOKEN_END)
            return 0;
        depth += kind == TOKEN_LBRACE || kind == TOKEN_LESS ||
                 kind == TOKEN_LPAREN || kind == TOKEN_LBRACKET;
        depth -= kind == TOKEN_RBRACE || kind == TOKEN_GREATER ||
                 kind == TOKEN_RPAREN || kind == TOKEN_RBRACKET;
        count += depth == 0 && kind == TOKEN_COMMA;
    }
    return count;
}

/* `array {1, 2}` and `array[] {1, 2}`, of a later version: as long as what is
 * given. */
static bool array_is_unsized(struct parser *p)
{
    size_t left;
    enum token_kind kind = stream_peek(p)->kind;
    const struct token *next = stream_raw(p, &left);
    if (kind == TOKEN_LBRACKET && left > 2 && next[0].kind == TOKEN_RBRACKET &&
        next[1].kind == TOKEN_LBRACE)
        next += 2;
    else if (kind != TOKEN_LBRACE || left == 0)
        return false;
    int count = array_values_counted(next);
    error_at(p, p->token_span,
             count ? arena_printf(p->arena, "[%d]", count) : "[3]",
             "an array without its size needs POV-Ray 3.8, and glim reads 3.7");
    return true;
}

/* `array(8)`, as other languages have it. */
static const char *array_size_hint(struct parser *p)
{
    size_t left;
    const struct token *token = stream_peek(p), *size = stream_raw(p, &left);
    return token->kind == TOKEN_LPAREN && left > 1 &&
                   size[0].kind == TOKEN_NUMBER && size[1].kind == TOKEN_RPAREN
               ? arena_printf(p->arena, "[%g]", size->number)
               : "[3]";
}

/* array = "array" "[" float "]" {"[" float "]"} [array_values] . */
bool parse_array(struct parser *p, struct value *value)
{
    struct array *array = ARENA_NEW(p->arena, struct array);
    stream_next(p);
    array->count = 1;
    if (array_is_mixed(p) || array_is_unsized(p))
        return false;
    if (stream_peek(p)->kind != TOKEN_LBRACKET)
        return error_expected_hint(p, "'[' and the size of the array",
                                   array_size_hint(p));
    while (stream_peek_infix(p)->kind == TOKEN_LBRACKET)
        if (!array_add_dimension(p, array))
            return false;
    if (array_is_mixed(p))
        return false;
    if (stream_peek_infix(p)->kind == TOKEN_EQUAL) {
        error_at(p, p->token_span, NULL,
                 "no '=' stands between an array's size and its values");
        stream_next(p);
        return false;
    }
    array->elements = ARENA_ARRAY(p->arena, struct value, array->count);
    struct value *next = array->elements;
    *value = (struct value){ .kind = VALUE_ARRAY, .array = array };
    if (stream_peek_infix(p)->kind != TOKEN_LBRACE)
        return true;
    struct cursor *outer = brackets_begin(p);
    return brackets_end(p, outer, parse_array_values(p, array, 0, &next));
}

/* value = thing | expression . */
bool parse_value(struct parser *p, struct value *value)
{
    enum taken taken = parse_thing(p, value);
    return taken != NOT_MINE ? taken : parse_expression(p, value);
}
