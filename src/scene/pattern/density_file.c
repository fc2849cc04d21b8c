/* density_file: numbers of a df3 file over the cube from 0 to 1; 0 outside. */
#include "scene/density_file.h"

#include <stdint.h>

#include "scene/pattern.h"
#include "scene/spots.h"

/* The largest number there can be. */
static inline double density_most(int width)
{
    return width == 1 ? 0xff : width == 2 ? 0xffff : 0xffffffff;
}

static inline double density_at(const struct density_file *file, size_t at)
{
    const unsigned char *b = file->bytes + at * (size_t)file->width;
    switch (file->width) {
    case 1:
        return b[0];
    case 2:
        return b[0] << 8 | b[1];
    default:
        return (uint32_t)b[0] << 24 | (uint32_t)b[1] << 16 |
               (uint32_t)b[2] << 8 | (uint32_t)b[3];
    }
}

/* Along one axis: where in the file the numbers around a coordinate are, and
 * how much each counts. */
struct density_step {
    size_t at[4];
    double share[4];
};

/* And the number behind. Measured: a neighbour beyond the last is the first
 * again. */
static inline void step_linear(struct density_step *step, size_t first,
                               size_t count, double rest)
{
    step->at[1] = first + 1 < count ? first + 1 : 0;
    step->share[1] = rest;
    step->share[0] = 1 - rest;
}

/* Two before and two behind, by the curve that passes through all (Catmull and
 * Rom 1974). Measured: the neighbour before the first is the one that 2^32 - 1
 * is the number of, counted round and round. */
static inline void step_cubic(struct density_step *step, size_t first,
                              size_t count, double rest)
{
    const double s = rest, s2 = s * s, s3 = s2 * s;
    step->at[0] = first > 0 ? first - 1 : UINT32_MAX % count;
    step->at[1] = first;
    step->at[2] = (first + 1) % count;
    step->at[3] = (first + 2) % count;
    step->share[0] = -0.5 * s + s2 - 0.5 * s3;
    step->share[1] = 1 - 2.5 * s2 + 1.5 * s3;
    step->share[2] = 0.5 * s + 2 * s2 - 1.5 * s3;
    step->share[3] = 0.5 * (s3 - s2);
}

/* Of `taps` numbers along the axis. False: it is outside. */
static inline bool density_step(struct density_step *step, double coordinate,
                                int size, size_t stride, int taps)
{
    if (!(coordinate >= 0 && coordinate < 1))
        return false;
    double x = coordinate * size, rest = x - (double)(int)x;
    size_t first = (size_t)x, count = (size_t)size;
    first = first < count ? first : 0; /* just below 1, it is rounded up */
    step->at[0] = first;
    step->share[0] = 1;
    if (taps == 2)
        step_linear(step, first, count, rest);
    else if (taps == 4)
        step_cubic(step, first, count, rest);
    for (int i = 0; i < taps; i++)
        step->at[i] *= stride;
    return true;
}

/* The sum of taps^3 numbers around the point. */
static inline double density_sum(const struct density_file *file,
                                 const struct density_step step[3], int taps)
{
    double sum = 0;
    for (int k = 0; k < taps; k++)
        for (int j = 0; j < taps; j++)
            for (int i = 0; i < taps; i++)
                sum += step[0].share[i] * step[1].share[j] * step[2].share[k] *
                       density_at(file, step[0].at[i] + step[1].at[j] +
                                            step[2].at[k]);
    return sum;
}

/* The same over the file's largest number; 0 outside. */
static inline double density_around(const struct density_file *file, vec3 point,
                                    int taps)
{
    struct density_step step[3];
    size_t row = (size_t)file->size[0], sheet = row * (size_t)file->size[1];
    if (!density_step(&step[0], point.x, file->size[0], 1, taps) ||
        !density_step(&step[1], point.y, file->size[1], row, taps) ||
        !density_step(&step[2], point.z, file->size[2], sheet, taps))
        return 0;
    return density_sum(file, step, taps) / density_most(file->width);
}

static double density_file_of(const struct density_file *file, vec3 point)
{
    if (!file->bytes)
        return 0;
    if (file->interpolation == 0)
        return density_around(file, point, 1);
    if (file->interpolation == 1)
        return density_around(file, point, 2);
    double curve = density_around(file, point, 4);
    return curve > 0 ? curve : 0; /* below all numbers it may pass */
}

static double density_file_value(const struct pattern *pattern, vec3 point)
{
    return density_file_of(pattern->parameters, point);
}

static void density_file_values(const struct pattern *pattern,
                                const struct spots *spots, double *values)
{
    for (int i = 0; i < spots->count; i++)
        values[i] = density_file_of(pattern->parameters, spots_at(spots, i));
}

/* For fingerprints; read by parse/density_file.c. */
static const struct field density_file_arguments[] = {
    { "samples", FIELD_TERMS, offsetof(struct density_file, samples), 0, 0,
      "values of the file" },
    { .name = NULL },
};

static const struct field density_file_items[] = {
    { "interpolate", FIELD_INTEGER,
      offsetof(struct density_file, interpolation), 0, 9,
      "0 none, 1 linear, from 2 on cubic" },
    { .name = NULL },
};

const struct pattern_kind density_file_pattern = {
    .name = "density_file",
    .help = "numbers of a file: density_file df3 \"cloud.df3\" interpolate 1",
    .size = sizeof(struct density_file),
    .arguments = density_file_arguments,
    .items = density_file_items,
    .value = density_file_value,
    .values = density_file_values,
};
