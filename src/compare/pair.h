/* Two pictures of one size, their numbers brought into one space so that an
 * 8-bit PNG can be laid beside a linear EXR. */
#ifndef COMPARE_PAIR_H
#define COMPARE_PAIR_H

#include "image/image.h"

enum pair_space {
    SPACE_DISPLAY, /* sRGB-encoded, as a monitor gets them */
    SPACE_LINEAR,  /* light */
    SPACE_RAW,     /* as they stand in the files */
};

struct pair {
    struct image *image[2]; /* A and B, on black; the alpha of a picture
                             * without one is 1 */
    enum pair_space space;
    bool has_alpha; /* one of them */
    bool identical; /* every number the same */
};

/* Takes over both pictures, which have the same size, and converts them in
 * place. Where one comes from a file of integers, which can't hold more than
 * 1 or less than 0, the other is cut there too, but not in SPACE_RAW. */
struct pair pair_new(struct image *a, struct image *b, enum pair_space space);
void pair_free(struct pair *pair);

/* A colour of the pair's space as seen: linear light or sRGB-encoded, cut to
 * 0..1; NaN becomes 0. Raw numbers are taken for encoded ones. */
double pair_light(const struct pair *pair, double value);
double pair_display(const struct pair *pair, double value);

#endif
