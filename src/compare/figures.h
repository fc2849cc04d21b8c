/* What is counted when two pictures are compared. */
#ifndef COMPARE_FIGURES_H
#define COMPARE_FIGURES_H

#include <stddef.h>

#include "compare/pair.h"

/* The number below which a colour counts as this in relative differences. */
#define FIGURES_DARK 0.01

/* Over all pixels and colours, in the pair's space. Colours that are no finite
 * number in one picture, and not the same in the other, are left out; their
 * pixels are counted in `broken`. */
struct figures {
    double mean, percentile, largest; /* |B - A|; the 99th percentile */
    double mean_relative, percentile_relative; /* |B - A| / max(|A|, dark) */
    double rmse;
    double psnr;        /* dB, of a peak of 1; infinite when rmse is 0 */
    double slope, bias; /* least squares B = slope A + bias; NaN when A is of
                         * one colour */
    double ratio;       /* mean of B / mean of A; NaN when A is black */
    double over;        /* share of pixels one of whose colours, or opacity,
                         * differs by more than the threshold */
    size_t pixels, pixels_over, broken;
};

struct figures figures_find(const struct pair *pair, double threshold);

#endif
