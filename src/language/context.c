/* Contexts: see context.h. */
#include "language/context.h"

#include <ctype.h>

enum { DEPTH_LIMIT = 1000 };

struct frame {
    enum token_kind open; /* '{', '(', '<', '[' */
    const struct word *word;
    unsigned commas;
};

struct walk {
    struct frame frames[DEPTH_LIMIT];
    size_t depth, beyond;
    size_t branches[DEPTH_LIMIT]; /* depth where an #if began */
    size_t branch_count;
    unsigned macros; /* open directives inside a #macro, itself included */
};

static bool word_letter(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

bool token_at(const struct token_list *list, size_t offset, size_t *token)
{
    size_t at = page_token_at(list, offset + 1);
    while (at > 0 && list->tokens[at - 1].offset > offset)
        at--;
    if (at == 0)
        return false;
    const struct token *found = &list->tokens[at - 1];
    bool covers = offset < (size_t)found->offset + found->length;
    *token = at - 1;
    if (covers || offset > (size_t)found->offset + found->length)
        return covers;
    return found->kind == TOKEN_WORD || found->kind == TOKEN_DIRECTIVE ||
           found->kind == TOKEN_NUMBER || found->kind == TOKEN_STRING;
}

/* The word that a '{' belongs to: what stands before it, arguments of a
 * function or an array left out. */
static const struct word *brace_word(const struct token *tokens, size_t at)
{
    unsigned depth = 0;
    for (unsigned back = 0; at > 0 && back < 200; back++) {
        const struct token *token = &tokens[--at];
        if (token->kind == TOKEN_RPAREN || token->kind == TOKEN_RBRACKET)
            depth++;
        else if (token->kind == TOKEN_LPAREN || token->kind == TOKEN_LBRACKET)
            depth -= depth > 0;
        else if (depth == 0)
            return token->kind == TOKEN_WORD || token->kind == TOKEN_DIRECTIVE
                       ? token->word
                       : NULL;
    }
    return NULL;
}

static void walk_open(struct walk *w, enum token_kind open,
                      const struct word *word)
{
    if (w->depth == DEPTH_LIMIT)
        w->beyond++;
    else
        w->frames[w->depth++] = (struct frame){ open, word, 0 };
}

static void walk_close(struct walk *w, enum token_kind open)
{
    if (w->beyond > 0) {
        w->beyond--;
        return;
    }
    size_t depth = w->depth;
    while (depth > 0 && w->frames[depth - 1].open != open) {
        if (w->frames[depth - 1].open == TOKEN_LBRACE && open != TOKEN_LBRACE)
            return;
        depth--;
    }
    if (depth > 0)
        w->depth = depth - 1;
}

static void walk_directive(struct walk *w, enum keyword keyword)
{
    switch (keyword) {
    case KEYWORD_MACRO:
    case KEYWORD_IF:
    case KEYWORD_IFDEF:
    case KEYWORD_IFNDEF:
    case KEYWORD_WHILE:
    case KEYWORD_FOR:
    case KEYWORD_SWITCH:
        w->macros += keyword == KEYWORD_MACRO || w->macros > 0;
        if (w->branch_count < DEPTH_LIMIT)
            w->branches[w->branch_count++] = w->depth;
        break;
    case KEYWORD_ELSE:
    case KEYWORD_ELSEIF:
        if (w->branch_count > 0 && w->branches[w->branch_count - 1] < w->depth)
            w->depth = w->branches[w->branch_count - 1];
        break;
    case KEYWORD_END:
        w->branch_count -= w->branch_count > 0;
        w->macros -= w->macros > 0;
        break;
    default:
        break;
    }
}

/* A '<' opens a vector, unless a value stands before it. */
static bool opens_vector(const struct token *tokens, size_t at)
{
    if (at == 0)
        return true;
    enum token_kind kind = tokens[at - 1].kind;
    bool value = kind == TOKEN_NUMBER || kind == TOKEN_RPAREN ||
                 kind == TOKEN_RBRACKET || kind == TOKEN_GREATER ||
                 (kind == TOKEN_WORD && !tokens[at - 1].word->reserved);
    return !value;
}

static void walk_token(struct walk *w, const struct token *tokens, size_t at)
{
    const struct token *before = at > 0 ? &tokens[at - 1] : NULL;
    switch (tokens[at].kind) {
    case TOKEN_LBRACE:
        walk_open(w, TOKEN_LBRACE, brace_word(tokens, at));
        break;
    case TOKEN_LPAREN:
        walk_open(w, TOKEN_LPAREN,
                  before && before->kind == TOKEN_WORD ? before->word : NULL);
        break;
    case TOKEN_LBRACKET:
        walk_open(w, TOKEN_LBRACKET, NULL);
        break;
    case TOKEN_LESS:
        if (opens_vector(tokens, at))
            walk_open(w, TOKEN_LESS, NULL);
        break;
    case TOKEN_RBRACE:
        walk_close(w, TOKEN_LBRACE);
        break;
    case TOKEN_RPAREN:
        walk_close(w, TOKEN_LPAREN);
        break;
    case TOKEN_RBRACKET:
        walk_close(w, TOKEN_LBRACKET);
        break;
    case TOKEN_GREATER:
        if (w->depth > 0 && w->frames[w->depth - 1].open == TOKEN_LESS)
            walk_close(w, TOKEN_LESS);
        break;
    case TOKEN_COMMA:
        if (w->depth > 0)
            w->frames[w->depth - 1].commas++;
        break;
    case TOKEN_SEMICOLON:
        while (w->depth > 0 && w->frames[w->depth - 1].open != TOKEN_LBRACE)
            w->depth--;
        break;
    case TOKEN_DIRECTIVE:
        walk_directive(w, tokens[at].word->keyword);
        break;
    default:
        break;
    }
}

/* Whether a comment is open between the end of a token and the place. */
static bool in_comment(const struct page *page, size_t from, size_t offset)
{
    const char *text = page->text;
    unsigned depth = 0;
    while (from < offset) {
        if (depth == 0 && text[from] == '/' && text[from + 1] == '/') {
            while (from < offset && text[from] != '\n' && text[from] != '\r')
                from++;
            if (from == offset)
                return true;
        } else if (text[from] == '/' && text[from + 1] == '*') {
            depth++;
            from++;
        } else if (depth > 0 && text[from] == '*' && text[from + 1] == '/') {
            depth--;
            from++;
        }
        from++;
    }
    return depth > 0;
}

/* Whether the place is in the string that begins at token `at`. */
static bool in_string(const struct page *page, const struct token *token,
                      size_t offset)
{
    size_t end = token->offset + (size_t)token->length;
    if (token->kind == TOKEN_STRING)
        return offset > token->offset && offset < end;
    return token->kind == TOKEN_BAD && page->text[token->offset] == '"' &&
           offset > token->offset &&
           !memchr(page->text + token->offset, '\n', offset - token->offset);
}

/* What file a string behind these tokens names; false: none. */
static bool names_file(const struct token *tokens, size_t at,
                       const struct walk *w, enum file_kind *file)
{
    const struct token *before = at > 0 ? &tokens[at - 1] : NULL;
    const struct word *block =
        w->depth > 0 ? w->frames[w->depth - 1].word : NULL;
    if (before && before->kind == TOKEN_DIRECTIVE &&
        before->word->keyword == KEYWORD_INCLUDE) {
        *file = FILE_INCLUDE;
        return true;
    }
    if (before && before->kind == TOKEN_WORD &&
        before->word->keyword == KEYWORD_TTF) {
        *file = FILE_FONT;
        return true;
    }
    *file = FILE_IMAGE;
    return block && (block->keyword == KEYWORD_IMAGE_MAP ||
                     block->keyword == KEYWORD_BUMP_MAP ||
                     block->keyword == KEYWORD_IMAGE_PATTERN ||
                     block->keyword == KEYWORD_HEIGHT_FIELD);
}

static bool token_is_operator(const struct token *token)
{
    switch (token->kind) {
    case TOKEN_COMMA:
    case TOKEN_LESS:
    case TOKEN_LPAREN:
    case TOKEN_LBRACKET:
    case TOKEN_EQUAL:
    case TOKEN_PLUS:
    case TOKEN_MINUS:
    case TOKEN_STAR:
    case TOKEN_SLASH:
    case TOKEN_AND:
    case TOKEN_OR:
    case TOKEN_NOT:
    case TOKEN_QUESTION:
    case TOKEN_COLON:
    case TOKEN_LESS_EQUAL:
    case TOKEN_GREATER_EQUAL:
    case TOKEN_NOT_EQUAL:
        return true;
    default:
        return false;
    }
}

static void context_before(struct context *c, const struct token *tokens,
                           size_t at, const struct walk *w)
{
    const struct token *before = at > 0 ? &tokens[at - 1] : NULL;
    c->kind = CONTEXT_ITEM;
    if (!before)
        return;
    if (before->kind == TOKEN_DIRECTIVE) {
        enum keyword keyword = before->word->keyword;
        bool names = keyword == KEYWORD_DECLARE || keyword == KEYWORD_LOCAL ||
                     keyword == KEYWORD_MACRO;
        c->kind = names ? CONTEXT_NAME
                  : keyword == KEYWORD_ELSE || keyword == KEYWORD_END ||
                          keyword == KEYWORD_BREAK
                      ? CONTEXT_ITEM
                      : CONTEXT_VALUE;
    } else if (token_is_operator(before)) {
        c->kind = CONTEXT_VALUE;
        c->declaring = before->kind == TOKEN_EQUAL;
        bool entry = before->kind == TOKEN_COMMA && w->depth > 0 &&
                     w->frames[w->depth - 1].open == TOKEN_LBRACE;
        if (entry)
            c->kind = CONTEXT_ITEM;
    } else if (before->kind == TOKEN_WORD && before->word->reserved) {
        c->keyword = before->word;
    }
}

static void context_call(struct context *c, const struct walk *w)
{
    for (size_t i = w->depth; i > 0; i--) {
        const struct frame *frame = &w->frames[i - 1];
        bool call = frame->open == TOKEN_LPAREN && frame->word;
        bool block = frame->open == TOKEN_LBRACE && frame->word;
        if (call || block) {
            c->call = (struct call){ frame->word, block, frame->commas };
            return;
        }
    }
}

static void context_block(struct context *c, const struct walk *w)
{
    for (size_t i = w->depth; i > 0; i--)
        if (w->frames[i - 1].open == TOKEN_LBRACE) {
            const struct word *word = w->frames[i - 1].word;
            const char *spelling =
                word && word->keyword ? keyword_spelling(word->keyword) : NULL;
            c->block = !word ? "" : spelling ? spelling : word->text;
            return;
        }
}

struct context context_at(struct library *library, struct page *page,
                          size_t offset)
{
    const struct token_list *list = page_tokens(library, page);
    const struct token *tokens = list->tokens;
    struct context c = { .prefix = offset };
    while (c.prefix > 0 && word_letter(page->text[c.prefix - 1]))
        c.prefix--;
    size_t end = page_token_at(list, c.prefix);
    c.token = end;
    struct arena *arena = arena_new(0);
    struct walk *w = ARENA_NEW(arena, struct walk);
    const struct token *last = NULL;
    for (size_t at = 0; at < end; at++) {
        last = &tokens[at];
        if (in_string(page, last, offset)) {
            bool names = names_file(tokens, at, w, &c.file);
            c.kind = names ? CONTEXT_FILE : CONTEXT_NOTHING;
            c.prefix = last->offset + 1;
            arena_free(arena);
            return c;
        }
        walk_token(w, tokens, at);
    }
    size_t from = last ? last->offset + (size_t)last->length : 0;
    bool digit = isdigit((unsigned char)page->text[c.prefix]);
    context_block(&c, w);
    context_call(&c, w);
    c.in_macro = w->macros > 0;
    if (in_comment(page, from, c.prefix) || (digit && c.prefix < offset))
        c.kind = CONTEXT_NOTHING;
    else if (c.prefix > 0 && page->text[c.prefix - 1] == '#')
        c.kind = CONTEXT_DIRECTIVE;
    else
        context_before(&c, tokens, end, w);
    arena_free(arena);
    return c;
}
