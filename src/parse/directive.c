/* Running directives, and the blocks they open: see directive.h. */
#include "parse/directive.h"

#include "base/text.h"

#define X(keyword, name) extern const struct directive name##_directive;
#include "parse/directive/list.h"
#undef X

static const struct directive *const directives[KEYWORDS_TOTAL] = {
#define X(keyword, name) [KEYWORD_##keyword] = &name##_directive,
#include "parse/directive/list.h"
#undef X
};

static bool directive_unknown(struct parser *p, const struct word *word,
                              struct span at)
{
    struct text_nearest nearest = text_nearest_start(word->text);
    for (int i = 1; i < KEYWORDS_TOTAL; i++)
        if (directives[i])
            text_nearest_try(&nearest, keyword_spelling(i));
    const char *hint =
        nearest.best ? arena_printf(p->arena, "#%s", nearest.best) : NULL;
    return error_at(p, at, hint, "there is no directive '#%s'", word->text);
}

bool directive_run(struct parser *p)
{
    struct cursor *cursor = p->cursor;
    struct span at = token_span(cursor->list, cursor->index);
    const struct word *word = cursor->list->tokens[cursor->index++].word;
    const struct directive *directive = directives[word->keyword];
    if (!directive)
        return directive_unknown(p, word, at);
    p->last_span = at;
    /* A directive in a block in a #declare in a block ... */
    if (p->nesting >= PARSE_NESTING_LIMIT) {
        error_at(p, at, NULL, "blocks are nested more than %d deep",
                 PARSE_NESTING_LIMIT);
        stream_abort(p);
        return false;
    }
    p->nesting++;
    bool ok = directive->run(p, at);
    p->nesting--;
    return ok;
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
    bool ok = parse_condition(p, out);
    return directive_condition_end(p, outer) && ok;
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
