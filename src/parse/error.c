/* Errors of a scene: with the trace of macros and includes, each place once,
 * and with what to type. */
#include <ctype.h>
#include <stdio.h>

#include "base/hash.h"
#include "base/text.h"
#include "parse/error_parts.h"
#include "parse/expression.h"
#include "parse/mistaken.h"
#include "parse/stream.h"
#include "parse/symbol.h"
#include "scene/pattern.h"

enum { ERROR_TRACE_LIMIT = 8 }; /* most notes of one trace */

static bool span_is(struct span a, struct span b)
{
    return a.source == b.source && a.offset == b.offset;
}

static bool error_reported(struct parser *p, struct span span)
{
    for (unsigned i = 0; i < p->reported_count; i++)
        if (span_is(p->reported[i], span))
            return true;
    return false;
}

bool error_is_silent(struct parser *p)
{
    struct span span = stream_span(p);
    return p->failed || p->told || error_reported(p, library_user(p, span));
}

bool error_follows(struct parser *p)
{
    return p->reported_count > 0 && p->taken_at_error == p->taken;
}

/* "in macro M called here", "included from here", innermost first; but for
 * the place `shown`, which the message itself shows. */
static void error_trace(struct parser *p, struct span shown)
{
    unsigned notes = 0, hidden = 0;
    struct span last = span_none();
    for (struct cursor *c = p->cursor; c; c = c->below) {
        if (!c->called_at.source)
            continue;
        if (span_is(c->called_at, shown))
            continue;
        bool again = span_is(c->called_at, last);
        last = c->called_at;
        if (again || notes++ >= ERROR_TRACE_LIMIT) {
            hidden++;
            continue;
        }
        if (c->kind == CURSOR_FILE)
            note_at(p, c->called_at, "included from here");
        else
            note_at(p, c->called_at, "in %s '%s' called here",
                    c->kind == CURSOR_MACRO ? "macro" : "function",
                    c->macro->text);
    }
    if (hidden)
        note_at(p, span_none(), "and %u more calls and includes", hidden);
}

bool error_at(struct parser *p, struct span span, const char *hint,
              const char *format, ...)
{
    bool stopped = p->options->stop && *p->options->stop;
    struct span user = library_user(p, span);
    bool library = user.source != span.source;
    p->silent = p->failed || p->told || stopped || error_reported(p, user);
    if (p->silent)
        return false;
    if (p->reported_count < DIAG_ERROR_LIMIT)
        p->reported[p->reported_count++] = user;
    va_list arguments;
    va_start(arguments, format);
    diag_vprint(p->diag, DIAG_ERROR, user, library ? NULL : hint, format,
                arguments);
    va_end(arguments);
    if (library)
        diag_print(p->diag, DIAG_NOTE, span, hint,
                   "it shows here, in POV-Ray's own file");
    error_trace(p, library ? user : span_none());
    p->taken_at_error = p->taken;
    if (p->diag->errors >= DIAG_ERROR_LIMIT) {
        note_at(p, span_none(), "%d errors are enough; the rest is not read",
                DIAG_ERROR_LIMIT);
        stream_abort(p);
    }
    return false;
}

/* In a loop a warning is given once, and that it comes again. */
struct warned {
    struct span span;
    uint64_t text;
    bool again;
};

static void note_warned_again(struct parser *p, struct span span)
{
    struct source_place place = source_locate(span.source, span.offset);
    diag_print(p->diag, DIAG_NOTE, span_none(), NULL,
               "the warning of %s:%u:%u comes again and is not repeated",
               span.source->name, place.line, place.column);
}

static bool warning_comes_again(struct parser *p, struct span span,
                                const char *format, va_list arguments)
{
    char text[200]; /* what is beyond hardly tells two of a place apart */
    vsnprintf(text, sizeof text, format, arguments);
    uint64_t hash = hash_text(0, text);
    for (size_t i = 0; i < p->warned.count; i++) {
        struct warned *warned = &p->warned.items[i];
        if (warned->text != hash || !span_is(warned->span, span))
            continue;
        if (!warned->again)
            note_warned_again(p, span);
        warned->again = true;
        return true;
    }
    if (p->warned.count < DIAG_WARNING_LIMIT) /* more are not printed */
        *ARRAY_PUSH(p->arena, &p->warned) =
            (struct warned){ .span = span, .text = hash };
    return false;
}

void warning_at(struct parser *p, struct span span, const char *hint,
                const char *format, ...)
{
    va_list arguments;
    p->silent = false;
    va_start(arguments, format);
    bool again = span.source && warning_comes_again(p, span, format, arguments);
    va_end(arguments);
    if (again)
        return;
    va_start(arguments, format);
    diag_vprint(p->diag, DIAG_WARNING, span, hint, format, arguments);
    va_end(arguments);
    error_trace(p, span_none());
}

