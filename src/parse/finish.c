/* How a surface takes light. Numbers and names are POV-Ray's; the kd, ks and
 * Emiss of the light-mesh paper are diffuse, reflection and emission. */
#include "parse/rules.h"
#include "parse/tables.h"

/* reflection_item = "falloff" float | "exponent" float
 *                 | "fresnel" [bool] | "metallic" [float] . */
static bool parse_reflection_item(struct parser *p, struct finish *finish)
{
    const struct field *inner = finish_item_find("reflection")->inner;
    const struct field *field = accept_field(p, inner);
    struct reflection *r = &finish->reflection;
    if (field)
        return parse_field(p, field, finish);
    if (!accept_keyword(p, KEYWORD_METALLIC))
        return error_unknown_item(p, "reflection", inner);
    r->metallic = 1;
    return !at_expression(p) || parse_float(p, &r->metallic);
}

static bool reflection_rgb(struct parser *p, rgb *out)
{
    colour value;
    if (!parse_colour(p, &value))
        return false;
    *out = colour_rgb(value);
    return true;
}

/* reflection_range = [colour [[","] colour]] {reflection_item} .
 * At normal and at grazing incidence. A lone colour is for every angle; with
 * fresnel it is the maximum. */
static bool parse_reflection_range(struct parser *p, struct finish *finish)
{
    struct reflection *r = &finish->reflection;
    bool lone = at_any_colour(p);
    r->maximum = rgb_grey(0);
    if (lone && !reflection_rgb(p, &r->maximum))
        return false;
    r->minimum = r->maximum;
    if (lone)
        accept(p, TOKEN_COMMA);
    if (lone && at_any_colour(p)) {
        lone = false;
        if (!reflection_rgb(p, &r->maximum))
            return false;
    }
    while (stream_peek(p)->kind != TOKEN_RBRACE)
        if (!parse_reflection_item(p, finish))
            return false;
    if (lone && r->fresnel)
        r->minimum = rgb_grey(0);
    return true;
}

/* reflection = "reflection" ( colour | "{" reflection_range "}" ) . */
static bool parse_reflection(struct parser *p, struct finish *finish)
{
    struct span open;
    stream_next(p);
    if (stream_peek(p)->kind == TOKEN_LBRACE)
        return block_begin(p, &open) &&
               block_end(p, open, parse_reflection_range(p, finish));
    enum keyword keyword = stream_keyword(p);
    if (keyword == KEYWORD_METALLIC || keyword == KEYWORD_FRESNEL)
        return error_expected_hint(
            p, "a colour",
            arena_printf(p->arena, "{ 1 %s }", stream_peek(p)->word->text));
    if (!reflection_rgb(p, &finish->reflection.maximum))
        return false;
    finish->reflection.minimum = finish->reflection.maximum;
    return true;
}

/* diffuse = "diffuse" ["albedo"] float [[","] float] .
 * The second is for light that falls on the other side. */
static bool parse_diffuse(struct parser *p, struct finish *finish)
{
    stream_next(p);
    finish->diffuse_albedo = accept_keyword(p, KEYWORD_ALBEDO);
    finish->diffuse_back = 0;
    if (!parse_float(p, &finish->diffuse))
        return false;
    accept(p, TOKEN_COMMA);
    return !at_expression(p) || parse_float(p, &finish->diffuse_back);
}

/* phong = "phong" ["albedo"] float . */
static bool parse_phong(struct parser *p, struct finish *finish)
{
    stream_next(p);
    finish->phong_albedo = accept_keyword(p, KEYWORD_ALBEDO);
    return parse_float(p, &finish->phong);
}

/* specular = "specular" ["albedo"] float . */
static bool parse_specular(struct parser *p, struct finish *finish)
{
    stream_next(p);
    finish->specular_albedo = accept_keyword(p, KEYWORD_ALBEDO);
    return parse_float(p, &finish->specular);
}

/* metallic = "metallic" [float] . */
static bool parse_metallic(struct parser *p, struct finish *finish)
{
    stream_next(p);
    finish->metallic = 1;
    return !at_expression(p) || parse_float(p, &finish->metallic);
}

/* film_value = "thickness" float | "turbulence" float . */
static bool film_items(struct parser *p, struct finish *finish)
{
    const struct field *inner = finish_item_find("irid")->inner;
    if (!parse_float(p, &finish->film.amount))
        return false;
    while (stream_peek(p)->kind != TOKEN_RBRACE) {
        const struct field *field = accept_field(p, inner);
        if (!field)
            return error_unknown_item(p, "irid", inner);
        if (!parse_field(p, field, finish))
            return false;
    }
    return true;
}

/* film = "irid" "{" float {film_value} "}" . */
static bool parse_film(struct parser *p, struct finish *finish)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) && block_end(p, open, film_items(p, finish));
}

static bool translucency_items(struct parser *p, struct finish *finish)
{
    const struct field *inner = finish_item_find("subsurface")->inner;
    while (stream_peek(p)->kind != TOKEN_RBRACE) {
        const struct field *field = accept_field(p, inner);
        if (!field)
            return error_unknown_item(p, "subsurface", inner);
        if (!parse_field(p, field, finish))
            return false;
    }
    return true;
}

/* translucency = "subsurface" "{" {"translucency" colour} "}" . */
static bool parse_translucency(struct parser *p, struct finish *finish)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) &&
           block_end(p, open, translucency_items(p, finish));
}

