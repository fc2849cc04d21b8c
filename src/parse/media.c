/* Media: matter that emits, swallows or scatters light, and its densities. */
#include "parse/expression.h"
#include "parse/rules.h"
#include "parse/tables.h"
#include "scene/medium.h"

enum { MEDIUM_SAMPLES_LIMIT = 10000 };

static const struct field medium_names[] = {
    { .name = "absorption" }, { .name = "emission" },
    { .name = "scattering" }, { .name = "density" },
    { .name = "method" },     { .name = "intervals" },
    { .name = "samples" },    { .name = "ratio" },
    { .name = "confidence" }, { .name = "variance" },
    { .name = "aa_level" },   { .name = "aa_threshold" },
    { .name = "jitter" },     { .name = NULL },
};

/* ---- densities ---- */

/* What `rule` reads begins with a white pigment. */
static bool density_rule(struct parser *p, const struct pigment *white,
                         bool (*rule)(struct parser *p, void *out), void *out)
{
    const struct pigment *outside = p->defaults.pigment;
    bool within = p->density;
    p->defaults.pigment = white;
    p->density = true;
    bool ok = rule(p, out);
    p->density = within;
    p->defaults.pigment = outside;
    return ok;
}

static const struct pigment *density_default(struct parser *p)
{
    struct pigment *white = ARENA_NEW(p->scene_arena, struct pigment);
    *white = pigment_default(p->scene_arena);
    white->colour = colour_opaque(rgb_grey(1));
    return white;
}

static bool density_pigment(struct parser *p, void *out)
{
    return parse_pigment(p, out);
}

static bool density_pigments(struct parser *p, void *out)
{
    return parse_density_entries(p, false, out);
}

/* density = "density" "{" pigment_body "}" .
 * A pigment that starts white, with DENSITY for PIGMENT and density_map for
 * pigment_map. */
bool parse_density(struct parser *p, const struct pigment **out)
{
    struct span span = stream_span(p);
    return density_rule(p, density_default(p), density_pigment, out) &&
           uv_refuse(p, span, &(*out)->pattern);
}

/* density_map = "density_map" "{" ( DENSITY_MAP
 *             | pigment_map_entry {pigment_map_entry} ) "}" . */
bool parse_density_map(struct parser *p, const struct blend_map **out)
{
    return density_rule(p, density_default(p), density_pigments, out);
}

static bool medium_density_add(struct parser *p, struct medium *medium)
{
    size_t count = medium->density_count;
    const struct pigment **densities =
        ARENA_ARRAY(p->scene_arena, const struct pigment *, count + 1);
    if (count >= MEDIA_MAX)
        return error_at(p, stream_span(p), NULL,
                        "a media has at most %d densities", MEDIA_MAX);
    if (count)
        memcpy(densities, medium->densities, count * sizeof *densities);
    medium->densities = densities;
    medium->density_count = count + 1;
    return parse_density(p, &densities[count]);
}

/* ---- media ---- */

static bool scattering_body(struct parser *p, struct medium *medium)
{
    int type;
    struct span span = stream_span(p);
    colour amount;
    const struct token *token = stream_peek(p);
    if (!at_expression(p) ||
        (token->kind == TOKEN_WORD && colour_begins(token->word->keyword)))
        return error_expected_hint(p, "the kind of scattering, from 1 to 5",
                                   "1, rgb 1");
    if (!parse_integer(p, &type))
        return false;
    if (type < PHASE_ISOTROPIC || type > PHASE_HENYEY_GREENSTEIN) {
        warning_at(p, span, "1",
                   "there are scattering types 1 to 5; %d counts as 1", type);
        type = PHASE_ISOTROPIC;
    }
    medium->phase = (enum phase)type;
    accept(p, TOKEN_COMMA);
    if (stream_peek(p)->kind == TOKEN_RBRACE)
        return error_expected_hint(p, "how much is scattered, a colour",
                                   "scattering { 1, rgb 1 }");
    if (!parse_colour(p, &amount))
        return false;
    medium->scattering = colour_rgb(amount);
    while (stream_peek(p)->kind != TOKEN_RBRACE) {
        const struct field *field = accept_field(p, scattering_fields);
        if (!field)
            return error_unknown_item(p, "scattering", scattering_fields);
        if (type != PHASE_HENYEY_GREENSTEIN &&
            strcmp(field->name, "eccentricity") == 0)
            return error_at(p, p->last_span, NULL,
                            "only scattering of type %d has an eccentricity, "
                            "this is of type %d",
                            PHASE_HENYEY_GREENSTEIN, type);
        if (!parse_field(p, field, medium))
            return false;
    }
    return true;
}

