/* #while #for #break #end: text read again and again. */
#include "base/text.h"
#include "parse/directive.h"
#include "parse/function.h"
#include "parse/mistaken.h"
#include "parse/symbol.h"

enum {
    WHILE_LOOKED = 997, /* rounds from one look at the condition to the next */
    WHILE_PATIENCE = 1000000, /* rounds in which it may ask for the same */
};

/* Whether what is in the loop, which the cursor is at the beginning of, can end
 * it: by a #break, or as it declares the `variable` (NULL: none) of a #for. */
static bool loop_may_leave(const struct parser *p, const struct word *variable)
{
    const struct cursor *cursor = p->cursor;
    const struct token *tokens = cursor->list->tokens;
    unsigned depth = 0;
    for (size_t i = cursor->index; i < cursor->end; i++) {
        enum keyword keyword = tokens[i].kind == TOKEN_DIRECTIVE
                                   ? tokens[i].word->keyword
                                   : KEYWORD_NONE;
        if (keyword == KEYWORD_BREAK || keyword == KEYWORD_INCLUDE)
            return true;
        if (variable && tokens[i].kind == TOKEN_WORD &&
            tokens[i].word == variable && tokens[i - 1].kind == TOKEN_DIRECTIVE)
            return true;
        if (stream_block_opens(keyword))
            depth++;
        else if (keyword == KEYWORD_END && depth-- == 0)
            return false;
    }
    return true;
}

/* A hash of what the condition, which was just read, asks for; false: of more
 * than numbers and strings that have names. */
static bool while_asked(struct parser *p, const struct open_block *block,
                        unsigned long *hash)
{
    const struct cursor *cursor = p->cursor;
    *hash = 0;
    for (size_t i = block->condition; i < cursor->index; i++) {
        const struct token *token = &cursor->list->tokens[i];
        if (token->kind == TOKEN_DIRECTIVE)
            return false;
        if (token->kind != TOKEN_WORD)
            continue;
        if (token->word->reserved && function_is(token->word->keyword))
            return false;
        if (token->word->reserved)
            continue;
        const struct value *value = symbol_find(p, token->word);
        if (!value || value->kind < VALUE_FLOAT || value->kind > VALUE_STRING)
            return false;
        size_t size = value->kind == VALUE_FLOAT    ? sizeof *value->number
                      : value->kind == VALUE_STRING ? strlen(value->text)
                                                    : sizeof value->number;
        const char *bytes = value->kind == VALUE_STRING
                                ? value->text
                                : (const char *)value->number;
        *hash = *hash * 31 + text_hash(bytes, size);
    }
    return true;
}

/* How far from its end the condition, which was just read, says that the loop
 * is: of `(I < 10)` and its like; else 0. */
static double while_distance(struct parser *p, const struct open_block *block)
{
    enum { TOKENS = 5 }; /* with the parentheses */
    const struct cursor *cursor = p->cursor;
    const struct token *condition = cursor->list->tokens + block->condition;
    double sides[2];
    if (cursor->index - block->condition != TOKENS)
        return 0;
    for (int i = 0; i < 2; i++) {
        const struct token *side = &condition[1 + 2 * i];
        const struct value *value =
            side->kind == TOKEN_WORD ? symbol_find(p, side->word) : NULL;
        if (side->kind != TOKEN_NUMBER &&
            (!value || value->kind != VALUE_FLOAT))
            return 0;
        sides[i] = value ? value->number[0] : side->number;
    }
    enum token_kind kind = condition[2].kind;
    bool less = kind == TOKEN_LESS || kind == TOKEN_LESS_EQUAL;
    bool more = kind == TOKEN_GREATER || kind == TOKEN_GREATER_EQUAL;
    return less ? sides[1] - sides[0] : more ? sides[0] - sides[1] : 0;
}

/* Whether the condition of a #while, which was just read and holds, has asked
 * for the same, or led away from the end, for so long that it never ends. */
static bool while_goes_on(struct parser *p, struct open_block *block)
{
    unsigned long asked;
    if (block->rounds % WHILE_LOOKED != 0)
        return false;
    bool still = while_asked(p, block, &asked) && asked == block->asked;
    double distance = while_distance(p, block);
    bool away = distance > block->value && block->value > 0;
    block->same = still || away ? block->same + 1 : 0;
    block->asked = asked;
    block->value = distance;
    if (block->same < WHILE_PATIENCE / WHILE_LOOKED || loop_may_leave(p, NULL))
        return false;
    error_at(p, block->span, NULL, "this '#while' never ends: in %d rounds %s",
             WHILE_PATIENCE,
             still ? "nothing has changed that its condition asks for"
                   : "its condition has only led away from the end");
    stream_abort(p);
    return true;
}

/* Whether the loop may begin another round. A #while whose last round changed
 * no identifier will never end. */
static bool loop_round(struct parser *p, struct open_block *block)
{
    unsigned limit = stream_round_limit(p);
    bool stuck = block->kind == BLOCK_WHILE && block->rounds > 0 &&
                 block->changes == p->changes;
    if (stuck && p->reported_count > 0) /* likely because of that */
        return directive_skip_to_end(p) && false;
    if (stuck)
        error_at(p, block->span, NULL,
                 "this '#while' never ends: nothing changes in a round of it");
    else if (++block->rounds > limit)
        error_at(p, block->span, NULL,
                 "this loop took more than %u rounds, glim's limit", limit);
    else
        return stream_round(p, 1, block->span);
    stream_abort(p);
    return false;
}

/* Evaluates the condition of the innermost #while and enters or leaves it.
 * The cursor is at the condition. */