/* old_refraction = "ior" float | "refraction" float | "caustics" float .
 * Scenes older than version 3.1: the interior's business today. */
static bool parse_old_refraction(struct parser *p, struct finish *finish)
{
    struct token word = stream_next(p);
    struct span span = p->last_span;
    double value;
    if (!parse_float(p, &value))
        return false;
    if (word.word->keyword == KEYWORD_REFRACTION)
        return true;
    bool caustics = word.word->keyword == KEYWORD_CAUSTICS;
    warning_at(p, span,
               caustics ? "interior { caustics ... }" : "interior { ior ... }",
               "'%s' belongs into the object's interior", word.word->text);
    *(caustics ? &finish->caustics : &finish->ior) = value;
    return true;
}

/* The words of all items, for "did you mean". */
static const struct field *finish_words(struct parser *p)
{
    const struct finish_item *item;
    struct {
        struct field *items;
        size_t count, capacity;
    } words = { NULL, 0, 0 };
    for (size_t i = 0; (item = finish_item_at(i)) != NULL; i++) {
        *ARRAY_PUSH(p->arena, &words) = (struct field){ .name = item->name };
        for (const struct field *f = item->fields; f && f->name; f++)
            *ARRAY_PUSH(p->arena, &words) = *f;
    }
    *ARRAY_PUSH(p->arena, &words) = (struct field){ .name = NULL };
    return words.items;
}

/* What the item keeps, to be written: of its own it has a copy for each
 * finish. */
static void *finish_said(struct parser *p, struct finish *finish,
                         enum finish_place place)
{
    const struct finish_item *item = finish_item_at(place);
    const void *from = finish->own[place] ? finish->own[place] : item->usual;
    if (!item->size)
        return finish;
    void *own = arena_alloc(p->scene_arena, item->size);
    if (from)
        memcpy(own, from, item->size);
    else
        memset(own, 0, item->size);
    finish->own[place] = own;
    return own;
}

/* finish_value = "ambient" colour | "emission" colour | "brilliance" float
 *              | "phong_size" float | "roughness" float | "crand" float
 *              | "conserve_energy" .
 * All words of the items in scene/finish/ that have no form of their own. */
static bool parse_finish_value(struct parser *p, struct finish *finish)
{
    const struct token *token = stream_peek(p);
    enum finish_place place;
    const struct field *field = token->kind == TOKEN_WORD
                                    ? finish_field(token->word->text, &place)
                                    : NULL;
    if (!field)
        return error_unknown_thing(p, "finish", finish_words(p), "a finish");
    stream_next(p);
    return parse_field(p, field, finish_said(p, finish, place));
}

/* finish_item = finish_value | diffuse | phong | specular | metallic
 *             | reflection | "reflection_exponent" float | film
 *             | translucency | old_refraction . */
bool parse_finish_item(struct parser *p, struct finish *finish)
{
    switch (stream_keyword(p)) {
    case KEYWORD_DIFFUSE:
        return parse_diffuse(p, finish);
    case KEYWORD_PHONG:
        return parse_phong(p, finish);
    case KEYWORD_SPECULAR:
        return parse_specular(p, finish);
    case KEYWORD_METALLIC:
        return parse_metallic(p, finish);
    case KEYWORD_REFLECTION:
        return parse_reflection(p, finish);
    case KEYWORD_IRID:
        return parse_film(p, finish);
    case KEYWORD_SUBSURFACE:
        return parse_translucency(p, finish);
    case KEYWORD_REFLECTION_EXPONENT:
        stream_next(p);
        return parse_float(p, &finish->reflection.exponent);
    case KEYWORD_IOR:
    case KEYWORD_REFRACTION:
    case KEYWORD_CAUSTICS:
        return parse_old_refraction(p, finish);
    default:
        return parse_finish_value(p, finish);
    }
}

/* Amounts below 0 count as 0; a roughness of 0 is a highlight everywhere. */
void finish_limit(struct parser *p, struct finish *finish)
{
    finish->diffuse = fmax(finish->diffuse, 0);
    finish->diffuse_back = fmax(finish->diffuse_back, 0);
    finish->phong = fmax(finish->phong, 0);
    finish->specular = fmax(finish->specular, 0);
    if (finish->roughness == 0) {
        warning_at(p, p->last_span, NULL,
                   "with roughness 0 the highlight covers everything");
        finish->roughness = HUGE_VAL;
    }
}

struct finish *finish_begin(struct parser *p, const struct finish *from)
{
    struct finish *finish = ARENA_NEW(p->scene_arena, struct finish);
    *finish = *from;
    *ARRAY_PUSH(p->arena, &p->finishes) = finish;
    return finish;
}

static bool finish_items(struct parser *p, const struct finish **in)
{
    const struct value *value = accept_value(p, VALUE_FINISH);
    if (value)
        *in = value->finish;
    if (value && stream_peek(p)->kind == TOKEN_RBRACE)
        return true;
    struct finish *finish = finish_begin(p, *in);
    *in = finish;
    while (stream_peek(p)->kind != TOKEN_RBRACE)
        if (!parse_finish_item(p, finish))
            return false;
    finish_limit(p, finish);
    return true;
}

/* finish = "finish" "{" [FINISH] {finish_item} "}" . */
bool parse_finish_block(struct parser *p, const struct finish **in)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) && block_end(p, open, finish_items(p, in));
}

bool parse_finish(struct parser *p, const struct finish **out)
{
    *out = p->defaults.finish;
    return parse_finish_block(p, out);
}
