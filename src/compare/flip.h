/* FLIP: how different two pictures look when they are shown by turns. */
#ifndef COMPARE_FLIP_H
#define COMPARE_FLIP_H

#include "compare/pair.h"
#include "compare/plane.h"

/* Pixels in a degree of the viewer's eye: 0.7 m away from a monitor 0.7 m wide
 * with 3840 pixels, the paper's. At most FLIP_PIXELS_LIMIT. */
#define FLIP_PIXELS_PER_DEGREE 67.0
#define FLIP_PIXELS_LIMIT      400.0

/* For each pixel 0 (alike) to 1; freed by plane_free. The paper's one figure
 * for a picture is the mean. */
struct plane flip_map(const struct pair *pair, double pixels_per_degree);

#endif
