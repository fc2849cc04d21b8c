/* Solid noise: K. Perlin, "An Image Synthesizer", SIGGRAPH 1985. Each point of
 * the integer lattice has a random value and a random gradient; between them
 * the eight linear functions are blended by 3t^2 - 2t^3. The random numbers are
 * POV-Ray's (scene/noise_tables). */
#include "scene/noise.h"

#include <string.h>

#include "scene/noise_cell.h"
#include "scene/noise_tables.h"
#include "scene/perlin.h"

const struct noise_settings noise_settings_default = { NOISE_SCALED,
                                                       NOISE_WAVES };

/* noise_generator 2 as a linear function of the raw noise. */
#define VALUE_SCALE  0.48985582
#define VALUE_OFFSET 0.5155340620844

/* Of a lattice point its value and its gradient. */
typedef float lanes __attribute__((vector_size(16)));

/* The unit cell a point is in and the place in it. */
struct cell {
    uint32_t plane[3][2]; /* per axis: the lower and upper lattice plane */
    float place[3];
    float blend[3];
};

static inline struct cell cell_at(vec3 point)
{
    double coordinate[3] = { point.x, point.y, point.z };
    struct cell cell;
    for (int i = 0; i < 3; i++) {
        int64_t low = plane_below(&coordinate[i]);
        float t = (float)(coordinate[i] - (double)low);
        cell.plane[i][0] = lattice_plane(low);
        cell.plane[i][1] = lattice_plane(low + 1);
        cell.place[i] = t;
        cell.blend[i] = plane_blend(t);
    }
    return cell;
}

/* What the corners of a cell add up to. */
struct corners {
    const struct noise_tables *tables;
    const struct cell *cell;
    int count; /* of fields, 1 or NOISE_FIELDS */
    lanes place;
    lanes sum[NOISE_FIELDS];
};

/* Adds the corner on the upper planes where i, j and k are 1: its weight, and
 * the hash of its x and y. */
static inline __attribute__((always_inline)) void
corner_add(struct corners *corners, int i, int j, int k, float weight,
           uint32_t hash)
{
    const struct noise_tables *tables = corners->tables;
    const lanes origin = { 0, (float)i, (float)j, (float)k };
    lanes basis = (corners->place - origin) * weight;
    hash = tables->permutation[hash ^ corners->cell->plane[2][k]];
    const float *window = &tables->lattice[hash % NOISE_WINDOWS];
    for (int field = 0; field < corners->count; field++) {
        lanes random;
        memcpy(&random, window + field * NOISE_FIELD_STEP, sizeof random);
        corners->sum[field] += basis * random;
    }
}

/* Blends `count` (1 or 3) fields of the cell into out[]. The corners are added
 * in a fixed order, without a loop: its branches would take as long again. */
static inline __attribute__((always_inline)) void
cell_blend(const struct noise_tables *tables, const struct cell *cell,
           int count, float *out)
{
    struct corners c = { .tables = tables, .cell = cell, .count = count };
    const uint16_t *permutation = tables->permutation;
    const uint32_t *y = cell->plane[1];
    const float *blend = cell->blend;
    uint32_t low = permutation[cell->plane[0][0]];
    uint32_t high = permutation[cell->plane[0][1]];
    uint32_t hash[4] = { permutation[low ^ y[0]], permutation[high ^ y[0]],
                         permutation[low ^ y[1]], permutation[high ^ y[1]] };
    float weight[4] = { (1 - blend[0]) * (1 - blend[1]),
                        blend[0] * (1 - blend[1]), (1 - blend[0]) * blend[1],
                        blend[0] * blend[1] };
    float below = 1 - blend[2], above = blend[2];
    c.place = (lanes){ 0.5f, cell->place[0], cell->place[1], cell->place[2] };
    corner_add(&c, 0, 0, 0, weight[0] * below, hash[0]);
    corner_add(&c, 1, 0, 0, weight[1] * below, hash[1]);
    corner_add(&c, 0, 1, 0, weight[2] * below, hash[2]);
    corner_add(&c, 1, 1, 0, weight[3] * below, hash[3]);
    corner_add(&c, 0, 0, 1, weight[0] * above, hash[0]);
    corner_add(&c, 1, 0, 1, weight[1] * above, hash[1]);
    corner_add(&c, 0, 1, 1, weight[2] * above, hash[2]);
    corner_add(&c, 1, 1, 1, weight[3] * above, hash[3]);
    for (int field = 0; field < count; field++) {
        lanes s = c.sum[field];
        out[field] = s[0] + s[1] + s[2] + s[3];
    }
}

static double noise_raw(vec3 point)
{
    struct cell cell = cell_at(point);
    float raw;
    cell_blend(noise_tables(), &cell, 1, &raw);
    return (double)raw;
}

static double clip(double value)
{
    return value < 0 ? 0 : value > 1 ? 1 : value;
}

double noise_value(enum noise_generator generator, vec3 point)
{
    switch (generator) {
    case NOISE_CLIPPED:
        return clip(noise_raw(point) + 0.5);
    case NOISE_PERLIN:
        return clip(0.795 * perlin_noise(point) + 0.4925);
    case NOISE_SCALED:
        break;
    }
    return clip(VALUE_SCALE * noise_raw(point) + VALUE_OFFSET);
}

double noise_wide(enum noise_generator generator, vec3 point)
{
    double value = noise_value(generator, point);
    return generator == NOISE_CLIPPED ? value : 2 * value - 0.5;
}

vec3 noise_vector(vec3 point)
{
    struct cell cell = cell_at(point);
    float raw[NOISE_FIELDS];
    cell_blend(noise_tables(), &cell, NOISE_FIELDS, raw);
    return vec3_make((double)raw[0], (double)raw[1], (double)raw[2]);
}

vec3 noise_cell_point(double x, double y, double z)
{
    const struct noise_tables *tables = noise_tables();
    uint32_t hash = lattice_hash(tables, plane_below(&x) & LATTICE_MASK,
                                 plane_below(&y) & LATTICE_MASK,
                                 plane_below(&z) & LATTICE_MASK);
    return noise_cell_inner(tables, hash);
}

int turbulence_octaves(const struct turbulence *turbulence)
{
    return turbulence->octaves < 1    ? 1
           : turbulence->octaves > 10 ? 10
                                      : turbulence->octaves;
}

/* Measured: the first octave is cut to [0,1], the others are not. */
double noise_turbulence(enum noise_generator generator, vec3 point,
                        const struct turbulence *turbulence)
{
    double weight = 1, sum = 0;
    int octaves = turbulence_octaves(turbulence);
    for (int i = 0; i < octaves; i++) {
        double value = noise_wide(generator, point);
        sum += weight * (i == 0 ? clip(value) : value);
        weight *= turbulence->omega;
        point = vec3_scale(point, turbulence->lambda);
    }
    return sum;
}

vec3 noise_vector_turbulence(vec3 point, const struct turbulence *turbulence)
{
    double weight = 1;
    vec3 sum = { 0, 0, 0 };
    int octaves = turbulence_octaves(turbulence);
    for (int i = 0; i < octaves; i++) {
        sum = vec3_along(sum, noise_vector(point), weight);
        weight *= turbulence->omega;
        point = vec3_scale(point, turbulence->lambda);
    }
    return sum;
}

vec3 noise_wave_source(int index)
{
    return noise_tables()->waves[index].source;
}

double noise_wave_frequency(int index)
{
    return noise_tables()->waves[index].frequency;
}
