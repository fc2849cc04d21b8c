/* A picture made by a function: image_map { function W, H { ... } }. */
#include <string.h>

#include "image/image.h"
#include "parse/function_picture.h"
#include "parse/rules.h"
#include "parse/user_function.h"

enum { PICTURE_PIXELS = 1 << 24 };

static bool picture_room(struct parser *p, struct span span, int width,
                         int height)
{
    double pixels = (double)width * height;
    size_t limit = arena_limit(p->scene_arena);
    size_t used = arena_used(p->scene_arena);
    if (width < 1 || height < 1 || pixels > PICTURE_PIXELS)
        return error_at(p, span, NULL,
                        "a function's picture has 1 to %d pixels, found %d by "
                        "%d",
                        PICTURE_PIXELS, width, height);
    return !limit ||
           (used < limit &&
            pixels * 4 * sizeof(float) < (double)(limit - used)) ||
           error_at(p, span, NULL,
                    "with this picture the scene needs more memory than the "
                    "limit of %zu MiB",
                    limit >> 20);
}

/* In two bytes, so that what is above 1 begins at 0 again (measured). */
static double picture_number(double value)
{
    double number = trunc(value * 65535);
    return (number - 65536 * floor(number / 65536)) / 65535;
}

static void picture_pixel(const struct function_piece *piece, bool colours,
                          int i, float pixel[4])
{
    double c[5] = { 0 };
    if (colours)
        memcpy(c, piece->parts[i], sizeof c);
    else
        c[0] = c[1] = c[2] = picture_number(piece->values[i]);
    double alpha = fmin(fmax(1 - c[4], 0), 1);
    for (int k = 0; k < 3; k++)
        pixel[k] = isfinite(c[k]) ? (float)c[k] : 0;
    pixel[3] = (float)alpha;
}

static bool picture_row(struct function_picture *picture, struct image *image,
                        int y)
{
    struct function_piece piece;
    for (int x = 0; x < image->width; x += piece.count) {
        if (!function_picture_piece(picture, x, y, &piece))
            return false;
        for (int i = 0; i < piece.count; i++)
            picture_pixel(&piece, picture->function->values != NULL, i,
                          image_pixel(image, x + i, y));
    }
    return true;
}

bool parse_image_of_function(struct parser *p, const struct image **out)
{
    const struct function *function;
    struct image *image = ARENA_NEW(p->scene_arena, struct image);
    struct span span = stream_span(p);
    int width, height;
    bool ok = true;
    if (!parse_function_image(p, &width, &height, &function))
        return false;
    span = span_join(span, p->last_span);
    if (!picture_room(p, span, width, height))
        return false;
    struct function_picture picture =
        function_picture_new(function, width, height);
    *image = (struct image){ .width = width, .height = height };
    image->pixels =
        ARENA_ARRAY(p->scene_arena, float, 4 * (size_t)width * (size_t)height);
    *out = image;
    for (int y = 0; y < height && ok; y++) {
        if (stream_stopped(p))
            return false;
        ok = picture_row(&picture, image, y);
    }
    return ok || error_at(p, span, NULL,
                          "all pixels together take more than %d steps of the "
                          "function, glim's limit",
                          FUNCTION_PICTURE_STEPS);
}
