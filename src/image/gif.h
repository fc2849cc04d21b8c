/* GIF files as numbers of their palette: what height fields and material_map
 * are made of. Their colours are read by OpenImageIO, which drops the numbers.
 */
#ifndef IMAGE_GIF_H
#define IMAGE_GIF_H

#include "image/codec.h"

/* The first picture of the file; target->numbers must be wanted. */
codec_decode_function gif_decode;

#endif
