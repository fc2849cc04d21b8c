/* #if #ifdef #ifndef #elseif #else #switch #case #range: which text is read.
 * Skipped text may hold anything as long as its directives balance. */
#include "parse/array.h"
#include "parse/directive.h"
#include "parse/symbol.h"

/* Goes to the branch of an #if that is to be read, from inside a branch that
 * is not: an #elseif that holds, #else or #end. */
static bool conditional_next_branch(struct parser *p)
{
    static const enum keyword stops[] = { KEYWORD_ELSEIF, KEYWORD_ELSE,
                                          KEYWORD_END, KEYWORD_NONE };
    for (;;) {
        enum keyword stop =
            stream_skip_block(p, stops, directive_block(p)->span);
        if (stop != KEYWORD_NONE)
            p->cursor->index++;
        if (stop == KEYWORD_ELSE) {
            struct open_block *block = directive_block(p);
            block->is_else = true;
            block->otherwise =
                token_span(p->cursor->list, p->cursor->index - 1);
            return true;
        }
        if (stop != KEYWORD_ELSEIF) {
            directive_close(p);
            return stop == KEYWORD_END;
        }
        double condition;
        if (!directive_float(p, &condition))
            return directive_skip_to_end(p) && false;
        if (condition != 0)
            return true;
    }
}

static bool conditional_begin(struct parser *p, struct span at, bool holds)
{
    directive_open(p, BLOCK_IF, at);
    return holds || conditional_next_branch(p);
}

/* if_directive = "#if" "(" condition ")" . */
static bool if_run(struct parser *p, struct span at)
{
    double condition = 0;
    if (!directive_float(p, &condition)) {
        directive_open(p, BLOCK_IF, at);
        return directive_skip_to_end(p) && false;
    }
    return conditional_begin(p, at, condition != 0);
}

/* A declared name, or an element that has a value, in parentheses; sets
 * *declared. */
static bool conditional_name(struct parser *p, bool *declared)
{
    struct cursor *cursor = p->cursor;
    const struct token *tokens = cursor->list->tokens + cursor->index;
    *declared = false;
    if (tokens[0].kind != TOKEN_LPAREN || tokens[1].kind != TOKEN_WORD)
        return error_expected_hint(
            p, "a name in parentheses",
            tokens[0].kind == TOKEN_WORD
                ? arena_printf(p->arena, "(%s)", tokens[0].word->text)
                : NULL);
    const struct word *word = tokens[1].word;
    const struct value *value = symbol_find(p, word);
    *declared = word->reserved || value != NULL;
    cursor->index += 2;
    if (value && value->kind == VALUE_ARRAY &&
        cursor->list->tokens[cursor->index].kind == TOKEN_LBRACKET) {
        struct value *element;
        if (!array_element(p, value->array, &element))
            return false;
        *declared = element->kind != VALUE_NONE;
    }
    while (cursor->list->tokens[cursor->index].kind == TOKEN_LBRACKET) {
        double index;
        cursor->index++;
        if (!parse_float(p, &index) || !expect(p, TOKEN_RBRACKET, span_none()))
            return false;
    }
    return expect(p, TOKEN_RPAREN, span_none());
}

/* The same, and nothing that its subscripts call is left unread. */
static bool conditional_asks(struct parser *p, bool *declared)
{
    struct directive_head outer = directive_head_begin(p);
    bool ok = conditional_name(p, declared);
    return directive_condition_end(p, outer) && ok;
}

/* ifdef_directive = "#ifdef" "(" name [subscripts] ")" . */
static bool ifdef_run(struct parser *p, struct span at)
{
    bool declared, ok = conditional_asks(p, &declared);
    return conditional_begin(p, at, declared) && ok;
}

/* ifndef_directive = "#ifndef" "(" name [subscripts] ")" . */
static bool ifndef_run(struct parser *p, struct span at)
{
    bool declared, ok = conditional_asks(p, &declared);
    return conditional_begin(p, at, ok && !declared) && ok;
}

/* Nothing comes behind the #else that is being read but its #end. POV-Ray, too,
 * lets it pass in text that it skips. */
static bool behind_else(struct parser *p, struct span at, const char *name)
{
    const struct open_block *block = directive_block(p);
    if (!block->is_else)
        return true;
    error_at(p, at, "#end", "'#%s' behind the '#else' of the same '#if'", name);
    note_at(p, block->otherwise, "its '#else' is here");
    return false;
}

/* A branch that was read ends here: the rest is skipped. */
static bool elseif_run(struct parser *p, struct span at)
{
    struct open_block *block = directive_block(p);
    if (!block || block->kind != BLOCK_IF)
        return error_at(p, at, NULL, "'#elseif' without '#if'");
    bool ok = behind_else(p, at, "elseif");
    return directive_skip_to_end(p) && ok;
}

/* In a #switch, #else is the branch for no match; reached by falling through
 * it is read on. */
