/* A block of numbers from a df3 file: the density_file pattern. */
#ifndef SCENE_DENSITY_FILE_H
#define SCENE_DENSITY_FILE_H

#include "base/field.h"

struct density_file {
    int size[3];                /* along x, y, z; each at least 1 */
    const unsigned char *bytes; /* x first, of each number the high byte */
    int width;                  /* bytes of a number: 1, 2 or 4 */
    int interpolation;          /* of what lies between: 0 none, 1 linear,
                                 * from 2 on cubic */
    struct terms samples;       /* what tells it from others */
};

#endif
