/* Points side by side: see spots.h. */
#include "scene/spots.h"

#include "base/clones.h"

CLONES void spots_moved(const struct spots *restrict spots,
                        const affine *transform, struct spots *restrict moved)
{
    const affine move = *transform;
    moved->count = spots->count;
    for (int i = 0; i < spots->count; i++)
        spots_put(moved, i, affine_point(&move, spots_at(spots, i)));
}
