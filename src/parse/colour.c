/* Colours: `rgb <1, 0.5, 0>`, `color red 1 filter 0.5`, `Red * 0.5`. */
#include <ctype.h>

#include "parse/array.h"
#include "parse/expression.h"
#include "parse/mistaken.h"
#include "parse/stream.h"
#include "parse/symbol.h"

struct colour_model {
    enum keyword keyword;
    int components; /* a float stands for so many */
    bool transmit;  /* the fourth is transmit, not filter */
    bool encoded;   /* red, green, blue as on a screen, not as light */
};

static const struct colour_model colour_models[] = {
    { KEYWORD_RGB, 3, false, false }, { KEYWORD_RGBF, 4, false, false },
    { KEYWORD_RGBT, 4, true, false }, { KEYWORD_RGBFT, 5, false, false },
    { KEYWORD_SRGB, 3, false, true }, { KEYWORD_SRGBF, 4, false, true },
    { KEYWORD_SRGBT, 4, true, true }, { KEYWORD_SRGBFT, 5, false, true },
};

static const struct colour_model *colour_model(enum keyword keyword)
{
    for (size_t i = 0; i < sizeof colour_models / sizeof *colour_models; i++)
        if (colour_models[i].keyword == keyword)
            return &colour_models[i];
    return NULL;
}

/* -1: none. `alpha` is filter's name before version 3. */
static int channel_index(enum keyword keyword)
{
    switch (keyword) {
    case KEYWORD_RED:
        return 0;
    case KEYWORD_GREEN:
        return 1;
    case KEYWORD_BLUE:
        return 2;
    case KEYWORD_FILTER:
    case KEYWORD_ALPHA:
        return 3;
    case KEYWORD_TRANSMIT:
        return 4;
    default:
        return -1;
    }
}

bool colour_begins(enum keyword keyword)
{
    return keyword == KEYWORD_COLOUR || colour_model(keyword) ||
           channel_index(keyword) >= 0;
}

/* sRGB to light (IEC 61966-2-1), continued below 0 and above 1. */
static double colour_decode(double v)
{
    return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
}

/* To the numbers the scene calculates with, which assumed_gamma defines. */
static bool colour_decode_srgb(struct parser *p, struct span keyword,
                               double numbers[5])
{
    const struct settings *settings = &p->scene->settings;
    if (settings->gamma_kind == GAMMA_SRGB)
        return true;
    if (settings->gamma_kind == GAMMA_NONE)
        return error_at(p, keyword, "global_settings { assumed_gamma 1 }",
                        "colours in sRGB need to know the scene's "
                        "assumed_gamma, which must be set before them");
    for (int i = 0; i < 3; i++) {
        numbers[i] = colour_decode(numbers[i]);
        if (settings->assumed_gamma != 1)
            numbers[i] = copysign(
                pow(fabs(numbers[i]), 1 / settings->assumed_gamma), numbers[i]);
    }
    return true;
}

/* The value after `rgb`; one with more components than the keyword says keeps
 * them, as in POV-Ray.
 * model = "rgb" | "rgbf" | "rgbt" | "rgbft"
 *       | "srgb" | "srgbf" | "srgbt" | "srgbft" . */
static bool parse_model(struct parser *p, struct value *value)
{
    const struct colour_model *model = colour_model(stream_keyword(p));
    struct span keyword = stream_span(p);
    stream_next(p);
    if (!parse_operation(p, PRECEDENCE_SUM, "a number or a vector", value))
        return false;
    if (!value_size(value))
        return true;
    if (value->kind == VALUE_FLOAT)
        value_promote(value, model->components);
    value_promote(value, 5);
    if (model->transmit) {
        value->number[4] = value->number[3];
        value->number[3] = 0;
    }
    return !model->encoded || colour_decode_srgb(p, keyword, value->number);
}

