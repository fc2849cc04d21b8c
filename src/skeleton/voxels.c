/* Neighbours of voxels: see voxels.h. */
#include "skeleton/voxels.h"

size_t voxels_empty_beside(const struct voxels *v, vec3 point, vec3 normal)
{
    int at[3];
    size_t best = VOXEL_NONE;
    double most = 0;
    if (!voxels_find(v, point, at))
        return VOXEL_NONE;
    for (int i = 0; i < 27; i++) {
        vec3 offset = { i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1 };
        int next[3] = { at[0] + (int)offset.x, at[1] + (int)offset.y,
                        at[2] + (int)offset.z };
        if (!voxels_holds(v, next))
            continue;
        size_t index = voxels_index(v, next[0], next[1], next[2]);
        vec3 d = vec3_sub(voxels_centre(v, next), point);
        double along = vec3_dot(vec3_normalise(offset), normal);
        if (!v->empty[index] || vec3_dot(d, normal) <= 0 || along <= most)
            continue;
        most = along;
        best = index;
    }
    return best;
}
