/* Heat maps and strips: see heat.h. */
#include "compare/heat.h"

#include <math.h>
#include <string.h>

#include "base/save.h"
#include "base/text.h"
#include "cli/output_name.h"
#include "image/file.h"
#include "image/ramp.h"
#include "image/tone.h"

struct image *heat_picture(const struct plane *plane, double top)
{
    struct image *heat = image_new(plane->width, plane->height);
    size_t pixels = (size_t)plane->width * (size_t)plane->height;
    for (size_t i = 0; i < pixels; i++) {
        ramp_colour(RAMP_MAGMA, (double)plane->values[i] / top,
                    heat->pixels + 4 * i);
        heat->pixels[4 * i + 3] = 1;
    }
    return heat;
}

static void strip_copy(struct image *strip, int x, const struct image *from)
{
    size_t bytes = (size_t)from->width * 4 * sizeof(float);
    for (int y = 0; y < from->height; y++)
        memcpy(image_pixel(strip, x, y), image_pixel(from, 0, y), bytes);
}

static void strip_copy_displayed(struct image *strip, int left,
                                 const struct pair *pair, int which)
{
    const struct image *from = pair->image[which];
    for (int y = 0; y < from->height; y++) {
        for (int x = 0; x < from->width; x++) {
            const float *in = image_pixel(from, x, y);
            float *out = image_pixel(strip, left + x, y);
            for (int c = 0; c < 3; c++)
                out[c] = (float)pair_display(pair, (double)in[c]);
        }
    }
}

struct image *heat_strip(const struct pair *pair, const struct image *heat)
{
    long long width = 3LL * heat->width + 2 * STRIP_GAP;
    if (width > IMAGE_SIDE_LIMIT || width * heat->height > IMAGE_PIXEL_LIMIT)
        return NULL;
    struct image *strip = image_new((int)width, heat->height);
    size_t count = (size_t)strip->width * (size_t)strip->height * 4;
    for (size_t i = 0; i < count; i++)
        strip->pixels[i] = 1;
    int step = heat->width + STRIP_GAP;
    strip_copy_displayed(strip, 0, pair, 0);
    strip_copy_displayed(strip, step, pair, 1);
    strip_copy(strip, 2 * step, heat);
    return strip;
}

static bool heat_fail(struct diag *diag, const char *path, const char *why)
{
    diag_print(diag, DIAG_ERROR, span_none(), NULL, "can't write '%s': %s",
               path, why);
    return false;
}

static const struct output_type *heat_type(const char *path)
{
    const char *extension = path + output_stem(path);
    for (size_t i = 0; output_type_at(i); i++)
        if (text_equal_nocase(extension, output_type_at(i)->extension))
            return output_type_at(i);
    return NULL;
}

bool heat_writable(const char *path, struct diag *diag)
{
    char why[512];
    if (!heat_type(path))
        return heat_fail(diag, path,
                         "its name must end in .png, .exr, .hdr, .jpg, .ppm, "
                         ".tga or .bmp");
    return save_possible(path, why, sizeof why) || heat_fail(diag, path, why);
}

bool heat_write(struct image *image, const char *path, struct diag *diag)
{
    char why[512];
    const struct output_type *type = heat_type(path);
    struct image_format format = { .type = type->format,
                                   .bits = 8,
                                   .quality = 95 };
    size_t pixels = (size_t)image->width * (size_t)image->height;
    bool light = type->letter == 'E' || type->letter == 'H';
    for (size_t i = 0; light && i < pixels; i++)
        for (int c = 0; c < 3; c++) {
            float *value = &image->pixels[4 * i + (size_t)c];
            *value = (float)tone_srgb_decode((double)*value);
        }
    return image_write(image, path, &format, why, sizeof why) ||
           heat_fail(diag, path, why);
}
