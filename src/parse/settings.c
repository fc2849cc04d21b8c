/* global_settings, #default, and the working space of colours. */
#include "parse/rules.h"
#include "parse/tables.h"

#define SETTING(name, kind, member, low, high, help)                           \
    {                                                                          \
        name, kind, offsetof(struct settings, member), low, high, help         \
    }

/* setting_value = "ambient_light" colour | "irid_wavelength" colour
 *               | "max_trace_level" float | "adc_bailout" float
 *               | "mm_per_unit" float . */
const struct field setting_fields[] = {
    SETTING("ambient_light", FIELD_RGB, ambient_light, 0, 0,
            "multiplies every ambient, white"),
    SETTING("irid_wavelength", FIELD_RGB, irid_wavelength, 0, 0,
            "of red, green and blue light, <0.70, 0.52, 0.48>"),
    SETTING("max_trace_level", FIELD_INTEGER, max_trace_level, 0, 0,
            "surfaces a ray may meet one after the other, 5"),
    SETTING("adc_bailout", FIELD_FLOAT, adc_bailout, 0, 0,
            "rays that count for less are not followed, 1/255"),
    SETTING("mm_per_unit", FIELD_FLOAT, subsurface.mm_per_unit, 1e-9, 1e9,
            "how long a unit is, for subsurface, 10"),
    { NULL },
};

static const struct field setting_names[] = {
    { .name = "assumed_gamma" },   { .name = "ambient_light" },
    { .name = "max_trace_level" }, { .name = "adc_bailout" },
    { .name = "irid_wavelength" }, { .name = "photons" },
    { .name = "noise_generator" }, { .name = "number_of_waves" },
    { .name = "radiosity" },       { .name = "light_mesh" },
    { .name = "skeleton" },        { .name = "subsurface" },
    { .name = "mm_per_unit" },     { .name = NULL },
};

/* assumed_gamma = "assumed_gamma" ( "srgb" | float ) .
 * Only the first counts. */
static bool parse_assumed_gamma(struct parser *p)
{
    struct settings *settings = &p->scene->settings;
    enum gamma_kind kind = GAMMA_SRGB;
    double gamma = 1;
    stream_next(p);
    struct span span = stream_span(p);
    if (!accept_keyword(p, KEYWORD_SRGB)) {
        kind = GAMMA_POWER;
        if (!parse_float(p, &gamma))
            return false;
        if (!(gamma > 0))
            return error_at(p, span, "1.0", "assumed_gamma must be above 0");
    }
    if (settings->gamma_kind != GAMMA_NONE) {
        if (kind != settings->gamma_kind || gamma != settings->assumed_gamma)
            warning_at(p, span, NULL,
                       "assumed_gamma was said before; this one is ignored");
        return true;
    }
    settings->gamma_kind = kind;
    settings->assumed_gamma = gamma;
    return true;
}

void settings_follow_version(struct parser *p)
{
    if (!p->noise_said)
        p->scene->noise.generator =
            p->version < 3.5 ? NOISE_CLIPPED : NOISE_SCALED;
}

/* noise_setting = noise_generator | "number_of_waves" float . */
static bool parse_noise_setting(struct parser *p)
{
    struct noise_settings *noise = &p->scene->noise;
    if (stream_keyword(p) == KEYWORD_NOISE_GENERATOR) {
        int generator;
        p->noise_said = true;
        if (!parse_noise_generator(p, &generator))
            return false;
        noise->generator = (enum noise_generator)generator;
        return true;
    }
    stream_next(p);
    struct span span = stream_span(p);
    if (!parse_integer(p, &noise->waves))
        return false;
    if (noise->waves > NOISE_WAVES_LIMIT)
        return error_at(p, span, "10", "glim's limit is %d waves",
                        NOISE_WAVES_LIMIT);
    noise->waves = noise->waves < 1 ? 1 : noise->waves;
    return true;
}

static bool parse_subsurface_samples(struct parser *p, int *samples)
{
    enum { SUBSURFACE_SAMPLES_LIMIT = 100000 };
    struct span span = stream_span(p);
    if (!parse_integer(p, samples))
        return false;
    return (*samples >= 0 && *samples <= SUBSURFACE_SAMPLES_LIMIT) ||
           error_at(p, span_join(span, p->last_span), "50",
                    "there are 0 to %d samples", SUBSURFACE_SAMPLES_LIMIT);
}

/* subsurface_value = "samples" float [","] float | "radiosity" [bool] .
 * The light of surfaces goes in where it is known, whatever `radiosity` says.
 */
