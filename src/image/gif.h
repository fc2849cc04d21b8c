/* GIF files: their colours, or the numbers of their palette, which height
 * fields and material_map are made of. OpenImageIO drops the numbers, and its
 * colours are those of the file's whole screen, not of its first picture. */
#ifndef IMAGE_GIF_H
#define IMAGE_GIF_H

#include "image/codec.h"

/* The first picture of the file. */
codec_decode_function gif_decode;

#endif
