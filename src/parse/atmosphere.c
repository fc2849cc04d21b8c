/* What rays meet where there is no object: background, sky_sphere, fog. */
#include "parse/rules.h"
#include "parse/tables.h"

/* Before version 3.7 a background is opaque, or, with +UA, not there at all.
 * background = "background" "{" [colour] "}" . */
bool parse_background(struct parser *p, colour *out)
{
    struct span open;
    stream_next(p);
    if (!block_begin(p, &open))
        return false;
    *out = (colour){ .r = 0 };
    bool ok = !at_any_colour(p) || parse_colour(p, out);
    if (ok && at_any_colour(p))
        ok = error_at(p, stream_span(p), NULL,
                      "a background has one colour, and it stands before this");
    else if (ok && stream_peek(p)->kind != TOKEN_RBRACE)
        ok = error_unknown_item(p, "background", NULL);
    if (!p->version_said || p->version < 3.7) {
        out->filter = out->transmit = 0;
        p->scene->settings.clear_background = true;
    }
    return block_end(p, open, ok);
}

/* ---- fog ---- */

/* fog_type = "fog_type" float .
 * 1 is the same everywhere, 2 lies on the ground. */
static bool parse_fog_type(struct parser *p, struct fog *fog)
{
    int type;
    stream_next(p);
    struct span span = stream_span(p);
    if (!at_expression(p))
        return error_expected_hint(
            p, "fog_type 1, the same everywhere, or 2, on the ground", "2");
    if (!parse_integer(p, &type))
        return false;
    fog->ground = type == 2;
    if (type != 1 && type != 2)
        warning_at(p, span, "2", "fog_type is 1 or 2; %d counts as 1", type);
    return true;
}

static bool fog_upwards(struct parser *p, struct fog *fog, struct span span,
                        vec3 up)
{
    fog->up = vec3_normalise(up);
    return vec3_dot(fog->up, fog->up) > 0.5 ||
           error_at(p, span, "y", "this is no direction");
}

/* fog_turbulence = "turbulence" vector | "turb_depth" float
 *                | "octaves" float | "omega" float | "lambda" float .
 * Measured: any of these is enough for turbulence. */
static enum taken parse_fog_turbulence(struct parser *p, struct fog *fog)
{
    const struct field *field = accept_field(p, fog_turbulence_fields);
    if (!field)
        return NOT_MINE;
    fog->turbulent = true;
    return parse_field(p, field, fog);
}

/* fog_shape = fog_type | "up" vector | transformation .
 * Measured: transformations turn the way up, and change no more. */
static enum taken parse_fog_shape(struct parser *p, struct fog *fog)
{
    affine step = affine_identity();
    struct span span = stream_span(p);
    vec3 up;
    enum taken taken;
    switch (stream_keyword(p)) {
    case KEYWORD_FOG_TYPE:
        return parse_fog_type(p, fog);
    case KEYWORD_UP:
        stream_next(p);
        return parse_vector(p, &up) && fog_upwards(p, fog, span, up);
    default:
        taken = parse_transformation(p, &step);
        return taken != TAKEN ? taken
                              : fog_upwards(p, fog, span,
                                            affine_direction(&step, fog->up));
    }
}

/* fog_item = "distance" float | "fog_offset" float | "fog_alt" float
 *          | colour | fog_turbulence | fog_shape | float .
 * A number alone is the distance, in old scenes. */
static bool parse_fog_item(struct parser *p, struct fog *fog)
{
    const struct field *field = accept_field(p, fog_fields);
    if (field)
        return parse_field(p, field, fog);
    if (at_colour(p))
        return parse_colour(p, &fog->colour);
    if (at_number(p))
        return parse_float(p, &fog->distance);
    enum taken taken = parse_fog_turbulence(p, fog);
    if (taken == NOT_MINE)
        taken = parse_fog_shape(p, fog);
    return taken != NOT_MINE ? taken : error_unknown_item(p, "fog", fog_fields);
}

/* Stands for 0: a fog that ends at its offset. */
static const double fog_altitude_least = 1e-9;

