/* Image files through OpenImageIO; file.cpp is the only C++ in the program. */
#ifndef IMAGE_FILE_H
#define IMAGE_FILE_H

#include "image/image.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How to write; see image_write. */
struct image_format {
    const char *type; /* OIIO format name: "png", "openexr", "hdr", "jpeg",
                       * "targa", "bmp", "pnm" */
    int bits;         /* per channel: 8 or 16; ignored by float formats */
    bool grey, alpha;
    int quality;  /* JPEG, 1..100 */
    double gamma; /* written as gAMA: 0 for sRGB */
};

/* Reads any image OIIO knows; on failure returns NULL and puts OIIO's words
 * into error[size]. 8- and 16-bit numbers become 0..1, not decoded. */
struct image *image_read(const char *path, char *error, size_t size);

/* Writes `image` (values as they are to stand in the file, 0..1 for integer
 * formats, clamped and rounded) under a temporary name beside `path`, then
 * renames. "-" writes to standard output. On failure returns false, leaves no
 * file and an older picture as it was. */
bool image_write(const struct image *image, const char *path,
                 const struct image_format *format, char *error, size_t size);

#ifdef __cplusplus
}
#endif

#endif
