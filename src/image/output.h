/* From the working space of a scene to the numbers of a file: section 5.9 of
 * tests/povray.md, and measured on POV-Ray 3.7. */
#ifndef IMAGE_OUTPUT_H
#define IMAGE_OUTPUT_H

#include "image/image.h"

struct output_space {
    double working_gamma; /* v^working_gamma is linear light; 0: sRGB curve */
    /* No assumed_gamma: the numbers go out as they are, whatever the file's
     * gamma. Only float files are decoded, as sRGB. */
    bool keep_numbers;
    bool linear_file;  /* float formats: linear light, premultiplied */
    bool no_negative;  /* of those, Radiance's */
    bool half;         /* of those, half floats: none beyond 65504 */
    double file_gamma; /* of the others; 0: sRGB */
    bool alpha;        /* the file has opacity; else the picture is on black */
    bool grey;         /* all three channels become the luminance */
    int bits;          /* of a PNG: its numbers may be rounded; 0: exact */
};

/* Turns the picture into the file's numbers, in place. Integer files get
 * colours not premultiplied, as PNG wants them, in 0..1; float files get
 * finite numbers. NaN becomes 0. Of many numbers with up to 8 bits each is
 * made the level that it will be rounded to. */
void output_convert(struct image *image, const struct output_space *space,
                    unsigned threads);

/* Whether the file has no opacity and at most 256 levels of each of three
 * channels: then they are all that has to be known of finished pixels. */
bool output_has_levels(const struct output_space *space);

enum { OUTPUT_LEVELS = 3 }; /* bytes of a pixel */

struct tone_table;

/* For such a space: what the next three want. */
void output_levels_fill(const struct output_space *space,
                        struct tone_table *table);

/* Of pixels of the working space, four floats each; they may begin at the same
 * place. */
void output_levels_of(const struct tone_table *table, const float *pixels,
                      size_t count, unsigned char *levels);

/* The other way, to opaque pixels: numbers of the working space that have those
 * levels, and the file's numbers. */
void output_levels_working(const struct tone_table *table,
                           const unsigned char *levels, size_t count,
                           float *pixels);
void output_levels_numbers(const struct tone_table *table,
                           const unsigned char *levels, size_t count,
                           float *pixels);

#endif
