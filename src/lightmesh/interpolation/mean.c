/* The light-mesh paper's own interpolation, equation (3): the plain mean of all
 * mesh points within a radius. It jumps wherever a point comes in or goes out;
 * `spherical` does not. */
#include "lightmesh/interpolation.h"
#include "lightmesh/tuning.h"

static int mean_weights(vec3 place, vec3 normal, double radius,
                        struct mesh_weight out[INTERPOLATION_POINTS])
{
    int count = interpolation_ball(place, radius, out);
    (void)normal;
    for (int i = 0; i < count; i++)
        out[i].weight = 1;
    return count;
}

const struct interpolation mean_interpolation = {
    .name = "mean",
    .help =
        "the plain mean of all mesh points within a radius, as in the paper",
    .radius = interpolation_usual,
    .weights = mean_weights,
};
