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

/* Along one axis: where in the file the numbers before and behind a coordinate
 * are, and how near it is to the second. */
struct density_step {
    size_t at[2];
    double share[2];
};

/* Measured: a neighbour beyond the last is the first again. */
static inline bool density_step(struct density_step *step, double coordinate,
                                int size, size_t stride)
{
    if (!(coordinate >= 0 && coordinate < 1))
        return false;
    double x = coordinate * size;
    size_t first = (size_t)x, count = (size_t)size;
    first = first < count ? first : 0; /* just below 1, it is rounded up */
    size_t second = first + 1 < count ? first + 1 : 0;
    step->share[1] = x - (double)(int)x;
    step->share[0] = 1 - step->share[1];
    step->at[0] = first * stride;
    step->at[1] = second * stride;
    return true;
}

static double density_file_of(const struct density_file *file, vec3 point)
{
    struct density_step x, y, z;
    size_t row = (size_t)file->size[0], sheet = row * (size_t)file->size[1];
    double sum = 0;
    if (!file->bytes || !density_step(&x, point.x, file->size[0], 1) ||
        !density_step(&y, point.y, file->size[1], row) ||
        !density_step(&z, point.z, file->size[2], sheet))
        return 0;
    if (file->interpolation == 0)
        return density_at(file, x.at[0] + y.at[0] + z.at[0]) /
               density_most(file->width);
    for (int corner = 0; corner < 8; corner++) {
        int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
        sum += x.share[i] * y.share[j] * z.share[k] *
               density_at(file, x.at[i] + y.at[j] + z.at[k]);
    }
    return sum / density_most(file->width);
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
      offsetof(struct density_file, interpolation), 0, 1, "0 none, 1 linear" },
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
