/* Compiling user functions: see user_function.h. Their grammar is its own: no
 * vectors, no "!" and "?:", but comparisons everywhere, "&" before "|", sum()
 * and prod() (measured). */
#include "parse/user_function.h"

#include "parse/array.h"
#include "parse/expression.h"
#include "parse/function.h"
#include "parse/function_field.h"
#include "parse/mistaken.h"
#include "parse/operator.h"
#include "parse/stream.h"
#include "parse/symbol.h"
#include "scene/function_field.h"

enum {
    FUNCTION_DEPTH_LIMIT = 100,
    FUNCTION_NAMES = FUNCTION_PARAMETERS + PARSE_NESTING_LIMIT,
};

struct compiler {
    struct parser *p;
    struct function *function;
    const struct word *names[FUNCTION_NAMES]; /* by slot */
    int name_count;
    unsigned height; /* of the stack at this point of the body */
    bool standard;   /* no parameters named: x, y, z, and u = x, v = y */
    bool poisoned;   /* a part of it had an error */
};

static void compile_height(struct compiler *c, unsigned height)
{
    if (c->function->height < height)
        c->function->height = height;
}

/* A step that makes the stack `change` higher. */
static struct step *compile_step(struct compiler *c, enum step_kind kind,
                                 int change)
{
    struct step *step = ARRAY_PUSH(c->p->scene_arena, &c->function->steps);
    *step = (struct step){ .kind = kind };
    c->function->work++;
    c->height = (unsigned)((int)c->height + change);
    compile_height(c, c->height);
    return step;
}

static bool parse_body_operation(struct compiler *c, int lowest);

/* ---- functions in functions ---- */

/* body_arguments = "(" body_operation {"," body_operation} ")" . */
static bool parse_body_arguments(struct compiler *c, const char *name,
                                 int least, int most, int *count)
{
    struct parser *p = c->p;
    struct span open = stream_span(p);
    if (stream_peek(p)->kind != TOKEN_LPAREN)
        return error_expected(p,
                              arena_printf(p->arena, "'(' after '%s'", name));
    stream_next(p);
    for (*count = 0; *count < most; ++*count) {
        if (*count > 0 && !accept(p, TOKEN_COMMA))
            break;
        if (!parse_body_operation(c, 0))
            return false;
    }
    if (*count < least)
        return error_at(p, span_join(open, stream_span(p)), NULL,
                        "%s() wants %d argument%s, found %d", name, least,
                        least == 1 ? "" : "s", *count);
    return expect(p, TOKEN_RPAREN, open);
}

/* A power whose exponent is the number on the stack, if there is a step of its
 * own for it. */
static bool compile_power(struct compiler *c)
{
    size_t last = c->function->steps.count - 1;
    struct step *step = &c->function->steps.items[last];
    if (step->kind != STEP_NUMBER || !step_set_power(step, step->number))
        return false;
    c->height--;
    return true;
}

static bool compile_builtin(struct compiler *c, const struct word *word,
                            const struct function_row *row)
{
    bool fold = row->signature[1] == '+';
    int count, arity = row->two && !fold ? 2 : 1;
    stream_next(c->p);
    if (!parse_body_arguments(c, word->text, arity, fold ? 1000 : arity,
                              &count))
        return false;
    if (row->one)
        step_set_one(compile_step(c, STEP_ONE, 0), row->one);
    if (row->two == pow && compile_power(c))
        return true;
    for (int i = 1; row->two && i < count; i++)
        step_set_two(compile_step(c, STEP_TWO, -1), row->two);
    return true;
}

static bool compile_select(struct compiler *c)
{
    int count;
    stream_next(c->p);
    if (!parse_body_arguments(c, "select", 3, 4, &count))
        return false;
    compile_step(c, STEP_SELECT, 1 - count)->slot = count;
    return true;
}

/* The loop variable is known in the last argument only.
 * loop = ( "sum" | "prod" ) "(" word "," body_operation "," body_operation ","
 *        body_operation ")" . */
