/* #declare #local #undef: names for values. */
#include "parse/array.h"
#include "parse/directive.h"
#include "parse/expression.h"
#include "parse/mistaken.h"
#include "parse/symbol.h"

/* What stands before the '='. */
struct declaration {
    const struct word *name;
    struct span span;    /* of the name */
    struct value *slot;  /* of an array's element, NULL: the name itself */
    struct array *array; /* which that is of */
    const char *deprecated;
    bool once;
};

/* deprecation = "deprecated" ["once"] string . */
static bool declare_deprecation(struct parser *p, struct declaration *head)
{
    if (!accept_keyword(p, KEYWORD_DEPRECATED))
        return true;
    head->once = accept_keyword(p, KEYWORD_ONCE);
    return parse_string(p, &head->deprecated);
}

/* A name that begins with a digit: `1st`; several names in brackets. Returns
 * false, as what is reported is not more than one thing. */
static bool declare_begins_wrong(struct parser *p)
{
    size_t left;
    struct span span = p->token_span;
    const struct token *next = stream_raw(p, &left);
    if (p->token.kind == TOKEN_LPAREN || p->token.kind == TOKEN_LBRACE)
        return error_at(p, span, NULL,
                        "a declaration of several names at once needs POV-Ray "
                        "3.8, and glim reads 3.7; each has one of its own");
    if (p->token.kind != TOKEN_NUMBER || left == 0 ||
        next->kind != TOKEN_WORD || next->offset != span.offset + span.length)
        return false;
    span.length += next->length;
    error_at(p, span,
             arena_printf(p->arena, "_%.*s", (int)span.length,
                          span.source->text + span.offset),
             "a name begins with a letter or '_'");
    return false;
}

/* False after reporting a name like `my-ball` or `my.ball`. */
static bool declare_name_ends(struct parser *p)
{
    struct span name = p->last_span;
    enum token_kind kind = stream_peek_infix(p)->kind;
    size_t left;
    const struct token *next = stream_raw(p, &left);
    struct span sign = p->token_span;
    bool touches = sign.offset == name.offset + name.length;
    bool joined = touches && left > 0 && next->kind == TOKEN_WORD &&
                  (kind == TOKEN_MINUS || kind == TOKEN_DOT) &&
                  next->offset == sign.offset + 1;
    bool number = touches && kind == TOKEN_NUMBER; /* of Ball2.5 */
    if (!joined && !number)
        return true;
    size_t after =
        number ? sign.offset + sign.length : next->offset + next->length;
    char *hint = arena_copy_text(p->arena, name.source->text + name.offset,
                                 after - name.offset);
    hint[name.length] = '_';
    name.length = (uint32_t)(after - name.offset);
    return error_at(p, name, hint, "a name is made of letters, digits and '_'");
}

/* The reserved word with a capital letter, which is free. */
static const char *declare_capital(struct parser *p, const struct word *word)
{
    const char *name = mistaken_capital(p, word->text);
    return word_intern(p->words, name, strlen(name))->reserved ? NULL : name;
}

static bool declare_name(struct parser *p, const struct word **name)
{
    const struct token *token = stream_peek(p);
    if (token->kind != TOKEN_WORD)
        return declare_begins_wrong(p) ||
               error_expected_hint(p, "a name to declare",
                                   token->kind == TOKEN_STRING ? token->text
                                                               : NULL);
    if (token->word->reserved)
        return error_at(p, p->token_span, declare_capital(p, token->word),
                        "'%s' is a reserved word; declare another name",
                        token->word->text);
    *name = stream_next(p).word;
    return declare_name_ends(p);
}

/* The last token of the value as it was written: of a macro's value its call,
 * not what is in the macro. */
static struct span declare_end(const struct parser *p)
{
    const struct cursor *cursor = p->cursor;
    size_t taken = cursor->index - p->peeked;
    return cursor == p->directive && taken > 0
               ? token_span(cursor->list, taken - 1)
               : p->last_span;
}

