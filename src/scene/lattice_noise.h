/* The noise of noise_generator 1 and 2 as it is before it is cut or scaled, and
 * three fields of it; see lattice_noise.c for the source. Of several points,
 * coordinate by coordinate, eight at a time: unless there is one alone there is
 * room for a multiple of eight, whatever is in the last. After a point's fields
 * comes a number that means nothing. */
#ifndef SCENE_LATTICE_NOISE_H
#define SCENE_LATTICE_NOISE_H

#include "scene/noise_tables.h"

enum { LATTICE_STEP = 8 };

struct coordinates {
    const double *x, *y, *z;
};

void lattice_noise(struct coordinates at, int count, float *raw);
void lattice_noise_fields(struct coordinates at, int count,
                          float (*raw)[NOISE_ROOM]);

#endif
