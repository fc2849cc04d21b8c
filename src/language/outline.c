/* Outlines: see outline.h. */
#include "language/outline.h"

#include "base/array.h"

enum { DEPTH_LIMIT = 1000 }; /* blocks inside each other that are told */

/* A '{' or a directive that is not closed yet. */
struct opening {
    size_t token;
    size_t name; /* of a macro, its place among the names + 1; else 0 */
    bool brace;
};

struct outliner {
    struct page *page;
    struct outline *outline;
    const struct token *tokens;
    size_t count; /* TOKEN_END left out */
    struct opening open[DEPTH_LIMIT];
    size_t depth, deeper; /* those beyond the limit */
};

static bool token_is_name(const struct token *token)
{
    return token->kind == TOKEN_WORD && !token->word->reserved;
}

static struct name *outliner_add(struct outliner *o, enum name_kind kind,
                                 size_t first, size_t token)
{
    struct name *name = ARRAY_PUSH(o->page->arena, &o->outline->names);
    *name = (struct name){ .kind = kind,
                           .word = o->tokens[token].word,
                           .token = token,
                           .first = first,
                           .last = token,
                           .seen = token,
                           .unseen = o->count };
    return name;
}

/* The last token of a value that begins at `at`. */
static size_t outliner_value_end(const struct outliner *o, size_t at)
{
    unsigned depth = 0;
    bool block = false;
    for (; at < o->count; at++) {
        enum token_kind kind = o->tokens[at].kind;
        if (kind == TOKEN_LBRACE) {
            depth++;
            block = true;
        } else if (kind == TOKEN_RBRACE && depth > 0) {
            depth--;
        } else if (depth == 0 && kind == TOKEN_SEMICOLON) {
            return at;
        } else if (depth == 0 &&
                   (kind == TOKEN_DIRECTIVE || kind == TOKEN_RBRACE)) {
            return at - 1;
        }
        bool more = at + 1 < o->count && o->tokens[at + 1].kind == TOKEN_WORD &&
                    block && o->tokens[at + 1].word->keyword == KEYWORD_TEXTURE;
        if (block && depth == 0 && !more)
            return at;
    }
    return o->count ? o->count - 1 : 0;
}

static void outliner_declare(struct outliner *o, size_t at, bool local)
{
    size_t token = at + 1;
    while (token < o->count &&
           ((o->tokens[token].kind == TOKEN_WORD &&
             (o->tokens[token].word->keyword == KEYWORD_DEPRECATED ||
              o->tokens[token].word->keyword == KEYWORD_ONCE)) ||
            o->tokens[token].kind == TOKEN_STRING))
        token++;
    if (token + 1 >= o->count || !token_is_name(&o->tokens[token]) ||
        o->tokens[token + 1].kind != TOKEN_EQUAL)
        return;
    struct name *name =
        outliner_add(o, local ? NAME_LOCAL : NAME_DECLARE, at, token);
    if (token + 2 < o->count && o->tokens[token + 2].kind == TOKEN_WORD)
        name->value = o->tokens[token + 2].word;
    name->last = outliner_value_end(o, token + 2);
    for (size_t i = o->depth; local && i > 0; i--)
        if (o->open[i - 1].name) { /* known until that macro ends */
            name->unseen = 0;
            break;
        }
}

static void outliner_macro(struct outliner *o, size_t at)
{
    size_t token = at + 1;
    if (token >= o->count || !token_is_name(&o->tokens[token]))
        return;
    outliner_add(o, NAME_MACRO, at, token);
    size_t macro = o->outline->names.count;
    if (++token >= o->count || o->tokens[token].kind != TOKEN_LPAREN)
        return;
    struct {
        const struct word **items;
        size_t count, capacity;
    } parameters = { 0 };
    for (token++; token < o->count; token++) {
        if (token_is_name(&o->tokens[token])) {
            *ARRAY_PUSH(o->page->arena, &parameters) = o->tokens[token].word;
            outliner_add(o, NAME_PARAMETER, at, token)->unseen = 0;
        } else if (o->tokens[token].kind != TOKEN_COMMA) {
            break;
        }
    }
    struct name *name = &o->outline->names.items[macro - 1];
    name->parameters = parameters.items;
    name->parameter_count = parameters.count;
    if (o->depth > 0 && o->open[o->depth - 1].token == at)
        o->open[o->depth - 1].name = macro;
}

static void outliner_open(struct outliner *o, size_t token, bool brace)
{
    if (o->depth == DEPTH_LIMIT)
        o->deeper++;
    else
        o->open[o->depth++] = (struct opening){ token, 0, brace };
}

/* Names of a macro end with it. */
static void outliner_close_macro(struct outliner *o, size_t macro, size_t at)
{
    for (size_t i = macro; i < o->outline->names.count; i++)
        if (o->outline->names.items[i].unseen == 0)
            o->outline->names.items[i].unseen = at;
    o->outline->names.items[macro - 1].last = at;
}

/* What is open and of the other kind was not closed: it is dropped. */
static void outliner_close(struct outliner *o, size_t at, bool brace)
{
    if (o->deeper > 0) {
        o->deeper--;
        return;
    }
    size_t depth = o->depth;
    while (depth > 0 && o->open[depth - 1].brace != brace)
        depth--;
    if (depth == 0)
        return;
    struct opening *open = &o->open[depth - 1];
    struct fold *fold = ARRAY_PUSH(o->page->arena, &o->outline->folds);
    *fold = (struct fold){ open->token, at, brace && depth == 1 };
    if (open->name)
        outliner_close_macro(o, open->name, at);
    /* An #end closes what a brace left open in its text, not the reverse: an
     * #if may open a brace that is closed behind its #end. */
    if (brace) {
        memmove(open, open + 1, (o->depth - depth) * sizeof *open);
        o->depth--;
    } else {
        size_t kept = depth - 1;
        for (size_t i = depth; i < o->depth; i++)
            if (o->open[i].brace)
                o->open[kept++] = o->open[i];
        o->depth = kept;
    }
}