static bool parse_loop(struct compiler *c, enum step_kind kind)
{
    struct parser *p = c->p;
    stream_next(p);
    struct span open = stream_span(p);
    if (!expect(p, TOKEN_LPAREN, span_none()))
        return false;
    if (stream_peek(p)->kind != TOKEN_WORD || p->token.word->reserved)
        return error_expected(p, "a name for the loop variable");
    const struct word *name = stream_next(p).word;
    if (!expect(p, TOKEN_COMMA, span_none()) || !parse_body_operation(c, 0) ||
        !expect(p, TOKEN_COMMA, span_none()) || !parse_body_operation(c, 0) ||
        !expect(p, TOKEN_COMMA, span_none()))
        return false;
    if (c->name_count == FUNCTION_NAMES)
        return error_at(p, open, NULL, "too many loops inside each other");
    int slot = c->name_count++;
    if (c->function->slots < c->name_count)
        c->function->slots = c->name_count;
    c->names[slot] = name;
    compile_step(c, kind, -2)->slot = slot;
    size_t body = c->function->steps.count;
    bool ok = parse_body_operation(c, 0) && expect(p, TOKEN_RPAREN, open);
    c->name_count--;
    c->function->steps.items[body - 1].length = c->function->steps.count - body;
    return ok;
}

/* A part of the colour or place, where it is wanted being on the stack. */
static bool compile_part(struct compiler *c, const struct function *callee)
{
    int part;
    if (!parse_colour_part(c->p, &part))
        return false;
    for (int i = callee->parameter_count; i < 3; i++)
        compile_step(c, STEP_NUMBER, 1)->number = 0;
    compile_step(c, STEP_FIELD, -2)->field =
        field_of_values(c->p->scene_arena, callee->values, part);
    return true;
}

/* The function's name is behind. */
static bool compile_call(struct compiler *c, const struct word *word,
                         const struct function *callee)
{
    struct parser *p = c->p;
    int n = callee->parameter_count, count;
    struct span at = p->last_span;
    if (!parse_body_arguments(c, word->text, n, n, &count))
        return false;
    compile_height(c, c->height - (unsigned)n + (unsigned)callee->slots +
                          callee->height);
    if (c->function->depth <= callee->depth)
        c->function->depth = callee->depth + 1;
    if (c->function->depth > FUNCTION_DEPTH_LIMIT)
        return error_at(p, at, NULL,
                        "functions call functions more than %d "
                        "deep",
                        FUNCTION_DEPTH_LIMIT);
    c->function->work += callee->work;
    if (c->function->levels < callee->levels)
        c->function->levels = callee->levels;
    if (!work_check(p, c->function->work, c->function->levels))
        return false;
    if (callee->values)
        return compile_part(c, callee);
    struct step *call = compile_step(c, STEP_CALL, 1 - n);
    const struct step *only = function_only_step(callee);
    if (only)
        *call = *only;
    else
        call->function = callee;
    return true;
}

/* ---- operands ---- */

static int compile_slot(const struct compiler *c, const struct word *word)
{
    for (int i = c->name_count; i > 0; i--)
        if (c->names[i - 1] == word)
            return i - 1;
    if (c->standard && word->keyword == KEYWORD_U)
        return 0;
    if (c->standard && word->keyword == KEYWORD_V)
        return 1;
    return -1;
}

/* Anything else with a value now: numbers, pi, identifiers, V.x, A[1] ... */
static bool compile_constant(struct compiler *c)
{
    struct parser *p = c->p;
    struct value value;
    struct span start = stream_span(p);
    double number = 0;
    if (!parse_operand(p, "a number or a parameter of the function", &value))
        return false;
    if (value_is_poison(&value))
        c->poisoned = true;
    else if (!value_to_float(p, start, &value, &number))
        return false;
    compile_step(c, STEP_NUMBER, 1)->number = number;
    return true;
}

