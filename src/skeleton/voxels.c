/* Neighbours of voxels: see voxels.h. */
#include "skeleton/voxels.h"

#include <stdlib.h>

size_t voxels_empty_beside(const struct voxels *v, vec3 point, vec3 normal)
{
    static const double per_length[4] = { 0, 1, 0.70710678118654752,
                                          0.57735026918962576 };
    int at[3];
    size_t best = VOXEL_NONE;
    double most = 0;
    if (!voxels_find(v, point, at))
        return VOXEL_NONE;
    for (int i = 0; i < 27; i++) {
        int offset[3] = { i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1 };
        vec3 way = { offset[0], offset[1], offset[2] };
        double along =
            vec3_dot(way, normal) *
            per_length[abs(offset[0]) + abs(offset[1]) + abs(offset[2])];
        if (along <= most)
            continue;
        int next[3] = { at[0] + offset[0], at[1] + offset[1],
                        at[2] + offset[2] };
        if (!voxels_holds(v, next) ||
            !v->empty[voxels_index(v, next[0], next[1], next[2])])
            continue;
        vec3 d = vec3_sub(voxels_centre(v, next), point);
        if (vec3_dot(d, normal) <= 0)
            continue;
        most = along;
        best = voxels_index(v, next[0], next[1], next[2]);
    }
    return best;
}
