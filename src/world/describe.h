/* From a crossing of a leaf to all that there is to know of it. */
#ifndef WORLD_DESCRIBE_H
#define WORLD_DESCRIBE_H

#include "world/world.h"

/* `hit` is whole: nothing of it is left out (query.h). */
void describe_hit(const struct ray *ray, const struct leaf *leaf,
                  const struct hit *hit, struct intersection *out);

#endif
