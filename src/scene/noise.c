/* Solid noise: K. Perlin, "An Image Synthesizer", SIGGRAPH 1985. Each point of
 * the integer lattice has a random value and a random gradient; between them
 * the eight linear functions are blended by 3t^2 - 2t^3. The random numbers
 * are a hash of the lattice point, so there is no table and no period.
 *
 * Measured with POV-Ray 3.7: at lattice points the value is uniform in an
 * interval of length 1 about -0.02, the gradient's components are uniform in
 * +-1 and independent; noise_generator 2 is that, shifted and divided by
 * 2.0414 so that it stays in [0,1]. */
#include "scene/noise.h"

#include <stdint.h>
#include <string.h>

/* The mean of the raw noise over many cells. */
#define RAW_MEAN (-0.0217)
/* noise_generator 2 as a linear function of the raw noise. */
#define VALUE_SCALE  0.489856
#define VALUE_OFFSET 0.515534

/* Four numbers at once: of a lattice point its value and its gradient. */
typedef float lanes __attribute__((vector_size(16)));
typedef int32_t words __attribute__((vector_size(16)));
typedef int16_t halves __attribute__((vector_size(8)));

/* The unit cell a point is in and the place in it. */
struct cell {
    uint64_t key[3][2]; /* per axis: of the lower and upper lattice plane */
    float place[3];
    float blend[3];
};

/* Lattice planes are numbered by integers up to 2^40; far beyond, a
 * coordinate has no fraction left and any number does. */
static inline struct cell cell_at(vec3 point)
{
    static const uint64_t multiplier[3] = { 0x9e3779b97f4a7c15u,
                                            0xc2b2ae3d27d4eb4fu,
                                            0x165667b19e3779f9u };
    const double coordinate[3] = { point.x, point.y, point.z };
    struct cell cell;
    for (int i = 0; i < 3; i++) {
        double c = coordinate[i];
        if (!(fabs(c) < 0x1p40))
            c = isfinite(c) ? fmod(c, 0x1p40) : 0;
        int64_t low = (int64_t)c;
        low -= c < (double)low;
        float t = (float)(c - (double)low);
        uint64_t plane = (uint64_t)low * multiplier[i];
        cell.key[i][0] = plane;
        cell.key[i][1] = plane + multiplier[i];
        cell.place[i] = t;
        cell.blend[i] = t * t * (3 - 2 * t);
    }
    return cell;
}

/* Multiply and xor-shift, twice: neighbours then show no correlation. */
static inline uint64_t lattice_mix(uint64_t key)
{
    key ^= key >> 32;
    key *= 0xd6e8feb86659fd93u;
    key ^= key >> 32;
    key *= 0xd6e8feb86659fd93u;
    return key ^ key >> 32;
}

static inline uint64_t lattice_hash(const struct cell *cell, int i, int j,
                                    int k)
{
    return lattice_mix(cell->key[0][i] ^ cell->key[1][j] ^ cell->key[2][k]);
}

/* Four numbers in [-32768, 32767]. */
static inline lanes lattice_lanes(uint64_t hash)
{
    halves h;
    memcpy(&h, &hash, sizeof h);
    return __builtin_convertvector(__builtin_convertvector(h, words), lanes);
}

/* Blends `count` (1 or 3) independent fields of the cell into out[]. */
static inline void cell_blend(const struct cell *cell, int count, float *out)
{
    const lanes scale = { 0x1p-16f, 0x1p-15f, 0x1p-15f, 0x1p-15f };
    const lanes place = { 1, cell->place[0], cell->place[1], cell->place[2] };
    const float *b = cell->blend;
    lanes sum[3] = { { 0, 0, 0, 0 }, { 0, 0, 0, 0 }, { 0, 0, 0, 0 } };
    for (int corner = 0; corner < 8; corner++) {
        int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
        const lanes origin = { 0, (float)i, (float)j, (float)k };
        float weight = (i ? b[0] : 1 - b[0]) * (j ? b[1] : 1 - b[1]) *
                       (k ? b[2] : 1 - b[2]);
        lanes basis = (place - origin) * weight;
        uint64_t hash = lattice_hash(cell, i, j, k);
        sum[0] += basis * lattice_lanes(hash);
        for (int field = 1; field < count; field++) {
            hash *= 0x9e6c63d0876a9a47u;
            hash ^= hash >> 32;
            sum[field] += basis * lattice_lanes(hash);
        }
    }
    for (int field = 0; field < count; field++) {
        lanes s = sum[field] * scale;
        out[field] = (float)RAW_MEAN + s[0] + s[1] + s[2] + s[3];
    }
}

static double noise_raw(vec3 point)
{
    struct cell cell = cell_at(point);
    float raw;
    cell_blend(&cell, 1, &raw);
    return (double)raw;
}

double noise_value(vec3 point)
{
    double value = VALUE_SCALE * noise_raw(point) + VALUE_OFFSET;
    return value < 0 ? 0 : value > 1 ? 1 : value;
}

vec3 noise_vector(vec3 point)
{
    struct cell cell = cell_at(point);
    float raw[3];
    cell_blend(&cell, 3, raw);
    return vec3_make((double)raw[0], (double)raw[1], (double)raw[2]);
}

vec3 noise_cell_point(double x, double y, double z)
{
    struct cell cell = cell_at(vec3_make(x, y, z));
    uint64_t hash = lattice_hash(&cell, 0, 0, 0);
    const double unit = 0x1p-21;
    return vec3_make((double)(hash & 0x1fffff) * unit,
                     (double)(hash >> 21 & 0x1fffff) * unit,
                     (double)(hash >> 42 & 0x1fffff) * unit);
}

int turbulence_octaves(const struct turbulence *turbulence)
{
    return turbulence->octaves < 1    ? 1
           : turbulence->octaves > 10 ? 10
                                      : turbulence->octaves;
}

/* Measured: the first octave is cut to [0,1], the others are not. */
double noise_turbulence(vec3 point, const struct turbulence *turbulence)
{
    double weight = 1, sum = 0;
    int octaves = turbulence_octaves(turbulence);
    for (int i = 0; i < octaves; i++) {
        double value = 2 * noise_value(point) - 0.5;
        if (i == 0)
            value = value < 0 ? 0 : value > 1 ? 1 : value;
        sum += weight * value;
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

/* Random directions, chosen so that the ripples' spread is POV-Ray's. */
vec3 noise_wave_source(int index)
{
    static const vec3 sources[NOISE_WAVES] = {
        { 0.860346, -0.001116, 0.509710 },  { -0.004745, -0.999027, -0.043855 },
        { -0.817171, -0.126360, 0.562375 }, { -0.810505, 0.585668, 0.008649 },
        { -0.488373, 0.467174, 0.737048 },  { -0.805099, -0.329686, 0.493075 },
        { -0.330775, 0.848133, 0.413834 },  { -0.244343, -0.480583, -0.842221 },
        { -0.447423, 0.543891, -0.709926 }, { 0.787531, 0.250403, 0.563110 },
    };
    return sources[index];
}
