/* Light sources. */
#include "parse/expression.h"
#include "parse/rules.h"
#include "parse/tables.h"

/* The samples of an area light are all asked for every point of a surface. */
enum { AREA_SIZE_LIMIT = 1000 };

static const struct field light_names[] = {
    { .name = "spotlight" },  { .name = "cylinder" },
    { .name = "parallel" },   { .name = "point_at" },
    { .name = "radius" },     { .name = "falloff" },
    { .name = "tightness" },  { .name = "area_light" },
    { .name = "adaptive" },   { .name = "jitter" },
    { .name = "circular" },   { .name = "orient" },
    { .name = "shadowless" }, { .name = "fade_distance" },
    { .name = "fade_power" }, { .name = "looks_like" },
    { .name = "photons" },    { .name = "projected_through" },
    { .name = "translate" },  { .name = "rotate" },
    { .name = "scale" },      { .name = "colour" },
    { .name = NULL },
};

/* Measured: a light is one of these, and the last word counts. A spotlight that
 * becomes shadowless shines everywhere alike, a cylinder stays parallel. */
static void light_become(struct parser *p, struct light *light,
                         enum light_kind kind, bool shadowless)
{
    bool was_directed = light->kind != LIGHT_POINT;
    if (shadowless ? was_directed : light->shadowless)
        warning_at(p, p->last_span, NULL,
                   "a light is a spotlight, a cylinder or shadowless, as in "
                   "POV-Ray, and the last of these words counts");
    light->parallel |= light->kind == LIGHT_CYLINDER && kind != LIGHT_CYLINDER;
    light->kind = kind;
    light->shadowless = shadowless;
}

/* light_kind = "spotlight" | "cylinder" | "shadowless" . */
static enum taken parse_light_kind(struct parser *p, struct light *light)
{
    if (accept_keyword(p, KEYWORD_SPOTLIGHT)) {
        light_become(p, light, LIGHT_SPOT, false);
    } else if (accept_word(p, "cylinder")) {
        light_become(p, light, LIGHT_CYLINDER, false);
        light->radius = 0.75;
        light->falloff = 1;
    } else if (accept_word(p, "shadowless")) {
        light_become(p, light, LIGHT_POINT, true);
    } else {
        return NOT_MINE;
    }
    return TAKEN;
}

static bool area_size(struct parser *p, int *out)
{
    struct span span = stream_span(p);
    if (!parse_integer(p, out))
        return false;
    accept(p, TOKEN_COMMA);
    return (*out >= 1 && *out <= AREA_SIZE_LIMIT) ||
           error_at(p, span, NULL,
                    "an area_light has 1 to %d lights in a row, not %d",
                    AREA_SIZE_LIMIT, *out);
}

/* area_light = "area_light" vector [","] vector [","] float [","] float . */
static bool parse_area_light(struct parser *p, struct light *light)
{
    struct span span = stream_span(p);
    stream_next(p);
    light->area = true;
    if (!parse_vector(p, &light->axis1))
        return false;
    accept(p, TOKEN_COMMA);
    if (!parse_vector(p, &light->axis2))
        return false;
    accept(p, TOKEN_COMMA);
    if (!at_number(p))
        return error_expected_hint(p, "how many lights along the first axis",
                                   "area_light x, z, 4, 4");
    if (!area_size(p, &light->size1))
        return false;
    if (!at_number(p))
        return error_expected_hint(p, "how many lights along the second axis",
                                   "area_light x, z, 4, 4");
    vec3 normal = vec3_cross(light->axis1, light->axis2);
    if (!(vec3_dot(normal, normal) > 0))
        warning_at(p, span_join(span, p->last_span),
                   "area_light 2*x, 2*z, 4, 4",
                   "the two sides of this area_light are parallel: its lights "
                   "stand in one line");
    return area_size(p, &light->size2);
}

/* The object of such a block, put in its place, and what modifies it there. */
static bool block_of_object(struct parser *p, const char *block,
                            const affine *place, struct object **out)
{
    struct modifiers m = { .block = block };
    if (!parse_object(p, out))
        return false;
    if (place)
        object_move(p->scene_arena, *out, place);
    m.object = *out;
    return parse_modifiers(p, &m);
}

/* looks_like = "looks_like" "{" object {modifier} "}" .
 * The object is written around the origin and goes where the light is; then it
 * is modified (measured). */
static bool parse_looks_like(struct parser *p, struct object *owner,
                             struct light *light, struct object **looks)
{
    struct span open, span = stream_span(p);
    affine place = affine_translation(light->location);
    if (*looks)
        return error_at(p, span, NULL, "a light has only one looks_like");
    stream_next(p);
    if (!block_begin(p, &open) ||
        !block_end(p, open, block_of_object(p, "looks_like", &place, looks)))
        return false;
    object_link(p, *looks);
    light->looks_like = *looks;
    return object_adopt(p, owner, *looks);
}

/* projected_through = "projected_through" "{" object {modifier} "}" .
 * The object is written where it is. */
static bool parse_projected_through(struct parser *p, struct object *owner,
                                    struct light *light)
{
    struct object *window;
    struct span open, span = stream_span(p);
    if (light->window)
        return error_at(p, span, "union",
                        "a light has only one projected_through");
    stream_next(p);
    if (!block_begin(p, &open) ||
        !block_end(p, open,
                   block_of_object(p, "projected_through", NULL, &window)))
        return false;
    object_link(p, window);
    light->window = window;
    p->scene->windows = true;
    return object_adopt(p, owner, window);
}

