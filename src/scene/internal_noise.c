/* Noise of functions.inc: sums of octaves, after F. K. Musgrave (Ebert et al.,
 * Texturing and Modeling, chapter "Procedural Fractal Terrains"). */
#include "scene/internal.h"

#include <math.h>

#include "base/lesser.h"
#include "scene/noise.h"

enum { MUSGRAVE_OCTAVES_MAX = 100 }; /* more add nothing that is seen */

/* The last two bits of the whole number tell; 0 is the first one (measured). */
static enum noise_generator noise_generator_of(double number)
{
    double bits = trunc(number) - 4 * floor(trunc(number) / 4);
    return bits < 2 ? NOISE_CLIPPED : bits < 3 ? NOISE_SCALED : NOISE_PERLIN;
}

static double internal_noise_generator(const double *a)
{
    return noise_value(noise_generator_of(a[3]), vec3_make(a[0], a[1], a[2]));
}

/* Noise of one size after the other at some points, of several sizes worked out
 * at a time. */
struct series {
    const octet *place; /* x, y and z */
    int points;
    enum noise_generator generator;
    double lacunarity, scale; /* of the next that is to be worked out */
    int wanted;               /* sizes that are to be, at most */
    int next, known;          /* of them */
    double values[SPOTS_MAX]; /* all of one size, then of the next */
};

/* Of as many octaves as there are, and a part of one. */
static struct series series_begin(const octet *place, int points,
                                  double generator, double lacunarity,
                                  double octaves)
{
    struct series series; /* no more of it than is needed */
    series.place = place;
    series.points = points;
    series.generator = noise_generator_of(generator);
    series.lacunarity = lacunarity;
    series.scale = 1;
    series.wanted = (int)fmax(ceil(octaves), 1) + (octaves > trunc(octaves));
    series.next = series.known = 0;
    return series;
}

static void series_work_out(struct series *series)
{
    struct spots spots;
    const octet *place = series->place;
    int most = (series->points == 1 ? OCTET : SPOTS_MAX) / series->points;
    int sizes = series->wanted < most ? series->wanted : most;
    spots.count = 0;
    for (int k = 0; k < sizes; k++) {
        double scale = series->scale;
        for (int i = 0; i < series->points; i++)
            spots_add(&spots,
                      vec3_make(place[0][i] * scale, place[1][i] * scale,
                                place[2][i] * scale));
        series->scale *= series->lacunarity;
    }
    noise_values(series->generator, &spots, series->values);
    series->wanted -= sizes;
    series->known = sizes;
    series->next = 0;
}

/* At all points. */
static inline const double *series_next(struct series *series)
{
    if (series->next == series->known)
        series_work_out(series);
    return series->values + series->next++ * series->points;
}

/* From -1 to 1, from noise. */
static inline double noise_signed(double noise)
{
    return 2 * noise - 1;
}

/* Sums of noise at some points, all whose numbers after x, y and z are as
 * these. */
typedef void musgrave(const double *a, struct series *noise, double *sums);

/* Each octave is as strong as what is below it is high, to the power T:
 * valleys are smooth. */
static void hetero_mf(const double *a, struct series *noise, double *values)
{
    double offset = a[6], t = trunc(a[7]), weight = 1;
    double octaves = fmin(a[5], MUSGRAVE_OCTAVES_MAX);
    double smaller = pow(a[4], -a[3]), rest = octaves - trunc(octaves);
    const double *octave = series_next(noise);
    for (int k = 0; k < noise->points; k++)
        values[k] = noise_signed(octave[k]) + offset;
    for (int i = 1; i < octaves; i++) {
        weight *= smaller;
        octave = series_next(noise);
        for (int k = 0; k < noise->points; k++)
            values[k] +=
                (noise_signed(octave[k]) + offset) * weight * pow(values[k], t);
    }
    if (!(rest > 0))
        return;
    octave = series_next(noise);
    for (int k = 0; k < noise->points; k++)
        values[k] += rest * (noise_signed(octave[k]) + offset) * weight *
                     smaller * values[k];
}

static inline double ridged_signal(double noise, double offset)
{
    double signal = offset - fabs(noise_signed(noise));
    return signal * signal;
}

/* Each octave has ridges where the noise is 0, the sharper the higher the one
 * below it is there. */
