/* Along the surface all mesh points within a radius, across it the two layers
 * around the place, linearly: what differs from point to point by chance is
 * evened out, and no points are asked for that are farther from the surface
 * than between the corners of a cell. */
#include "lightmesh/interpolation.h"
#include "lightmesh/tuning.h"

/* How far the points may be along an axis: a disc of that radius, as thick as
 * two layers. */
static double smooth_extent(double normal, double radius)
{
    return fabs(normal) + sqrt(fmax(1 - normal * normal, 0)) * radius;
}

static int smooth_weights(vec3 place, vec3 normal, double radius,
                          struct mesh_weight out[INTERPOLATION_POINTS])
{
    double r = interpolation_reach(radius);
    vec3 reach = { smooth_extent(normal.x, r), smooth_extent(normal.y, r),
                   smooth_extent(normal.z, r) };
    int count = 0;
    for (double z = ceil(place.z - reach.z); z <= place.z + reach.z; z++)
        for (double y = ceil(place.y - reach.y); y <= place.y + reach.y; y++)
            for (double x = ceil(place.x - reach.x); x <= place.x + reach.x;
                 x++) {
                vec3 d = vec3_sub(vec3_make(x, y, z), place);
                double rise = vec3_dot(d, normal);
                double across = 1 - fabs(rise);
                double along = 1 - (vec3_dot(d, d) - rise * rise) / (r * r);
                if (across > 0 && along > 0 && count < INTERPOLATION_POINTS)
                    out[count++] =
                        (struct mesh_weight){ { (int)x, (int)y, (int)z },
                                              along * along * across };
            }
    return count;
}

const struct interpolation smooth_interpolation = {
    .name = "smooth",
    .help = "within a radius along the surface, linear across it",
    .radius = interpolation_usual,
    .weights = smooth_weights,
};
