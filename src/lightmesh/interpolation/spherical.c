/* All mesh points within a radius (section 2 of the light-mesh paper). The
 * plain mean of the paper jumps whenever a point comes in or goes out; here
 * the weights fall smoothly to zero at the radius, (1 - d^2/r^2)^2. */
#include "lightmesh/interpolation.h"

static int spherical_weights(vec3 place, vec3 normal, double radius,
                             struct mesh_weight out[INTERPOLATION_POINTS])
{
    double r = fmin(fmax(radius, 0.9), INTERPOLATION_RADIUS_MAX);
    int count = 0;
    (void)normal;
    for (double z = ceil(place.z - r); z <= place.z + r; z++)
        for (double y = ceil(place.y - r); y <= place.y + r; y++)
            for (double x = ceil(place.x - r); x <= place.x + r; x++) {
                vec3 d = vec3_sub(vec3_make(x, y, z), place);
                double left = 1 - vec3_dot(d, d) / (r * r);
                if (left > 0 && count < INTERPOLATION_POINTS)
                    out[count++] =
                        (struct mesh_weight){ { (int)x, (int)y, (int)z },
                                              left * left };
            }
    return count;
}

const struct interpolation spherical_interpolation = {
    .name = "spherical",
    .help = "all mesh points within a radius, the near ones more",
    .radius = 1.6,
    .weights = spherical_weights,
};
