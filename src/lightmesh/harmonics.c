/* Irradiance from spherical harmonics: see harmonics.h. */
#include "lightmesh/harmonics.h"

/* The zonal ones of max(0, cosine)^b are
 * integrals of t^b P_l(t) over [0,1], times 2 pi; for b = 1 pi, 2 pi / 3 and
 * pi / 4. */
void harmonics_weights(vec3 normal, double brilliance,
                       double weights[HARMONICS])
{
    const double tau = 6.283185307179586;
    double b = brilliance;
    double order0 = tau / (b + 1), order1 = tau / (b + 2);
    double order2 = tau / 2 * (3 / (b + 3) - 1 / (b + 1));
    harmonics_basis(normal, weights);
    for (int i = 0; i < HARMONICS; i++)
        weights[i] *= i == 0 ? order0 : i < 4 ? order1 : order2;
}

void harmonics_bump(vec3 side, vec3 normal, double weights[HARMONICS])
{
    double behind[HARMONICS], part = (1 - vec3_dot(side, normal)) / 2;
    harmonics_weights(normal, 1, weights);
    harmonics_weights(vec3_negate(side), 1, behind);
    for (int i = 0; i < HARMONICS; i++)
        weights[i] -= part * behind[i];
}

rgb harmonics_weighted(const struct harmonics *harmonics,
                       const double weights[HARMONICS])
{
    rgb light = rgb_grey(0);
    for (int i = 0; i < HARMONICS; i++) {
        light.r += weights[i] * (double)harmonics->r[i];
        light.g += weights[i] * (double)harmonics->g[i];
        light.b += weights[i] * (double)harmonics->b[i];
    }
    return rgb_make(fmax(light.r, 0), fmax(light.g, 0), fmax(light.b, 0));
}

double harmonics_weighted_share(const float share[HARMONICS],
                                const double weights[HARMONICS])
{
    double sum = 0;
    for (int i = 0; i < HARMONICS; i++)
        sum += weights[i] * (double)share[i];
    return fmin(fmax(sum, 0), 1);
}

double harmonics_share(const float share[HARMONICS], vec3 normal)
{
    double weights[HARMONICS];
    harmonics_weights(normal, 1, weights);
    return harmonics_weighted_share(share, weights);
}

/* Order 1 is the vector sum of the light, x, y and z in places 3, 1 and 2. */
static vec3 harmonics_vector(const float order[HARMONICS])
{
    vec3 sum = { (double)order[3], (double)order[1], (double)order[2] };
    return vec3_scale(sum, 1 / 0.48860251190291992);
}

vec3 harmonics_direction(const struct harmonics *harmonics, rgb *light)
{
    vec3 r = harmonics_vector(harmonics->r);
    vec3 g = harmonics_vector(harmonics->g);
    vec3 b = harmonics_vector(harmonics->b);
    vec3 direction = vec3_normalise(vec3_add(r, vec3_add(g, b)));
    *light = rgb_make(fmax(vec3_dot(r, direction), 0),
                      fmax(vec3_dot(g, direction), 0),
                      fmax(vec3_dot(b, direction), 0));
    return direction;
}

rgb harmonics_total(const struct harmonics *h)
{
    double basis[HARMONICS];
    harmonics_basis(vec3_make(0, 0, 1), basis);
    return rgb_scale(
        rgb_make((double)h->r[0], (double)h->g[0], (double)h->b[0]),
        1 / basis[0]);
}

/* Of so much of its light that vector is at least, where it comes from one side
 * alone. */
static const double beam_least = 0.9;

/* Takes out what comes from about one direction, which is the more the nearer
 * all of it does: straight on harmonics of order 2 make 17/16 of that. */
static rgb harmonics_take_beam(struct harmonics *harmonics, vec3 *direction)
{
    rgb beam, total = harmonics_total(harmonics);
    *direction = harmonics_direction(harmonics, &beam);
    double one_sided =
        (beam.r + beam.g + beam.b) / (total.r + total.g + total.b);
    double share = (one_sided - beam_least) / (1 - beam_least);
    if (!(share > 0))
        return rgb_grey(0);
    beam = rgb_scale(beam, fmin(share, 1));
    harmonics_add(harmonics, *direction, rgb_scale(beam, -1));
    return beam;
}

rgb harmonics_irradiance(const struct harmonics *harmonics, vec3 normal,
                         double brilliance)
{
    double weights[HARMONICS];
    struct harmonics rest = *harmonics;
    vec3 direction;
    rgb beam = harmonics_take_beam(&rest, &direction);
    harmonics_weights(normal, brilliance, weights);
    rgb light = harmonics_weighted(&rest, weights);
    if (rgb_is_black(beam))
        return light;
    double cosine = fmax(vec3_dot(normal, direction), 0);
    return rgb_add_scaled(light, beam, pow(cosine, brilliance));
}

rgb harmonics_received(const void *context, vec3 place, vec3 normal,
                       const void *harmonics)
{
    (void)context;
    (void)place;
    return harmonics_irradiance(harmonics, normal, 1);
}
