/* Operators and operands in a loop over a precedence table, evaluated as they
 * are read. Grammar: grammar/expressions.ebnf. */
#include "parse/expression.h"
#include "parse/stream.h"

bool expression_enter(struct parser *p)
{
    if (p->nesting < PARSE_NESTING_LIMIT) {
        p->nesting++;
        return true;
    }
    error_at(p, stream_span(p), NULL,
             "brackets and blocks are nested more than %d deep",
             PARSE_NESTING_LIMIT);
    stream_abort(p);
    return false;
}

/* Operators that are legal in parentheses only: `2 = 2` outside them is not
 * read as the end of the value but explained. '<' may begin the next vector,
 * '>' end the one this is in. Of what was wrong itself nothing is said. */
static bool operator_misplaced(struct parser *p, enum precedence lowest,
                               const struct value *left)
{
    enum token_kind kind = stream_peek_infix(p)->kind;
    if (lowest < PRECEDENCE_WHOLE || kind == TOKEN_LESS ||
        (kind == TOKEN_GREATER && lowest != PRECEDENCE_WHOLE) ||
        operator_precedence(kind) >= PRECEDENCE_SUM)
        return false;
    if (value_is_poison(left))
        return true;
    const char *text = p->token_span.source->text + p->token_span.offset;
    int length = (int)p->token_span.length;
    error_at(p, p->token_span, NULL,
             kind == TOKEN_QUESTION
                 ? "'%.*s' must be inside parentheses: (a > b %.*s c : d)"
                 : "'%.*s' must be inside parentheses: (a %.*s b)",
             length, text, length, text);
    return true;
}

bool operator_unknown(struct parser *p)
{
    const struct token *token = stream_peek_infix(p);
    if (token->kind != TOKEN_OTHER)
        return false;
    char c = p->token_span.source->text[p->token_span.offset];
    if (c != '^' && c != '%')
        return false;
    error_at(p, p->token_span, c == '^' ? "pow(A, B)" : "mod(A, B)",
             "'%c' is not an operator", c);
    return true;
}

/* == && || of other languages; the first half was taken. */
static void operator_doubled(struct parser *p, enum token_kind taken)
{
    if (stream_peek(p)->kind != taken ||
        (taken != TOKEN_EQUAL && taken != TOKEN_AND && taken != TOKEN_OR))
        return;
    const char *one = taken == TOKEN_EQUAL ? "="
                      : taken == TOKEN_AND ? "&"
                                           : "|";
    error_at(p, span_join(p->last_span, p->token_span), one,
             "this operator is written '%s'", one);
    stream_next(p);
}

/* The value of (condition ? first : second); both are read.
 * choice = "?" operation ":" operation . */
static bool parse_choice(struct parser *p, struct span start,
                         const char *wanted, struct value *value)
{
    struct value first, second;
    double condition = 0;
    bool poison = value_is_poison(value);
    if (!poison && !value_to_float(p, start, value, &condition))
        poison = true;
    struct span question = stream_span(p);
    stream_next(p);
    if (!parse_operation(p, PRECEDENCE_CONDITION, wanted, &first) ||
        !expect(p, TOKEN_COLON, question) ||
        !parse_operation(p, PRECEDENCE_CONDITION, wanted, &second))
        return false;
    *value = poison                      ? value_poison()
             : operator_truth(condition) ? first
                                         : second;
    return true;
}

/* Signs bind tightest: !1+1 is 1, -x.x is -(x.x).
 * signed = {"+" | "-" | "!"} operand . */
static bool parse_signed(struct parser *p, const char *wanted,
                         struct value *value)
{
    const struct token *token = stream_peek(p);
    if (token->kind != TOKEN_MINUS && token->kind != TOKEN_PLUS &&
        token->kind != TOKEN_NOT)
        return parse_operand(p, wanted, value);
    struct span start = p->token_span;
    bool negative = false, truth = false, inverted = false;
    for (;; token = stream_peek(p)) {
        if (token->kind == TOKEN_NOT) {
            /* The signs before a ! apply to 0 or 1; those after it don't
             * change what is zero. */
            truth = true;
            inverted = !inverted;
        } else if (token->kind == TOKEN_MINUS) {
            negative ^= !truth;
        } else if (token->kind != TOKEN_PLUS) {
            break;
        }
        stream_next(p);
    }
    if (!parse_operand(p, wanted, value))
        return false;
    if (truth)
        operator_apply_sign(p, TOKEN_NOT, start, value);
    if (truth && !inverted)
        operator_apply_sign(p, TOKEN_NOT, start, value);
    if (negative)
        operator_apply_sign(p, TOKEN_MINUS, start, value);
    return true;
}

static bool operation_climb(struct parser *p, enum precedence lowest,
                            const char *wanted, struct value *left);

/* The binary operator that is next, and what is right of it. */
static bool operation_apply(struct parser *p, enum precedence precedence,
                            const char *wanted, struct value *left)
{
    struct value right;
    struct token operator= stream_next(p);
    struct span at = p->last_span;
    operator_doubled(p, operator.kind);
    if (!operation_climb(p, precedence + 1, wanted, &right))
        return false;
    if (operator.kind == TOKEN_OTHER)
        *left = value_poison();
    else
        operator_apply(p, operator.kind, at, left, &right);
    return true;
}

/* Whether no operator stands here: before version 1.5 they are for parentheses
 * alone, and <0 -1 2> has three components. */
static bool operators_absent(const struct parser *p, enum precedence lowest)
{
    return p->version < 1.5 && lowest >= PRECEDENCE_WHOLE;
}

/* Goes on after the value `left`, which began at `start`, with operators that
 * bind at least as tightly as `lowest`. */
static bool operation_continue(struct parser *p, enum precedence lowest,
                               struct span start, const char *wanted,
                               struct value *left)
{
    while (!operators_absent(p, lowest)) {
        enum token_kind kind = stream_peek_infix(p)->kind;
        enum precedence precedence = operator_precedence(kind);
        if (kind == TOKEN_OTHER && operator_unknown(p))
            precedence = PRECEDENCE_PRODUCT;
        if (precedence == PRECEDENCE_NONE || precedence < lowest)
            return true;
        if (left->kind == VALUE_STRING && lowest >= PRECEDENCE_WHOLE &&
            kind != TOKEN_PLUS)
            return true;
        bool ok = precedence == PRECEDENCE_CONDITION
                      ? parse_choice(p, start, wanted, left)
                      : operation_apply(p, precedence, wanted, left);
        if (!ok)
            return false;
    }
    return true;
}

/* The operators and how they bind: operator_precedence.
 * operation = signed {operator signed} [choice] . */
static bool operation_climb(struct parser *p, enum precedence lowest,
                            const char *wanted, struct value *left)
{
    struct span start = stream_span(p);
    return parse_signed(p, wanted, left) &&
           operation_continue(p, lowest, start, wanted, left);
}

bool parse_operation(struct parser *p, enum precedence lowest,
                     const char *wanted, struct value *value)
{
    struct span start = stream_span(p);
    if (!expression_enter(p))
        return false;
    bool ok = operation_climb(p, lowest, wanted, value);
    if (ok && operator_misplaced(p, lowest, value)) {
        *value = value_poison();
        ok = operation_continue(p, PRECEDENCE_CONDITION, start, wanted, value);
    }
    p->nesting--;
    return ok;
}