/* Of an array of functions. */
static bool compile_element(struct compiler *c, const struct word *word,
                            struct array *array)
{
    struct parser *p = c->p;
    struct value *slot;
    struct span at = stream_span(p);
    stream_next(p);
    if (!array_element(p, array, &slot))
        return false;
    if (slot->kind != VALUE_FUNCTION)
        return error_at(p, span_join(at, p->last_span), NULL,
                        slot->kind == VALUE_NONE
                            ? "this element of '%s' was never set"
                            : "this element of '%s' is no function",
                        word->text);
    return compile_call(c, word, slot->function);
}

/* `A > 0 ? A : 0` or `if (A > 0)`: functions know neither. */
static bool error_choice(struct parser *p)
{
    return error_at(p, stream_span(p), "select(A, IF_NEGATIVE, IF_NOT)",
                    "in a function it is select() that chooses");
}

static bool compile_word(struct compiler *c, const struct word *word)
{
    int slot = compile_slot(c, word);
    if (slot >= 0) {
        stream_next(c->p);
        compile_step(c, STEP_LOCAL, 1)->slot = slot;
        return true;
    }
    if (word->keyword == KEYWORD_SUM)
        return parse_loop(c, STEP_SUM);
    if (word->keyword == KEYWORD_PROD)
        return parse_loop(c, STEP_PRODUCT);
    if (word->keyword == KEYWORD_SELECT)
        return compile_select(c);
    const struct function_row *row = function_find(word->keyword);
    if (row && (row->one || row->two))
        return compile_builtin(c, word, row);
    if (word->keyword == KEYWORD_IF)
        return error_choice(c->p);
    const struct value *value = word->reserved ? NULL : symbol_find(c->p, word);
    if (value && value->kind == VALUE_FUNCTION) {
        stream_next(c->p);
        return compile_call(c, word, value->function);
    }
    if (value && value->kind == VALUE_ARRAY &&
        array_kind(value->array) == VALUE_FUNCTION)
        return compile_element(c, word, value->array);
    return compile_constant(c);
}

/* body_operand = {"+" | "-"} ( word | "(" body_operation ")" | loop
 *              | word [subscripts] body_arguments | operand ) . */
static bool parse_body_operand(struct compiler *c)
{
    struct parser *p = c->p;
    bool negative = false, ok;
    for (;;) {
        if (accept(p, TOKEN_MINUS))
            negative = !negative;
        else if (!accept(p, TOKEN_PLUS))
            break;
    }
    const struct token *token = stream_peek(p);
    struct span open = p->token_span;
    if (token->kind == TOKEN_LPAREN) {
        stream_next(p);
        ok = parse_body_operation(c, 0) && expect(p, TOKEN_RPAREN, open);
    } else if (token->kind == TOKEN_WORD) {
        ok = compile_word(c, token->word);
    } else if (token->kind == TOKEN_NUMBER) {
        ok = compile_constant(c);
    } else {
        ok = error_expected(p, "a number or a parameter of the function");
    }
    if (ok && negative)
        compile_step(c, STEP_NEGATE, 0);
    return ok;
}

/* ---- operators ---- */

/* As in expressions, but "&" binds tighter than "|". */
static int body_precedence(enum token_kind kind)
{
    return 2 * (int)operator_precedence(kind) + (kind == TOKEN_AND);
}

/* An operator whose right operand is the steps from number `before` on: one
 * that only fetches it goes into the operator's own step. */