static bool while_round(struct parser *p)
{
    struct open_block *block = directive_block(p);
    p->cursor->index = block->condition;
    if (!loop_round(p, block))
        return false;
    block->changes = p->changes;
    double condition;
    if (!directive_float(p, &condition))
        return directive_skip_to_end(p) && false;
    if (condition == 0)
        return directive_skip_to_end(p);
    return !while_goes_on(p, directive_block(p));
}

/* while_directive = "#while" "(" condition ")" . */
static bool while_run(struct parser *p, struct span at)
{
    struct open_block *block = directive_open(p, BLOCK_WHILE, at);
    block->condition = p->cursor->index;
    return while_round(p);
}

static bool for_comma(struct parser *p, const struct open_block *block)
{
    return accept(p, TOKEN_COMMA) ||
           error_expected_hint(p, "','",
                               arena_printf(p->arena, "#for (%s, 0, 9) ...",
                                            block->variable->text));
}

static bool for_numbers(struct parser *p, struct open_block *block,
                        struct span open)
{
    block->step = 1;
    if (!for_comma(p, block) || !parse_float(p, &block->value) ||
        !for_comma(p, block) || !parse_float(p, &block->last))
        return false;
    if (accept(p, TOKEN_COMMA) && !parse_float(p, &block->step))
        return false;
    return expect(p, TOKEN_RPAREN, open);
}

/* for_head = "(" name "," float "," float ["," float] ")" . */
static bool for_head(struct parser *p, struct open_block *block)
{
    struct span open = stream_span(p);
    if (!accept(p, TOKEN_LPAREN))
        return error_expected_hint(p, "'('", "#for (i, 0, 9) ...");
    const struct token *token = stream_peek(p);
    if (token->kind == TOKEN_WORD && token->word->reserved)
        return error_at(p, p->token_span,
                        token->word->keyword == KEYWORD_INT
                            ? "#for (i, 0, 9) ..."
                            : mistaken_capital(p, token->word->text),
                        "'%s' is a reserved word; name the loop's variable "
                        "otherwise",
                        token->word->text);
    if (token->kind != TOKEN_WORD)
        return error_expected(p, "the name of the loop's variable");
    block->variable = stream_next(p).word;
    if (!for_numbers(p, block, open))
        return false;
    if (block->step == 0)
        return error_at(p, block->span, NULL, "the step of '#for' is 0");
    return true;
}

/* The last value is reached in spite of rounding: #for (i, 0, 1, 0.1) runs
 * eleven times, as in POV-Ray. Afterwards the variable is past the end. */
static bool for_round(struct parser *p)
{
    struct open_block *block = directive_block(p);
    double slack = fabs(block->step) * 1e-6;
    bool more = block->step > 0 ? block->value <= block->last + slack
                                : block->value >= block->last - slack;
    struct value value = { .kind = VALUE_FLOAT, .number = { block->value } };
    symbol_set(p, block->variable, value, true);
    p->cursor->index = block->condition;
    if (!more)
        return directive_skip_to_end(p);
    return loop_round(p, block);
}

/* Whether it has more rounds than a loop may have, as is known before. */
static bool for_too_long(struct parser *p, const struct open_block *block)
{
    double rounds = floor((block->last - block->value) / block->step) + 1;
    unsigned limit = stream_round_limit(p);
    if (!(rounds > limit) || loop_may_leave(p, block->variable))
        return false;
    error_at(p, block->span, NULL,
             "this loop would take %s rounds, and glim's limit is %u",
             NUMBER_TEXT(rounds), limit);
    stream_abort(p);
    return true;
}

/* for_directive = "#for" for_head . */
static bool for_run(struct parser *p, struct span at)
{
    struct directive_head outer = directive_head_begin(p);
    struct open_block head = { .kind = BLOCK_FOR, .span = at };
    bool ok = for_head(p, &head);
    ok = directive_condition_end(p, outer) && ok;
    *directive_open(p, BLOCK_FOR, at) = head;
    directive_block(p)->condition = p->cursor->index;
    if (!ok)
        return directive_skip_to_end(p) && false;
    return !for_too_long(p, &head) && for_round(p);
}

/* The variable may have been changed in the loop: POV-Ray goes on from its
 * new value. */
static bool for_next(struct parser *p)
{
    struct open_block *block = directive_block(p);
    const struct value *value = symbol_find(p, block->variable);
    if (value && value->kind == VALUE_FLOAT)
        block->value = value->number[0];
    block->value += block->step;
    return for_round(p);
}

static bool end_run(struct parser *p, struct span at)
{
    struct open_block *block = directive_block(p);
    if (!block)
        return error_at(p, at, NULL, "'#end' without a directive to end");
    if (block->kind == BLOCK_WHILE)
        return while_round(p);
    if (block->kind == BLOCK_FOR)
        return for_next(p);
    directive_close(p);
    return true;
}

/* Leaves the innermost loop or #switch, closing the #ifs in it. */
static bool break_run(struct parser *p, struct span at)
{
    struct open_block *block = directive_block(p);
    while (block && block->kind == BLOCK_IF) {
        if (!directive_skip_to_end(p))
            return false;
        block = directive_block(p);
    }
    if (!block)
        return error_at(p, at, NULL, "'#break' outside a loop or '#switch'");
    return directive_skip_to_end(p);
}

const struct directive while_directive = {
    while_run, "read what follows again while the condition is not 0"
};
const struct directive for_directive = {
    for_run, "read what follows for each value of a variable"
};
const struct directive end_directive = { end_run,
                                         "ends #if, #while, #macro ..." };
const struct directive break_directive = { break_run,
                                           "leaves a loop or a #switch" };
