/* Numbers as other languages write them, and what is written to them: see
 * mistaken.h. */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/text.h"
#include "parse/expression.h"
#include "parse/mistaken.h"
#include "parse/stream.h"
#include "parse/symbol.h"

#define HEXADECIMAL "0123456789abcdefABCDEF"

static const char *span_text(struct span span)
{
    return span.source->text + span.offset;
}

/* Whether the token taken last is a number, and the next one touches it. */
static bool number_touched(const struct parser *p)
{
    struct span number = p->last_span, next = p->token_span;
    return number.source && number.source == next.source && number.length > 0 &&
           number.offset + number.length == next.offset &&
           (isdigit((unsigned char)*span_text(number)) ||
            *span_text(number) == '.') &&
           strchr("0123456789.", span_text(next)[-1]);
}

/* The word before the number, if it begins a colour of numbers as they are:
 * what is suggested takes its place. */
static struct span number_colour(struct parser *p, struct span span)
{
    const char *text = span.source->text;
    size_t end = span.offset, start;
    while (end > 0 && text[end - 1] == ' ')
        end--;
    for (start = end; start > 0 && isalnum((unsigned char)text[start - 1]);)
        start--;
    if (text_among(arena_copy_text(p->arena, text + start, end - start),
                   "rgb srgb")) {
        span.length += span.offset - (uint32_t)start;
        span.offset = (uint32_t)start;
    }
    return span;
}

const char *mistaken_shade(struct parser *p, const char *digits)
{
    unsigned red, green, blue, scale = 1;
    size_t length = strspn(digits, HEXADECIMAL);
    if (digits[length] || (length != 6 && length != 3))
        return NULL;
    if (length == 6) {
        sscanf(digits, "%2x%2x%2x", &red, &green, &blue);
    } else {
        sscanf(digits, "%1x%1x%1x", &red, &green, &blue);
        scale = 17;
    }
    return arena_printf(p->arena, "srgb <%u, %u, %u>/255", red * scale,
                        green * scale, blue * scale);
}

/* 0xff0000: of six digits it is a colour. */
static bool number_hexadecimal(struct parser *p, const char *word)
{
    struct span number = p->last_span, span = span_join(number, p->token_span);
    size_t digits = strspn(word + 1, HEXADECIMAL);
    if (number.length != 1 || *span_text(number) != '0' ||
        (*word != 'x' && *word != 'X') || digits == 0 || word[1 + digits])
        return false;
    const char *hint = NULL, *more = "";
    if (digits == 6) {
        span = number_colour(p, span);
        hint = mistaken_shade(p, word + 1);
        more = "; a colour is written in three numbers";
    } else if (digits <= 8) {
        hint = arena_printf(p->arena, "%lu", strtoul(word + 1, NULL, 16));
    }
    error_at(p, span, hint, "a number has decimal digits%s", more);
    return true;
}

/* 1_000_000 */
static bool number_grouped(struct parser *p, const char *word)
{
    struct span number = p->last_span, span = span_join(number, p->token_span);
    if (*word != '_' || word[strspn(word, "_0123456789")])
        return false;
    char *plain = arena_copy_text(p->arena, span_text(span), span.length);
    char *to = plain;
    for (const char *from = plain; *from; from++)
        if (*from != '_')
            *to++ = *from;
    *to = '\0';
    error_at(p, span, plain, "the digits of a number stand together");
    return true;
}

/* 1.0f, 5px */
static bool number_suffixed(struct parser *p, const char *word)
{
    static const char suffixes[] =
        "f d l ul lf h px pt em mm cm m km in ft deg "
        "rad s ms kb i j i32 f32 f64 d0";
    struct span number = p->last_span;
    if (!text_among(word, suffixes))
        return false;
    error_at(p, span_join(number, p->token_span),
             arena_copy_text(p->arena, span_text(number), number.length),
             "a number has no letters behind it");
    return true;
}

/* 2x, 3(a + b) */
static bool number_multiplied(struct parser *p, const char *word)
{
    const struct token *token = stream_peek_infix(p);
    const struct value *value =
        token->kind == TOKEN_WORD ? symbol_find(p, token->word) : NULL;
    struct span number = p->last_span;
    bool factor =
        token->kind == TOKEN_LPAREN ||
        (value && value->kind >= VALUE_FLOAT && value->kind <= VALUE_COLOUR) ||
        (token->kind == TOKEN_WORD && constant_is(p, token->word->keyword));
    if (!factor)
        return false;
    error_at(p, span_join(number, p->token_span),
             arena_printf(p->arena, "%.*s*%s", (int)number.length,
                          span_text(number), word),
             "a product wants a '*'");
    return true;
}

bool mistaken_number(struct parser *p)
{
    const struct token *token = stream_peek_infix(p);
    bool bracket = token->kind == TOKEN_LPAREN;
    if ((token->kind != TOKEN_WORD && !bracket) || !number_touched(p))
        return false;
    const char *word = bracket ? "(" : token->word->text;
    if (!number_hexadecimal(p, word) && !number_grouped(p, word) &&
        !number_multiplied(p, word) && !number_suffixed(p, word))
        return false;
    if (bracket)
        skip_brackets(p);
    else
        stream_next(p);
    p->blamed = p->last_span;
    return true;
}

/* `1,5`: the comma touches digits on both sides, and no third number follows.
 */
static const char *comma_decimal(struct parser *p, struct span *span)
{
    const char *text = span_text(*span), *comma = span_text(p->token_span);
    size_t digits = strspn(comma + 1, "0123456789");
    if (comma != text + span->length || digits == 0 ||
        text[strspn(text, "0123456789")] != ',' ||
        !strchr(" ;\r\n", comma[1 + digits]))
        return NULL;
    span->length += 1 + (uint32_t)digits;
    char *number = arena_copy_text(p->arena, text, span->length);
    *strchr(number, ',') = '.';
    return number;
}

/* From the '=' before the number, which must be the first, up to the ';'. */
static const char *comma_vector(struct parser *p, struct span *span)
{
    size_t before = span->offset;
    while (before > 0 && strchr(" -", span->source->text[before - 1]))
        before--;
    size_t sign = before + strspn(span->source->text + before, " ");
    size_t length = strcspn(span->source->text + sign, ";<(){}\r\n");
    if (before == 0 || span->source->text[before - 1] != '=' ||
        span->source->text[sign + length] != ';' || length > 60)
        return NULL;
    span->offset = (uint32_t)sign;
    span->length = (uint32_t)length;
    return arena_printf(p->arena, "<%.*s>", (int)length, span_text(*span));
}

bool mistaken_comma(struct parser *p, struct span last)
{
    if (stream_peek_infix(p)->kind != TOKEN_COMMA ||
        last.source != p->token_span.source ||
        last.offset > p->token_span.offset)
        return false;
    const char *hint = comma_decimal(p, &last);
    if (hint) {
        error_at(p, last, hint, "the decimal point of a number is a '.'");
        return true;
    }
    hint = comma_vector(p, &last);
    if (hint)
        error_at(p, last, hint, "a vector is written <1, 2, 3>");
    return hint != NULL;
}
