/* density_file: numbers of a df3 file over the cube from 0 to 1; 0 outside. */
#include "scene/density_file.h"

#include "scene/pattern.h"

/* Measured: a neighbour beyond the last is the first again. */
static double density_at(const struct density_file *file, const int place[3])
{
    size_t at = 0;
    for (int i = 3; i-- > 0;) {
        int n = file->size[i];
        at = at * (size_t)n + (size_t)(place[i] % n);
    }
    const unsigned char *bytes = file->bytes + at * (size_t)file->width;
    double number = 0, most = 0;
    for (int i = 0; i < file->width; i++) {
        number = 256 * number + bytes[i];
        most = 256 * most + 255;
    }
    return number / most;
}

static double density_file_value(const struct pattern *pattern, vec3 point)
{
    const struct density_file *file = pattern->parameters;
    double coordinates[3] = { point.x, point.y, point.z }, share[3], sum = 0;
    int first[3];
    if (!file->bytes)
        return 0;
    for (int i = 0; i < 3; i++) {
        if (!(coordinates[i] >= 0 && coordinates[i] < 1))
            return 0;
        double x = coordinates[i] * file->size[i];
        first[i] = (int)x;
        share[i] = x - first[i];
    }
    if (!file->linear)
        return density_at(file, first);
    for (int corner = 0; corner < 8; corner++) {
        double weight = 1;
        int place[3];
        for (int i = 0; i < 3; i++) {
            int beyond = corner >> i & 1;
            place[i] = first[i] + beyond;
            weight *= beyond ? share[i] : 1 - share[i];
        }
        sum += weight * density_at(file, place);
    }
    return sum;
}

/* For fingerprints; read by parse/density_file.c. */
static const struct field density_file_arguments[] = {
    { "samples", FIELD_TERMS, offsetof(struct density_file, samples), 0, 0,
      "values of the file" },
    { .name = NULL },
};

const struct pattern_kind density_file_pattern = {
    .name = "density_file",
    .help = "numbers of a file: density_file df3 \"cloud.df3\" interpolate 1",
    .size = sizeof(struct density_file),
    .arguments = density_file_arguments,
    .value = density_file_value,
};
