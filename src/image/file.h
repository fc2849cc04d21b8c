/* Image files. OpenImageIO does the formats, behind codec.h; naming, atomic
 * replacement and full disks are dealt with here, in C. */
#ifndef IMAGE_FILE_H
#define IMAGE_FILE_H

#include "image/image.h"

/* How to write; see image_write. */
struct image_format {
    const char *type; /* OIIO format name: "png", "openexr", "hdr", "jpeg",
                       * "targa", "bmp", "pnm" */
    int bits;         /* per channel, 1..16; of "openexr" more: floats; not
                       * heeded by the others */
    bool grey, alpha;
    bool packed;      /* run-length coded, for "targa" */
    int quality;      /* JPEG, 1..100 */
    double gamma;     /* written as gAMA: 0 for sRGB */
    const char *note; /* of PNG and OpenEXR: image/note.h; NULL: none */
};

/* Reads an image of the kinds of kind.h; on failure returns NULL and puts the
 * reason into error[size]. 8- and 16-bit numbers become 0..1, not decoded. */
struct image *image_read(const char *path, char *error, size_t size);

/* The same with the colours as they stand in the file, premultiplied if the
 * image's `multiplied` says so; with `numbers` those of the palette of a PNG or
 * GIF, not its colours. */
struct image *image_read_raw(const char *path, bool numbers, char *error,
                             size_t size);

/* Who takes the numbers of a picture without keeping it. */
struct image_rows {
    /* Told first what it is, without pixels; false: it isn't wanted. */
    bool (*begin)(void *context, const struct image *image);
    /* Then each row, from the top. */
    void (*take)(void *context, const struct image *image, int y,
                 const float *pixels);
    void *context;
    bool any_size; /* beyond IMAGE_PIXEL_LIMIT, too */
};

/* As image_read_raw with `numbers`, row by row. False with the reason, which is
 * empty if it wasn't wanted. */
bool image_read_rows(const char *path, const struct image_rows *rows,
                     char *error, size_t size);

/* The size of the picture in the file at `path`, if all of it can be read. On
 * failure (missing, cut short, no image) returns false with the reason. */
bool image_probe(const char *path, int *width, int *height, char *error,
                 size_t size);

/* Writes `image` (values as they are to stand in the file, 0..1 for integer
 * formats, clamped and rounded; not premultiplied but for "openexr") as
 * save_bytes does (base/save.h). On failure returns false with the reason. */
bool image_write(const struct image *image, const char *path,
                 const struct image_format *format, char *error, size_t size);

/* A picture that is given in bands of rows, from the top. */
struct image_bands {
    int width, height;
    /* The band with row y, as an image whose first row is the picture's row
     * *top; it lasts until the next call. NULL: it can't be had. */
    const struct image *(*at)(void *context, int y, int *top);
    void *context;
};

/* As image_write, for "png", "pnm" and "openexr", in memory for one band. */
bool image_write_bands(const struct image_bands *bands, const char *path,
                       const struct image_format *format, char *error,
                       size_t size);

/* Whether image_write_bands can write the format. */
bool image_has_bands(const struct image_format *format);

/* Whether this installation of glim writes pictures of this format; if not,
 * the reason is in error[size]. Quick. */
bool image_can_write(const struct image_format *format, char *error,
                     size_t size);

/* Makes ready for writing a picture of this format, a struct image_format:
 * loads OpenImageIO, which takes 0.3 s, if it is needed. May run on a thread of
 * its own beside anything. */
void image_prepare(void *format);

#endif
