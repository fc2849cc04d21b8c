/* JPEG files, read without loading OpenImageIO: see jpeg.c. */
#ifndef IMAGE_JPEG_H
#define IMAGE_JPEG_H

#include <stdbool.h>

#include "image/codec.h"

/* Whether jpeg_decode reads this file, which begins as a JPEG: all but those
 * in printers' inks. */
bool jpeg_is_ours(const char *path);

/* Whether it has no more passes than jpeg_decode would go over, for the others;
 * else the reason. */
bool jpeg_passes_few(const char *path, char *error, size_t size);

/* As codec_decode. */
codec_decode_function jpeg_decode;

#endif
