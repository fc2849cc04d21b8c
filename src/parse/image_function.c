/* A picture made by a function: image_map { function W, H { ... } }. */
#include "image/image.h"
#include "parse/rules.h"
#include "parse/user_function.h"
#include "scene/function.h"

enum {
    PICTURE_PIXELS = 1 << 24,
    PICTURE_STEPS = 1000000000,
};

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

static void picture_pixel(const struct function *function, vec3 point,
                          unsigned long *steps_left, float pixel[4])
{
    const double arguments[] = { point.x, point.y, point.z };
    double c[5] = { 0 };
    if (function->values)
        function->values->at(function->values, point, c);
    else
        c[0] = c[1] = c[2] =
            picture_number(function_evaluate(function, arguments, steps_left));
    double alpha = fmin(fmax(1 - c[4], 0), 1);
    for (int i = 0; i < 3; i++)
        pixel[i] = isfinite(c[i]) ? (float)c[i] : 0;
    pixel[3] = (float)alpha;
}

bool parse_image_of_function(struct parser *p, const struct image **out)
{
    const struct function *function;
    struct image *image = ARENA_NEW(p->scene_arena, struct image);
    struct span span = stream_span(p);
    int width, height;
    if (!parse_function_image(p, &width, &height, &function))
        return false;
    span = span_join(span, p->last_span);
    if (!picture_room(p, span, width, height))
        return false;
    double pixels = (double)width * height;
    unsigned long left = PICTURE_STEPS;
    *image = (struct image){ .width = width, .height = height };
    image->pixels = ARENA_ARRAY(p->scene_arena, float, 4 * (size_t)pixels);
    bool slow = pixels * function->work > PICTURE_STEPS;
    for (int y = 0; y < height && !slow; y++) {
        if (stream_stopped(p))
            return false;
        for (int x = 0; x < width && left > 0; x++) {
            vec3 point = { width > 1 ? (double)x / (width - 1) : 0,
                           height > 1 ? (double)y / (height - 1) : 0, 0 };
            picture_pixel(function, point, &left, image_pixel(image, x, y));
        }
    }
    *out = image;
    return (!slow && left > 0) ||
           error_at(p, span, NULL,
                    "all pixels together take more than %d steps of the "
                    "function, glim's limit",
                    PICTURE_STEPS);
}
