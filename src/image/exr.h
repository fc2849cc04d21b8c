/* OpenEXR files, written without loading OpenImageIO: see exr.c. */
#ifndef IMAGE_EXR_H
#define IMAGE_EXR_H

#include "image/codec.h"

/* For format->type "openexr": half floats, or floats if
 * format->bits are more than 16. The same picture gives the same bytes. */
codec_stream_function exr_encode;

#endif
