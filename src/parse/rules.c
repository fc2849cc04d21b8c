/* Small helps for reading the inside of blocks. */
#include "parse/rules.h"

#include "parse/error_parts.h"
#include "parse/symbol.h"

bool at_word(struct parser *p, const char *word)
{
    const struct token *token = stream_peek(p);
    return token->kind == TOKEN_WORD && strcmp(token->word->text, word) == 0;
}

bool accept_word(struct parser *p, const char *word)
{
    if (!at_word(p, word))
        return false;
    stream_next(p);
    return true;
}

const struct field *accept_field(struct parser *p, const struct field *table)
{
    const struct token *token = stream_peek(p);
    if (token->kind != TOKEN_WORD)
        return NULL;
    enum keyword keyword = token->word->keyword;
    const struct field *field = field_find(
        table, keyword ? keyword_spelling(keyword) : token->word->text);
    if (field)
        stream_next(p);
    return field;
}

bool at_any_colour(struct parser *p)
{
    return at_colour(p) || at_expression(p);
}

bool bracket_begin(struct parser *p, struct span *open)
{
    *open = stream_span(p);
    return accept(p, TOKEN_LBRACKET) ||
           error_expected_hint(p, "'['", "[0 ...]");
}

bool entry_end(struct parser *p)
{
    return stream_peek(p)->kind != TOKEN_COMMA ||
           error_at(p, p->token_span, NULL,
                    "no comma stands between the entries of a map");
}

bool skip_item(struct parser *p)
{
    double ignored;
    stream_next(p);
    return !at_expression(p) || parse_float(p, &ignored);
}

bool skip_block(struct parser *p)
{
    struct value ignored;
    while (stream_peek(p)->kind == TOKEN_WORD) {
        stream_next(p);
        accept(p, TOKEN_COMMA);
        if (at_expression(p) && !parse_expression(p, &ignored))
            return false;
    }
    return true;
}

/* The field that is meant, unless a name is, declared or of an include file. */
static const char *near_field(struct parser *p, const struct word *word,
                              const struct field *fields)
{
    struct text_nearest nearest = text_nearest_start(word->text);
    if (symbol_nearest(p, word->text) || standard_include(p, word->text))
        return NULL;
    error_try_fields(&nearest, fields);
    return nearest.best;
}

bool error_unknown_thing(struct parser *p, const char *block,
                         const struct field *names, const char *thing)
{
    size_t left;
    const struct token *token = stream_peek(p);
    const struct token *next = stream_raw(p, &left);
    if (token->kind == TOKEN_WORD && !token->word->reserved && left > 0 &&
        next->kind == TOKEN_RBRACE)
        return error_expected_hint(p, thing, near_field(p, token->word, names));
    return error_unknown_item(p, block, names);
}

bool at_body_end(struct parser *p)
{
    enum token_kind kind = stream_peek(p)->kind;
    return kind == TOKEN_RBRACE || kind == TOKEN_RBRACKET;
}
