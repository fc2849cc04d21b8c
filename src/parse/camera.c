/* The camera. Its vectors may come in any order: all is worked out at the
 * end, transformations last (measured; tests/povray.md, section 5.8). */
#include "parse/rules.h"
#include "parse/tables.h"

#define CAMERA(name, kind, member, low, high, help)                            \
    {                                                                          \
        name, kind, offsetof(struct camera_draft, camera.member), low, high,   \
            help                                                               \
    }

struct camera_draft {
    struct camera camera;
    affine moved; /* applied at the end, wherever it stands */
};

/* camera_value = "location" vector | "direction" vector | "right" vector
 *              | "up" vector | "sky" vector | "look_at" vector
 *              | "angle" float [[","] float] . */
const struct field camera_fields[] = {
    CAMERA("location", FIELD_VECTOR, location, 0, 0, "where it is, 0"),
    CAMERA("direction", FIELD_VECTOR, direction, 0, 0,
           "to the picture's middle, z"),
    CAMERA("right", FIELD_VECTOR, right, 0, 0, "across the picture, 1.33 x"),
    CAMERA("up", FIELD_VECTOR, up, 0, 0, "up the picture, y"),
    CAMERA("sky", FIELD_VECTOR, sky, 0, 0, "what look_at keeps up, y"),
    CAMERA("look_at", FIELD_VECTOR, look_at, 0, 0, "the point in the middle"),
    CAMERA("angle", FIELD_FLOAT, angle, 0, 0, "degrees across the picture"),
    { NULL },
};

/* camera_kind = mesh_camera | CAMERA_KIND .
 * The last are in the tables of src/scene/camera/, "cylinder" with a number. */
static enum taken parse_camera_kind(struct parser *p, struct camera *camera)
{
    const struct token *token = stream_peek(p);
    const struct camera_kind *kind =
        token->kind == TOKEN_WORD ? camera_kind_find(token->word->text) : NULL;
    if (!kind)
        return NOT_MINE;
    camera->kind = kind;
    if (stream_keyword(p) == KEYWORD_MESH_CAMERA)
        return parse_mesh_camera(p, camera);
    stream_next(p);
    return !kind->arguments || parse_arguments(p, kind->arguments, camera);
}

enum { BLUR_SAMPLES_LIMIT = 100000 };

const struct field blur_fields[] = {
    CAMERA("aperture", FIELD_FLOAT, aperture, 0, 0,
           "width of the lens: the wider, the more is blurred, 0"),
    CAMERA("focal_point", FIELD_VECTOR, focal_point, 0, 0,
           "at whose distance all is sharp"),
    CAMERA("confidence", FIELD_FLOAT, confidence, 0, 0,
           "how sure it is that the variance is met, 0.9"),
    CAMERA("variance", FIELD_FLOAT, variance, 0, 0,
           "no more samples once theirs is less, 1/10000"),
    { NULL },
};

/* blur_samples = "blur_samples" float [[","] float] .
 * At most; or at least and at most. */
static bool parse_blur_samples(struct parser *p, struct camera *camera)
{
    stream_next(p);
    struct span span = stream_span(p);
    if (!parse_float(p, &camera->blur_samples[1]))
        return false;
    accept(p, TOKEN_COMMA);
    camera->blur_samples[0] = 0;
    if (at_expression(p)) {
        camera->blur_samples[0] = camera->blur_samples[1];
        if (!parse_float(p, &camera->blur_samples[1]))
            return false;
    }
    for (int i = 0; i < 2; i++)
        if (!(camera->blur_samples[i] >= 0 &&
              camera->blur_samples[i] <= BLUR_SAMPLES_LIMIT))
            return error_at(p, span_join(span, p->last_span), NULL,
                            "there are 0 to %d blur_samples",
                            BLUR_SAMPLES_LIMIT);
    return true;
}

static bool bokeh_body(struct parser *p, struct camera *camera)
{
    if (stream_keyword(p) != KEYWORD_PIGMENT)
        return error_at(p, stream_span(p), "pigment { boxed }",
                        "the shape of a lens is the brightness of a pigment");
    return parse_pigment(p, &camera->bokeh);
}

/* bokeh = "bokeh" "{" pigment "}" .
 * A square lens, by the pigment's brightness. */
static bool parse_bokeh(struct parser *p, struct camera *camera)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) && block_end(p, open, bokeh_body(p, camera));
}

/* focal_blur = blur_samples | "aperture" float | "focal_point" vector
 *            | "confidence" float | "variance" float | bokeh .
 * Without samples or with an aperture of 0 nothing is blurred. */
