/* Noise of functions.inc: sums of octaves, after F. K. Musgrave (Ebert et al.,
 * Texturing and Modeling, chapter "Procedural Fractal Terrains"). */
#include "scene/internal.h"

#include <math.h>

#include "scene/noise.h"

enum { MUSGRAVE_OCTAVES_MAX = 100 }; /* more add nothing that is seen */

static double noise_at(const double *a, double generator, double scale)
{
    int kind = generator < 1.5 ? 1 : generator < 2.5 ? 2 : 3;
    return noise_value(kind,
                       vec3_make(a[0] * scale, a[1] * scale, a[2] * scale));
}

static double signed_noise(const double *a, double generator, double scale)
{
    return 2 * noise_at(a, generator, scale) - 1;
}

static double internal_noise_generator(const double *a)
{
    return noise_at(a, a[3], 1);
}

/* Each octave is as strong as what is below it is high, to the power T:
 * valleys are smooth. */
static double internal_hetero_mf(const double *a)
{
    double h = a[3], lacunarity = a[4], offset = a[6], t = trunc(a[7]);
    double octaves = fmin(a[5], MUSGRAVE_OCTAVES_MAX), scale = 1;
    double value = signed_noise(a, a[8], scale) + offset;
    for (int i = 1; i < octaves; i++) {
        scale *= lacunarity;
        value += (signed_noise(a, a[8], scale) + offset) * pow(scale, -h) *
                 pow(value, t);
    }
    double rest = octaves - trunc(octaves);
    scale *= lacunarity;
    if (rest > 0)
        value += rest * (signed_noise(a, a[8], scale) + offset) *
                 pow(scale, -h) * value;
    return value;
}

static double ridged_signal(const double *a, double scale)
{
    double signal = a[6] - fabs(signed_noise(a, a[8], scale));
    return signal * signal;
}

/* Each octave has ridges where the noise is 0, the sharper the higher the one
 * below it is there. */
static double internal_ridged_mf(const double *a)
{
    double h = a[3], lacunarity = a[4], gain = a[7], scale = 1;
    double octaves = fmin(a[5], MUSGRAVE_OCTAVES_MAX);
    double signal = ridged_signal(a, scale), value = signal;
    for (int i = 1; i < octaves; i++) {
        scale *= lacunarity;
        double weight = fmin(fmax(signal * gain, 0), 1);
        signal = weight * ridged_signal(a, scale);
        value += signal * pow(scale, -h);
    }
    return value;
}

/* How far from the ridge's value, of as far as it can be. */
static double ridge_noise(const double *a, double scale)
{
    double noise = noise_at(a, a[8], scale), ridge = a[7];
    return fabs(noise - ridge) / fmax(ridge, 1 - ridge);
}

static double internal_ridge(const double *a)
{
    double lambda = a[3], omega = a[5], offset = a[6];
    double octaves = fmin(a[4], MUSGRAVE_OCTAVES_MAX), scale = 1, strength = 1;
    double sum = ridge_noise(a, 1), total = 1;
    for (int i = 1; i < (int)octaves; i++) {
        scale *= lambda;
        strength *= omega;
        sum += strength * ridge_noise(a, scale);
        total += strength;
    }
    double rest = octaves - trunc(octaves);
    if (rest > 0) {
        strength *= omega * rest;
        sum += strength * ridge_noise(a, scale * lambda);
        total += strength;
    }
    return (sum / total - offset) / (1 - offset);
}

const struct internal_function internal_noises[] = {
    { 29, 9, internal_hetero_mf },
    { 58, 9, internal_ridge },
    { 59, 9, internal_ridged_mf },
    { 78, 4, internal_noise_generator },
    { 0, 0, 0 },
};
