/* The token stream: see stream.h and the calls in parser.h. */
#include "parse/stream.h"

#include "parse/directive.h"
#include "parse/macro.h"
#include "parse/mistaken.h"
#include "parse/symbol.h"

enum { STREAM_PATIENCE = 32 }; /* tokens */

static struct span cursor_span(const struct cursor *cursor, size_t index)
{
    return token_span(cursor->list, index);
}

static bool stream_push(struct parser *p, struct cursor cursor)
{
    if (p->depth >= PARSE_CURSOR_LIMIT) {
        error_at(p, cursor.called_at, NULL,
                 "includes and macro calls are nested more than %d deep",
                 PARSE_CURSOR_LIMIT);
        stream_abort(p);
        return false;
    }
    struct cursor *top = p->free_cursors;
    if (top)
        p->free_cursors = top->below;
    else
        top = ARENA_NEW(p->arena, struct cursor);
    cursor.blocks.items = top->blocks.items;
    cursor.blocks.capacity = top->blocks.capacity;
    cursor.below = p->cursor;
    *top = cursor;
    p->cursor = top;
    p->depth++;
    return true;
}

static void stream_pop(struct parser *p)
{
    struct cursor *top = p->cursor;
    if (top->owns_scope)
        scope_pop(p);
    p->cursor = top->below;
    top->below = p->free_cursors;
    p->free_cursors = top;
    p->depth--;
}

bool stream_push_file(struct parser *p, const struct token_list *list)
{
    if (!stream_push(
            p, (struct cursor){ .kind = CURSOR_FILE,
                                .list = list,
                                .end = list->count - 1,
                                .called_at = list->source->included_from }))
        return false;
    p->cursor->owns_scope = p->cursor->below != NULL;
    return !p->cursor->owns_scope || scope_push(p);
}

bool stream_push_macro(struct parser *p, const struct token_list *list,
                       size_t first, size_t end, const struct word *name,
                       struct span called_at)
{
    return stream_push(p, (struct cursor){ .kind = CURSOR_MACRO,
                                           .list = list,
                                           .index = first,
                                           .end = end,
                                           .macro = name,
                                           .owns_scope = true,
                                           .called_at = called_at });
}

bool stream_push_range(struct parser *p, const struct token_list *list,
                       size_t first, size_t end, const struct word *name,
                       struct span called_at)
{
    return stream_push(p, (struct cursor){ .kind = CURSOR_RANGE,
                                           .list = list,
                                           .index = first,
                                           .end = end,
                                           .macro = name,
                                           .called_at = called_at });
}

void stream_pop_range(struct parser *p)
{
    while (p->cursor && p->cursor->kind != CURSOR_RANGE)
        stream_pop(p);
    if (p->cursor)
        stream_pop(p);
    p->peeked = false;
}

bool stream_pop_to(struct parser *p, const struct cursor *cursor)
{
    bool found = p->cursor == cursor;
    while (p->cursor && p->cursor != cursor)
        stream_pop(p);
    if (!found)
        p->peeked = false;
    return found;
}

void stream_abort(struct parser *p)
{
    p->failed = true;
    p->token.kind = TOKEN_END;
}

unsigned stream_round_limit(const struct parser *p)
{
    return p->options->round_limit ? p->options->round_limit : PARSE_LOOP_LIMIT;
}

bool stream_round(struct parser *p, unsigned cost, struct span span)
{
    unsigned long limit =
        (unsigned long)stream_round_limit(p) * PARSE_ROUNDS_FACTOR;
    bool erroneous = p->reported_count > 0;
    if (erroneous && (p->rounds_after_error += cost) > PARSE_ROUNDS_AFTER_ERROR)
        diag_print(p->diag, DIAG_NOTE, span, NULL,
                   "the rest is not read: after an error this may never end");
    else if ((p->rounds += cost) > limit)
        error_at(p, span, NULL,
                 "loops, macros and includes took more than %lu rounds in all, "
                 "glim's limit",
                 limit);
    else
        return true;
    stream_abort(p);
    return false;
}

