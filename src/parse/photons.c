/* The three photons {} blocks: of global_settings, of objects, of lamps. */
#include "parse/rules.h"
#include "parse/tables.h"
#include "scene/photon.h"

enum {
    GATHER_LIMIT = 10000,   /* photons at one place */
    COUNT_LIMIT = 50000000, /* photons sent, half a minute of a core */
    STEPS_LIMIT = 100000,   /* of one photon in a stretch of media */
};

#define PHOTONS(name, kind, member, low, high, help)                           \
    {                                                                          \
        name, kind, offsetof(struct photon_settings, member), low, high, help  \
    }
#define FLAGS(name, kind, member, low, high, help)                             \
    {                                                                          \
        name, kind, offsetof(struct photon_flags, member), low, high, help     \
    }

/* photon_number = "spacing" float | "count" float | "gather" float "," float
 *               | "jitter" float | "max_trace_level" float
 *               | "adc_bailout" float . */
const struct field photon_fields[] = {
    PHOTONS("spacing", FIELD_FLOAT, spacing, -1e9, 1e9,
            "between photons at their target, units"),
    PHOTONS("count", FIELD_FLOAT, count, 0, COUNT_LIMIT,
            "photons that are sent, about"),
    PHOTONS("gather", FIELD_PAIR, gather, 1, GATHER_LIMIT,
            "photons that are looked at for one place, least and most, "
            "20, 100"),
    PHOTONS("jitter", FIELD_FLOAT, jitter, 0, 1,
            "how far they leave their rows, 0.4 of their distance"),
    PHOTONS("max_trace_level", FIELD_INTEGER, max_trace_level, 0, 0,
            "surfaces a photon may meet"),
    PHOTONS("adc_bailout", FIELD_FLOAT, adc_bailout, 0, 0,
            "photons weaker than this are not followed"),
    { NULL },
};

static const struct field photon_names[] = {
    { .name = "spacing" },   { .name = "count" },
    { .name = "gather" },    { .name = "media" },
    { .name = "jitter" },    { .name = "max_trace_level" },
    { .name = "radius" },    { .name = "adc_bailout" },
    { .name = "autostop" },  { .name = "expand_thresholds" },
    { .name = "load_file" }, { .name = "save_file" },
    { .name = NULL },
};

static bool photon_numbers(struct parser *p, double *numbers, int most)
{
    for (int i = 0; i < most; i++) {
        if (!parse_float(p, &numbers[i]))
            return false;
        accept(p, TOKEN_COMMA);
        if (!at_expression(p))
            return true;
    }
    return true;
}

/* photon_radius = "radius" float {[","] float} .
 * Of a place, and what it is multiplied with; then the same of media. */
static bool parse_photon_radius(struct parser *p,
                                struct photon_settings *photons)
{
    double numbers[4] = { 0, 1, 0, 1 };
    struct span span = stream_span(p);
    if (!photon_numbers(p, numbers, 4))
        return false;
    if (!(numbers[0] >= 0) || !(numbers[1] > 0) || !(numbers[2] >= 0) ||
        !(numbers[3] > 0))
        return error_at(p, span, NULL,
                        "the radius of photons must not be below 0, and what "
                        "multiplies it must be above 0");
    photons->radius = numbers[0];
    photons->radius_share = numbers[1];
    photons->media_radius = numbers[2];
    photons->media_radius_share = numbers[3];
    return true;
}

/* photon_media = "media" float [[","] float] .
 * How many places of each stretch photons are kept at, at most, and how far
 * these are from each other, in spacings. */
static bool parse_photon_media(struct parser *p,
                               struct photon_settings *photons)
{
    double numbers[2] = { 0, 1 };
    struct span span = stream_span(p);
    if (!photon_numbers(p, numbers, 2))
        return false;
    if (!(numbers[0] >= 0 && numbers[0] <= STEPS_LIMIT) || !(numbers[1] > 0))
        return error_at(p, span, NULL,
                        "photons stay in 0 to %d steps of media, whose "
                        "distance must be above 0",
                        STEPS_LIMIT);
    photons->steps = floor(numbers[0]);
    photons->step = numbers[1];
    return true;
}

/* photon_file = ("load_file" | "save_file") string .
 * A scene may come from anybody and must not write; what POV-Ray wrote is in
 * a form of its own. */
static bool parse_photon_file(struct parser *p, bool save)
{
    const char *ignored;
    warning_at(p, p->last_span, NULL,
               save ? "a scene may not write files: its photons are not kept"
                    : "photons are not read from files: they are sent anew");
    return parse_string(p, &ignored);
}