/* scattering = "scattering" "{" float [","] colour
 *              {"eccentricity" float | "extinction" float} "}" . */
static bool parse_scattering(struct parser *p, struct medium *medium)
{
    struct span open;
    stream_next(p);
    if (stream_peek(p)->kind != TOKEN_LBRACE)
        return error_expected_hint(p, "the kind and the colour in braces",
                                   "{ 1, rgb 1 }");
    return block_begin(p, &open) &&
           block_end(p, open, scattering_body(p, medium));
}

/* medium_samples = "samples" float [[","] float] .
 * At least, and with methods 1 and 2 at most. */
static bool parse_medium_samples(struct parser *p, struct medium *medium)
{
    stream_next(p);
    struct span span = stream_span(p);
    if (!parse_integer(p, &medium->samples))
        return false;
    accept(p, TOKEN_COMMA);
    medium->samples_most = medium->samples;
    if (at_number(p) && !parse_integer(p, &medium->samples_most))
        return false;
    span = span_join(span, p->last_span);
    if (medium->samples < 1 || medium->samples_most > MEDIUM_SAMPLES_LIMIT)
        return error_at(p, span, NULL,
                        "a media takes 1 to %d samples in an interval",
                        MEDIUM_SAMPLES_LIMIT);
    return medium->samples_most >= medium->samples ||
           error_at(p, span, NULL,
                    "the second number is how many samples there are at most: "
                    "less than the first");
}

static void medium_move(struct parser *p, struct medium *medium,
                        const affine *step)
{
    *medium = *medium_moved(p->scene_arena, medium, step);
}

/* medium_value = "absorption" colour | "emission" colour | "method" float
 *              | "intervals" float | "ratio" float | "confidence" float
 *              | "variance" float | "aa_level" float | "aa_threshold" float
 *              | "jitter" float .
 * medium_item = medium_value | scattering | density | medium_samples
 *             | transformation . */
static bool parse_medium_item(struct parser *p, struct medium *medium)
{
    affine step = affine_identity();
    enum taken taken;
    const struct field *field = accept_field(p, medium_fields);
    if (field)
        return parse_field(p, field, medium);
    switch (stream_keyword(p)) {
    case KEYWORD_SCATTERING:
        return parse_scattering(p, medium);
    case KEYWORD_DENSITY:
        return medium_density_add(p, medium);
    case KEYWORD_SAMPLES:
        return parse_medium_samples(p, medium);
    default:
        taken = parse_transformation(p, &step);
        if (taken == TAKEN)
            medium_move(p, medium, &step);
        return taken != NOT_MINE
                   ? taken
                   : error_unknown_thing(p, "media", medium_names, "a media");
    }
}

static bool medium_items(struct parser *p, struct medium *medium)
{
    const struct value *value = accept_value(p, VALUE_MEDIA);
    *medium = value ? *value->medium : medium_default();
    while (stream_peek(p)->kind != TOKEN_RBRACE)
        if (!parse_medium_item(p, medium))
            return false;
    return true;
}

/* media = "media" "{" [MEDIA] {medium_item} "}" . */
bool parse_medium(struct parser *p, const struct medium **out)
{
    struct medium *medium = ARENA_NEW(p->scene_arena, struct medium);
    struct span open;
    *out = medium;
    stream_next(p);
    return block_begin(p, &open) && block_end(p, open, medium_items(p, medium));
}

bool parse_media(struct parser *p, struct media *media)
{
    const struct medium *medium;
    struct span span = stream_span(p);
    if (!parse_medium(p, &medium))
        return false;
    if (media->count >= MEDIA_MAX)
        return error_at(p, span, NULL, "at most %d media fill one place",
                        MEDIA_MAX);
    *media = media_with(p->scene_arena, *media, medium);
    p->scene->misty = true;
    p->scene->murky |= !rgb_is_black(medium_extinction(medium));
    return true;
}
