/* The commonest format, without loading OpenImageIO: see png.c. */
#ifndef IMAGE_PNG_H
#define IMAGE_PNG_H

#include "image/codec.h"

/* For format->type "png". */
codec_stream_function png_encode;

/* As codec_decode, for a file that begins as a PNG. */
codec_decode_function png_decode;

#endif