static bool parse_subsurface_value(struct parser *p)
{
    static const struct field names[] = { { .name = "samples" },
                                          { .name = "radiosity" },
                                          { .name = NULL } };
    int *samples = p->scene->settings.subsurface.samples;
    bool flag;
    if (accept_keyword(p, KEYWORD_RADIOSITY))
        return !at_expression(p) || parse_bool(p, &flag);
    if (!accept_word(p, "samples"))
        return error_unknown_item(p, "subsurface", names);
    if (!parse_subsurface_samples(p, &samples[0]))
        return false;
    accept(p, TOKEN_COMMA);
    return parse_subsurface_samples(p, &samples[1]);
}

/* subsurface = "subsurface" "{" {subsurface_value} "}" . */
static bool parse_subsurface(struct parser *p)
{
    p->scene->settings.subsurface.on = true;
    return block_items(p, parse_subsurface_value);
}

/* setting_without_effect = "charset" name | "max_intersections" float
 *                        | "hf_gray_16" [bool] . */
static enum taken parse_setting_without_effect(struct parser *p)
{
    bool flag;
    switch (stream_keyword(p)) {
    case KEYWORD_CHARSET:
        stream_next(p);
        if (stream_peek(p)->kind != TOKEN_WORD)
            return error_expected(p, "'ascii', 'utf8' or 'sys'");
        p->letters_told = at_word(p, "utf8");
        stream_next(p);
        return TAKEN;
    case KEYWORD_MAX_INTERSECTIONS:
        return skip_item(p);
    case KEYWORD_HF_GRAY_16:
        stream_next(p);
        return parse_bool(p, &flag);
    default:
        return NOT_MINE;
    }
}

static bool setting_field(struct parser *p, const struct field *field)
{
    struct settings *settings = &p->scene->settings;
    struct span span = stream_span(p);
    if (!parse_field(p, field, settings))
        return false;
    if (settings->max_trace_level > SETTINGS_LEVELS_MAX) {
        warning_at(p, span, NULL, "max_trace_level is at most %d",
                   SETTINGS_LEVELS_MAX);
        settings->max_trace_level = SETTINGS_LEVELS_MAX;
    }
    if (settings->max_trace_level < 1)
        settings->max_trace_level = 1;
    return true;
}

/* light_setting = light_mesh | skeleton | radiosity | photons | subsurface . */
static enum taken parse_light_setting(struct parser *p)
{
    if (at_word(p, "light_mesh"))
        return parse_light_mesh(p);
    if (at_word(p, "skeleton"))
        return parse_skeleton(p);
    if (stream_keyword(p) == KEYWORD_RADIOSITY)
        return parse_radiosity(p);
    if (stream_keyword(p) == KEYWORD_PHOTONS)
        return parse_photons(p);
    if (stream_keyword(p) == KEYWORD_SUBSURFACE)
        return parse_subsurface(p);
    return NOT_MINE;
}

/* global_setting = setting_value | assumed_gamma | noise_setting
 *                | light_setting | setting_without_effect . */
bool parse_global_setting(struct parser *p)
{
    enum keyword keyword = stream_keyword(p);
    const struct field *field = accept_field(p, setting_fields);
    if (field)
        return setting_field(p, field);
    if (keyword == KEYWORD_ASSUMED_GAMMA)
        return parse_assumed_gamma(p);
    if (keyword == KEYWORD_NOISE_GENERATOR ||
        keyword == KEYWORD_NUMBER_OF_WAVES)
        return parse_noise_setting(p);
    enum taken taken = parse_light_setting(p);
    if (taken == NOT_MINE)
        taken = parse_setting_without_effect(p);
    if (taken != NOT_MINE)
        return taken;
    return error_unknown_item(p, "global_settings", setting_names);
}

/* global_settings = "global_settings" "{" {global_setting} "}" . */
bool parse_global_settings(struct parser *p)
{
    return block_items(p, parse_global_setting);
}

enum gamma_kind settings_gamma(const struct parser *p)
{
    enum gamma_kind kind = p->scene->settings.gamma_kind;
    if (kind != GAMMA_NONE)
        return kind;
    return p->version_said && p->version >= 3.7 ? GAMMA_POWER : GAMMA_NONE;
}

/* As POV-Ray decides it: by the #version in force at the end, for all. */
static void settings_filters(struct parser *p)
{
    bool old = !p->version_said || p->version < 3.7;
    p->scene->settings.old_filter = old;
    for (size_t i = 0; i < p->finishes.count; i++)
        p->finishes.items[i]->old_filter = old;
}