void note_at(struct parser *p, struct span span, const char *format, ...)
{
    if (p->silent)
        return;
    va_list arguments;
    va_start(arguments, format);
    diag_vprint(p->diag, DIAG_NOTE, span, NULL, format, arguments);
    va_end(arguments);
}

const char *error_found(struct parser *p)
{
    const struct token *token = stream_peek(p);
    struct span span = p->token_span;
    if (token->kind == TOKEN_END)
        return "the end of the file";
    int length = span.length > 40 ? 40 : (int)span.length;
    return arena_printf(p->arena, "'%.*s%s'", length,
                        span.source->text + span.offset,
                        span.length > 40 ? "..." : "");
}

/* What begins a colour, or a function, in other letters: `Rgb`, `VLength`; and
 * `PI`, `True`, but `X`, which may be anything, for a vector only. */
static const char *error_other_case(struct parser *p, const char *wanted,
                                    const char *text)
{
    size_t left;
    const bool vector = strncmp(wanted, "a vector", 8) == 0;
    enum token_kind next = stream_raw(p, &left)->kind;
    bool called = next == TOKEN_LPAREN;
    const struct word *small = mistaken_case(p, text, strlen(text));
    if ((small->length > 1 || vector) && constant_is(p, small->keyword))
        return small->text;
    if (left == 0 || (!called && next != TOKEN_LESS && next != TOKEN_NUMBER))
        return NULL;
    bool meant = called ? small->reserved : colour_begins(small->keyword);
    return meant ? small->text : NULL;
}

/* The pattern whose name is nearest, where one is wanted. */
static const char *error_near_pattern(const char *wanted, const char *text)
{
    struct text_nearest nearest = text_nearest_start(text);
    if (strstr(wanted, "a pattern"))
        for (size_t i = 0; pattern_at(i); i++)
            text_nearest_try(&nearest, pattern_at(i)->name);
    return nearest.best;
}

/* `&lt;`, of a scene that was copied out of a web page's source. */
static const char *error_entity(struct parser *p, const char *word)
{
    static const char *const entities[][2] = {
        { "lt", "<" }, { "gt", ">" }, { "amp", "&" }, { "quot", "\"" }
    };
    struct span last = p->last_span;
    if (!last.source || last.source->text[last.offset] != '&')
        return NULL;
    for (size_t i = 0; i < sizeof entities / sizeof *entities; i++)
        if (strcmp(word, entities[i][0]) == 0)
            return entities[i][1];
    return NULL;
}

/* What is written in another language than this one; tells whether it was. */
static bool error_foreign(struct parser *p, const char *word)
{
    const char *meant = error_entity(p, word);
    if (meant) {
        error_at(p, span_join(p->last_span, p->token_span), meant,
                 "this is HTML for '%s'", meant);
        stream_next(p);
        accept(p, TOKEN_SEMICOLON);
        p->blamed = p->last_span;
        return true;
    }
    if (strcmp(word, "return") == 0 && p->cursor->kind == CURSOR_MACRO) {
        error_at(p, p->token_span, NULL,
                 "what a macro gives just stands in it, without 'return'");
        stream_next(p);
        return true;
    }
    return false;
}

/* A name that is used while its own declaration goes on. */
static void note_declaring(struct parser *p, const struct word *name)
{
    const struct declaring *d = p->declaring;
    while (d && d->name != name)
        d = d->outer;
    if (d && d->block_count < p->block_count)
        note_at(p, p->blocks[d->block_count],
                "this '{' of the declaration of '%s' is not closed yet; a '}' "
                "may be missing",
                name->text);
}

/* Where the name is declared further on in the file; nowhere: it isn't. */
static struct span declared_below(struct parser *p, const struct word *name)
{
    const struct token_list *list = p->cursor->list;
    if (list->source != p->token_span.source)
        return span_none();
    for (size_t i = p->cursor->index; i + 1 < list->count; i++) {
        const struct token *token = &list->tokens[i];
        bool declares = token->kind == TOKEN_DIRECTIVE &&
                        (token->word->keyword == KEYWORD_DECLARE ||
                         token->word->keyword == KEYWORD_LOCAL ||
                         token->word->keyword == KEYWORD_MACRO);
        if (declares && token[1].kind == TOKEN_WORD && token[1].word == name)
            return token_span(list, i + 1);
    }
    return span_none();
}