static enum taken parse_focal_blur(struct parser *p, struct camera_draft *draft)
{
    if (stream_keyword(p) == KEYWORD_BLUR_SAMPLES)
        return parse_blur_samples(p, &draft->camera);
    if (stream_keyword(p) == KEYWORD_BOKEH)
        return parse_bokeh(p, &draft->camera);
    const struct field *field = accept_field(p, blur_fields);
    return field ? parse_field(p, field, draft) : NOT_MINE;
}

static bool camera_check_angle(struct parser *p, const struct camera *camera,
                               struct span span)
{
    if (camera->angle < 0)
        return error_at(p, span, NULL, "a viewing angle can't be negative");
    if (camera->kind == &perspective_camera && camera->angle >= 180)
        return error_at(p, span, NULL,
                        "a viewing angle must be smaller than 180 degrees");
    return true;
}

static bool camera_field(struct parser *p, const struct field *field,
                         struct camera_draft *draft)
{
    struct span span = p->last_span;
    if (!parse_field(p, field, draft))
        return false;
    bool is_look_at = strcmp(field->name, "look_at") == 0;
    if (strcmp(field->name, "angle") == 0) {
        draft->camera.angle_said = true;
        accept(p, TOKEN_COMMA);
        if (at_number(p) && !parse_float(p, &draft->camera.angle_up))
            return false;
    }
    draft->camera.has_look_at = draft->camera.has_look_at || is_look_at;
    draft->camera.has_size = draft->camera.has_size ||
                             strcmp(field->name, "right") == 0 ||
                             strcmp(field->name, "up") == 0;
    return camera_check_angle(p, &draft->camera, span_join(span, p->last_span));
}

/* camera_item = camera_value | camera_kind | focal_blur | normal
 *             | transformation . */
static bool parse_camera_item(struct parser *p, struct camera_draft *draft)
{
    const struct field *field = accept_field(p, camera_fields);
    if (field)
        return camera_field(p, field, draft);
    if (stream_keyword(p) == KEYWORD_NORMAL)
        return parse_normal(p, &draft->camera.normal);
    enum taken taken = parse_camera_kind(p, &draft->camera);
    if (taken == NOT_MINE)
        taken = parse_focal_blur(p, draft);
    if (taken == NOT_MINE)
        taken = parse_transformation(p, &draft->moved);
    return taken != NOT_MINE ? taken
                             : error_unknown_item(p, "camera", camera_fields);
}

static bool camera_end(struct parser *p, struct span span,
                       struct camera_draft *draft)
{
    draft->camera.pixels[0] = p->options->image_width;
    draft->camera.pixels[1] = p->options->image_height;
    const char *problem = camera_finish(&draft->camera);
    if (problem)
        return error_at(p, span, NULL, "impossible camera: %s", problem);
    camera_move(&draft->camera, &draft->moved);
    return true;
}

/* camera_use = CAMERA {transformation} . */
static bool parse_camera_use(struct parser *p, struct camera *camera)
{
    affine moved = affine_identity();
    while (stream_peek(p)->kind != TOKEN_RBRACE) {
        enum taken taken = parse_transformation(p, &moved);
        if (taken == NOT_MINE)
            return error_at(p, stream_span(p), NULL,
                            "a declared camera can only be moved: translate, "
                            "rotate, scale ...");
        if (taken == WRONG)
            return false;
    }
    camera_move(camera, &moved);
    return true;
}

static bool camera_body(struct parser *p, struct span span,
                        struct camera *camera)
{
    const struct value *value = accept_value(p, VALUE_CAMERA);
    if (value) {
        *camera = *value->camera;
        return parse_camera_use(p, camera);
    }
    struct camera_draft draft = { .camera = camera_default(),
                                  .moved = affine_identity() };
    while (stream_peek(p)->kind != TOKEN_RBRACE)
        if (!parse_camera_item(p, &draft))
            return false;
    if (draft.camera.aperture != 0 && draft.camera.blur_samples[1] == 0)
        warning_at(p, span, "blur_samples 50",
                   "an aperture without blur_samples blurs nothing");
    if (!camera_end(p, span, &draft))
        return false;
    *camera = draft.camera;
    return true;
}

/* camera = "camera" "{" ( camera_use | {camera_item} ) "}" . */
bool parse_camera(struct parser *p, struct camera *out)
{
    struct span open;
    stream_next(p);
    struct span span = p->last_span;
    return block_begin(p, &open) &&
           block_end(p, open, camera_body(p, span, out));
}
