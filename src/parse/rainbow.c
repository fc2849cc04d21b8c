/* Rainbows. */
#include "parse/rules.h"
#include "parse/tables.h"

#define RAINBOW(name, kind, member, low, high, help)                           \
    {                                                                          \
        name, kind, offsetof(struct rainbow, member), low, high, help          \
    }

/* rainbow_value = "direction" vector | "up" vector | "angle" float
 *               | "width" float | "arc_angle" float | "falloff_angle" float
 *               | "distance" float | "jitter" float . */
const struct field rainbow_fields[] = {
    RAINBOW("direction", FIELD_VECTOR, direction, 0, 0,
            "to the middle of its circle"),
    RAINBOW("up", FIELD_VECTOR, up, 0, 0, "to the middle of its arc, y"),
    RAINBOW("angle", FIELD_FLOAT, angle, 0, 0,
            "of its radius, degrees as seen from the camera"),
    RAINBOW("width", FIELD_FLOAT, width, 0, 0, "of its band, degrees"),
    RAINBOW("arc_angle", FIELD_FLOAT, arc, 0, 360,
            "degrees of its circle that there are; all, and full"),
    RAINBOW("falloff_angle", FIELD_FLOAT, falloff, 0, 360,
            "degrees of arc_angle that have full colour; all"),
    RAINBOW("distance", FIELD_FLOAT, distance, 0, 0,
            "after which 1/e of what is behind is left"),
    RAINBOW("jitter", FIELD_FLOAT, jitter, 0, 0, "grain of its colours, 0"),
    { NULL },
};

static const struct field rainbow_names[] = {
    { .name = "direction" }, { .name = "up" },
    { .name = "angle" },     { .name = "width" },
    { .name = "arc_angle" }, { .name = "falloff_angle" },
    { .name = "distance" },  { .name = "jitter" },
    { .name = "color_map" }, { .name = "colour_map" },
    { .name = NULL },
};

/* rainbow_item = rainbow_value | colour_map . */
static bool parse_rainbow_item(struct parser *p, struct rainbow *rainbow)
{
    const struct field *field = accept_field(p, rainbow_fields);
    if (field)
        return parse_field(p, field, rainbow);
    if (stream_keyword(p) == KEYWORD_COLOUR_MAP)
        return parse_colour_map(p, &rainbow->map);
    if (at_number(p))
        return error_expected_hint(p, "a word that says what this number is",
                                   "angle 42.5 width 5");
    return error_unknown_item(p, "rainbow", rainbow_names);
}

static bool rainbow_check(struct parser *p, struct rainbow *rainbow)
{
    struct span span = stream_span(p);
    if (!(vec3_length(rainbow->direction) > 0))
        return error_at(p, span, "direction <-0.2, -0.2, 1>",
                        "a rainbow needs a direction");
    if (!(rainbow->width > 0) || rainbow->angle == 0 ||
        !(rainbow->distance > 0))
        return error_at(p, span, "angle 42.5 width 5 distance 1e7",
                        "a rainbow needs an angle, a width and a distance");
    if (!rainbow->map)
        return error_at(p, span, "color_map { [0 rgbt 1] [1 rgb 1] }",
                        "a rainbow needs a color_map");
    if (isfinite(rainbow->falloff) && rainbow->falloff > rainbow->arc)
        return error_at(p, span, NULL,
                        "falloff_angle is %g; it can't be more than "
                        "arc_angle, %g",
                        rainbow->falloff, rainbow->arc);
    rainbow->direction = vec3_normalise(rainbow->direction);
    return true;
}

static bool rainbow_items(struct parser *p, struct rainbow *rainbow)
{
    const struct value *value = accept_value(p, VALUE_RAINBOW);
    *rainbow = value ? *value->rainbow
                     : (struct rainbow){ .up = { 0, 1, 0 },
                                         .arc = HUGE_VAL,
                                         .falloff = HUGE_VAL };
    while (stream_peek(p)->kind != TOKEN_RBRACE) {
        if (!parse_rainbow_item(p, rainbow))
            return false;
        accept(p, TOKEN_COMMA);
    }
    return p->declaring || rainbow_check(p, rainbow);
}

/* rainbow = "rainbow" "{" [RAINBOW] {rainbow_item [","]} "}" . */
bool parse_rainbow(struct parser *p, struct rainbow *out)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) && block_end(p, open, rainbow_items(p, out));
}
