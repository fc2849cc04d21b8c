/* See part_values.h. */
#include "image/part_values.h"

#include "base/memory.h"

bool values_opaque(const float *values, size_t pixels)
{
    size_t others = 0;
    for (size_t i = 0; i < pixels; i++)
        others += values[4 * i + 3] != 1;
    return others == 0;
}

float *values_packed(const float *values, size_t pixels)
{
    float *packed = memory_resize(NULL, pixels * PART_RGB);
    for (size_t i = 0; i < pixels; i++)
        for (size_t k = 0; k < 3; k++)
            packed[3 * i + k] = values[4 * i + k];
    return packed;
}

/* From the last on, nothing is overwritten too early. */
void values_unpack(float *values, size_t pixels)
{
    for (size_t i = pixels; i-- > 0;) {
        values[4 * i + 3] = 1;
        for (size_t k = 3; k-- > 0;)
            values[4 * i + k] = values[3 * i + k];
    }
}
