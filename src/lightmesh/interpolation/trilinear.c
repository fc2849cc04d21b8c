/* The eight corners of the cell, linear along each axis: continuous, and the
 * fewest points that are. */
#include "lightmesh/interpolation.h"

static int trilinear_weights(vec3 place, vec3 normal, double radius,
                             struct mesh_weight out[INTERPOLATION_POINTS])
{
    vec3 low = vec3_make(floor(place.x), floor(place.y), floor(place.z));
    vec3 t = vec3_sub(place, low);
    int count = 0;
    (void)normal;
    (void)radius;
    for (int corner = 0; corner < 8; corner++) {
        int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
        double weight =
            (i ? t.x : 1 - t.x) * (j ? t.y : 1 - t.y) * (k ? t.z : 1 - t.z);
        if (weight <= 0)
            continue;
        out[count++] = (struct mesh_weight){
            { (int)low.x + i, (int)low.y + j, (int)low.z + k }, weight
        };
    }
    return count;
}

const struct interpolation trilinear_interpolation = {
    .name = "trilinear",
    .help = "between the eight corners of the cell",
    .radius = 1,
    .weights = trilinear_weights,
};