static bool fog_items(struct parser *p, struct fog *fog)
{
    const struct value *value = accept_value(p, VALUE_FOG);
    *fog = value ? *value->fog
                 : (struct fog){ .up = { 0, 1, 0 },
                                 .turbulence = { { 0, 0, 0 }, 6, 0.5, 2 },
                                 .turbulent_share = 0.5 };
    while (stream_peek(p)->kind != TOKEN_RBRACE) {
        if (!parse_fog_item(p, fog))
            return false;
        accept(p, TOKEN_COMMA);
    }
    if (fog->altitude == 0 && fog->ground)
        warning_at(p, p->token_span, "fog_alt 1",
                   "a fog_type 2 without a fog_alt ends at its fog_offset; "
                   "POV-Ray draws black");
    if (fog->altitude == 0)
        fog->altitude = fog_altitude_least;
    return true;
}

/* fog = "fog" "{" [FOG] {fog_item [","]} "}" . */
bool parse_fog(struct parser *p, struct fog *out)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) && block_end(p, open, fog_items(p, out));
}

/* ---- sky_sphere ---- */

const struct field sky_fields[] = {
    { "emission", FIELD_RGB, offsetof(struct sky_sphere, emission), 0, 0,
      "multiplies, 1" },
    { NULL },
};

static const struct field sky_names[] = {
    { .name = "pigment" },
    { .name = "emission" },
    { .name = NULL },
};

static void sky_move(struct parser *p, struct sky_sphere *sky,
                     const affine *step)
{
    for (size_t i = 0; i < sky->count; i++)
        sky->pigments[i] =
            pigment_moved(p->scene_arena, sky->pigments[i], step);
}

static bool sky_add(struct parser *p, struct sky_sphere *sky)
{
    const struct pigment **pigments =
        ARENA_ARRAY(p->scene_arena, const struct pigment *, sky->count + 1);
    if (sky->count)
        memcpy(pigments, sky->pigments, sky->count * sizeof *pigments);
    sky->pigments = pigments;
    struct span span = stream_span(p);
    return parse_plain_pigment(p, &pigments[sky->count]) &&
           uv_refuse(p, span, &pigments[sky->count++]->pattern);
}

/* sky_sphere_item = pigment | "emission" colour | transformation . */
static bool parse_sky_sphere_item(struct parser *p, struct sky_sphere *sky)
{
    affine step = affine_identity();
    const struct field *field = accept_field(p, sky_fields);
    if (field)
        return parse_field(p, field, sky);
    if (stream_keyword(p) == KEYWORD_PIGMENT)
        return sky_add(p, sky);
    enum taken taken = parse_transformation(p, &step);
    if (taken == TAKEN)
        sky_move(p, sky, &step);
    return taken != NOT_MINE ? taken
                             : error_unknown_item(p, "sky_sphere", sky_names);
}

static bool sky_items(struct parser *p, struct sky_sphere *sky)
{
    const struct value *value = accept_value(p, VALUE_SKY_SPHERE);
    *sky = value ? *value->sky : (struct sky_sphere){ .emission = rgb_grey(1) };
    if (sky->count) {
        const struct pigment **own =
            ARENA_ARRAY(p->scene_arena, const struct pigment *, sky->count);
        memcpy(own, sky->pigments, sky->count * sizeof *own);
        sky->pigments = own;
    }
    while (stream_peek(p)->kind != TOKEN_RBRACE)
        if (!parse_sky_sphere_item(p, sky))
            return false;
    return sky->count || error_at(p, stream_span(p), "pigment { rgb 1 }",
                                  "a sky_sphere needs a pigment");
}

/* sky_sphere = "sky_sphere" "{" [SKY_SPHERE] {sky_sphere_item} "}" . */
bool parse_sky_sphere(struct parser *p, const struct sky_sphere **out)
{
    struct sky_sphere *sky = ARENA_NEW(p->scene_arena, struct sky_sphere);
    struct span open;
    *out = sky;
    stream_next(p);
    return block_begin(p, &open) && block_end(p, open, sky_items(p, sky));
}
