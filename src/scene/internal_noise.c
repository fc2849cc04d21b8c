/* Noise of functions.inc: sums of octaves, after F. K. Musgrave (Ebert et al.,
 * Texturing and Modeling, chapter "Procedural Fractal Terrains"). */
#include "scene/internal.h"

#include <math.h>

#include "scene/noise.h"

enum { MUSGRAVE_OCTAVES_MAX = 100 }; /* more add nothing that is seen */

static enum noise_generator noise_generator_of(double number)
{
    return number < 1.5   ? NOISE_CLIPPED
           : number < 2.5 ? NOISE_SCALED
                          : NOISE_PERLIN;
}

static double internal_noise_generator(const double *a)
{
    return noise_value(noise_generator_of(a[3]), vec3_make(a[0], a[1], a[2]));
}

/* Noise of one size after the other, several of them worked out at a time. */
struct series {
    const double *place; /* x, y and z */
    enum noise_generator generator;
    double lacunarity, scale; /* of the next that is to be worked out */
    int wanted;               /* how many are to be, at most */
    int next, known;          /* of values */
    double values[OCTET];
};

/* Of as many octaves as there are, and a part of one. */
static struct series series_begin(const double *a, double generator,
                                  double lacunarity, double octaves)
{
    return (struct series){
        .place = a,
        .generator = noise_generator_of(generator),
        .lacunarity = lacunarity,
        .scale = 1,
        .wanted = (int)fmax(ceil(octaves), 1) + (octaves > trunc(octaves)),
    };
}

static void series_work_out(struct series *series)
{
    struct spots spots;
    const double *a = series->place;
    spots.count = 0;
    while (spots.count < OCTET && spots.count < series->wanted) {
        double scale = series->scale;
        spots_add(&spots, vec3_make(a[0] * scale, a[1] * scale, a[2] * scale));
        series->scale *= series->lacunarity;
    }
    noise_values(series->generator, &spots, series->values);
    series->wanted -= spots.count;
    series->known = spots.count;
    series->next = 0;
}

static inline double series_next(struct series *series)
{
    if (series->next == series->known)
        series_work_out(series);
    return series->values[series->next++];
}

/* From -1 to 1. */
static inline double series_next_signed(struct series *series)
{
    return 2 * series_next(series) - 1;
}

/* Each octave is as strong as what is below it is high, to the power T:
 * valleys are smooth. */
static double internal_hetero_mf(const double *a)
{
    double offset = a[6], t = trunc(a[7]), weight = 1;
    double octaves = fmin(a[5], MUSGRAVE_OCTAVES_MAX);
    double smaller = pow(a[4], -a[3]), rest = octaves - trunc(octaves);
    struct series noise = series_begin(a, a[8], a[4], octaves);
    double value = series_next_signed(&noise) + offset;
    for (int i = 1; i < octaves; i++) {
        weight *= smaller;
        value += (series_next_signed(&noise) + offset) * weight * pow(value, t);
    }
    if (rest > 0)
        value += rest * (series_next_signed(&noise) + offset) * weight *
                 smaller * value;
    return value;
}

static inline double ridged_signal(struct series *noise, double offset)
{
    double signal = offset - fabs(series_next_signed(noise));
    return signal * signal;
}

/* Each octave has ridges where the noise is 0, the sharper the higher the one
 * below it is there. */
static double internal_ridged_mf(const double *a)
{
    double smaller = pow(a[4], -a[3]), offset = a[6], gain = a[7], weight = 1;
    double octaves = fmin(a[5], MUSGRAVE_OCTAVES_MAX);
    struct series noise = series_begin(a, a[8], a[4], octaves);
    double signal = ridged_signal(&noise, offset), value = signal;
    for (int i = 1; i < octaves; i++) {
        double over = fmin(fmax(signal * gain, 0), 1);
        weight *= smaller;
        signal = over * ridged_signal(&noise, offset);
        value += signal * weight;
    }
    return value;
}

/* How far from the ridge's value, of as far as it can be. */
static inline double ridge_noise(struct series *noise, double ridge)
{
    return fabs(series_next(noise) - ridge) / fmax(ridge, 1 - ridge);
}

static double internal_ridge(const double *a)
{
    double omega = a[5], offset = a[6], ridge = a[7], strength = 1;
    double octaves = fmin(a[4], MUSGRAVE_OCTAVES_MAX);
    struct series noise = series_begin(a, a[8], a[3], octaves);
    double sum = ridge_noise(&noise, ridge), total = 1;
    for (int i = 1; i < (int)octaves; i++) {
        strength *= omega;
        sum += strength * ridge_noise(&noise, ridge);
        total += strength;
    }
    double rest = octaves - trunc(octaves);
    if (rest > 0) {
        strength *= omega * rest;
        sum += strength * ridge_noise(&noise, ridge);
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