bool error_below(struct parser *p, const struct word *name)
{
    struct span below = declared_below(p, name);
    if (!below.source)
        return false;
    error_at(p, p->token_span, NULL, "'%s' is used before it is declared",
             name->text);
    note_at(p, below, "it is declared here, below");
    return true;
}

/* The declared name that is nearest, but no other value where a string is
 * wanted: its quotes are forgotten. */
static const char *error_nearest(struct parser *p, const char *wanted,
                                 const char *text)
{
    const char *name = symbol_nearest(p, text);
    const struct value *value =
        name ? symbol_find(p, word_intern(p->words, name, strlen(name))) : NULL;
    bool fits = !value || strcmp(wanted, "a string") != 0 ||
                value->kind == VALUE_STRING;
    return fits ? name : NULL;
}

/* A reserved word instead of a name that differs from it by case only. */
static const char *error_declared_case(struct parser *p)
{
    const struct token *token = stream_peek(p);
    const char *name = token->kind == TOKEN_WORD && token->word->reserved
                           ? symbol_nearest(p, token->word->text)
                           : NULL;
    return name && text_equal_nocase(name, token->word->text) ? name : NULL;
}

void note_long_string(struct parser *p)
{
    struct span last = p->last_span;
    if (!last.source || last.source->text[last.offset] != '"' ||
        !memchr(last.source->text + last.offset, '\n', last.length))
        return;
    last.length = 1;
    note_at(p, last, "this string ends lines below; its '\"' may be missing");
}

/* A number that is there without being declared: `clok`. */
static const char *error_near_number(const char *wanted, const char *text)
{
    static const char *const numbers[] = { "clock",        "clock_delta",
                                           "frame_number", "final_frame",
                                           "image_width",  "image_height" };
    struct text_nearest nearest = text_nearest_start(text);
    if (strncmp(wanted, "a number", 8) != 0 &&
        strncmp(wanted, "a vector", 8) != 0 &&
        strcmp(wanted, "a condition") != 0)
        return NULL;
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++)
        text_nearest_try(&nearest, numbers[i]);
    return nearest.best;
}

/* The name that is meant by one that isn't declared: letters of another case
 * are nearer than other letters. */
static const char *error_near(struct parser *p, const char *wanted,
                              const char *text)
{
    const char *name = error_nearest(p, wanted, text);
    const char *alike = name && text_equal_nocase(name, text)
                            ? name
                            : error_other_case(p, wanted, text);
    if (alike)
        return alike;
    if (name)
        return name;
    const char *pattern = error_near_pattern(wanted, text);
    return pattern ? pattern : error_near_number(wanted, text);
}

/* `math.sin(1)`: functions belong to nothing. */
static const char *error_member(struct parser *p)
{
    size_t left;
    const struct token *next = stream_raw(p, &left);
    return left > 2 && next[0].kind == TOKEN_DOT &&
                   next[1].kind == TOKEN_WORD && next[1].word->reserved &&
                   next[2].kind == TOKEN_LPAREN
               ? arena_printf(p->arena, "%s( ...", next[1].word->text)
               : NULL;
}

/* An identifier that was never declared is the likeliest mistake of all. */
static bool error_undeclared(struct parser *p, const char *wanted,
                             const char *hint)
{
    const struct token *token = stream_peek(p);
    if (token->kind != TOKEN_WORD || token->word->reserved ||
        symbol_lookup(p, token->word))
        return false;
    if (error_foreign(p, token->word->text) || mistaken_degrees(p) ||
        error_later_word(p, token->word, ""))
        return true;
    if (strcmp(wanted, "a condition") != 0 && error_below(p, token->word))
        return true;
    const char *declared = symbol_nearest(p, token->word->text);
    if (!hint && declared && text_equal_nocase(declared, token->word->text))
        hint = declared;
    if (!hint)
        hint = standard_include(p, token->word->text);
    if (!hint)
        hint = mistaken_word(token->word, "");
    if (!hint)
        hint = error_member(p);
    if (!hint)
        hint = error_near(p, wanted, token->word->text);
    if (!hint && strcmp(wanted, "a condition") == 0)
        hint =
            arena_printf(p->arena, "#declare %s = 0; ...", token->word->text);
    if (!hint && strcmp(wanted, "a string") == 0)
        hint = arena_printf(p->arena, "\"%s\"", token->word->text);
    size_t left;
    const struct token *next = stream_raw(p, &left);
    bool names =
        left > 0 && (next->kind == TOKEN_LESS || next->kind == TOKEN_NUMBER ||
                     next->kind == TOKEN_EQUAL);
    if (!hint && names)
        hint = wanted_signature(p, 1);
    error_at(p, p->token_span, hint,
             "expected %s, found '%s', which is not declared", wanted,
             token->word->text);
    note_declaring(p, token->word);
    return true;
}

