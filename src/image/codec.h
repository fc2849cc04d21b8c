/* What file.c asks of the C++ half, which is a module of its own, loaded when
 * the first picture is read or written: OpenImageIO brings 250 libraries along
 * and takes 0.3 s of processor time to load, which nobody should wait for who
 * only has an error reported or writes a PNG, a PPM or an EXR. */
#ifndef IMAGE_CODEC_H
#define IMAGE_CODEC_H

#include "image/file.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Filled in by codec_decode, before it allocates. */
struct codec_target {
    const char *type; /* OIIO's name of the file's kind */
    /* Makes room for width * height * 4 floats once the size is known, or
     * returns NULL with the reason in error[size]. */
    float *(*allocate)(void *context, int width, int height, char *error,
                       size_t size);
    /* Not NULL: there is room for one row only, which is taken, row y, as soon
     * as it is there. */
    void (*take)(void *context, int y);
    void *context;
    bool has_alpha, linear;
    bool multiplied; /* the colours, which are as in the file, are by alpha */
    double gamma;
    bool srgb;
    bool plain;
    bool numbers; /* wanted: a palette's numbers, not its colours */
    bool indexed; /* and these are such */
    bool palette; /* the file has one, whatever was wanted of it */
    int channels, bits;
};

/* See image_read_raw. */
typedef bool codec_decode_function(const char *path,
                                   struct codec_target *target, char *error,
                                   size_t size);
codec_decode_function codec_decode;

/* Where a file's bytes go, one after the other. All return false after filling
 * in error[size]. */
struct codec_sink {
    bool (*put)(void *context, const void *bytes, size_t count, char *error,
                size_t size);
    /* Changes bytes that were put before. */
    bool (*patch)(void *context, size_t at, const void *bytes, size_t count,
                  char *error, size_t size);
    void *context;
};

/* As image_write describes. */
typedef bool codec_encode_function(const struct image *image,
                                   const struct image_format *format,
                                   const struct codec_sink *sink, char *error,
                                   size_t size);
codec_encode_function codec_encode;

/* The same of a picture that is never there as a whole. */
typedef bool codec_stream_function(const struct image_bands *bands,
                                   const struct image_format *format,
                                   const struct codec_sink *sink, char *error,
                                   size_t size);

/* The module's: a hash of the sources of image/, in hexadecimal. A module of
 * others would take structs for its own, or what they hold for what it was. */
extern const char codec_build[];

#ifdef __cplusplus
}
#endif

#endif