/* The end of a cursor's text: true when the stream ends here. */
static bool stream_leave(struct parser *p, bool infix)
{
    struct cursor *cursor = p->cursor;
    if (cursor->kind == CURSOR_RANGE || cursor == p->head ||
        (infix && cursor == p->directive))
        return true;
    if (cursor->blocks.count && !p->failed) {
        struct open_block *open =
            &cursor->blocks.items[cursor->blocks.count - 1];
        error_at(p, open->span, NULL,
                 "this directive has no '#end' before the end of the %s",
                 cursor->kind == CURSOR_FILE ? "file" : "macro");
        cursor->blocks.count = 0;
    }
    if (!cursor->below)
        return true;
    stream_pop(p);
    return false;
}

bool stream_stopped(struct parser *p)
{
    bool stopped = p->options->stop && *p->options->stop;
    if (stopped)
        stream_abort(p);
    return stopped;
}

void stream_ask(struct parser *p)
{
    p->fetched = STREAM_PATIENCE - 1;
}

/* The loop that had most rounds, of those that are open. */
static void note_longest_loop(struct parser *p)
{
    const struct open_block *longest = NULL;
    for (const struct cursor *c = p->cursor; c; c = c->below)
        for (size_t i = 0; i < c->blocks.count; i++)
            if (!longest || c->blocks.items[i].rounds > longest->rounds)
                longest = &c->blocks.items[i];
    if (longest && longest->rounds > 1)
        note_at(p, longest->span, "this is in its round %u", longest->rounds);
}

/* Asked now and then, for it takes as long as a token: the arenas are far
 * apart.
 */
static bool stream_interrupted(struct parser *p)
{
    if (++p->fetched % STREAM_PATIENCE != 0)
        return false;
    if (stream_stopped(p))
        return true;
    size_t limit = arena_limit(p->arena);
    if (arena_used(p->arena) + arena_used(p->scene_arena) +
            arena_used(p->sources) <=
        limit)
        return false;
    error_at(p, p->last_span, NULL,
             "the scene needs more memory than the limit of %zu MiB",
             limit >> 20);
    note_longest_loop(p);
    stream_abort(p);
    return true;
}

/* A '#' before what is no directive is passed over, as in POV-Ray. */
static bool stream_passes_sign(struct parser *p, const struct token *token)
{
    const struct word *word = token->word;
    return !directive_is(word->keyword) &&
           (word->reserved || symbol_find(p, word));
}

/* Two directives need no '#', since POV-Ray only warns. */
static bool stream_lacks_sign(enum keyword keyword)
{
    return keyword == KEYWORD_DECLARE || keyword == KEYWORD_INCLUDE;
}

static void stream_warn_sign(struct parser *p, const struct token *token)
{
    const char *word = token->word->text;
    warning_at(p, cursor_span(p->cursor, p->cursor->index),
               arena_printf(p->arena, "#%s", word),
               "'%s' should have a '#' before it", word);
}

/* Whether neither directive nor macro can begin with it. */
static bool token_is_plain(struct parser *p, const struct token *token)
{
    switch (token->kind) {
    case TOKEN_WORD:
        return token->word->reserved ? !stream_lacks_sign(token->word->keyword)
                                     : !macro_is_call(p, token->word);
    case TOKEN_DIRECTIVE:
    case TOKEN_BAD:
        return false;
    default:
        return true;
    }
}

static void stream_take(struct parser *p, struct cursor *cursor)
{
    p->token = cursor->list->tokens[cursor->index];
    p->token_span = cursor_span(cursor, cursor->index++);
    p->peeked = true;
}

/* Finds the next token of the scene: false at an end. */
static bool stream_fetch(struct parser *p, bool infix)
{
    for (;;) {
        struct cursor *cursor = p->cursor;
        if (p->failed || stream_interrupted(p))
            return false;
        if (cursor->index >= cursor->end) {
            if (stream_leave(p, infix))
                return false;
            continue;
        }
        const struct token *token = &cursor->list->tokens[cursor->index];
        bool stays = infix && cursor == p->directive;
        bool spare = p->spare_semicolon;
        p->spare_semicolon = false;
        if (spare && !stays && token->kind == TOKEN_SEMICOLON) {
            cursor->index++;
            continue;
        }
        if (token_is_plain(p, token)) {
            stream_take(p, cursor);
            return true;
        }
        if (token->kind == TOKEN_BAD) {
            struct span span = cursor_span(cursor, cursor->index++);
            error_at(p, span, mistaken_character(p, span), "%s", token->text);
        } else if (token->kind == TOKEN_DIRECTIVE &&
                   !stream_passes_sign(p, token)) {
            if (stays)
                return false;
            directive_run(p);
        } else if (token->kind == TOKEN_WORD &&
                   stream_lacks_sign(token->word->keyword)) {
            if (stays)
                return false;
            stream_warn_sign(p, token);
            directive_run(p);
        } else if (token->kind == TOKEN_WORD || macro_is_call(p, token->word)) {
            if (stays)
                return false;
            cursor->index++;
            macro_call(p, token->word, cursor_span(cursor, cursor->index - 1));
        } else {
            stream_take(p, cursor);
            p->token.kind = TOKEN_WORD;
            return true;
        }
    }
}