/* What glows is seen as in POV-Ray by every lighting: skies painted on planes,
 * signs, pictures. Where sky and background light the scene, what reflects
 * nothing is a lamp as well, as `emission` says. But since version 3.7
 * radiosity takes the place of all ambient light. */
static void settings_glows(struct parser *p)
{
    const struct settings *settings = &p->scene->settings;
    bool sky = settings_sky(settings);
    if (settings->radiosity && p->version_said && p->version >= 3.7)
        return;
    for (size_t i = 0; i < p->finishes.count; i++) {
        struct finish *finish = p->finishes.items[i];
        bool lamp = finish->diffuse == 0 && finish->diffuse_back == 0;
        rgb glow = rgb_mul(finish->ambient, settings->ambient_light);
        if (!finish_is_to_glow(finish, settings->ambient_light) ||
            (sky && !lamp))
            continue;
        if (sky)
            finish->emission = rgb_add(finish->emission, glow);
        else
            finish->glow = rgb_add(finish->glow, glow);
        finish->ambient = rgb_grey(0);
    }
}

/* Where `ambient` stands for what surfaces give each other: see scene/finish.h.
 * Before settings_glows takes it away. */
static void settings_returned(struct parser *p)
{
    for (size_t i = 0; i < p->finishes.count; i++) {
        struct finish *finish = p->finishes.items[i];
        if (rgb_peak(finish->ambient) > 0 && !settings_sky(&p->scene->settings))
            finish->returned_most = RETURNED_USUAL;
    }
}

/* The last irid_wavelength is that of all. */
static void settings_films(struct parser *p)
{
    for (size_t i = 0; i < p->finishes.count; i++) {
        p->finishes.items[i]->film.wavelength =
            p->scene->settings.irid_wavelength;
        p->finishes.items[i]->film.noise = &p->scene->noise;
    }
}

void settings_finish(struct parser *p)
{
    settings_filters(p);
    settings_returned(p);
    settings_glows(p);
    settings_films(p);
    if (p->scene->settings.gamma_kind != GAMMA_NONE || p->failed)
        return;
    p->scene->settings.gamma_kind = settings_gamma(p);
    p->scene->settings.assumed_gamma = 1;
    warning_at(p, span_none(), "global_settings { assumed_gamma 1.0 }",
               p->scene->settings.gamma_kind == GAMMA_NONE
                   ? "no assumed_gamma: numbers go into the picture as they "
                     "are, as in POV-Ray before version 3.7"
                   : "no assumed_gamma: 1.0 is taken");
}

void defaults_init(struct parser *p)
{
    struct pigment *pigment = ARENA_NEW(p->scene_arena, struct pigment);
    struct finish *finish = ARENA_NEW(p->scene_arena, struct finish);
    *pigment = pigment_default(p->scene_arena);
    *finish = finish_default();
    *ARRAY_PUSH(p->arena, &p->finishes) = finish;
    p->plain = p->defaults.pigment = pigment;
    p->defaults.normal = NULL;
    p->defaults.finish = finish;
}

/* default_item = texture | pigment | normal | finish . */
static bool parse_default_item(struct parser *p)
{
    const struct texture *texture;
    switch (stream_keyword(p)) {
    case KEYWORD_TEXTURE:
        if (!parse_texture(p, &texture))
            return false;
        p->defaults.pigment = texture->layers[texture->count - 1].pigment;
        p->defaults.normal = texture->layers[texture->count - 1].normal;
        p->defaults.finish = texture->layers[texture->count - 1].finish;
        return true;
    case KEYWORD_PIGMENT:
        return parse_pigment_block(p, &p->defaults.pigment);
    case KEYWORD_NORMAL:
        return parse_normal_block(p, &p->defaults.normal);
    case KEYWORD_FINISH:
        return parse_finish_block(p, &p->defaults.finish);
    default:
        return error_unknown_item(p, "#default", NULL);
    }
}

/* default_block = "default" "{" {default_item} "}" .
 * Without '#' as with it. */
bool parse_default_block(struct parser *p)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) && block_end(p, open, parse_defaults(p, open));
}

bool parse_defaults(struct parser *p, struct span open)
{
    (void)open;
    while (stream_peek(p)->kind != TOKEN_RBRACE)
        if (!parse_default_item(p))
            return false;
    return true;
}
