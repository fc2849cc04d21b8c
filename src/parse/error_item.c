/* Errors about what stands where an item of a block, or of the scene, should:
 * unknown words, and values without a word before them. */
#include <ctype.h>
#include <stdio.h>

#include "base/text.h"
#include "parse/directive.h"
#include "parse/error_parts.h"
#include "parse/expression.h"
#include "parse/function.h"
#include "parse/mistaken.h"
#include "parse/stream.h"
#include "parse/symbol.h"
#include "scene/pattern.h"

/* Functions and `#end` are no items of a block. */
static void error_try_word(void *context, const struct word *word)
{
    if (!function_is(word->keyword) && word->keyword != KEYWORD_END)
        text_nearest_try(context, word->text);
}

static bool error_file_ends(struct parser *p, const char *block)
{
    error_at(p, p->token_span, NULL,
             "the file ends inside '%s'; a '}' is missing", block);
    if (p->block_count > 0)
        note_at(p, p->blocks[p->block_count - 1], "to match this '{'");
    return false;
}

/* Blocks are named by their keyword, in quotes; the scene is none. */
static const char *error_block(struct parser *p, const char *block)
{
    return p->block_count ? arena_printf(p->arena, "'%s'", block) : block;
}

/* `spotlight { point_at 0 }`: what it is about stands beside it. */
static const char *error_no_block(struct parser *p)
{
    int length;
    const char *text = error_last_word(p, &length);
    return text && length <= ERROR_WORD_MAX
               ? arena_printf(p->arena, "; '%.*s' has no braces", length, text)
               : "; there is no item before it";
}

/* Words whose value is a vector or a colour. */
static bool error_takes_vector(const struct word *word)
{
    static const char *const words[] = {
        "translate", "rotate",      "scale",      "location",  "look_at",
        "right",     "up",          "sky",        "direction", "point_at",
        "gradient",  "focal_point", "turbulence",
    };
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(word->text, words[i]) == 0)
            return true;
    return colour_begins(word->keyword);
}

static bool error_is_bare(const struct token *token)
{
    return token->kind == TOKEN_NUMBER || token->kind == TOKEN_MINUS ||
           token->kind == TOKEN_COMMA;
}

/* `translate 1, 2, 3` in angular brackets, `rotate y 90` as a product; NULL:
 * neither is meant. */
static const char *error_bare_vector(struct parser *p)
{
    const struct cursor *cursor = p->cursor;
    const struct token *tokens = cursor->list->tokens;
    size_t at = cursor->index, first, count = 0;
    if (at < 3 || cursor->list->source != p->token_span.source ||
        tokens[--at].offset != p->token_span.offset)
        return NULL;
    const struct token *axis = &tokens[at - 1];
    if (tokens[at].kind == TOKEN_NUMBER && axis->kind == TOKEN_WORD &&
        constant_is(p, axis->word->keyword) && axis->word->length == 1)
        return arena_printf(p->arena, "%g*%s", tokens[at].number,
                            axis->word->text);
    for (first = at; first > 0 && error_is_bare(&tokens[first - 1]);)
        first--;
    const struct token *before = &tokens[first > 0 ? first - 1 : 0];
    if (before->kind != TOKEN_WORD)
        return NULL;
    const char *numbers = "", *minus = "";
    for (size_t i = first; error_is_bare(&tokens[i]); i++) {
        if (tokens[i].kind == TOKEN_MINUS)
            minus = "-";
        if (tokens[i].kind != TOKEN_NUMBER)
            continue;
        numbers = arena_printf(p->arena, "%s%s%s%g", numbers,
                               count++ ? ", " : "", minus, tokens[i].number);
        minus = "";
        if (count > 5)
            return NULL;
    }
    if (count < 2)
        return NULL;
    if (before->word->keyword == KEYWORD_REFLECTION && count == 2)
        return arena_printf(p->arena, "reflection { %s }", numbers);
    if (before->word->keyword == KEYWORD_COLOUR)
        return arena_printf(p->arena, "rgb <%s>", numbers);
    return error_takes_vector(before->word)
               ? arena_printf(p->arena, "%s <%s>", before->word->text, numbers)
               : NULL;
}

static bool error_block_is_csg(const char *block)
{
    return strcmp(block, "difference") == 0 || strcmp(block, "union") == 0 ||
           strcmp(block, "intersection") == 0 || strcmp(block, "merge") == 0;
}

