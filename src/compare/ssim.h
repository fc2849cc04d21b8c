/* The structural similarity index of two pictures. */
#ifndef COMPARE_SSIM_H
#define COMPARE_SSIM_H

#include "compare/pair.h"

/* The mean over the picture: 1 for identical pictures, down to -1. Of luma, as
 * displayed. */
double ssim_mean(const struct pair *pair);

#endif
