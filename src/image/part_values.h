/* Pixels of four floats as part files have them: only three of those that are
 * opaque, whose fourth is always 1. */
#ifndef IMAGE_PART_VALUES_H
#define IMAGE_PART_VALUES_H

#include <stdbool.h>
#include <stddef.h>

enum {
    PART_RGB = 3 * sizeof(float),
    PART_RGBA = 4 * sizeof(float)
}; /* bytes */

bool values_opaque(const float *values, size_t pixels);

/* The first three floats of each pixel; freed with memory_free. */
float *values_packed(const float *values, size_t pixels);

/* The other way, in place. */
void values_unpack(float *values, size_t pixels);

#endif
