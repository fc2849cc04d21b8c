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

enum { LAYERS_MOST = 2 * ((int)INTERPOLATION_RADIUS_MAX + 1) };

/* The layers of the lattice across an axis that are near enough. */
struct layers {
    int first, count;
    double rise[LAYERS_MOST], square[LAYERS_MOST]; /* each one's share of a
                                                    * point's height over the
                                                    * place and of its
                                                    * distance's square */
};

static void layers_find(struct layers *layers, double place, double normal,
                        double radius)
{
    double reach = smooth_extent(normal, radius), least = ceil(place - reach);
    double most = floor(place + reach);
    layers->count = 0;
    if (!(most - least < LAYERS_MOST))
        return;
    layers->first = (int)least;
    layers->count = (int)(most - least) + 1;
    for (int i = 0; i < layers->count; i++) {
        double away = least + i - place;
        layers->rise[i] = away * normal;
        layers->square[i] = away * away;
    }
}

static int smooth_weights(vec3 place, vec3 normal, double radius,
                          struct mesh_weight out[INTERPOLATION_POINTS])
{
    const double r = interpolation_reach(radius), part = 1 / (r * r);
    struct layers x, y, z;
    int count = 0;
    layers_find(&x, place.x, normal.x, r);
    layers_find(&y, place.y, normal.y, r);
    layers_find(&z, place.z, normal.z, r);
    for (int k = 0; k < z.count; k++)
        for (int j = 0; j < y.count; j++) {
            double row_rise = z.rise[k] + y.rise[j];
            double row_square = z.square[k] + y.square[j];
            for (int i = 0; i < x.count; i++) {
                double rise = row_rise + x.rise[i];
                double across = 1 - fabs(rise);
                double aside = row_square + x.square[i] - rise * rise;
                double along = 1 - aside * part;
                if (across > 0 && along > 0 && count < INTERPOLATION_POINTS)
                    out[count++] =
                        (struct mesh_weight){ { x.first + i, y.first + j,
                                                z.first + k },
                                              along * along * across };
            }
        }
    return count;
}

const struct interpolation smooth_interpolation = {
    .name = "smooth",
    .help = "within a radius along the surface, linear across it",
    .radius = interpolation_usual,
    .weights = smooth_weights,
};
