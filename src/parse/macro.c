/* Macros: #macro keeps the range of tokens between its head and its #end; a
 * call evaluates the arguments and reads that range again. */
#include "parse/macro.h"

#include "parse/array.h"
#include "parse/directive.h"
#include "parse/expression.h"
#include "parse/mistaken.h"
#include "parse/symbol.h"

enum { MACRO_PARAMETER_LIMIT = 56 }; /* as POV-Ray 3.7 */

struct macro {
    const struct word *name;
    const struct token_list *list;
    size_t first, end; /* the body */
    struct span span;
    int parameter_count;
    const struct word *parameters[MACRO_PARAMETER_LIMIT];
};

bool macro_is_call(struct parser *p, const struct word *word)
{
    if (word->reserved)
        return false;
    const struct value *value = symbol_find(p, word);
    return value && value->kind == VALUE_MACRO;
}

/* Where the names in other brackets end, as in `#macro A [P, Q]`; 0: nowhere.
 */
static size_t macro_other_brackets(const char *text)
{
    static const char names[] = "abcdefghijklmnopqrstuvwxyz"
                                "ABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789, ";
    if (!*text || !strchr("[{<", *text))
        return 0;
    size_t length = 1 + strspn(text + 1, names);
    return text[length] && strchr("]}>", text[length]) ? length : 0;
}

/* `#macro A P, Q`: the brackets are forgotten; in `#macro AP, Q)` one, and no
 * one knows where. */
static bool macro_unbracketed(struct parser *p)
{
    const struct token *token = stream_peek(p);
    size_t left;
    const struct token *after = stream_raw(p, &left);
    struct span at = p->token_span;
    const char *text = at.source->text + at.offset;
    size_t other = macro_other_brackets(text);
    if (other) {
        at.length = (uint32_t)other + 1;
        return error_at(
            p, at, arena_printf(p->arena, "(%.*s)", (int)other - 1, text + 1),
            "parameters of a macro stand in '(' and ')'");
    }
    if (token->kind != TOKEN_WORD || token->word->reserved)
        return error_expected_hint(
            p, "'('", token->kind == TOKEN_COMMA ? "NAME(A, B) ..." : "()");
    const char *names = token->word->text;
    for (size_t i = 0;
         i + 1 < left && i < 2 * MACRO_PARAMETER_LIMIT &&
         after[i].kind == TOKEN_COMMA && after[i + 1].kind == TOKEN_WORD;
         i += 2)
        names =
            arena_printf(p->arena, "%s, %s", names, after[i + 1].word->text);
    return error_expected_hint(p, "'('", arena_printf(p->arena, "(%s)", names));
}

/* Read as written: a parameter may have the name of another macro.
 * macro_parameters = "(" [name {[","] name}] ")" . */
static bool macro_parameters(struct parser *p, struct macro *macro)
{
    struct span open = stream_span(p);
    if (!accept(p, TOKEN_LPAREN))
        return macro_unbracketed(p);
    struct cursor *cursor = p->cursor;
    const struct token *tokens = cursor->list->tokens;
    while (tokens[cursor->index].kind == TOKEN_WORD) {
        const struct word *name = tokens[cursor->index].word;
        struct span span = token_span(cursor->list, cursor->index);
        bool pair = tokens[cursor->index + 1].kind == TOKEN_WORD;
        bool behind = macro->parameter_count > 0 &&
                      tokens[cursor->index - 1].kind != TOKEN_COMMA;
        if (name->reserved && behind) /* the ')' is missing */
            break;
        if (pair && strcmp(name->text, "optional") == 0)
            return error_at(p, span, NULL,
                            "an optional parameter needs POV-Ray 3.8, and "
                            "glim reads 3.7; calls give all of them");
        if (name->keyword == KEYWORD_INT && pair)
            return error_at(p, span, NULL,
                            "a parameter has no type, only its "
                            "name");
        if (name->reserved)
            return error_at(p, span, mistaken_capital(p, name->text),
                            "'%s' is a reserved word; name the parameter "
                            "otherwise",
                            name->text);
        if (macro->parameter_count == MACRO_PARAMETER_LIMIT)
            return error_at(p, span, NULL,
                            "a macro can have %d parameters at most",
                            MACRO_PARAMETER_LIMIT);
        macro->parameters[macro->parameter_count++] = name;
        cursor->index += tokens[cursor->index + 1].kind == TOKEN_COMMA ? 2 : 1;
    }
    if (tokens[cursor->index].kind == TOKEN_EQUAL && macro->parameter_count)
        return error_at(p, token_span(cursor->list, cursor->index), NULL,
                        "a parameter has no value of its own; calls give all "
                        "of them");
    return expect(p, TOKEN_RPAREN, open);
}

