/* A picture in memory: float RGBA, linear light or not as its maker says. */
#ifndef IMAGE_IMAGE_H
#define IMAGE_IMAGE_H

#include <stdbool.h>
#include <stddef.h>

/* The largest picture: 16 bytes a pixel make 4 GiB of it. */
enum { IMAGE_SIDE_LIMIT = 65535, IMAGE_PIXEL_LIMIT = 1 << 28 };

struct image {
    int width, height;
    float *pixels;   /* width * height * 4, row by row from the top; alpha is
                      * opacity, colours are premultiplied by it, but of what
                      * is read raw and of a scene's if `multiplied` is false */
    bool has_alpha;  /* read: the file had one */
    bool multiplied; /* read: colours were premultiplied in the file */
    bool linear;     /* read: the file's numbers are linear light (EXR, HDR) */
    double gamma;    /* read: they are light to the power 1/gamma, says the
                      * file (PNG); 0: it says nothing, */
    bool srgb;       /* or that they are those of sRGB */
    int channels;    /* read: 1 grey, 2 with alpha, 3 colour, 4 with alpha */
    int bits;        /* read: of a channel, 8 or more */
    bool indexed;    /* read as numbers: pixels are a palette's
                      * numbers, 1 being 255 */
    bool palette;    /* read: the file has one (PNG, GIF) */
    bool png;        /* read: of this kind */
    bool plain;      /* read: of a kind whose numbers POV-Ray takes for the
                      * scene's own, whatever they are (PPM, PGM, TIFF) */
};

/* Black, transparent. Freed by image_free. Never NULL. Both sides are at
 * least 1 and within the limits above. */
struct image *image_new(int width, int height);
void image_free(struct image *image);

static inline float *image_pixel(const struct image *image, int x, int y)
{
    return image->pixels + ((size_t)y * (size_t)image->width + (size_t)x) * 4;
}

#endif