/* A comment right behind the value that has a ';': that is taken for a part of
 * the declaration, or '//' for an operator. */
static void note_comment(struct parser *p, struct span end)
{
    const char *text = end.source->text;
    size_t at = end.offset + end.length;
    at += strspn(text + at, " \t");
    size_t length = strcspn(text + at, "\r\n");
    if (strncmp(text + at, "//", 2) == 0 && memchr(text + at, ';', length))
        note_at(p, (struct span){ end.source, (uint32_t)at, 2 },
                "what follows is a comment, its ';' as well");
}

/* Behind a declaration that is wrong: its ';' or the next directive. */
static void declare_skip(struct parser *p)
{
    for (;;) {
        enum token_kind kind = stream_peek_infix(p)->kind;
        if (kind == TOKEN_END)
            return;
        stream_next(p);
        if (kind == TOKEN_SEMICOLON)
            return;
    }
}

/* What stands where the ';' should. */
static bool declare_unended(struct parser *p, const struct value *value)
{
    struct span end = declare_end(p);
    enum token_kind kind = stream_peek_infix(p)->kind;
    bool subscript = kind == TOKEN_LBRACKET, closes = kind == TOKEN_RPAREN;
    if (subscript)
        error_expected(p, "';'");
    if (closes)
        error_at(p, p->token_span, NULL, "this ')' closes nothing");
    if (subscript || closes || mistaken_number(p) || mistaken_comma(p, end)) {
        declare_skip(p);
        return false;
    }
    error_at(p, end, ";", "a declaration of %s must end with ';'",
             value_kind_name(value->kind));
    note_comment(p, end);
    return false;
}

/* A #declare of a number needs a ';': without it POV-Ray could not tell where
 * the expression ends. Before version 3.5 its lack was a warning. One more may
 * follow, wherever the text goes on: `#declare A = M();` with a M that ends in
 * `;` (measured). */
static bool declare_semicolon(struct parser *p, const struct value *value)
{
    bool needed = value->kind == VALUE_FLOAT || value->kind == VALUE_VECTOR ||
                  value->kind == VALUE_COLOUR;
    if (stream_peek_infix(p)->kind == TOKEN_SEMICOLON) {
        stream_next(p);
        p->spare_semicolon = needed;
        return true;
    }
    if (!needed || (p->version_said && p->version < 3.5))
        return true;
    return declare_unended(p, value);
}

/* `#declare Ball = { sphere { ... } }` */
static bool declare_is_braced(struct parser *p)
{
    size_t left;
    bool open = stream_peek(p)->kind == TOKEN_LBRACE;
    const struct token *after = stream_raw(p, &left);
    return open && left > 1 && after[0].kind == TOKEN_WORD &&
           after[0].word->reserved && after[1].kind == TOKEN_LBRACE;
}

static bool declare_braced(struct parser *p, const struct word *name)
{
    size_t left;
    const char *first = stream_raw(p, &left)->word->text;
    return error_at(
        p, stream_span(p),
        arena_printf(p->arena, "#declare %s = %s { ... }", name->text, first),
        "a value stands without braces around it; of several "
        "objects 'union { ... }' makes one");
}

/* What is declared gets a value in any case, so that its uses are not
 * reported too: errors leave VALUE_POISON behind. */
static bool declare_value(struct parser *p, const struct word *name,
                          struct value *value)
{
    if (declare_is_braced(p)) {
        *value = (struct value){ .kind = VALUE_POISON };
        return declare_braced(p, name);
    }
    unsigned errors = p->diag->errors;
    const struct declaring now = { name, p->block_count, p->declaring };
    p->declaring = &now;
    bool ok = parse_value(p, value);
    p->declaring = now.outer;
    if (ok)
        return true;
    *value = (struct value){ .kind = VALUE_POISON };
    return p->diag->errors == errors;
}

/* For `A[3] = ...` of no array: one with nearly that name or, as no such value
 * was declared, the declaration that comes first. */
