/* Adaptive meshes: see refine.h. */
#include "lightmesh/refine.h"

#include <math.h>

#include "base/smooth.h"

static double rgb_size(rgb c)
{
    return fabs(c.r) + fabs(c.g) + fabs(c.b);
}

double refine_difference(const struct refine_views *views)
{
    rgb mean = rgb_grey(0);
    double apart = 0;
    for (int i = 0; i < views->count; i++)
        mean = rgb_add_scaled(mean, views->at[i].light, views->at[i].weight);
    for (int i = 0; i < views->count; i++)
        apart += views->at[i].weight *
                 rgb_size(rgb_add_scaled(views->at[i].light, mean, -1));
    double whole = rgb_size(mean);
    return (whole > 0 ? 2 * apart / whole : 0) + views->hidden;
}

double refine_share(const struct refinement *refinement, double difference)
{
    return smooth_step(difference / refinement->threshold - 1);
}
