/* The single nearest mesh point (section 2 of the light-mesh paper); the next
 * nearest if that one can't be used. Shows its cells. */
#include "lightmesh/interpolation.h"

static void nearest_sort(struct mesh_weight *points, int count)
{
    for (int i = 1; i < count; i++) {
        struct mesh_weight point = points[i];
        int j = i;
        for (; j > 0 && points[j - 1].weight < point.weight; j--)
            points[j] = points[j - 1];
        points[j] = point;
    }
}

static int nearest_weights(vec3 place, vec3 normal, double radius,
                           struct mesh_weight out[INTERPOLATION_POINTS])
{
    vec3 low = vec3_make(floor(place.x), floor(place.y), floor(place.z));
    (void)normal;
    (void)radius;
    for (int corner = 0; corner < 8; corner++) {
        int at[3] = { (int)low.x + (corner & 1), (int)low.y + (corner >> 1 & 1),
                      (int)low.z + (corner >> 2) };
        vec3 offset = vec3_sub(vec3_make(at[0], at[1], at[2]), place);
        out[corner] =
            (struct mesh_weight){ { at[0], at[1], at[2] },
                                  1 / (1 + vec3_dot(offset, offset)) };
    }
    nearest_sort(out, 8);
    return 8;
}

const struct interpolation nearest_interpolation = {
    .name = "nearest",
    .help = "the nearest mesh point alone",
    .radius = 1,
    .single = true,
    .weights = nearest_weights,
};