static const char *declare_no_array(struct parser *p,
                                    const struct symbol *symbol,
                                    const struct word *name)
{
    const char *near = symbol ? NULL : symbol_nearest(p, name->text);
    if (symbol || near)
        return near;
    return arena_printf(p->arena, "#declare %s = array[10]; ...", name->text);
}

/* Where the value goes: an element's place or, slot NULL, the name itself. */
static bool declare_place(struct parser *p, struct declaration *head)
{
    const struct word *name = head->name;
    head->slot = NULL;
    head->span = p->last_span;
    if (stream_peek_infix(p)->kind != TOKEN_LBRACKET)
        return true;
    struct symbol *symbol = symbol_lookup(p, name);
    if (symbol && symbol->value.kind == VALUE_POISON)
        return false;
    if (!symbol || symbol->value.kind != VALUE_ARRAY)
        return error_at(p, p->last_span, declare_no_array(p, symbol, name),
                        "'%s' is not an array", name->text);
    p->changes++;
    return array_place(p, symbol->value.array, &head->slot, &head->array);
}

/* `i++`, `i += 2`, `i : 2` and `f(x) = ...`, as other languages have it, and a
 * value without the '='. */
static const char *declare_counted(struct parser *p, const struct word *name)
{
    const struct token *token = stream_peek_infix(p);
    enum token_kind kind = token->kind;
    if (kind == TOKEN_NUMBER || kind == TOKEN_STRING || kind == TOKEN_LESS ||
        (kind == TOKEN_WORD && token->word->reserved))
        return arena_printf(p->arena, "= %.*s", (int)p->token_span.length,
                            p->token_span.source->text + p->token_span.offset);
    if (kind == TOKEN_COLON)
        return "=";
    if (kind == TOKEN_SEMICOLON)
        return "= 0";
    if (kind == TOKEN_LPAREN)
        return "= function(x) { ... }";
    if (kind != TOKEN_PLUS && kind != TOKEN_MINUS && kind != TOKEN_STAR &&
        kind != TOKEN_SLASH)
        return NULL;
    const char *text = p->token_span.source->text + p->token_span.offset;
    const char *by = text[1] == '=' ? text + 2 + strspn(text + 2, " ") : "1";
    return arena_printf(p->arena, "= %s %c %.*s;", name->text, *text,
                        (int)strcspn(by, ";\r\n"), by);
}

/* How many words stand before the '=' of `My Red Ball = ...`, behind its first
 * one, if that is how it goes on; 0: it does not. */
static size_t declare_words_apart(struct parser *p)
{
    enum { MOST = 8 };
    size_t left, count = 0;
    bool word = stream_peek_infix(p)->kind == TOKEN_WORD;
    const struct token *after = stream_raw(p, &left);
    while (word && count < left && count < MOST &&
           after[count].kind == TOKEN_WORD)
        count++;
    return word && count < left && after[count].kind == TOKEN_EQUAL ? count + 1
                                                                    : 0;
}

static bool declare_apart(struct parser *p, const struct declaration *head,
                          size_t words)
{
    size_t left;
    const struct token *after = stream_raw(p, &left);
    const char *name =
        arena_printf(p->arena, "%s_%s", head->name->text, p->token.word->text);
    uint32_t end = p->token_span.offset + p->token_span.length;
    for (size_t i = 0; i + 1 < words; i++) {
        name = arena_printf(p->arena, "%s_%s", name, after[i].word->text);
        end = after[i].offset + after[i].length;
    }
    struct span span = head->span;
    span.length = end - span.offset;
    return error_at(p, span, name, "a name is one word");
}

static bool declare_equal(struct parser *p, const struct declaration *head)
{
    size_t words = declare_words_apart(p);
    if (words)
        return declare_apart(p, head, words);
    if (stream_peek_infix(p)->kind != TOKEN_EQUAL)
        return error_expected_hint(p, "'='", declare_counted(p, head->name));
    struct span span = stream_span(p);
    stream_next(p);
    if (stream_peek(p)->kind != TOKEN_EQUAL)
        return true;
    return error_at(p, span_join(span, p->token_span), "=",
                    "a value is given with one '='");
}