/* media_interaction = "media_interaction" [bool] . */
static bool parse_media_interaction(struct parser *p, struct light *light)
{
    bool on;
    stream_next(p);
    bool ok = parse_bool(p, &on);
    light->no_media = !on;
    return ok;
}

static enum taken light_move(struct parser *p, struct light *light,
                             struct object *looks)
{
    affine step = affine_identity();
    enum taken taken = parse_transformation(p, &step);
    if (taken != TAKEN)
        return taken;
    *light = light_moved(light, &step);
    if (looks)
        object_move(p->scene_arena, looks, &step);
    light->looks_like = looks;
    if (light->window) {
        struct object *window = object_copy(p->scene_arena, light->window);
        object_move(p->scene_arena, window, &step);
        light->window = window;
    }
    return TAKEN;
}

/* A plain light shines everywhere alike: pointing it is a mistake. */
static bool light_check_directed(struct parser *p, const struct light *light)
{
    const struct token *token = stream_peek(p);
    if (light->kind != LIGHT_POINT || light->parallel ||
        token->kind != TOKEN_WORD ||
        !field_find(directed_fields, token->word->text))
        return true;
    return error_at(p, stream_span(p), NULL,
                    "'%s' needs 'spotlight', 'cylinder' or 'parallel' before "
                    "it",
                    token->word->text);
}

/* light_value = "fade_distance" float | "fade_power" float
 *             | "adaptive" float | "circular" | "orient" | "jitter"
 *             | "area_illumination" [bool] | "parallel"
 *             | "media_attenuation" [bool] .
 * directed_value = "point_at" vector | "radius" float | "falloff" float
 *                | "tightness" float .
 * light_item = light_value | directed_value | light_kind | area_light
 *            | looks_like | projected_through | media_interaction
 *            | photon_flags | transformation . */
static bool parse_light_item(struct parser *p, struct object *object,
                             struct light *light, struct object **looks)
{
    if (parse_light_kind(p, light) == TAKEN)
        return true;
    const struct field *field = accept_field(p, lamp_fields);
    if (!field)
        field = accept_field(p, lamp_kind_fields);
    if (field)
        return parse_field(p, field, light);
    if (!light_check_directed(p, light))
        return false;
    field = accept_field(p, directed_fields);
    if (field)
        return parse_field(p, field, light);
    if (stream_keyword(p) == KEYWORD_AREA_LIGHT)
        return parse_area_light(p, light);
    if (stream_keyword(p) == KEYWORD_LOOKS_LIKE)
        return parse_looks_like(p, object, light, looks);
    if (stream_keyword(p) == KEYWORD_PROJECTED_THROUGH)
        return parse_projected_through(p, object, light);
    if (stream_keyword(p) == KEYWORD_MEDIA_INTERACTION)
        return parse_media_interaction(p, light);
    if (stream_keyword(p) == KEYWORD_PHOTONS)
        return parse_photon_flags(p, &light->photons);
    enum taken taken = light_move(p, light, *looks);
    if (taken != NOT_MINE)
        return taken;
    const struct token *token = stream_peek(p);
    if (token->kind == TOKEN_WORD && colour_begins(token->word->keyword))
        return error_at(p, p->token_span, "<1, 2, 3>, rgb 1 ...",
                        "a light has one colour, which comes behind its place; "
                        "a place is written <1, 2, 3>");
    return error_unknown_item(p, "light_source", light_names);
}

/* None is black, as in POV-Ray. */
static bool light_colour(struct parser *p, struct light *light)
{
    colour value = { .r = 0 };
    const struct token *token = stream_peek(p);
    bool said = at_any_colour(p);
    if (said && !parse_colour(p, &value))
        return false;
    light->colour = colour_rgb(value);
    if (said)
        return true;
    if (token->kind == TOKEN_WORD && !token->word->reserved)
        return error_expected(p, "a colour");
    warning_at(p, light->span, "colour rgb 1",
               "a light without a colour is black");
    return true;
}

static bool light_body(struct parser *p, struct object *object)
{
    struct light *light = ARENA_NEW(p->scene_arena, struct light);
    struct object *looks = NULL;
    *light = light_default();
    light->span = object->span;
    object->light = light;
    if (stream_peek(p)->kind == TOKEN_WORD && stream_peek(p)->word->reserved &&
        (colour_begins(stream_peek(p)->word->keyword) || !at_expression(p)))
        return error_expected_hint(p, "where the light is, a vector",
                                   "<1, 2, 3>, rgb 1 ...");
    if (!parse_vector(p, &light->location))
        return false;
    accept(p, TOKEN_COMMA);
    if (!light_colour(p, light))
        return false;
    while (stream_peek(p)->kind != TOKEN_RBRACE)
        if (!parse_light_item(p, object, light, &looks))
            return false;
    return true;
}

static bool light_source_items(struct parser *p, struct object **out)
{
    const struct value *value = accept_value(p, VALUE_OBJECT);
    if (!value)
        return light_body(p, *out);
    *out = object_copy(p->scene_arena, value->object);
    struct modifiers m = { .object = *out, .block = "light_source" };
    return parse_modifiers(p, &m);
}

/* light_source = "light_source" "{" ( OBJECT {modifier}
 *              | vector [","] [colour] {light_item} ) "}" . */
bool parse_light_source(struct parser *p, struct object **out)
{
    struct span open;
    stream_next(p);
    *out = object_new(p->scene_arena, OBJECT_LIGHT, p->last_span);
    return block_begin(p, &open) &&
           block_end(p, open, light_source_items(p, out));
}
