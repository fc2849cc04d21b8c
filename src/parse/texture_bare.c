/* Textures of scenes older than version 3: what pigments, normals and finishes
 * are made of stands in them without blocks (measured):
 *
 *     texture { marble turbulence 0.5 color_map { ... } bumps 0.3 phong 1 } */
#include "parse/rules.h"
#include "scene/finish.h"
#include "scene/pattern.h"

static bool word_among(const struct word *word, const char *const *list)
{
    while (*list && strcmp(*list, word->text) != 0)
        list++;
    return *list;
}

/* Words of normals; others that normals have, such as turbulence, are meant
 * for the pigment. */
static bool bare_normal(const struct word *word)
{
    static const char *const words[] = { "bumps",     "dents",    "ripples",
                                         "waves",     "wrinkles", "bump_map",
                                         "frequency", "phase",    NULL };
    return word_among(word, words);
}

static bool bare_pigment(struct parser *p, const struct word *word)
{
    static const char *const words[] = {
        "color_map",  "colour_map", "image_map", "quick_color", "quick_colour",
        "turbulence", "octaves",    "omega",     "lambda",      NULL
    };
    return at_colour(p) || pattern_find(word->text) || word_among(word, words);
}

static bool bare_finish(const struct word *word)
{
    enum finish_place place;
    return word->keyword == KEYWORD_IOR ||
           word->keyword == KEYWORD_REFRACTION ||
           finish_item_find(word->text) || finish_field(word->text, &place);
}

bool at_bare_item(struct parser *p)
{
    if (p->version >= 3)
        return false;
    const struct token *token = stream_peek(p);
    return token->kind == TOKEN_NUMBER ||
           (token->kind == TOKEN_WORD &&
            (bare_normal(token->word) || bare_pigment(p, token->word) ||
             bare_finish(token->word)));
}

static bool parse_bare_normal(struct parser *p, const struct normal **in)
{
    struct normal *normal = normal_begin(p, *in);
    *in = normal;
    enum taken taken = parse_normal_start(p, normal);
    if (taken == NOT_MINE)
        taken = parse_normal_item(p, normal);
    return taken != WRONG && normal_count(p, normal);
}

/* Marble and wood begin again where they would go back (measured). */
static bool parse_bare_pigment(struct parser *p, const struct pigment **in)
{
    static const char *const again[] = { "marble", "wood", NULL };
    const struct word *word = stream_peek(p)->word;
    struct pigment *pigment = ARENA_NEW(p->scene_arena, struct pigment);
    *pigment = **in;
    *in = pigment;
    enum taken taken = parse_pigment_start(p, pigment);
    if (taken == NOT_MINE)
        taken = parse_pigment_item(p, pigment);
    if (taken == WRONG)
        return false;
    if (word_among(word, again))
        pigment->pattern.wave = WAVE_RAMP;
    return pigment_count(p, pigment);
}

static bool parse_bare_finish(struct parser *p, const struct finish **in)
{
    struct finish *finish = finish_begin(p, *in);
    *in = finish;
    if (!parse_finish_item(p, finish))
        return false;
    finish_limit(p, finish);
    return true;
}

static bool parse_bare_grain(struct parser *p, const struct finish **in)
{
    struct finish *finish = finish_begin(p, *in);
    *in = finish;
    return parse_float(p, &finish->crand);
}

/* bare_item = float | pigment_start | pigment_item | normal_start
 *           | normal_item | finish_item .
 * The float is grain, as crand is. */
enum taken parse_bare_item(struct parser *p, const struct texture **in)
{
    if (!at_bare_item(p))
        return NOT_MINE;
    struct layer *top;
    *in = texture_top(p, *in, &top);
    if (stream_peek(p)->kind == TOKEN_NUMBER)
        return parse_bare_grain(p, &top->finish);
    const struct word *word = stream_peek(p)->word;
    return bare_normal(word)       ? parse_bare_normal(p, &top->normal)
           : bare_pigment(p, word) ? parse_bare_pigment(p, &top->pigment)
                                   : parse_bare_finish(p, &top->finish);
}