static void outliner_loop(struct outliner *o, size_t at)
{
    if (at + 2 < o->count && o->tokens[at + 1].kind == TOKEN_LPAREN &&
        token_is_name(&o->tokens[at + 2]))
        outliner_add(o, NAME_LOOP, at, at + 2);
}

static void outliner_directive(struct outliner *o, size_t at)
{
    switch (o->tokens[at].word->keyword) {
    case KEYWORD_DECLARE:
    case KEYWORD_LOCAL:
        outliner_declare(o, at, o->tokens[at].word->keyword == KEYWORD_LOCAL);
        break;
    case KEYWORD_MACRO:
        outliner_open(o, at, false);
        outliner_macro(o, at);
        break;
    case KEYWORD_FOR:
        outliner_open(o, at, false);
        outliner_loop(o, at);
        break;
    case KEYWORD_IF:
    case KEYWORD_IFDEF:
    case KEYWORD_IFNDEF:
    case KEYWORD_WHILE:
    case KEYWORD_SWITCH:
        outliner_open(o, at, false);
        break;
    case KEYWORD_END:
        outliner_close(o, at, false);
        break;
    case KEYWORD_INCLUDE:
        if (at + 1 < o->count && o->tokens[at + 1].kind == TOKEN_STRING)
            *ARRAY_PUSH(o->page->arena, &o->outline->includes) =
                (struct include){ at + 1, o->tokens[at + 1].text };
        break;
    default:
        break;
    }
}

const struct outline *page_outline(struct library *library, struct page *page)
{
    if (page->outline)
        return page->outline;
    const struct token_list *list = page_tokens(library, page);
    page->outline = ARENA_NEW(page->arena, struct outline);
    struct arena *arena = arena_new(0);
    struct outliner *o = ARENA_NEW(arena, struct outliner);
    o->page = page;
    o->outline = page->outline;
    o->tokens = list->tokens;
    o->count = list->count - 1;
    for (size_t at = 0; at < o->count; at++) {
        enum token_kind kind = o->tokens[at].kind;
        if (kind == TOKEN_DIRECTIVE)
            outliner_directive(o, at);
        else if (kind == TOKEN_LBRACE)
            outliner_open(o, at, true);
        else if (kind == TOKEN_RBRACE)
            outliner_close(o, at, true);
    }
    for (size_t i = 0; i < page->outline->names.count; i++)
        if (page->outline->names.items[i].unseen == 0)
            page->outline->names.items[i].unseen = o->count;
    arena_free(arena);
    return page->outline;
}

const struct name *outline_name(const struct outline *outline,
                                const struct word *word, size_t at)
{
    const struct name *best = NULL, *after = NULL;
    for (size_t i = 0; i < outline->names.count; i++) {
        const struct name *name = &outline->names.items[i];
        if (name->word != word)
            continue;
        bool known = name->seen <= at && at <= name->unseen;
        bool inner = name->kind == NAME_PARAMETER || name->kind == NAME_LOCAL;
        if (known && (!best || inner || name->kind == NAME_DECLARE ||
                      name->kind == NAME_MACRO))
            best = name;
        if (!after && !inner)
            after = name;
    }
    return best ? best : after;
}

static bool pages_have(const struct page_list *list, const struct page *page)
{
    for (size_t i = 0; i < list->count; i++)
        if (list->items[i] == page)
            return true;
    return false;
}

enum { PAGES_LIMIT = 500 }; /* of one scene */

void pages_below(struct library *library, struct page *page,
                 struct arena *arena, struct page_list *list)
{
    if (pages_have(list, page))
        return;
    *ARRAY_PUSH(arena, list) = page;
    for (size_t at = list->count - 1;
         at < list->count && list->count < PAGES_LIMIT; at++) {
        const struct outline *outline = page_outline(library, list->items[at]);
        for (size_t i = 0; i < outline->includes.count; i++) {
            const char *path = library_find(library, arena, list->items[at],
                                            outline->includes.items[i].name);
            struct page *below = path ? page_of_file(library, path) : NULL;
            if (below && !pages_have(list, below))
                *ARRAY_PUSH(arena, list) = below;
        }
    }
}

void pages_around(struct library *library, struct page *page,
                  struct arena *arena, struct page_list *list)
{
    pages_below(library, page, arena, list);
    for (struct page *other = library->pages; other; other = other->next) {
        struct page_list below = { 0 };
        if (!other->open || pages_have(list, other))
            continue;
        pages_below(library, other, arena, &below);
        if (!pages_have(&below, page))
            continue;
        for (size_t i = 0; i < below.count; i++)
            if (!pages_have(list, below.items[i]))
                *ARRAY_PUSH(arena, list) = below.items[i];
    }
}

const struct name *pages_name(struct library *library,
                              const struct page_list *list,
                              const struct word *word, struct page **where)
{
    for (size_t p = 0; p < list->count; p++) {
        const struct outline *outline = page_outline(library, list->items[p]);
        for (size_t i = outline->names.count; i > 0; i--) {
            const struct name *name = &outline->names.items[i - 1];
            *where = list->items[p];
            if (name->word == word && name->kind != NAME_PARAMETER)
                return name;
        }
    }
    return NULL;
}