const char *error_kind(struct parser *p)
{
    const struct token *token = stream_peek(p);
    if (token->kind != TOKEN_WORD || token->word->reserved)
        return NULL;
    const struct value *value = symbol_find(p, token->word);
    return value ? value_kind_name(value->kind) : NULL;
}

/* `ior = 1.5`, as other languages have it. */
static const char *error_assigned(struct parser *p, const char *wanted)
{
    enum token_kind kind = stream_peek(p)->kind;
    struct span last = p->last_span;
    if (*wanted == '\'' || (kind != TOKEN_EQUAL && kind != TOKEN_COLON) ||
        !last.source || !isalpha((unsigned char)last.source->text[last.offset]))
        return "";
    return kind == TOKEN_EQUAL ? "; no '=' stands between a word and its value"
                               : "; no ':' stands between a word and its value";
}

/* The number behind that '=', with the word before it: `ior 1.5`. */
static const char *error_assigned_hint(struct parser *p)
{
    enum { LONGEST = 40 };
    size_t left;
    const struct token *value = stream_raw(p, &left);
    const struct span word = p->last_span;
    if (!*error_assigned(p, "") || left == 0 ||
        p->token_span.source != word.source || value->kind != TOKEN_NUMBER)
        return NULL;
    const char *text = word.source->text + value->offset;
    const size_t length = strcspn(text, " \t\r\n,;(){}");
    return length < LONGEST
               ? arena_printf(p->arena, "%.*s %.*s", (int)word.length,
                              word.source->text + word.offset, (int)length,
                              text)
               : NULL;
}

const char *error_last_word(const struct parser *p, int *length)
{
    struct span last = p->last_span;
    if (!last.source || !isalpha((unsigned char)last.source->text[last.offset]))
        return NULL;
    *length = (int)last.length;
    return last.source->text + last.offset;
}

const char *error_last_value(struct parser *p, enum value_kind kind,
                             int *length)
{
    const char *text = error_last_word(p, length);
    const struct value *value =
        text ? symbol_find(p, word_intern(p->words, text, (size_t)*length))
             : NULL;
    return value && value->kind == kind ? text : NULL;
}

/* `V[0]` of a vector: it has no subscripts. */
static const char *error_subscript(struct parser *p)
{
    int length;
    const char *text = stream_peek(p)->kind == TOKEN_LBRACKET
                           ? error_last_value(p, VALUE_VECTOR, &length)
                           : NULL;
    return text ? arena_printf(p->arena, "%.*s.x ...", length, text) : NULL;
}

/* `pigment { V }` of a vector: it is no colour yet. */
static const char *error_uncoloured(struct parser *p, const char *wanted)
{
    const struct token *token = stream_peek(p);
    if (strncmp(wanted, "a colour", 8) != 0 || token->kind != TOKEN_WORD ||
        token->word->reserved)
        return NULL;
    const struct value *value = symbol_find(p, token->word);
    return value && value->kind == VALUE_VECTOR
               ? arena_printf(p->arena, "rgb %s", token->word->text)
               : NULL;
}

bool error_expected_hint(struct parser *p, const char *wanted, const char *hint)
{
    if (p->blamed.source && p->blamed.source == p->last_span.source &&
        p->blamed.offset == p->last_span.offset) {
        p->silent = true;
        return false;
    }
    stream_peek(p);
    p->silent = true;
    wanted = wanted_field(p, wanted, 1);
    if (error_follows(p) || at_poison(p) || error_is_silent(p) ||
        mistaken_number(p) || error_undeclared(p, wanted, hint)) {
        note_long_string(p);
        return false;
    }
    const char *kind = error_kind(p);
    if (!hint)
        hint = error_subscript(p);
    if (!hint)
        hint = error_uncoloured(p, wanted);
    if (!hint)
        hint = item_wrapped(p, wanted);
    if (!hint)
        hint = error_declared_case(p);
    if (!hint)
        hint = wanted_signature(p, 1);
    if (!hint)
        hint = mistaken_value(p, wanted);
    if (!hint)
        hint = error_assigned_hint(p);
    error_at(p, stream_span(p), hint ? hint : wanted_example(p, wanted),
             "expected %s, found %s%s%s%s", wanted, error_found(p),
             kind ? ", " : "", kind ? kind : "", error_assigned(p, wanted));
    note_long_string(p);
    return false;
}

bool error_expected(struct parser *p, const char *wanted)
{
    return error_expected_hint(p, wanted, NULL);
}
