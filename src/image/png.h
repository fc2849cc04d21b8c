/* The commonest format, written without loading OpenImageIO: see png.c. */
#ifndef IMAGE_PNG_H
#define IMAGE_PNG_H

#include "image/codec.h"

/* As codec_encode, for format->type "png". */
codec_encode_function png_encode;

#endif
