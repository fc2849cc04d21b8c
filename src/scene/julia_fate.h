/* Whether points stay under a julia_fractal's steps, and how far all do as they
 * do, eight at a time: what rays ask at each of their own steps. For squares
 * and cubes of quaternions, and for squares of hypercomplex numbers. */
#ifndef SCENE_JULIA_FATE_H
#define SCENE_JULIA_FATE_H

#include "base/octet.h"
#include "scene/julia_fractal.h"

/* Points of space. */
struct julia_points {
    octet x, y, z;
};

struct julia_fates {
    octet_bits gone;
    octet distance; /* a ray may go on so far before that changes: by an
                     * estimate that is nearly as far as can be; or 0 */
};

/* Of the points where `open` is set; nothing is said of the others. */
void julia_fates_find(const struct julia_fractal *fractal,
                      const struct julia_points *points, const octet_bits *open,
                      struct julia_fates *fates);

/* The logarithm of their sizes after the last step by the radius, doubled, and
 * no more than some thousand: above 0 they are gone. Where what was gone may
 * have come back, 1 or -1. */
void julia_fates_beyond(const struct julia_fractal *fractal,
                        const struct julia_points *points,
                        const octet_bits *open, octet *beyond);

#endif
