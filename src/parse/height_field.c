/* height_field{}: heights from a picture's numbers, which POV-Ray takes as
 * they are in the file unless the scene says their gamma (measured), or from a
 * function. */
#include "scene/height_field.h"

#include "base/clones.h"
#include "base/rgb.h"
#include "image/file.h"
#include "parse/function_picture.h"
#include "parse/rules.h"
#include "parse/user_function.h"

static double height_number(float value, double top)
{
    return trunc((double)value * top + 0.5);
}

/* Two bytes as POV-Ray makes them: rounded down, and without what is beyond
 * them, so that what is above them begins at 0 again. */
static inline double height_cut(double number)
{
    number = trunc(number);
    return fabs(number) < 1e15 ? number - 65536 * floor(number / 65536) : 0;
}

/* A grey byte of a PNG is rounded down as the sum of its shares of red, green
 * and blue is in single precision, but no others, 16 bits or with alpha;
 * colours of 8 bits are two bytes, red and green, those of 16 as bright; a
 * palette has its entries' numbers. All are as written, premultiplied or not.
 * EXR and HDR files have red and green again, not rounded, and what is above
 * two bytes is left out. */
static double height_of(const struct image *image, const float *pixel)
{
    if (image->indexed)
        return height_number(pixel[0], 255) * 256;
    if (image->linear)
        return height_cut((double)pixel[0] * 65280 + (double)pixel[1] * 255);
    float v = pixel[0];
    if (image->channels < 3 && image->bits > 8)
        return height_number(v, 65535);
    if (image->channels == 2 || (image->channels == 1 && !image->png))
        return height_number(v, 255) * 257;
    if (image->channels == 1) {
        /* Divided, as readers of files don't. */
        v = (float)height_number(v, 255) / 255;
        float grey = 0.297F * v + 0.589F * v + 0.114F * v;
        return trunc((double)(grey * 255.0F)) * 257;
    }
    if (image->bits > 8) {
        double grey = grey_of((double)v, (double)pixel[1], (double)pixel[2]);
        return trunc(grey * 65535);
    }
    double red = height_number(v, 255);
    return red * 256 + height_number(pixel[1], 255);
}

/* Makes room for the heights, if all that will be known of them has. */
static bool height_room(struct parser *p, struct span span,
                        struct height_grid *grid, int width, int height)
{
    double count = (double)width * height;
    double bytes =
        count * sizeof *grid->heights + (double)height_grid_size(width, height);
    size_t limit = arena_limit(p->scene_arena);
    if (width < 2 || height < 2)
        return error_at(p, span, NULL,
                        "a height_field needs 2 x 2 heights at least, this "
                        "has %d x %d",
                        width, height);
    if (count > HEIGHT_GRID_LIMIT)
        return error_at(p, span, NULL,
                        "a height_field has at most %d heights, this has "
                        "%d x %d",
                        HEIGHT_GRID_LIMIT, width, height);
    if (limit && (double)arena_used(p->scene_arena) + bytes > (double)limit)
        return error_at(p, span, NULL,
                        "with this height_field the scene needs more memory "
                        "than the limit of %zu MiB",
                        limit >> 20);
    grid->width = width;
    grid->height = height;
    grid->heights =
        ARENA_ARRAY(p->scene_arena, uint16_t, (size_t)width * (size_t)height);
    return true;
}

/* A picture's way into the grid. */
struct height_picture {
    struct parser *p;
    struct span span; /* its name */
    struct height_grid *grid;
    double gamma; /* of the numbers, 0: sRGB; -1: not said */
    bool pot; /* Fractint's: bytes in a GIF, to the right of the higher ones */
};

static bool picture_begin(void *context, const struct image *image)
{
    const struct height_picture *picture = context;
    int width = picture->pot ? image->width / 2 : image->width;
    if (picture->pot && (!image->indexed || image->png))
        return error_at(picture->p, picture->span, NULL,
                        "pot means a GIF whose right half has the lower bytes "
                        "of the heights, this is none");
    return height_room(picture->p, picture->span, picture->grid, width,
                       image->height);
}

/* Of a pixel whose numbers the scene says the gamma of: no more in bytes, but
 * those of 16 bits are as bright as ever. */
static double height_decoded(const struct image *image, double gamma,
                             const float *pixel)
{
    double part[3];
    for (int k = 0; k < 3; k++)
        part[k] = image_number(image, gamma, (double)pixel[k]);
    if (image->channels < 3 && !image->linear)
        return trunc(part[0] * 65535 + 0.5);
    if (image->bits > 8 && !image->linear)
        return trunc(grey_of(part[0], part[1], part[2]) * 65535);
    return height_cut(part[0] * 65280 + part[1] * 255);
}