static void compile_operator(struct compiler *c, enum token_kind kind,
                             size_t before)
{
    enum step_kind plain = kind == TOKEN_PLUS    ? STEP_PLUS
                           : kind == TOKEN_MINUS ? STEP_MINUS
                           : kind == TOKEN_STAR  ? STEP_TIMES
                           : kind == TOKEN_SLASH ? STEP_OVER
                                                 : STEP_TWO;
    struct step *last = &c->function->steps.items[before];
    bool alone = c->function->steps.count == before + 1;
    if (plain == STEP_TWO) {
        step_set_two(compile_step(c, STEP_TWO, -1), operator_function(kind));
    } else if (alone && last->kind == STEP_LOCAL) {
        last->kind = plain - STEP_PLUS + STEP_PLUS_LOCAL;
        c->height--;
    } else if (alone && last->kind == STEP_NUMBER) {
        last->kind = plain - STEP_PLUS + STEP_PLUS_NUMBER;
        c->height--;
    } else {
        compile_step(c, plain, -1);
    }
}

static bool compile_climb(struct compiler *c, int lowest)
{
    if (!parse_body_operand(c))
        return false;
    for (;;) {
        enum token_kind kind = stream_peek(c->p)->kind;
        if (kind == TOKEN_OTHER && operator_unknown(c->p))
            return false;
        if (kind == TOKEN_QUESTION)
            return error_choice(c->p);
        int precedence = body_precedence(kind);
        if (operator_precedence(kind) == PRECEDENCE_NONE || precedence < lowest)
            return true;
        stream_next(c->p);
        size_t before = c->function->steps.count;
        if (!compile_climb(c, precedence + 1))
            return false;
        compile_operator(c, kind, before);
    }
}

/* body_operation = body_operand {operator body_operand} . */
static bool parse_body_operation(struct compiler *c, int lowest)
{
    if (!expression_enter(c->p))
        return false;
    bool ok = compile_climb(c, lowest);
    c->p->nesting--;
    return ok;
}

/* ---- the function ---- */

static bool parameter_is_legal(const struct word *word)
{
    enum keyword k = word->keyword;
    return !word->reserved || k == KEYWORD_X || k == KEYWORD_Y ||
           k == KEYWORD_Z || k == KEYWORD_U || k == KEYWORD_V || k == KEYWORD_T;
}

static void standard_parameters(struct compiler *c)
{
    c->standard = true;
    c->names[c->name_count++] = word_intern(c->p->words, "x", 1);
    c->names[c->name_count++] = word_intern(c->p->words, "y", 1);
    c->names[c->name_count++] = word_intern(c->p->words, "z", 1);
}

/* Without parameters they are x, y, z, and u and v mean x and y.
 * parameters = "(" word {"," word} ")" . */
static bool parse_parameters(struct compiler *c)
{
    struct parser *p = c->p;
    struct span open = stream_span(p);
    if (!accept(p, TOKEN_LPAREN)) {
        standard_parameters(c);
        return true;
    }
    do {
        const struct token *token = stream_peek(p);
        if (token->kind != TOKEN_WORD)
            return error_expected(p, "the name of a parameter");
        if (!parameter_is_legal(token->word))
            return error_at(p, p->token_span, NULL,
                            "'%s' is a reserved word; name the parameter "
                            "otherwise",
                            token->word->text);
        if (c->name_count == FUNCTION_PARAMETERS)
            return error_at(p, p->token_span, NULL,
                            "a function can have %d parameters at most",
                            FUNCTION_PARAMETERS);
        c->names[c->name_count++] = stream_next(p).word;
        if (stream_peek(p)->kind == TOKEN_WORD)
            return error_at(p, span_join(p->last_span, p->token_span),
                            p->token.word->text,
                            "a parameter is one word, its name");
    } while (accept(p, TOKEN_COMMA));
    return expect(p, TOKEN_RPAREN, open);
}

static bool compile_body(struct compiler *c)
{
    struct parser *p = c->p;
    c->function->parameter_count = c->function->slots = c->name_count;
    if (at_field_body(p) ? !parse_field_body(p, c->function)
                         : !parse_body_operation(c, 0))
        return false;
    function_join(c->function);
    if (c->function->slots + (int)c->function->height > FUNCTION_STACK)
        return error_at(p, stream_span(p), NULL,
                        "this function needs more than %d numbers of stack, "
                        "glim's limit",
                        FUNCTION_STACK);
    return true;
}

