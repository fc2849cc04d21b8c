/* OpenEXR files, written without loading OpenImageIO: see exr.c. */
#ifndef IMAGE_EXR_H
#define IMAGE_EXR_H

#include "image/codec.h"

/* As codec_encode, for format->type "openexr": half floats, or floats if
 * format->bits are more than 16. The same picture gives the same bytes. */
codec_encode_function exr_encode;

#endif
