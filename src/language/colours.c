/* Colours that are written as numbers, as the editor's swatches. The editor
 * thinks in sRGB; rgb and its kin are linear light. */
#include "language/server.h"

#include <math.h>

#include "base/text.h"

static double srgb_of_linear(double c)
{
    c = fmin(fmax(c, 0), 1);
    return c <= 0.0031308 ? 12.92 * c : 1.055 * pow(c, 1 / 2.4) - 0.055;
}

static double linear_of_srgb(double c)
{
    return c <= 0.04045 ? c / 12.92 : pow((c + 0.055) / 1.055, 2.4);
}

/* A colour as it is written. */
struct swatch {
    bool srgb;
    double numbers[5];
    int count;
    size_t first, last; /* tokens */
};

/* A number at *at with its sign; false: something else. */
static bool swatch_number(const struct token *tokens, size_t *at, double *out)
{
    bool minus = tokens[*at].kind == TOKEN_MINUS;
    if (tokens[*at + minus].kind != TOKEN_NUMBER)
        return false;
    *out = (minus ? -1 : 1) * tokens[*at + minus].number;
    *at += 1 + minus;
    return true;
}

static bool swatch_model(const struct token *token, struct swatch *swatch)
{
    if (token->kind != TOKEN_WORD || !token->word->reserved)
        return false;
    const char *word = token->word->text;
    swatch->srgb = *word == 's';
    return strcmp(word + swatch->srgb, "rgb") == 0 ||
           strcmp(word + swatch->srgb, "rgbf") == 0 ||
           strcmp(word + swatch->srgb, "rgbt") == 0 ||
           strcmp(word + swatch->srgb, "rgbft") == 0;
}

/* What begins with token `at`, of numbers alone. */
static bool swatch_read(const struct token_list *list, size_t at,
                        struct swatch *swatch)
{
    const struct token *tokens = list->tokens;
    *swatch = (struct swatch){ .first = at };
    if (!swatch_model(&tokens[at++], swatch))
        return false;
    if (tokens[at].kind != TOKEN_LESS) {
        swatch->count = swatch_number(tokens, &at, &swatch->numbers[0]);
        swatch->numbers[1] = swatch->numbers[2] = swatch->numbers[0];
        swatch->last = at - 1;
        bool product =
            tokens[at].kind == TOKEN_STAR || tokens[at].kind == TOKEN_SLASH;
        return swatch->count == 1 && !product;
    }
    for (at++; swatch->count < 5; swatch->count++) {
        if (!swatch_number(tokens, &at, &swatch->numbers[swatch->count]))
            return false;
        if (tokens[at].kind == TOKEN_GREATER)
            break;
        if (tokens[at++].kind != TOKEN_COMMA)
            return false;
    }
    swatch->last = at;
    return ++swatch->count >= 3 && swatch->count <= 5 &&
           tokens[at].kind == TOKEN_GREATER;
}

json_t *colours_answer(struct request *request)
{
    struct page *page = request->page;
    const struct token_list *list =
        page_tokens(&request->server->library, page);
    json_t *colours = json_array();
    for (size_t at = 0; at + 1 < list->count; at++) {
        struct swatch s;
        double rgb[3];
        if (!swatch_read(list, at, &s))
            continue;
        for (int i = 0; i < 3; i++)
            rgb[i] = s.srgb ? fmin(fmax(s.numbers[i], 0), 1)
                            : srgb_of_linear(s.numbers[i]);
        double through = s.numbers[3] + s.numbers[4];
        const struct token *last = &list->tokens[s.last];
        struct stretch range = page_range(page, list->tokens[s.first].offset,
                                          last->offset + (size_t)last->length);
        json_array_append_new(
            colours,
            json_pack("{s:o,s:{s:f,s:f,s:f,s:f}}", "range", json_range(range),
                      "color", "red", rgb[0], "green", rgb[1], "blue", rgb[2],
                      "alpha", 1 - fmin(fmax(through, 0), 1)));
    }
    return colours;
}

/* "rgbt <1, 0.5, 0, 0.2>" */
static const char *colour_text(struct arena *arena, bool srgb,
                               const char *letter, const double rgb[3],
                               double through)
{
    const char *text =
        arena_printf(arena, "%srgb%s <", srgb ? "s" : "", letter);
    for (int i = 0; i < 3; i++) {
        double c = srgb ? rgb[i] : linear_of_srgb(rgb[i]);
        text = arena_printf(arena, "%s%s%s", text, i ? ", " : "",
                            NUMBER_TEXT(round(c * 10000) / 10000));
    }
    bool clear = strcmp(letter, "ft") == 0;
    if (*letter)
        text = arena_printf(arena, "%s%s, %s", text, clear ? ", 0" : "",
                            NUMBER_TEXT(round(through * 10000) / 10000));
    return arena_printf(arena, "%s>", text);
}

json_t *presentation_answer(struct request *request)
{
    struct arena *arena = request->arena;
    const json_t *colour = json_object_get(request->params, "color");
    const json_t *at = json_object_get(request->params, "range");
    struct page *page = request->page;
    size_t start = page_offset(page, json_to_range(at).start);
    static const char *const names[] = { "red", "green", "blue" };
    double rgb[3], through;
    for (int i = 0; i < 3; i++)
        rgb[i] = fmin(
            fmax(json_number_value(json_object_get(colour, names[i])), 0), 1);
    const json_t *alpha = json_object_get(colour, "alpha");
    through = alpha ? fmin(fmax(1 - json_number_value(alpha), 0), 1) : 0;
    const char *written = page->text + start;
    bool srgb = strncmp(written, "srgb", 4) == 0;
    const char *letters = written + (srgb ? 4 : 3);
    bool model = strncmp(written + srgb, "rgb", 3) == 0;
    const char *letter = model && strncmp(letters, "ft", 2) == 0 ? "ft"
                         : model && *letters == 'f'              ? "f"
                         : model && *letters == 't'              ? "t"
                         : through > 0                           ? "t"
                                                                 : "";
    return json_pack("[{s:s},{s:s}]", "label",
                     colour_text(arena, srgb, letter, rgb, through), "label",
                     colour_text(arena, !srgb, letter, rgb, through));
}