/* What stands where no value belongs. */
static bool error_no_item(struct parser *p, const char *block)
{
    enum token_kind kind = p->token.kind;
    bool comma = kind == TOKEN_COMMA;
    size_t left;
    const struct token *next = stream_raw(p, &left);
    if (comma && left > 0)
        kind = next->kind;
    bool values = kind == TOKEN_NUMBER || kind == TOKEN_MINUS ||
                  kind == TOKEN_LPAREN || kind == TOKEN_LESS;
    if (kind == TOKEN_LESS && !comma && strcmp(block, "pigment") == 0)
        return error_at(p, p->token_span, "rgb <1, 0.5, 0>",
                        "a colour begins with 'rgb', also in 'pigment'");
    if (kind == TOKEN_LESS && !comma && strcmp(block, "mesh") == 0)
        return error_at(p, p->token_span, "triangle { <1, 0, 0>, ... }",
                        "a mesh consists of triangles, of three corners each");
    bool side = error_block_is_csg(block) &&
                (kind == TOKEN_MINUS || kind == TOKEN_PLUS);
    const char *why =
        side     ? "; objects stand side by side, nothing between "
                   "them"
        : values ? "; a vector is written <1, 2, 3>, a product 2*x"
        : comma  ? "; no comma stands between items"
        : kind == TOKEN_SEMICOLON
            ? "; a ';' only ends #declare, #local and #version"
        : kind == TOKEN_EQUAL  ? "; no '=' stands between a word and its value"
        : kind == TOKEN_LBRACE ? error_no_block(p)
        : kind == TOKEN_STRING ? "; a declared name stands without quotes"
                               : "";
    const char *hint = comma && values ? primitive_hint(p, block) : NULL;
    if (values && !comma && strcmp(block, "camera") == 0)
        hint = kind == TOKEN_LESS ? "location <0, 1, -5>" : NULL;
    if (kind == TOKEN_NUMBER && !comma && strcmp(block, "interior") == 0)
        hint = "ior 1.5";
    if (values && !hint && !side)
        hint = error_bare_vector(p);
    return error_at(p, p->token_span, hint, "unexpected %s in %s%s",
                    error_found(p), error_block(p, block), why);
}

/* `x y`: a sum of axes, as far as it is written. */
static bool error_axes(struct parser *p)
{
    struct span last = p->last_span, word = p->token_span;
    const char *text = last.source ? last.source->text + last.offset : "";
    if (last.source != word.source || last.length != 1 || word.length != 1 ||
        !strchr("xyz", *text) || !strchr("xyz", *p->token.word->text))
        return false;
    error_at(p, span_join(last, word),
             arena_printf(p->arena, "%c + %s", *text, p->token.word->text),
             "an operator stands between two vectors");
    return true;
}

/* A number right before x, y or z: 20y is meant as a product. */
static bool error_product(struct parser *p)
{
    struct span number = p->last_span, word = p->token_span;
    if (!constant_is(p, p->token.word->keyword) ||
        number.source != word.source || number.offset >= word.offset)
        return false;
    if (error_axes(p))
        return true;
    size_t end = number.offset + number.length;
    size_t blanks = strspn(word.source->text + end, " ");
    if (end + blanks != word.offset ||
        !strchr("0123456789.", word.source->text[end - 1]))
        return false;
    const char *text = number.source->text + number.offset;
    error_at(p, span_join(number, word),
             arena_printf(p->arena, "%.*s*%s", (int)number.length, text,
                          p->token.word->text),
             "a product wants a '*'");
    return true;
}

/* `Ball translate x`: a declared object that is moved or coloured beside, not
 * in a block. */
static const char *error_bare_object(struct parser *p, const struct word *word)
{
    int length;
    const char *text =
        p->block_count == 0 ? error_last_value(p, VALUE_OBJECT, &length) : NULL;
    return text && length <= ERROR_WORD_MAX
               ? arena_printf(p->arena, "object { %.*s %s ... }", length, text,
                              word->text)
               : NULL;
}

void error_try_fields(struct text_nearest *nearest, const struct field *fields)
{
    for (; fields && fields->name; fields++)
        text_nearest_try(nearest, fields->name);
}

