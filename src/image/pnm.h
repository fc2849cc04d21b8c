/* PPM and PGM files without loading OpenImageIO: see pnm.c. */
#ifndef IMAGE_PNM_H
#define IMAGE_PNM_H

#include "image/codec.h"

/* For format->type "pnm": bytes, or two of each for more than 8 bits. */
codec_stream_function pnm_encode;

/* Whether pnm_decode reads this file, which begins as one of the family: whole,
 * in colour or grey, of bytes up to 255. */
bool pnm_is_ours(const char *path);

/* As codec_decode. */
codec_decode_function pnm_decode;

#endif