/* A palette's numbers have no gamma. */
static double picture_height(const struct height_picture *picture,
                             const struct image *image, const float *pixel)
{
    return picture->gamma < 0 || image->indexed
               ? height_of(image, pixel)
               : height_decoded(image, picture->gamma, pixel);
}

static void picture_take(void *context, const struct image *image, int y,
                         const float *pixels)
{
    const struct height_picture *picture = context;
    size_t width = (size_t)picture->grid->width;
    uint16_t *row = picture->grid->heights + (size_t)y * width;
    for (size_t i = 0; i < width; i++) {
        double height = picture_height(picture, image, pixels + 4 * i);
        if (picture->pot)
            height +=
                picture_height(picture, image, pixels + 4 * (width + i)) / 256;
        row[i] = (uint16_t)height;
    }
}

CLONES static void heights_of_values(const double *restrict values, int count,
                                     uint16_t *restrict heights)
{
    for (int i = 0; i < count; i++)
        heights[i] = (uint16_t)(int)height_cut(values[i] * 65535);
}

static bool height_too_slow(struct parser *p, struct span span)
{
    return error_at(p, span, NULL,
                    "all heights together take more than %d steps of the "
                    "function, glim's limit",
                    FUNCTION_PICTURE_STEPS);
}

/* Of x and y from 0 to 1, y downwards from z = 1. */
static bool height_row(struct function_picture *picture, int y, uint16_t *row)
{
    struct function_piece piece;
    for (int x = 0; x < picture->width; x += piece.count) {
        if (!function_picture_piece(picture, x, y, &piece))
            return false;
        for (int i = 0; picture->function->values && i < piece.count; i++)
            piece.values[i] = grey_of(piece.parts[i][0], piece.parts[i][1],
                                      piece.parts[i][2]);
        heights_of_values(piece.values, piece.count, row + x);
    }
    return true;
}

static bool height_sample(struct parser *p, struct span span,
                          struct function_picture *picture,
                          struct height_grid *grid)
{
    for (int y = 0; y < grid->height; y++) {
        if (stream_stopped(p))
            return false;
        if (!height_row(picture, y,
                        grid->heights + (size_t)y * (size_t)grid->width))
            return height_too_slow(p, span);
    }
    return true;
}

static bool height_function(struct parser *p, struct height_grid *grid)
{
    const struct function *function;
    int width, height;
    struct span span = stream_span(p);
    if (!parse_function_image(p, &width, &height, &function))
        return false;
    span = span_join(span, p->last_span);
    struct function_picture picture =
        function_picture_new(function, width, height);
    if ((double)width * height <= HEIGHT_GRID_LIMIT && !picture.steps_left)
        return height_too_slow(p, span);
    return height_room(p, span, grid, width, height) &&
           height_sample(p, span, &picture, grid);
}

static bool parse_decoding(struct parser *p, double *gamma)
{
    bool premultiplied;
    *gamma = -1;
    if (stream_keyword(p) == KEYWORD_GAMMA && !parse_image_gamma(p, gamma))
        return false;
    return !accept_keyword(p, KEYWORD_PREMULTIPLIED) ||
           parse_bool(p, &premultiplied);
}

/* premultiplied has no effect: a height is a number of the file.
 * heights = [image_type | "pot"] string [image_gamma]
 *           ["premultiplied" [bool]] | function_image . */
static bool parse_heights(struct parser *p, void *shape)
{
    struct height_field *field = shape;
    const char *type, *name;
    char problem[256] = "";
    if (stream_keyword(p) == KEYWORD_FUNCTION)
        return height_function(p, &field->grid);
    bool pot = accept_keyword(p, KEYWORD_POT);
    type = pot ? "pot" : NULL;
    if (!pot && !parse_image_type(p, &type))
        return false;
    struct span span = stream_span(p);
    if (!parse_string(p, &name))
        return false;
    span = span_join(span, p->last_span);
    const char *path =
        file_checked(p, span, "image", name, image_file(p, name, type));
    double gamma;
    if (!path || !parse_decoding(p, &gamma))
        return false;
    struct height_picture picture = { p, span, &field->grid, gamma, pot };
    struct image_rows rows = { picture_begin, picture_take, &picture };
    return image_read_rows(path, &rows, problem, sizeof problem) ||
           (*problem && error_at(p, span, NULL, "can't read the image '%s': %s",
                                 path, problem));
}

/* height_field = "height_field" "{" heights
 *                {"smooth" | "water_level" float | modifier} "}" . */
bool parse_height_field(struct parser *p, struct object **out)
{
    return parse_shape(p, out, &height_field_primitive, parse_heights);
}
