/* Two pictures in one space: see pair.h. */
#include "compare/pair.h"

#include <math.h>

#include "image/tone.h"

/* A file's number, its colour not multiplied by alpha, as linear light. */
static double pair_decode(const struct image *image, double value)
{
    return image->linear ? value : tone_decode(value, image->gamma);
}

/* One colour into the space. Colours of integer files were encoded before
 * they are seen on black: they are multiplied by alpha as light. */
static double pair_convert(const struct image *image, double value,
                           double alpha, enum pair_space space)
{
    bool as_stored = image->linear ? space == SPACE_LINEAR
                                   : space == SPACE_DISPLAY &&
                                         image->gamma == 0 && alpha == 1;
    if (as_stored)
        return value;
    bool straighten = !image->linear && alpha > 0;
    double light = straighten ? alpha * pair_decode(image, value / alpha)
                              : pair_decode(image, value);
    return space == SPACE_LINEAR ? light : tone_srgb_encode(light);
}

static void pair_convert_image(struct image *image, enum pair_space space,
                               bool cut)
{
    size_t count = (size_t)image->width * (size_t)image->height;
    for (size_t i = 0; i < count; i++) {
        float *pixel = image->pixels + 4 * i;
        for (int c = 0; c < 3 && space != SPACE_RAW; c++) {
            double value =
                pair_convert(image, (double)pixel[c], (double)pixel[3], space);
            if (cut && !isnan(value))
                value = fmin(fmax(value, 0), 1);
            pixel[c] = (float)value;
        }
    }
}

/* A NaN is the same as a NaN: a file is identical to itself. */
static bool pair_is_identical(const struct image *a, const struct image *b)
{
    size_t count = (size_t)a->width * (size_t)a->height * 4;
    for (size_t i = 0; i < count; i++)
        if (a->pixels[i] != b->pixels[i] &&
            !(isnan(a->pixels[i]) && isnan(b->pixels[i])))
            return false;
    return true;
}

struct pair pair_new(struct image *a, struct image *b, enum pair_space space)
{
    struct pair pair = {
        .image = { a, b },
        .space = space,
        .has_alpha = a->has_alpha || b->has_alpha,
    };
    pair_convert_image(a, space, a->linear && !b->linear);
    pair_convert_image(b, space, b->linear && !a->linear);
    pair.identical = pair_is_identical(a, b);
    return pair;
}

void pair_free(struct pair *pair)
{
    for (int i = 0; i < 2; i++) {
        image_free(pair->image[i]);
        pair->image[i] = NULL;
    }
}

static double pair_cut(double value)
{
    return value > 0 ? fmin(value, 1) : 0; /* so written that NaN gives 0 */
}

double pair_light(const struct pair *pair, double value)
{
    value = pair_cut(value);
    return pair->space == SPACE_LINEAR ? value : tone_srgb_decode(value);
}

double pair_display(const struct pair *pair, double value)
{
    value = pair_cut(value);
    return pair->space == SPACE_LINEAR ? tone_srgb_encode(value) : value;
}