/* macro_directive = "#macro" name macro_parameters {token} "#end" . */
static bool macro_run(struct parser *p, struct span at)
{
    static const enum keyword stops[] = { KEYWORD_END, KEYWORD_NONE };
    struct cursor *cursor = p->cursor;
    const struct token *token = &cursor->list->tokens[cursor->index];
    if (token->kind != TOKEN_WORD || token->word->reserved) {
        error_at(p, token_span(cursor->list, cursor->index),
                 token->kind == TOKEN_WORD
                     ? mistaken_capital(p, token->word->text)
                     : NULL,
                 token->kind == TOKEN_WORD ? "'%s' is a reserved word; "
                                             "name the macro otherwise"
                                           : "expected the macro's name%s",
                 token->kind == TOKEN_WORD ? token->word->text : "");
        stream_skip_block(p, stops, at);
        cursor->index++;
        return false;
    }
    struct macro *macro = ARENA_NEW(p->arena, struct macro);
    macro->name = token->word;
    macro->list = cursor->list;
    macro->span = at;
    cursor->index++;
    struct cursor *outer = stream_directive_begin(p);
    bool ok = macro_parameters(p, macro);
    stream_directive_end(p, outer);
    macro->first = cursor->index;
    if (stream_skip_block(p, stops, at) == KEYWORD_NONE)
        return false;
    macro->end = cursor->index++;
    struct value value = { .kind = VALUE_MACRO, .macro = macro };
    symbol_set(p, macro->name, ok ? value : value_poison(), false);
    return ok;
}

/* An argument: its value or, passed by reference, the element it is. */
struct macro_value {
    struct value value;
    struct value *element; /* or NULL */
};

/* A plain identifier or an element of an array, alone between commas, is passed
 * by reference: the macro may #declare it. */
static struct symbol *macro_refers(struct parser *p)
{
    size_t available;
    const struct token *token = stream_peek(p);
    if (token->kind != TOKEN_WORD || token->word->reserved)
        return NULL;
    struct symbol *symbol = symbol_lookup(p, token->word);
    const struct token *after = stream_raw(p, &available);
    size_t end = symbol && symbol->value.kind == VALUE_ARRAY
                     ? array_subscripts_end(after, available, 0)
                     : 0;
    bool alone = end < available && (after[end].kind == TOKEN_COMMA ||
                                     after[end].kind == TOKEN_RPAREN);
    return alone ? symbol : NULL;
}

/* One that was never set has no value to pass. */
static bool macro_element(struct parser *p, const struct symbol *symbol,
                          struct macro_value *out)
{
    struct span at = p->last_span;
    if (!array_element(p, symbol->value.array, &out->element))
        return false;
    out->value = *out->element;
    return out->value.kind != VALUE_NONE ||
           error_at(p, span_join(at, p->last_span), NULL,
                    "this element of '%s' was never set", symbol->word->text);
}

static bool macro_argument(struct parser *p, struct macro_value *out)
{
    struct symbol *symbol = macro_refers(p);
    out->element = NULL;
    if (symbol) {
        stream_next(p);
        if (symbol->value.kind == VALUE_ARRAY &&
            stream_peek(p)->kind == TOKEN_LBRACKET)
            return macro_element(p, symbol, out);
        out->value =
            (struct value){ .kind = VALUE_REFERENCE, .symbol = symbol };
        return true;
    }
    return parse_value(p, &out->value);
}

