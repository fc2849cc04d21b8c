/* What kind of picture a file holds: see kind.c. */
#ifndef IMAGE_KIND_H
#define IMAGE_KIND_H

#include <stddef.h>

/* What glim reads, in words. */
#define KIND_NAMES "BMP, EXR, GIF, HDR, IFF, JPEG, PNG, PNM, TGA or TIFF"

/* OpenImageIO's name of it ("png", "openexr"), by the first `count` bytes of
 * the file, of which KIND_BYTES are enough; NULL: none that glim reads. */
enum { KIND_BYTES = 32 };
const char *kind_of_bytes(const unsigned char *bytes, size_t count);

#endif
