/* How a surface takes light. Numbers and names are POV-Ray's; the kd, ks and
 * Emiss of the light-mesh paper are diffuse, reflection and emission. */
#include "parse/rules.h"
#include "parse/tables.h"

#define FINISH(name, kind, member, low, high, help)                            \
    {                                                                          \
        name, kind, offsetof(struct finish, member), low, high, help           \
    }
#define REFLECTION(name, kind, member, low, high, help)                        \
    {                                                                          \
        name, kind, offsetof(struct reflection, member), low, high, help       \
    }

/* finish_value = "ambient" colour | "emission" colour | "brilliance" float
 *              | "phong_size" float | "roughness" float | "crand" float
 *              | "conserve_energy" . */
const struct field finish_fields[] = {
    FINISH("ambient", FIELD_RGB, ambient, 0, 0,
           "times ambient_light: light from everywhere, 0.1"),
    FINISH("emission", FIELD_RGB, emission, 0, 0,
           "light of its own (Emiss), 0"),
    FINISH("brilliance", FIELD_FLOAT, brilliance, 0, 0,
           "exponent of the cosine of diffuse light, 1"),
    FINISH("phong_size", FIELD_FLOAT, phong_size, 0, 0,
           "exponent of phong, 40"),
    FINISH("roughness", FIELD_FLOAT, roughness, 0, 0,
           "1 / exponent of specular, 0.05"),
    FINISH("crand", FIELD_FLOAT, crand, 0, 0, "grain, 0"),
    FINISH("conserve_energy", FIELD_FLAG, conserve_energy, 0, 0,
           "what is reflected is not transmitted"),
    { NULL },
};

/* The items with a form of their own are here for "did you mean". */
static const struct field finish_names[] = {
    { .name = "ambient" },    { .name = "emission" },
    { .name = "brilliance" }, { .name = "phong_size" },
    { .name = "roughness" },  { .name = "crand" },
    { .name = "diffuse" },    { .name = "phong" },
    { .name = "specular" },   { .name = "metallic" },
    { .name = "reflection" }, { .name = "conserve_energy" },
    { .name = "irid" },       { .name = "subsurface" },
    { .name = NULL },
};

const struct field reflection_fields[] = {
    REFLECTION("falloff", FIELD_FLOAT, falloff, 0, 0,
               "exponent of the change from minimum to maximum, 1"),
    REFLECTION("exponent", FIELD_FLOAT, exponent, 0, 0,
               "reflected light is raised to 1/exponent, 1"),
    REFLECTION("fresnel", FIELD_BOOL, fresnel, 0, 0,
               "the change follows the interior's ior"),
    { NULL },
};

/* reflection_item = "falloff" float | "exponent" float
 *                 | "fresnel" [bool] | "metallic" [float] . */
static bool parse_reflection_item(struct parser *p, struct reflection *r)
{
    const struct field *field = accept_field(p, reflection_fields);
    if (field)
        return parse_field(p, field, r);
    if (!accept_keyword(p, KEYWORD_METALLIC))
        return error_unknown_item(p, "reflection", reflection_fields);
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

/* A lone colour is for every angle; with fresnel it is the maximum. */
static bool reflection_colours(struct parser *p, struct reflection *r,
                               bool *lone)
{
    r->minimum = r->maximum = rgb_grey(0);
    *lone = at_any_colour(p);
    if (!*lone)
        return true;
    if (!reflection_rgb(p, &r->maximum))
        return false;
    r->minimum = r->maximum;
    accept(p, TOKEN_COMMA);
    if (!at_any_colour(p))
        return true;
    *lone = false;
    return reflection_rgb(p, &r->maximum);
}

/* reflection_range = [colour [[","] colour]] {reflection_item} .
 * At normal and at grazing incidence. */
static bool parse_reflection_range(struct parser *p, struct finish *finish)
{
    struct reflection *r = &finish->reflection;
    bool lone;
    if (!reflection_colours(p, r, &lone))
        return false;
    while (stream_peek(p)->kind != TOKEN_RBRACE)
        if (!parse_reflection_item(p, r))
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
static const struct field film_fields[] = {
    FINISH("thickness", FIELD_FLOAT, film.thickness, 0, 0,
           "of the film, in the unit of irid_wavelength, 0"),
    FINISH("turbulence", FIELD_FLOAT, film.turbulence, 0, 0,
           "how much the thickness varies, 0"),
    { NULL },
};

static bool film_items(struct parser *p, struct finish *finish)
{
    if (!parse_float(p, &finish->film.amount))
        return false;
    while (stream_peek(p)->kind != TOKEN_RBRACE) {
        const struct field *field = accept_field(p, film_fields);
        if (!field)
            return error_unknown_item(p, "irid", film_fields);
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

static const struct field translucency_fields[] = {
    FINISH("translucency", FIELD_RGB, translucency, 0, HUGE_VAL,
           "how far light goes within, mm"),
    { NULL },
};

static bool translucency_items(struct parser *p, struct finish *finish)
{
    while (stream_peek(p)->kind != TOKEN_RBRACE) {
        const struct field *field = accept_field(p, translucency_fields);
        if (!field)
            return error_unknown_item(p, "subsurface", translucency_fields);
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

/* finish_item = finish_value | diffuse | phong | specular | metallic
 *             | reflection | "reflection_exponent" float | film
 *             | translucency | old_refraction . */
static bool parse_finish_item(struct parser *p, struct finish *finish)
{
    const struct field *field = accept_field(p, finish_fields);
    if (field)
        return parse_field(p, field, finish);
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
        return error_unknown_thing(p, "finish", finish_names, "a finish");
    }
}

/* Amounts below 0 count as 0; a roughness of 0 is a highlight everywhere. */
static void finish_limit(struct parser *p, struct finish *finish)
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

static bool finish_items(struct parser *p, const struct finish **in)
{
    const struct value *value = accept_value(p, VALUE_FINISH);
    if (value)
        *in = value->finish;
    if (value && stream_peek(p)->kind == TOKEN_RBRACE)
        return true;
    struct finish *finish = ARENA_NEW(p->scene_arena, struct finish);
    *finish = **in;
    *in = finish;
    *ARRAY_PUSH(p->arena, &p->finishes) = finish;
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
