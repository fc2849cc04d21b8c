/* height_field{}: heights from a picture's numbers, which POV-Ray takes as
 * they are in the file, whatever their gamma (measured). */
#include "scene/height_field.h"

#include "image/file.h"
#include "parse/mesh_builder.h"
#include "parse/rules.h"

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
    { KEYWORD_FUNCTION, "a height_field from a function" },
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
                        const struct image *image)
{
    enum { BYTES_A_HEIGHT = 150 };
    double count = (double)image->width * image->height;
    size_t limit = arena_limit(p->scene_arena);
    if (image->width < 2 || image->height < 2)
        return error_at(p, span, NULL,
                        "a height_field needs 2 x 2 heights at least, this "
                        "has %d x %d",
                        image->width, image->height);
    if (count > HEIGHT_FIELD_LIMIT)
        return error_at(p, span, NULL,
                        "a height_field has at most %d heights, this has "
                        "%d x %d",
                        HEIGHT_FIELD_LIMIT, image->width, image->height);
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
    if (!height_room(p, span, image))
        return false;
    size_t count = (size_t)image->width * (size_t)image->height;
    field->width = image->width;
    field->height = image->height;
    field->heights = ARENA_ARRAY(p->scene_arena, double, count);
    for (size_t i = 0; i < count; i++)
        field->heights[i] = height_of(image, image->pixels + 4 * i);
    return true;
}

/* heights = [image_type] string . */
static bool parse_heights(struct parser *p, struct height_field *field)
{
    const char *name;
    char problem[256] = "";
    if (!check_supported(p, height_unsupported) || !parse_image_type(p))
        return false;
    struct span span = stream_span(p);
    if (!parse_string(p, &name))
        return false;
    span = span_join(span, p->last_span);
    const char *path = file_find(p, name, NULL);
    if (!path)
        return error_at(p, span, file_hint(p, name),
                        "can't find the image '%s'", name);
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