/* `color red`: the channel's number is missing, or the colour is meant. */
static bool channel_missing(struct parser *p)
{
    struct span span = p->last_span;
    const char *text = span.source->text + span.offset;
    const char *word = arena_printf(p->arena, "%.*s", (int)span.length, text);
    const char *capital = mistaken_capital(p, word);
    if (symbol_find(p, word_intern(p->words, capital, strlen(capital))))
        return error_at(p, span, capital,
                        "'%s' wants a number after it; the colour has a "
                        "capital letter",
                        word);
    return error_at(p, span, arena_printf(p->arena, "%s 1", word),
                    "'%s' wants a number after it; the colours of colors.inc "
                    "have capital letters",
                    word);
}

/* channels = {( "red" | "green" | "blue" | "filter" | "transmit" | "alpha" )
 *             float} . */
bool parse_channels(struct parser *p, struct value *value)
{
    for (;;) {
        const struct token *token = stream_peek_infix(p);
        int index = token->kind == TOKEN_WORD
                        ? channel_index(token->word->keyword)
                        : -1;
        if (index < 0)
            return true;
        if (token->word->keyword == KEYWORD_ALPHA)
            warning_at(p, p->token_span, "filter",
                       "'alpha' is the old name of 'filter'");
        stream_next(p);
        if (stream_peek(p)->kind == TOKEN_RBRACE ||
            stream_peek(p)->kind == TOKEN_RBRACKET)
            return channel_missing(p);
        if (!parse_float(p, &value->number[index]))
            return false;
    }
}

/* `color "red"`: colours are declared names, in colors.inc with a capital.
 * `color "#ff0000"` is written in numbers. */
static const char *colour_quoted(struct parser *p, const struct value *value)
{
    enum { LONGEST = 40 };
    const char *text = value->kind == VALUE_STRING ? value->text : "";
    if (*text == '#')
        return mistaken_shade(p, text + 1);
    return isalpha((unsigned char)*text) && strlen(text) <= LONGEST &&
                   !text[strcspn(text, " ./")]
               ? mistaken_capital(p, text)
               : NULL;
}

/* The value of what is no channel, `rgb 1` or `Red * 0.5`. */
static bool parse_colour_value(struct parser *p, struct value *value)
{
    struct span start = stream_span(p);
    bool ok = colour_model(stream_keyword(p))
                  ? parse_model(p, value)
                  : parse_operation(p, PRECEDENCE_SUM, "a colour", value);
    if (!ok || value_is_poison(value))
        return false;
    return value_size(value) ||
           error_at(p, span_join(start, p->last_span), colour_quoted(p, value),
                    "expected a colour, found %s", value_describe(value));
}

/* After its value come its channels. */
static bool colour_end(struct parser *p, struct value *value, colour *out)
{
    value_promote(value, 5);
    if (!parse_channels(p, value))
        return false;
    const double *n = value->number;
    *out = (colour){ n[0], n[1], n[2], n[3], n[4] };
    return true;
}

/* colour = ["color" | "colour"] [[model] operation] channels . */
bool parse_colour(struct parser *p, colour *out)
{
    accept_keyword(p, KEYWORD_COLOUR);
    struct value value = { .kind = VALUE_COLOUR };
    if (channel_index(stream_keyword(p)) < 0 && !parse_colour_value(p, &value))
        return false;
    return colour_end(p, &value, out);
}

bool parse_colour_or_number(struct parser *p, colour *out, double *number,
                            bool *is_number)
{
    struct value value;
    *is_number = false;
    if (at_colour(p))
        return parse_colour(p, out);
    if (!parse_colour_value(p, &value))
        return false;
    *is_number = value.kind == VALUE_FLOAT;
    *number = value.number[0];
    return *is_number || colour_end(p, &value, out);
}

bool at_colour(struct parser *p)
{
    const struct token *token = stream_peek(p);
    if (token->kind != TOKEN_WORD)
        return false;
    if (token->word->reserved)
        return colour_begins(token->word->keyword);
    const struct value *value = symbol_find(p, token->word);
    if (value && value->kind == VALUE_ARRAY)
        value = array_sample(value->array);
    return value && (value->kind == VALUE_COLOUR ||
                     (value->kind == VALUE_VECTOR && value->size > 3));
}
