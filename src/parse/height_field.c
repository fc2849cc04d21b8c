/* height_field{}: heights from a picture's numbers, which POV-Ray takes as
 * they are in the file, whatever their gamma (measured), or from a function. */
#include "scene/height_field.h"

#include "image/file.h"
#include "parse/mesh_builder.h"
#include "parse/rules.h"
#include "parse/user_function.h"
#include "scene/function.h"

/* Of all heights of a function together. */
enum { HEIGHT_STEPS = 1000000000 };

static const struct field height_items[] = {
    { "smooth", FIELD_FLAG, offsetof(struct height_field, smooth), 0, 0,
      "normals between those of the corners" },
    { "water_level", FIELD_FLOAT, offsetof(struct height_field, water_level), 0,
      0, "what is lower is not there, 0" },
    { NULL },
};

static const struct unsupported_word height_unsupported[] = {
    { KEYWORD_GIF, "a height_field from a GIF; made a PNG it would be read" },
    { KEYWORD_POT, "a height_field from a POT file" },
    { KEYWORD_NONE, NULL },
};

static double height_number(float value, double top)
{
    return trunc((double)value * top + 0.5);
}

/* A grey byte is rounded down as the sum of its shares of red, green and blue
 * is in single precision, but neither are 16 bits nor bytes with alpha; colours
 * are two bytes, red and green; a palette has its entries' numbers. */
static double height_of(const struct image *image, const float *pixel)
{
    if (image->indexed)
        return height_number(pixel[0], 255) / 256;
    float alpha = pixel[3] > 0 ? pixel[3] : 1;
    float v = pixel[0] / alpha;
    if (image->channels < 3 && image->bits > 8)
        return height_number(v, 65535) / 65536;
    if (image->channels == 2)
        return height_number(v, 255) * 257 / 65536;
    if (image->channels == 1) {
        float grey = 0.297F * v + 0.589F * v + 0.114F * v;
        return trunc((double)(grey * 255.0F)) * 257 / 65536;
    }
    double red = height_number(v, 255);
    double green = height_number(pixel[1] / alpha, 255);
    return (red * 256 + green) / 65536;
}

/* Heights and mesh together must have room. */
static bool height_room(struct parser *p, struct span span,
                        struct height_field *field, int width, int height)
{
    enum { BYTES_A_HEIGHT = 150 };
    double count = (double)width * height;
    size_t limit = arena_limit(p->scene_arena);
    if (width < 2 || height < 2)
        return error_at(p, span, NULL,
                        "a height_field needs 2 x 2 heights at least, this "
                        "has %d x %d",
                        width, height);
    if (count > HEIGHT_FIELD_LIMIT)
        return error_at(p, span, NULL,
                        "a height_field has at most %d heights, this has "
                        "%d x %d",
                        HEIGHT_FIELD_LIMIT, width, height);
    field->width = width;
    field->height = height;
    return !limit ||
           (double)arena_used(p->scene_arena) + count * BYTES_A_HEIGHT <
               (double)limit ||
           error_at(p, span, NULL,
                    "with this height_field the scene needs more memory than "
                    "the limit of %zu MiB",
                    limit >> 20);
}

static bool height_take(struct parser *p, struct span span,
                        const struct image *image, struct height_field *field)
{
    if (!height_room(p, span, field, image->width, image->height))
        return false;
    size_t count = (size_t)image->width * (size_t)image->height;
    field->heights = ARENA_ARRAY(p->scene_arena, double, count);
    for (size_t i = 0; i < count; i++)
        field->heights[i] = height_of(image, image->pixels + 4 * i);
    return true;
}

/* Two bytes as POV-Ray makes them: rounded down, and without what is beyond
 * them, so that what is above 1 begins at 0 again. */
static double height_of_value(double value)
{
    double number = trunc(value * 65535);
    if (!(fabs(number) < 1e15))
        return 0;
    return (number - 65536 * floor(number / 65536)) / 65536;
}

static double height_value(const struct function *function, vec3 point,
                           unsigned long *steps_left)
{
    if (function->pigment) {
        colour c = pigment_colour(function->pigment, point);
        return 0.297 * c.r + 0.589 * c.g + 0.114 * c.b;
    }
    const double arguments[] = { point.x, point.y, point.z };
    return function_evaluate(function, arguments, steps_left);
}

/* Of a function of x and y from 0 to 1, y downwards from z = 1. */
static bool height_sample(struct parser *p, struct span span,
                          const struct function *function,
                          struct height_field *field)
{
    unsigned long left = HEIGHT_STEPS;
    double work = (double)field->width * field->height * function->work;
    size_t i = 0, count = (size_t)field->width * (size_t)field->height;
    field->heights = ARENA_ARRAY(p->scene_arena, double, count);
    for (int y = 0; y < field->height && work <= HEIGHT_STEPS; y++)
        for (int x = 0; x < field->width && left > 0; x++) {
            vec3 point = { (double)x / (field->width - 1),
                           (double)y / (field->height - 1), 0 };
            field->heights[i++] =
                height_of_value(height_value(function, point, &left));
        }
    return (left > 0 && i == count) ||
           error_at(p, span, NULL,
                    "all heights together take more than %d steps of the "
                    "function, glim's limit",
                    HEIGHT_STEPS);
}

static bool height_function(struct parser *p, struct height_field *field)
{
    const struct function *function;
    int width, height;
    struct span span = stream_span(p);
    if (!parse_function_image(p, &width, &height, &function))
        return false;
    span = span_join(span, p->last_span);
    return height_room(p, span, field, width, height) &&
           height_sample(p, span, function, field);
}

/* heights = [image_type] string | function_image . */
static bool parse_heights(struct parser *p, struct height_field *field)
{
    const char *name;
    char problem[256] = "";
    if (stream_keyword(p) == KEYWORD_FUNCTION)
        return height_function(p, field);
    if (!check_supported(p, height_unsupported) || !parse_image_type(p))
        return false;
    struct span span = stream_span(p);
    if (!parse_string(p, &name))
        return false;
    span = span_join(span, p->last_span);
    const char *path = file_need(p, span, "image", name, NULL);
    if (!path)
        return false;
    struct image *image = image_read_numbers(path, problem, sizeof problem);
    if (!image)
        return error_at(p, span, NULL, "can't read the image '%s': %s", path,
                        problem);
    bool ok = height_take(p, span, image, field);
    image_free(image);
    return ok;
}

/* height_field = "height_field" "{" heights
 *                {"smooth" | "water_level" float | modifier} "}" . */
bool parse_height_field(struct parser *p, struct object **out)
{
    struct height_field field = { .width = 0 };
    struct mesh *mesh = ARENA_NEW(p->scene_arena, struct mesh);
    struct span open;
    stream_next(p);
    *out = object_new(p->scene_arena, OBJECT_MESH, p->last_span);
    (*out)->mesh = mesh;
    struct modifiers m = { .object = *out,
                           .block = "height_field",
                           .items = height_items,
                           .shape = &field };
    if (!block_begin(p, &open) ||
        !block_end(p, open, parse_heights(p, &field) && parse_modifiers(p, &m)))
        return false;
    height_field_build(p->scene_arena, &field, mesh);
    mesh_end(p, *out, mesh);
    return true;
}
