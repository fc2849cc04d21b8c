/* How much of what zones see is each other zone, and how much is sky, by rays
 * from their walls that are spread as light from dull walls is: the form
 * factors of radiosity (Goral, Torrance, Greenberg and Battaile, Modeling the
 * Interaction of Light Between Diffuse Surfaces, 1984), coarsely. What glows
 * lights zones by these rays and by others that pick it. */
#ifndef SKELETON_EXCHANGE_H
#define SKELETON_EXCHANGE_H

#include "skeleton/enclosure.h"
#include "skeleton/sight.h"

/* Puts walls, openings and sky into an enclosure of as many zones as the pieces
 * have. The same for any number of threads. */
void exchange_measure(const struct sight *sight, const struct patches *patches,
                      struct enclosure *enclosure);

#endif