static bool declare_head(struct parser *p, struct declaration *head)
{
    return declare_deprecation(p, head) && declare_name(p, &head->name) &&
           declare_place(p, head) && declare_equal(p, head);
}

static void declare_tell(struct parser *p, const struct declaration *head,
                         const struct value *value)
{
    const struct parse_listener *listener = p->options->listener;
    if (!listener || value->kind == VALUE_POISON)
        return;
    bool is_colour = value->kind == VALUE_COLOUR;
    struct parse_declared declared = {
        .name = head->name->text,
        .span = head->span,
        .kind = value_kind_name(value->kind),
        .numbers = value->number,
        .size = value->kind == VALUE_FLOAT    ? 1
                : value->kind == VALUE_VECTOR ? value->size
                : is_colour                   ? 5
                                              : 0,
        .colour = is_colour,
        .text = value->kind == VALUE_STRING ? value->text : NULL,
    };
    listener->declared(listener->context, &declared);
}

/* declaration = [deprecation] name {"[" float "]"} "=" value [";"] . */
static bool declare_read(struct parser *p, bool local)
{
    /* A macro that gives the value may still be open after it, in spite of
     * its end: `#macro M() #local Q = 1; Q; #end`. The name is not local to
     * it, and not one of its locals. */
    struct scope *scope = p->scope;
    struct declaration head = { 0 };
    if (!declare_head(p, &head)) {
        declare_skip(p);
        return false;
    }
    struct value value = { .kind = VALUE_NONE };
    bool ok = declare_value(p, head.name, &value);
    if (p->failed)
        return false;
    if (head.slot && !array_takes(p, head.array, head.span, &value))
        ok = false;
    if (head.slot) {
        *head.slot = ok ? value : value_poison();
    } else {
        struct symbol *symbol = symbol_make_in(p, scope, head.name, local);
        symbol_give(p, symbol, &value);
        symbol->deprecated = head.deprecated;
        symbol->deprecated_once = head.once;
        declare_tell(p, &head, &value);
    }
    if (ok)
        return declare_semicolon(p, &value);
    const struct token *token = stream_peek_infix(p);
    if (token->kind == TOKEN_WORD && token->word->keyword == KEYWORD_IF)
        declare_skip(p);
    for (enum token_kind kind = token->kind;
         kind == TOKEN_LBRACKET || kind == TOKEN_LBRACE;
         kind = stream_peek_infix(p)->kind)
        skip_brackets(p);
    if (stream_peek_infix(p)->kind == TOKEN_SEMICOLON)
        stream_next(p); /* it belongs to what was wrong */
    return false;
}

static bool declare_run_in(struct parser *p, bool local)
{
    struct cursor *outer = stream_directive_begin(p);
    bool ok = declare_read(p, local);
    stream_directive_end(p, outer);
    return ok;
}

/* declare_directive = "#declare" declaration . */
static bool declare_run(struct parser *p, struct span at)
{
    (void)at;
    return declare_run_in(p, false);
}

/* local_directive = "#local" declaration . */
static bool local_run(struct parser *p, struct span at)
{
    (void)at;
    return declare_run_in(p, true);
}

/* undef_directive = "#undef" name . */
static bool undef_run(struct parser *p, struct span at)
{
    (void)at;
    struct cursor *cursor = p->cursor;
    const struct token *token = &cursor->list->tokens[cursor->index];
    if (token->kind != TOKEN_WORD || token->word->reserved)
        return error_expected_hint(p, "a declared name",
                                   directive_bracketed_name(p));
    cursor->index++;
    symbol_undefine(p, token->word);
    return true;
}

const struct directive declare_directive = {
    declare_run, "give a name a value, for the rest of the scene"
};
const struct directive local_directive = {
    local_run, "give a name a value, within this file or macro"
};
const struct directive undef_directive = { undef_run, "forget a name" };
