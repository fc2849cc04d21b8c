/* How fast an isosurface's function must be said to change, for rays to find
 * its surface: measured on chords of the container. Of two places with values
 * of one sign and crossings between them, a search that leaves out stretches by
 * the largest gradient misses these unless it is as large as this. */
#include "base/random.h"
#include "scene/isosurface.h"
#include "scene/spots.h"

enum { PLACES = 32 }; /* of a chord */

/* In the box around the container. */
static vec3 chord_place(const struct box3 *box, uint64_t key)
{
    return vec3_make(
        box->low.x + random_unit(key) * (box->high.x - box->low.x),
        box->low.y + random_unit(key + 1) * (box->high.y - box->low.y),
        box->low.z + random_unit(key + 2) * (box->high.z - box->low.z));
}

static void chord_values(const struct isosurface *s, const struct ray *ray,
                         double from, double step, double values[PLACES])
{
    for (int first = 0; first < PLACES; first += OCTET) {
        struct spots spots;
        spots.count = 0;
        for (int i = 0; i < OCTET; i++)
            spots_add(&spots, ray_point(ray, from + (first + i) * step));
        isosurface_values(s, &spots, values + first);
    }
}

static double chord_gradient(const double values[PLACES], double step)
{
    double most = 0;
    for (int i = 0; i < PLACES; i++) {
        bool crossed = false;
        for (int j = i + 1; j < PLACES; j++) {
            bool same = (values[i] < 0) == (values[j] < 0);
            double slope =
                (fabs(values[i]) + fabs(values[j])) / ((j - i) * step);
            if (same && crossed && isfinite(slope))
                most = fmax(most, slope);
            crossed |= !same;
        }
    }
    return most;
}

double isosurface_gradient(const struct isosurface *s, int chords)
{
    struct container container = s->container;
    double most = 0, values[PLACES];
    if (container_prepare(&container))
        return 0;
    for (int i = 0; i < chords; i++) {
        uint64_t key = random_key(1, (uint64_t)i);
        vec3 from = chord_place(&container.box, key);
        vec3 to = chord_place(&container.box, random_mix(key));
        struct ray ray = { from, vec3_normalise(vec3_sub(to, from)) };
        struct hit ends[2];
        if (!container_interval(&container, &ray, ISOSURFACE_CONTAINER, ends))
            continue;
        double step = (ends[1].t - ends[0].t) / (PLACES - 1);
        if (!(step > s->accuracy))
            continue;
        chord_values(s, &ray, ends[0].t, step, values);
        most = fmax(most, chord_gradient(values, step));
    }
    return most;
}