static struct span stream_end_span(struct parser *p)
{
    struct cursor *cursor = p->cursor;
    if (cursor->index < cursor->list->count)
        return cursor_span(cursor, cursor->index);
    return p->last_span;
}

/* Runs and expands what stands before the next token. Apart from stream_look,
 * which then needs few registers. */
__attribute__((noinline)) static const struct token *
stream_search(struct parser *p, bool infix)
{
    static const struct token end = { .kind = TOKEN_END };
    if (stream_fetch(p, infix))
        return &p->token;
    p->peeked = false;
    p->token_span = stream_end_span(p);
    return &end;
}

/* As stream_search, for most tokens in a few steps: those that stand next and
 * need nothing run or asked. Apart from its callers, which are asked several
 * times for each token. */
__attribute__((noinline)) static const struct token *
stream_look(struct parser *p, bool infix)
{
    struct cursor *cursor = p->cursor;
    if (!p->failed && !p->spare_semicolon && cursor->index < cursor->end &&
        p->fetched % STREAM_PATIENCE != STREAM_PATIENCE - 1 &&
        token_is_plain(p, &cursor->list->tokens[cursor->index])) {
        p->fetched++;
        stream_take(p, cursor);
        return &p->token;
    }
    return stream_search(p, infix);
}

const struct token *stream_peek(struct parser *p)
{
    return p->peeked && !p->failed ? &p->token : stream_look(p, false);
}

const struct token *stream_peek_infix(struct parser *p)
{
    return p->peeked && !p->failed ? &p->token : stream_look(p, true);
}

struct token stream_next(struct parser *p)
{
    struct token token = *stream_peek(p);
    span_copy(&p->last_span, &p->token_span);
    p->peeked = false;
    p->taken++;
    return token;
}

struct span stream_span(struct parser *p)
{
    struct span span;
    stream_peek(p);
    span_copy(&span, &p->token_span);
    return span;
}

enum keyword stream_keyword(struct parser *p)
{
    const struct token *token = stream_peek(p);
    return token->kind == TOKEN_WORD ? token->word->keyword : KEYWORD_NONE;
}

bool accept(struct parser *p, enum token_kind kind)
{
    if (stream_peek(p)->kind != kind || kind == TOKEN_END)
        return false;
    stream_next(p);
    return true;
}

bool accept_keyword(struct parser *p, enum keyword keyword)
{
    if (stream_keyword(p) != keyword)
        return false;
    stream_next(p);
    return true;
}

bool expect(struct parser *p, enum token_kind kind, struct span open)
{
    if (accept(p, kind))
        return true;
    const enum token_kind found = stream_peek(p)->kind;
    const bool closes = (found == TOKEN_RBRACE || found == TOKEN_RPAREN ||
                         found == TOKEN_RBRACKET) &&
                        (kind == TOKEN_RPAREN || kind == TOKEN_RBRACKET ||
                         kind == TOKEN_GREATER);
    const char *name = token_kind_name(kind);
    error_expected_hint(
        p, name, closes ? arena_printf(p->arena, "%.1s", name + 1) : NULL);
    if (open.source)
        note_at(p, open, "to match this '%.*s'", (int)open.length,
                open.source->text + open.offset);
    return false;
}

struct cursor *stream_directive_begin(struct parser *p)
{
    struct cursor *outer = p->directive;
    p->directive = p->cursor;
    return outer;
}

void stream_directive_end(struct parser *p, struct cursor *outer)
{
    if (p->peeked)
        p->cursor->index--;
    p->peeked = false;
    p->directive = outer;
}

const struct token *stream_raw(struct parser *p, size_t *available)
{
    struct cursor *cursor = p->cursor;
    *available = cursor->end - cursor->index;
    return cursor->list->tokens + cursor->index;
}

