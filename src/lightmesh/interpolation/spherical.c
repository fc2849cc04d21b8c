/* All mesh points within a radius (section 2 of the light-mesh paper). The
 * plain mean of the paper jumps whenever a point comes in or goes out; here
 * the weights fall smoothly to zero at the radius, (1 - d^2/r^2)^2. */
#include "lightmesh/interpolation.h"
#include "lightmesh/tuning.h"

static int spherical_weights(vec3 place, vec3 normal, double radius,
                             struct mesh_weight out[INTERPOLATION_POINTS])
{
    int count = interpolation_ball(place, radius, out);
    (void)normal;
    for (int i = 0; i < count; i++)
        out[i].weight *= out[i].weight;
    return count;
}

const struct interpolation spherical_interpolation = {
    .name = "spherical",
    .help = "all mesh points within a radius, the near ones more",
    .radius = interpolation_usual,
    .weights = spherical_weights,
};