/* photon_value = photon_number | photon_radius | photon_media | photon_file
 *              | "autostop" float
 *              | "expand_thresholds" float [","] float .
 * The last two say how POV-Ray's photons are sent and looked up. */
static bool parse_photon_value(struct parser *p)
{
    struct photon_settings *photons = &p->scene->settings.photons;
    double ignored[2];
    const struct field *field = accept_field(p, photon_fields);
    if (field)
        return parse_field(p, field, photons);
    if (accept_word(p, "radius"))
        return parse_photon_radius(p, photons);
    if (accept_word(p, "save_file"))
        return parse_photon_file(p, true);
    if (accept_word(p, "load_file"))
        return parse_photon_file(p, false);
    if (accept_word(p, "autostop"))
        return photon_numbers(p, ignored, 1);
    if (accept_word(p, "media"))
        return parse_photon_media(p, photons);
    if (accept_word(p, "expand_thresholds"))
        return photon_numbers(p, ignored, 2);
    return error_unknown_item(p, "photons", photon_names);
}

static bool parse_photon_item(struct parser *p)
{
    if (!parse_photon_value(p))
        return false;
    accept(p, TOKEN_COMMA);
    return true;
}

/* photons = "photons" "{" {photon_value [","]} "}" .
 * Without spacing and count, or where they are 0, no photons are sent. */
bool parse_photons(struct parser *p)
{
    struct photon_settings *photons = &p->scene->settings.photons;
    struct span span = stream_span(p);
    if (!block_items(p, parse_photon_item))
        return false;
    photons->on = photons->spacing > 0 || photons->count > 0;
    if (!photons->on)
        warning_at(p, span, "photons { count 20000 }",
                   "'photons' without a 'spacing' or 'count' above 0: none are "
                   "sent");
    return true;
}

static const struct field object_photon_names[] = {
    { .name = "target" },  { .name = "refraction" }, { .name = "reflection" },
    { .name = "collect" }, { .name = "area_light" }, { .name = "pass_through" },
    { .name = NULL },
};

static bool photon_say(struct parser *p, enum photon_said *said)
{
    bool on;
    if (!at_expression(p))
        return error_expected_hint(
            p, "'on' or 'off'",
            arena_printf(p->arena, "%.*s on", (int)p->last_span.length,
                         p->last_span.source->text + p->last_span.offset));
    bool ok = parse_bool(p, &on);
    *said = on ? PHOTON_ON : PHOTON_OFF;
    return ok;
}

/* photon_flag = "target" [bool | float] | "refraction" bool
 *             | "reflection" bool | "collect" [bool]
 *             | "area_light" [bool] | "pass_through" [bool] .
 * A number after `target` multiplies the distance of its photons. */
static bool parse_photon_flag(struct parser *p, struct photon_flags *flags)
{
    bool on;
    struct span span = stream_span(p);
    if (accept_word(p, "refraction"))
        return photon_say(p, &flags->refraction);
    if (accept_word(p, "reflection"))
        return photon_say(p, &flags->reflection);
    if (accept_word(p, "area_light"))
        return parse_bool(p, &flags->area);
    if (accept_word(p, "pass_through"))
        return parse_bool(p, &flags->passed);
    if (accept_word(p, "collect")) {
        bool ok = parse_bool(p, &on);
        flags->unlit = !on;
        return ok;
    }
    if (!accept_word(p, "target"))
        return error_unknown_item(p, "photons", object_photon_names);
    flags->target = true;
    if (!at_expression(p))
        return true;
    if (!parse_float(p, &flags->spacing))
        return false;
    flags->target = flags->spacing > 0;
    return flags->spacing >= 0 ||
           error_at(p, span, NULL, "the target's number must not be below 0");
}

static bool photon_flags_items(struct parser *p, struct photon_flags *flags)
{
    while (stream_peek(p)->kind != TOKEN_RBRACE) {
        if (!parse_photon_flag(p, flags))
            return false;
        accept(p, TOKEN_COMMA);
    }
    return true;
}

/* What photons pass is no target of theirs, whatever else is said (measured).
 * photon_flags = "photons" "{" {photon_flag [","]} "}" . */
bool parse_photon_flags(struct parser *p, struct photon_flags *flags)
{
    struct span open;
    stream_next(p);
    bool ok = block_begin(p, &open) &&
              block_end(p, open, photon_flags_items(p, flags));
    flags->target &= !flags->passed;
    return ok;
}