void stream_skip_raw(struct parser *p, size_t n)
{
    p->cursor->index += n;
    p->last_span = cursor_span(p->cursor, p->cursor->index - 1);
    p->peeked = false;
}

bool block_begin(struct parser *p, struct span *open)
{
    struct span before;
    span_copy(&before, &p->last_span);
    *open = stream_span(p);
    if (stream_peek(p)->kind != TOKEN_LBRACE)
        return error_unopened(p, before);
    stream_next(p);
    if (++p->nesting > PARSE_NESTING_LIMIT) {
        error_at(p, *open, NULL, "blocks are nested more than %d deep",
                 PARSE_NESTING_LIMIT);
        stream_abort(p);
        return false;
    }
    p->blocks[p->block_count++] = *open;
    return true;
}

/* Skips to the '}' of a block whose inside had an error. */
static void block_skip(struct parser *p)
{
    for (unsigned depth = 1; depth > 0;) {
        struct token token = stream_next(p);
        if (token.kind == TOKEN_END)
            return;
        if (token.kind == TOKEN_LBRACE)
            depth++;
        if (token.kind == TOKEN_RBRACE)
            depth--;
    }
}

bool block_end(struct parser *p, struct span open, bool ok)
{
    ok = ok && expect(p, TOKEN_RBRACE, open);
    if (!ok && !p->unclosed)
        block_skip(p);
    p->unclosed = false;
    p->block_count--;
    p->nesting--;
    return ok;
}

bool block_items(struct parser *p, bool (*item)(struct parser *p))
{
    struct span open;
    bool ok = true;
    stream_next(p);
    if (!block_begin(p, &open))
        return false;
    while (ok && stream_peek(p)->kind != TOKEN_RBRACE)
        ok = item(p);
    return block_end(p, open, ok);
}

bool stream_block_opens(enum keyword keyword)
{
    return keyword == KEYWORD_IF || keyword == KEYWORD_IFDEF ||
           keyword == KEYWORD_IFNDEF || keyword == KEYWORD_WHILE ||
           keyword == KEYWORD_FOR || keyword == KEYWORD_SWITCH ||
           keyword == KEYWORD_MACRO;
}

/* What is wrong in the text that was skipped from the token `begin` on, and may
 * have taken an #end with it, a string that isn't closed, or stands for one:
 * #endif. */
static void note_unread(struct parser *p, size_t begin)
{
    const struct cursor *cursor = p->cursor;
    for (size_t i = begin; i < cursor->end; i++) {
        const struct token *token = &cursor->list->tokens[i];
        struct span span = cursor_span(cursor, i);
        bool lines =
            token->kind == TOKEN_STRING && strchr(token->text, '\n') != NULL;
        if (lines)
            span.length = 1;
        if (lines || token->kind == TOKEN_BAD) {
            note_at(p, span, "%s",
                    lines ? "this string ends lines below; its '\"' may be "
                            "missing"
                          : token->text);
            return;
        }
        if (token->kind == TOKEN_DIRECTIVE &&
            mistaken_directive_word(token->word) == KEYWORD_END) {
            note_at(p, span, "'#%s' is no directive: type #end",
                    token->word->text);
            return;
        }
    }
}

enum keyword stream_skip_block(struct parser *p, const enum keyword *stops,
                               struct span open)
{
    struct cursor *cursor = p->cursor;
    size_t begin = cursor->index;
    unsigned depth = 0;
    bool bare = open.source->text[open.offset] != '#'; /* reported by now */
    for (; cursor->index < cursor->end; cursor->index++) {
        const struct token *token = &cursor->list->tokens[cursor->index];
        if (token->kind != TOKEN_DIRECTIVE &&
            (token->kind != TOKEN_WORD || !bare))
            continue;
        enum keyword keyword = token->word->keyword;
        for (size_t i = 0; depth == 0 && stops[i]; i++)
            if (keyword == stops[i])
                return keyword;
        if (depth == 0 && mistaken_elseif(token))
            warning_at(p, token_span(cursor->list, cursor->index), "#elseif",
                       "'#%s' is no directive: this is skipped",
                       token->word->text);
        if (stream_block_opens(keyword))
            depth++;
        else if (keyword == KEYWORD_END && depth > 0)
            depth--;
    }
    error_at(p, open, NULL, "this directive has no '#end'");
    note_unread(p, begin);
    return KEYWORD_NONE;
}