static void ridged_mf(const double *a, struct series *noise, double *values)
{
    double smaller = pow(a[4], -a[3]), offset = a[6], gain = a[7], weight = 1;
    double octaves = fmin(a[5], MUSGRAVE_OCTAVES_MAX), signals[OCTET];
    const double *octave = series_next(noise);
    for (int k = 0; k < noise->points; k++)
        values[k] = signals[k] = ridged_signal(octave[k], offset);
    for (int i = 1; i < octaves; i++) {
        weight *= smaller;
        octave = series_next(noise);
        for (int k = 0; k < noise->points; k++) {
            double over = lesser(greater(signals[k] * gain, 0), 1);
            signals[k] = over * ridged_signal(octave[k], offset);
            values[k] += signals[k] * weight;
        }
    }
}

/* To a sum, how far noise is from the ridge's value, of as far as it can be. */
static void ridge_add(double *sums, struct series *noise, double ridge,
                      double strength)
{
    const double *octave = series_next(noise);
    for (int k = 0; k < noise->points; k++)
        sums[k] +=
            strength * (fabs(octave[k] - ridge) / fmax(ridge, 1 - ridge));
}

static void ridge(const double *a, struct series *noise, double *sums)
{
    double omega = a[5], offset = a[6], strength = 1, total = 1;
    double octaves = fmin(a[4], MUSGRAVE_OCTAVES_MAX);
    double rest = octaves - trunc(octaves);
    for (int k = 0; k < noise->points; k++)
        sums[k] = 0;
    ridge_add(sums, noise, a[7], 1);
    for (int i = 1; i < (int)octaves; i++) {
        strength *= omega;
        ridge_add(sums, noise, a[7], strength);
        total += strength;
    }
    if (rest > 0) {
        strength *= omega * rest;
        ridge_add(sums, noise, a[7], strength);
        total += strength;
    }
    for (int k = 0; k < noise->points; k++)
        sums[k] = (sums[k] / total - offset) / fmax(offset, 1 - offset);
}

/* One of them: where among its arguments lacunarity and octaves are. */
struct musgrave_kind {
    musgrave *sums;
    int lacunarity, octaves;
};

enum { MUSGRAVE_ARGUMENTS = 9, MUSGRAVE_GENERATOR = 8 };

static const struct musgrave_kind hetero_kind = { hetero_mf, 4, 5 };
static const struct musgrave_kind ridged_kind = { ridged_mf, 4, 5 };
static const struct musgrave_kind ridge_kind = { ridge, 3, 4 };

static void musgrave_some(const struct musgrave_kind *kind, octet *arguments,
                          int first, int count)
{
    double own[MUSGRAVE_ARGUMENTS], sums[OCTET];
    octet place[3];
    for (int i = 0; i < MUSGRAVE_ARGUMENTS; i++)
        own[i] = arguments[i][first];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < count; k++)
            place[i][k] = arguments[i][first + k];
    struct series noise = series_begin(
        place, count, own[MUSGRAVE_GENERATOR], own[kind->lacunarity],
        fmin(own[kind->octaves], MUSGRAVE_OCTAVES_MAX));
    kind->sums(own, &noise, sums);
    for (int k = 0; k < count; k++)
        arguments[0][first + k] = sums[k];
}

/* Whether all that follows x, y and z is the same for two points, to the bit.
 */
static bool musgrave_alike(const octet *arguments, int one, int other)
{
    bool alike = true;
    for (int i = 3; i < MUSGRAVE_ARGUMENTS; i++)
        alike = alike && arguments[i][one] == arguments[i][other];
    return alike;
}

static void musgrave_values(const struct musgrave_kind *kind, octet *arguments,
                            int count)
{
    for (int first = 0, end; first < count; first = end) {
        end = first + 1;
        while (end < count && musgrave_alike(arguments, first, end))
            end++;
        musgrave_some(kind, arguments, first, end - first);
    }
}

static double musgrave_value(const struct musgrave_kind *kind, const double *a)
{
    octet arguments[MUSGRAVE_ARGUMENTS];
    for (int i = 0; i < MUSGRAVE_ARGUMENTS; i++)
        arguments[i][0] = a[i];
    musgrave_some(kind, arguments, 0, 1);
    return arguments[0][0];
}

#define MUSGRAVE(name)                                                         \
    static double internal_##name(const double *a)                             \
    {                                                                          \
        return musgrave_value(&name##_kind, a);                                \
    }                                                                          \
    static void internal_##name##_values(octet *arguments, int count)          \
    {                                                                          \
        musgrave_values(&name##_kind, arguments, count);                       \
    }

MUSGRAVE(hetero)
MUSGRAVE(ridge)
MUSGRAVE(ridged)

const struct internal_function internal_noises[] = {
    { 29, 9, internal_hetero, internal_hetero_values },
    { 58, 9, internal_ridge, internal_ridge_values },
    { 59, 9, internal_ridged, internal_ridged_values },
    { 78, 4, internal_noise_generator, NULL },
    { 0, 0, NULL, NULL },
};