/* Its name is to be declared otherwise. Nothing more is said of it. */
static bool macro_declared(struct parser *p, const struct macro *macro,
                           struct span at)
{
    error_at(p, at, arena_printf(p->arena, "My%s", macro->name->text),
             "'%s' is a macro already: what is declared here needs another "
             "name",
             macro->name->text);
    note_at(p, macro->span, "it is defined here");
    symbol_set(p, macro->name, (struct value){ .kind = VALUE_POISON }, false);
    return false;
}

/* macro_arguments = "(" [value {[","] value}] ")" . */
static bool macro_arguments(struct parser *p, const struct macro *macro,
                            struct macro_value *values)
{
    struct span open = stream_span(p);
    if (!expect(p, TOKEN_LPAREN, span_none())) {
        note_at(p, macro->span,
                "'%s' is a macro, defined here: wherever it is named it is "
                "called, as %s(%s)",
                macro->name->text, macro->name->text,
                macro->parameter_count > 0 ? "..." : "");
        return false;
    }
    for (int i = 0; i < macro->parameter_count; i++) {
        if (i > 0)
            accept(p, TOKEN_COMMA);
        if (stream_peek(p)->kind == TOKEN_RPAREN) {
            error_at(p, p->token_span, NULL,
                     "macro '%s' wants %d argument%s, found %d",
                     macro->name->text, macro->parameter_count,
                     macro->parameter_count == 1 ? "" : "s", i);
            note_at(p, macro->span, "it is defined here");
            return false;
        }
        if (mistaken_named(p)) {
            note_at(p, macro->span, "'%s' is defined here", macro->name->text);
            return false;
        }
        if (!macro_argument(p, &values[i]))
            return false;
    }
    if (stream_peek(p)->kind == TOKEN_COMMA || at_expression(p)) {
        error_at(p, p->token_span, NULL,
                 "macro '%s' wants no more than %d argument%s",
                 macro->name->text, macro->parameter_count,
                 macro->parameter_count == 1 ? "" : "s");
        note_at(p, macro->span, "it is defined here");
        return false;
    }
    return expect(p, TOKEN_RPAREN, open);
}

/* Drops the rest of a wrong call, which is written at `cursor`, to its ')' or
 * as far as it can reach: also where what is wrong is in a macro that an
 * argument calls. */
static void macro_recover(struct parser *p, struct cursor *cursor)
{
    bool ended = true; /* at the name, before the '(' */
    for (const struct cursor *c = p->cursor; c && ended; c = c->below)
        ended = c != cursor;
    if (!ended)
        stream_pop_to(p, cursor);
    cursor = p->cursor;
    if (p->peeked)
        cursor->index--;
    p->peeked = false;
    for (unsigned depth = 1; depth > 0 && cursor->index < cursor->end;) {
        enum token_kind kind = cursor->list->tokens[cursor->index].kind;
        if (kind == TOKEN_DIRECTIVE || kind == TOKEN_SEMICOLON)
            return;
        depth += kind == TOKEN_LPAREN;
        depth -= kind == TOKEN_RPAREN;
        cursor->index++;
    }
}

/* The arguments are read as in parentheses, whatever is being read outside:
 * directives and macros in them do run. */
bool macro_call(struct parser *p, const struct word *word, struct span at)
{
    const struct macro *macro = symbol_find(p, word)->macro;
    struct macro_value values[MACRO_PARAMETER_LIMIT];
    struct cursor *directive = p->directive, *written = p->cursor;
    if (!expression_enter(p))
        return false;
    p->directive = NULL;
    bool ok = stream_peek(p)->kind == TOKEN_EQUAL
                  ? macro_declared(p, macro, at)
                  : macro_arguments(p, macro, values);
    p->directive = directive;
    p->nesting--;
    if (!ok) {
        macro_recover(p, written);
        return false;
    }
    if (!stream_round(p, 3, at) ||
        !stream_push_macro(p, macro->list, macro->first, macro->end, word, at))
        return false;
    scope_push(p);
    for (int i = 0; i < macro->parameter_count; i++) {
        struct symbol *symbol = symbol_make_parameter(p, macro->parameters[i]);
        value_copy(&symbol->value, &values[i].value);
        symbol->element = values[i].element;
    }
    return true;
}

const struct directive macro_directive = { macro_run,
                                           "define text with parameters" };
