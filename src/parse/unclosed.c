/* Braces that are missing. Of a '}', which '{' it belongs to is told from what
 * can't stand inside it and from how the lines are indented, and reading goes
 * on behind it. */
#include "parse/expression.h"
#include "parse/rules.h"

/* Coverings stand beside each other, not in each other. */
static bool keyword_is_covering(enum keyword keyword)
{
    return keyword == KEYWORD_PIGMENT || keyword == KEYWORD_NORMAL ||
           keyword == KEYWORD_FINISH || keyword == KEYWORD_TEXTURE ||
           keyword == KEYWORD_INTERIOR || keyword == KEYWORD_MATERIAL;
}

/* Where the line of a span begins, and its first character that shows. */
static size_t line_start(struct span span)
{
    size_t at = span.offset;
    const char *text = span.source->text;
    while (at > 0 && text[at - 1] != '\n' && text[at - 1] != '\r')
        at--;
    return at;
}

static size_t line_first(struct span span)
{
    size_t start = line_start(span);
    return start + strspn(span.source->text + start, " \t");
}

/* Whether `at` begins a line that is indented no deeper than the line of the
 * '{' above it: it can't have been meant to be inside. */
static bool unclosed_by_indent(struct span open, struct span at)
{
    return line_first(at) == at.offset &&
           at.offset - line_start(at) <= line_first(open) - line_start(open);
}

/* Whether that is the word before the '{'. */
static bool opens_as(struct span open, const char *name)
{
    const char *text = open.source->text;
    size_t end = open.offset, length = strlen(name);
    while (end > 0 && strchr(" \t\r\n", text[end - 1]))
        end--;
    return end >= length && memcmp(text + end - length, name, length) == 0;
}

/* Whether the '{' is that of a covering beside which this one stands. Textures
 * hold those that they are made of. */
static bool opens_beside(struct span open, enum keyword covering)
{
    static const char *const names[] = { "pigment", "normal", "finish",
                                         "interior" };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (opens_as(open, names[i]))
            return true;
    return (covering == KEYWORD_TEXTURE || covering == KEYWORD_INTERIOR ||
            covering == KEYWORD_MATERIAL) &&
           opens_as(open, "texture");
}

const char *unclosed_hint(struct parser *p)
{
    enum keyword keyword = stream_keyword(p);
    if (p->block_count == 0)
        return NULL;
    struct span at = p->token_span, open = p->blocks[p->block_count - 1];
    bool beside = keyword_is_covering(keyword) && opens_beside(open, keyword);
    bool below = at.source == open.source && at.offset > open.offset;
    return beside && below ? "}" : NULL;
}

/* The thing that stands where its block should: `texture T`, `pigment rgb 1`,
 * `sphere ( ... )`. */
bool error_unopened(struct parser *p, struct span before)
{
    const struct token *token = stream_peek(p);
    struct span at = p->token_span;
    bool alone = token->kind == TOKEN_STRING ||
                 (token->kind == TOKEN_WORD && !token->word->reserved);
    bool round = token->kind == TOKEN_LPAREN;
    const char *hint = alone
                           ? arena_printf(p->arena, "{ %.*s }", (int)at.length,
                                          at.source->text + at.offset)
                           : "{";
    bool told = p->told;
    const char *wanted = "'{'";
    if (before.source && before.length < 40)
        wanted = arena_printf(p->arena, "'{' after '%.*s'", (int)before.length,
                              before.source->text + before.offset);
    error_expected_hint(p, wanted, hint);
    /* Directives stand between. */
    if (before.source == at.source && p->last_span.offset != before.offset)
        note_at(p, before, "this has no '{'");
    p->told = true;
    if (round)
        skip_brackets(p);
    else if (alone)
        stream_next(p);
    p->told = told;
    return false;
}

void note_unclosed(struct parser *p)
{
    bool beside = unclosed_hint(p);
    if (p->block_count == 0 || (!beside && !at_scene_item(p)))
        return;
    struct span at = p->token_span, open = p->blocks[p->block_count - 1];
    const char *text = open.source->text;
    bool here = at.source == open.source && at.offset > open.offset;
    bool apart = !here || memchr(text + open.offset, '\n',
                                 at.offset - open.offset) != NULL;
    if (apart || beside)
        note_at(p, open, "the '}' to this '{' may be missing");
    p->unclosed = beside || (here && apart && unclosed_by_indent(open, at));
}