/* What the word was meant to be. */
static const char *error_meant(struct parser *p, const struct word *word,
                               const char *block, const struct field *fields)
{
    const char *symbol = symbol_nearest(p, word->text), *known = NULL;
    if (symbol && text_equal_nocase(symbol, word->text))
        return symbol;
    size_t left;
    const struct word *small = mistaken_case(p, word->text, word->length);
    if (small != word && small->reserved &&
        stream_raw(p, &left)->kind == TOKEN_LBRACE)
        return small->text;
    if (!word->reserved)
        known = standard_include(p, word->text);
    if (!word->reserved && !known)
        known = mistaken_word(word, block);
    if (known)
        return known;
    struct text_nearest nearest = text_nearest_start(word->text);
    error_try_fields(&nearest, fields);
    if (symbol && !word->reserved)
        text_nearest_try(&nearest, symbol);
    if (!word->reserved)
        word_table_visit(p->words, error_try_word, &nearest);
    return nearest.best;
}

/* A pattern that does not come first. */
static bool error_pattern(struct parser *p, const struct word *word,
                          const char *block)
{
    bool takes = strcmp(block, "pigment") == 0 ||
                 strcmp(block, "normal") == 0 || strcmp(block, "texture") == 0;
    if (!takes || !word->reserved || !pattern_find(word->text))
        return false;
    error_at(p, p->token_span, NULL,
             "'%s' stands too late: one pattern, and nothing before it, begins "
             "'%s'",
             word->text, block);
    return true;
}

/* `spotlight on`: on, off ... after a word that takes no value. */
static bool error_flag(struct parser *p, const struct word *word)
{
    struct span last = p->last_span;
    bool value = word->keyword == KEYWORD_ON || word->keyword == KEYWORD_OFF ||
                 word->keyword == KEYWORD_YES || word->keyword == KEYWORD_NO ||
                 word->keyword == KEYWORD_TRUE ||
                 word->keyword == KEYWORD_FALSE;
    if (!value || !last.source || last.length > ERROR_WORD_MAX ||
        !isalpha((unsigned char)last.source->text[last.offset]))
        return false;
    error_at(p, p->token_span, NULL, "'%.*s' takes no value, found '%s'",
             (int)last.length, last.source->text + last.offset, word->text);
    return true;
}

void note_outside(struct parser *p, const struct word *word)
{
    static const char *const words[] = {
        "translate", "rotate",  "scale",     "matrix",     "transform",
        "pigment",   "texture", "normal",    "finish",     "interior",
        "material",  "hollow",  "no_shadow", "clipped_by", "photons",
    };
    struct span last = p->last_span;
    if (p->block_count > 0 || !last.source ||
        last.source->text[last.offset] != '}')
        return;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(word->text, words[i]) == 0) {
            note_at(p, last,
                    "what belongs to the object stands before this '}'");
            return;
        }
}

bool error_unknown_item(struct parser *p, const char *block,
                        const struct field *fields)
{
    const struct token *token = stream_peek(p);
    if (token->kind == TOKEN_END)
        return error_file_ends(p, block);
    if (error_follows(p) || at_poison(p) || mistaken_statement(p) ||
        error_is_silent(p))
        return false;
    if (token->kind != TOKEN_WORD)
        return error_no_item(p, block);
    const struct word *word = token->word;
    if (error_product(p) || mistaken_number(p) ||
        error_later_word(p, word, block))
        return false;
    const char *belongs = unclosed_hint(p);
    if (!belongs)
        belongs = error_bare_object(p, word);
    if (!belongs && word->reserved)
        belongs = mistaken_word(word, block);
    if (!belongs)
        belongs = item_belongs(p, word, block);
    const char *kind = error_kind(p);
    if (error_pattern(p, word, block) || error_flag(p, word) ||
        (!word->reserved && !kind && error_below(p, word)))
        return false;
    if (kind)
        error_at(p, p->token_span, belongs, "'%s', %s, is not allowed in %s",
                 word->text, kind, error_block(p, block));
    else
        error_at(p, p->token_span,
                 belongs ? belongs : error_meant(p, word, block, fields),
                 word->reserved ? "'%s' is not allowed in %s"
                                : "unknown item '%s' in %s",
                 word->text, error_block(p, block));
    note_long_string(p);
    note_unclosed(p);
    note_outside(p, word);
    return false;
}
