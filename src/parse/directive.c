/* Running directives, and the blocks they open: see directive.h. */
#include "parse/directive.h"

#include "base/text.h"
#include "parse/mistaken.h"

#define X(keyword, name) extern const struct directive name##_directive;
#include "parse/directive/list.h"
#undef X

static const struct directive *const directives[KEYWORDS_TOTAL] = {
#define X(keyword, name) [KEYWORD_##keyword] = &name##_directive,
#include "parse/directive/list.h"
#undef X
};

bool directive_is(enum keyword keyword)
{
    return directives[keyword] != NULL;
}

const char *directive_help(enum keyword keyword)
{
    return directives[keyword] ? directives[keyword]->help : NULL;
}

/* A directive in a block in a #declare in a block ... */
static bool directive_start(struct parser *p, enum keyword keyword,
                            struct span at)
{
    p->last_span = at;
    if (p->nesting >= PARSE_NESTING_LIMIT) {
        error_at(p, at, NULL, "blocks are nested more than %d deep",
                 PARSE_NESTING_LIMIT);
        stream_abort(p);
        return false;
    }
    p->nesting++;
    bool ok = directives[keyword]->run(p, at);
    p->nesting--;
    return ok;
}

bool directive_run_as(struct parser *p, enum keyword keyword, struct span at)
{
    bool outer = p->told;
    p->told = true;
    directive_start(p, keyword, at);
    p->told = outer;
    return false;
}

/* Whether it is a declaration but for its directive. */
static bool directive_declares(const struct cursor *cursor)
{
    const struct token *tokens = cursor->list->tokens + cursor->index;
    return cursor->index + 1 < cursor->end && tokens[0].kind == TOKEN_WORD &&
           (tokens[1].kind == TOKEN_EQUAL || tokens[1].kind == TOKEN_LBRACKET);
}

static bool directive_unknown(struct parser *p, const struct word *word,
                              struct span at)
{
    char behind = at.source->text[at.offset + 1];
    if (behind == ' ' || behind == '\t') {
        error_at(p, at, "//",
                 "there is no directive '#%s'; a comment begins "
                 "with '//'",
                 word->text);
        mistaken_skip_line(p, at);
        return false;
    }
    enum keyword meant = mistaken_directive_word(word);
    const char *shade =
        strcmp(word->text, "def") == 0 ? NULL : mistaken_shade(p, word->text);
    const char *hint =
        shade   ? shade
        : meant ? arena_printf(p->arena, "#%s", keyword_spelling(meant))
                : NULL;
    bool returns = strcmp(word->text, "return") == 0;
    bool begins = text_among(word->text, mistaken_fillers);
    if (begins)
        hint = NULL;
    error_at(p, at, hint, "there is no directive '#%s'%s", word->text,
             shade     ? "; a colour is written in numbers"
             : begins  ? "; only an '#end' ends what belongs to another"
             : returns ? "; what a macro gives just stands in it, without a ';'"
                       : "");
    if (returns) {
        mistaken_skip_line(p, at);
        return false;
    }
    if (meant == KEYWORD_DECLARE && !directive_declares(p->cursor))
        mistaken_define(p, at);
    else if (meant && !shade)
        directive_run_as(p, meant, at);
    return false;
}

bool directive_run(struct parser *p)
{
    struct cursor *cursor = p->cursor;
    struct span at = token_span(cursor->list, cursor->index);
    const struct word *word = cursor->list->tokens[cursor->index++].word;
    if (!directive_is(word->keyword))
        return directive_unknown(p, word, at);
    return directive_start(p, word->keyword, at);
}

struct open_block *directive_block(struct parser *p)
{
    struct cursor *cursor = p->cursor;
    size_t closed = cursor == p->head ? p->head_blocks : 0;
    return cursor->blocks.count > closed
               ? &cursor->blocks.items[cursor->blocks.count - 1]
               : NULL;
}

struct open_block *directive_open(struct parser *p, enum block_kind kind,
                                  struct span at)
{
    struct open_block *block = ARRAY_PUSH(p->arena, &p->cursor->blocks);
    *block = (struct open_block){ .kind = kind, .span = at };
    return block;
}

void directive_close(struct parser *p)
{
    p->cursor->blocks.count--;
}

struct directive_head directive_head_begin(struct parser *p)
{
    struct directive_head outer = { stream_directive_begin(p), p->head,
                                    p->head_blocks };
    p->head = p->cursor;
    p->head_blocks = p->cursor->blocks.count;
    return outer;
}

/* Blocks opened in the condition and not closed in it are forgotten. */
void directive_head_end(struct parser *p, struct directive_head outer)
{
    if (p->cursor == p->head)
        p->cursor->blocks.count = p->head_blocks;
    stream_directive_end(p, outer.directive);
    p->head = outer.head;
    p->head_blocks = outer.blocks;
}

bool directive_condition_end(struct parser *p, struct directive_head outer)
{
    struct span inner = p->cursor->called_at;
    bool here = stream_pop_to(p, p->head);
    if (!here)
        error_at(p, inner, NULL,
                 "the condition of a directive must end where it begins, not "
                 "in what is included or called here");
    directive_head_end(p, outer);
    return here;
}

bool directive_float(struct parser *p, double *out)
{
    struct directive_head outer = directive_head_begin(p);
    bool ok = parse_condition(p, out), told = p->told;
    p->told |= !ok;
    ok &= directive_condition_end(p, outer);
    p->told = told;
    return ok;
}

bool directive_string(struct parser *p, const char **out)
{
    struct directive_head outer = directive_head_begin(p);
    bool ok = parse_string(p, out);
    directive_head_end(p, outer);
    return ok;
}

bool directive_skip_to_end(struct parser *p)
{
    static const enum keyword stops[] = { KEYWORD_END, KEYWORD_NONE };
    bool found = stream_skip_block(p, stops, directive_block(p)->span);
    if (found)
        p->cursor->index++;
    directive_close(p);
    return found;
}

const char *directive_bracketed_name(struct parser *p)
{
    size_t left;
    bool bracket = stream_peek(p)->kind == TOKEN_LPAREN;
    const struct token *inside = stream_raw(p, &left);
    return bracket && left > 0 && inside->kind == TOKEN_WORD
               ? inside->word->text
               : NULL;
}
