/* The list of interpolations: see interpolation.h. */
#include "lightmesh/interpolation.h"

#include "base/listing.h"
#include "lightmesh/tuning.h"

#define X(name) extern const struct interpolation name##_interpolation;
#include "lightmesh/interpolation/list.h"
#undef X

static const struct interpolation *const interpolations[] = {
#define X(name) &name##_interpolation,
#include "lightmesh/interpolation/list.h"
#undef X
};

LISTING(interpolation, interpolation, interpolations);

double interpolation_reach(double radius)
{
    return fmin(fmax(radius, interpolation_least), INTERPOLATION_RADIUS_MAX);
}

int interpolation_ball(vec3 place, double radius,
                       struct mesh_weight out[INTERPOLATION_POINTS])
{
    double r = interpolation_reach(radius);
    int count = 0;
    for (double z = ceil(place.z - r); z <= place.z + r; z++)
        for (double y = ceil(place.y - r); y <= place.y + r; y++)
            for (double x = ceil(place.x - r); x <= place.x + r; x++) {
                vec3 d = vec3_sub(vec3_make(x, y, z), place);
                double left = 1 - vec3_dot(d, d) / (r * r);
                if (left > 0 && count < INTERPOLATION_POINTS)
                    out[count++] =
                        (struct mesh_weight){ { (int)x, (int)y, (int)z },
                                              left };
            }
    return count;
}