static bool else_run(struct parser *p, struct span at)
{
    struct open_block *block = directive_block(p);
    if (block && block->kind == BLOCK_SWITCH)
        return true;
    if (!block || block->kind != BLOCK_IF)
        return error_at(p, at, NULL, "'#else' without '#if' or '#switch'");
    bool ok = behind_else(p, at, "else");
    return directive_skip_to_end(p) && ok;
}

static bool range_ends(struct parser *p, double *first, double *last)
{
    struct span open = stream_span(p);
    if (!accept(p, TOKEN_LPAREN))
        return error_expected_hint(p, "'('", condition_hint(p, open));
    return parse_float(p, first) && (accept(p, TOKEN_COMMA) || true) &&
           parse_float(p, last) && expect(p, TOKEN_RPAREN, open);
}

static bool switch_matches(struct parser *p, enum keyword stop, double value,
                           bool *matches)
{
    double first, last;
    struct directive_head outer = directive_head_begin(p);
    bool ok = stop == KEYWORD_CASE ? parse_condition(p, &first)
                                   : range_ends(p, &first, &last);
    if (!directive_condition_end(p, outer) || !ok)
        return false;
    *matches = stop == KEYWORD_CASE ? fabs(first - value) < 1e-10
                                    : value >= first && value <= last;
    return true;
}

/* What stands between a #switch and its first #case would never be read. */
static void switch_check(struct parser *p)
{
    const struct cursor *cursor = p->cursor;
    if (cursor->index >= cursor->end)
        return;
    const struct token *next = &cursor->list->tokens[cursor->index];
    enum keyword keyword =
        next->kind == TOKEN_DIRECTIVE || next->kind == TOKEN_WORD
            ? next->word->keyword
            : KEYWORD_NONE;
    bool cases = keyword == KEYWORD_CASE || keyword == KEYWORD_RANGE;
    if (next->kind != TOKEN_DIRECTIVE || !cases)
        error_at(p, token_span(cursor->list, cursor->index),
                 cases ? arena_printf(p->arena, "#%s", next->word->text) : NULL,
                 "'#case' or '#range' comes right behind '#switch (...)'");
}

/* switch_directive = "#switch" "(" condition ")" . */
static bool switch_run(struct parser *p, struct span at)
{
    static const enum keyword stops[] = { KEYWORD_CASE, KEYWORD_RANGE,
                                          KEYWORD_ELSE, KEYWORD_END,
                                          KEYWORD_NONE };
    double value;
    bool ok = directive_float(p, &value), matches = false;
    directive_open(p, BLOCK_SWITCH, at);
    if (ok && at.source->text[at.offset] == '#')
        switch_check(p);
    while (ok && !matches) {
        enum keyword stop = stream_skip_block(p, stops, at);
        if (stop != KEYWORD_NONE)
            p->cursor->index++;
        if (stop == KEYWORD_END || stop == KEYWORD_NONE) {
            directive_close(p);
            return stop == KEYWORD_END;
        }
        if (stop == KEYWORD_ELSE)
            return true;
        ok = switch_matches(p, stop, value, &matches);
    }
    return ok || (directive_skip_to_end(p) && false);
}

/* A case reached by falling through from the one before: its value is read
 * and ignored.
 * case_directive = "#case" "(" condition ")" . */
static bool case_run(struct parser *p, struct span at)
{
    struct open_block *block = directive_block(p);
    bool ignored;
    if (!block || block->kind != BLOCK_SWITCH)
        return error_at(p, at, "#switch (VALUE) #case (1)",
                        "'#case' without '#switch'");
    return switch_matches(p, KEYWORD_CASE, 0, &ignored);
}

/* range_directive = "#range" "(" float "," float ")" . */
static bool range_run(struct parser *p, struct span at)
{
    struct open_block *block = directive_block(p);
    bool ignored;
    if (!block || block->kind != BLOCK_SWITCH)
        return error_at(p, at, "#switch (VALUE) #range (0, 1)",
                        "'#range' without '#switch'");
    return switch_matches(p, KEYWORD_RANGE, 0, &ignored);
}

const struct directive if_directive = {
    if_run, "read what follows if the condition is not 0"
};
const struct directive ifdef_directive = {
    ifdef_run, "read what follows if the name is declared"
};
const struct directive ifndef_directive = {
    ifndef_run, "read what follows if the name is not declared"
};
const struct directive elseif_directive = {
    elseif_run, "another condition, tried if those before were 0"
};
const struct directive else_directive = {
    else_run, "what to read if no condition or case before it held"
};
const struct directive switch_directive = {
    switch_run, "read from the first #case or #range that matches"
};
const struct directive case_directive = {
    case_run, "in a #switch: the value equals this"
};
const struct directive range_directive = {
    range_run, "in a #switch: the value is from the first to the second number"
};