/* function = "function" [parameters] "{" ( field_body | body_operation ) "}" .
 */
bool parse_function(struct parser *p, struct value *value)
{
    struct compiler c = { .p = p,
                          .function =
                              ARENA_NEW(p->scene_arena, struct function) };
    struct span open;
    stream_next(p);
    if (!parse_parameters(&c) || !block_begin(p, &open) ||
        !block_end(p, open, compile_body(&c)))
        return false;
    *value = (struct value){ .kind = VALUE_FUNCTION, .function = c.function };
    return !c.poisoned;
}

/* function_image = "function" float [","] float
 *                  "{" ( field_body | body_operation ) "}" . */
bool parse_function_image(struct parser *p, int *width, int *height,
                          const struct function **out)
{
    struct compiler c = { .p = p,
                          .function =
                              ARENA_NEW(p->scene_arena, struct function) };
    struct span open;
    stream_next(p);
    if (stream_peek(p)->kind == TOKEN_LBRACE)
        return error_expected_hint(p, "the picture's width and height",
                                   "200, 200 {");
    if (!parse_integer(p, width))
        return false;
    accept(p, TOKEN_COMMA);
    *out = c.function;
    if (!parse_integer(p, height) || !block_begin(p, &open))
        return false;
    standard_parameters(&c);
    return block_end(p, open, compile_body(&c)) && !c.poisoned;
}

/* argument_list = "(" float {[","] float} ")" . */
static bool parse_argument_list(struct parser *p, const struct word *name,
                                int count, double *arguments, bool *poison)
{
    struct span open = stream_span(p);
    stream_next(p);
    for (int i = 0; i < count; i++) {
        struct value value;
        if (i > 0)
            accept(p, TOKEN_COMMA);
        struct span start = stream_span(p);
        if (stream_peek(p)->kind == TOKEN_RPAREN)
            return error_at(p, p->token_span, NULL,
                            "%s() wants %d argument%s, found %d", name->text,
                            count, count == 1 ? "" : "s", i);
        if (mistaken_named(p) ||
            !parse_operation(p, PRECEDENCE_WHOLE, "a number", &value))
            return false;
        if (!value_to_float(p, start, &value, &arguments[i]))
            *poison = true;
    }
    if (stream_peek(p)->kind == TOKEN_COMMA)
        return error_at(p, p->token_span, NULL,
                        "%s() wants no more than %d argument%s", name->text,
                        count, count == 1 ? "" : "s");
    return expect(p, TOKEN_RPAREN, open);
}

static struct value values_at(const struct function_values *values,
                              const double *arguments)
{
    struct value value = { .kind = values->colour ? VALUE_COLOUR : VALUE_VECTOR,
                           .size = values->count };
    vec3 point = { arguments[0], arguments[1], arguments[2] };
    values->at(values, point, value.number);
    return value;
}

bool function_call(struct parser *p, const struct function *function,
                   const struct word *name, struct value *value)
{
    double arguments[FUNCTION_PARAMETERS] = { 0 };
    bool poison = false;
    struct span at = p->last_span;
    unsigned long steps = FUNCTION_STEP_LIMIT;
    if (stream_peek_infix(p)->kind != TOKEN_LPAREN)
        return error_expected(
            p, arena_printf(p->arena, "'(' after '%s'", name->text));
    struct cursor *outer = brackets_begin(p);
    bool ok = parse_argument_list(p, name, function->parameter_count, arguments,
                                  &poison);
    if (!brackets_end(p, outer, ok))
        return false;
    *value = value_poison();
    if (!poison && function->values)
        *value = values_at(function->values, arguments);
    else if (!poison)
        *value = value_float(function_evaluate(function, arguments, &steps));
    if (steps == 0) {
        error_at(p, at, NULL,
                 "this call of '%s' takes more than %d steps, glim's limit",
                 name->text, FUNCTION_STEP_LIMIT);
        *value = value_poison();
    }
    return true;
}
