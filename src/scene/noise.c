/* Noise by its three generators, and sums of its octaves: see noise.h. What is
 * asked for at several places, as octaves are, is worked out for all of them at
 * once. */
#include "scene/noise.h"

#include "scene/lattice_noise.h"
#include "scene/noise_cell.h"
#include "scene/perlin.h"

const struct noise_settings noise_settings_default = { NOISE_SCALED,
                                                       NOISE_WAVES };

/* noise_generator 2 as a linear function of the raw noise. */
#define VALUE_SCALE  0.48985582
#define VALUE_OFFSET 0.5155340620844

/* Places dense by coordinate, as many as are asked for at a time. */
enum { PLACES_MAX = SPOTS_MAX * OCTAVES_MAX };

struct places {
    int count;
    double x[PLACES_MAX], y[PLACES_MAX], z[PLACES_MAX];
};

static inline struct coordinates places_all(const struct places *places)
{
    return (struct coordinates){ places->x, places->y, places->z };
}

/* The octaves of the first spot, then those of the next ... */
static inline void places_fill(struct places *places, const struct spots *spots,
                               struct octaves octaves)
{
    int k = 0;
    for (int i = 0; i < spots->count; i++) {
        vec3 at = spots_at(spots, i);
        for (int octave = 0; octave < octaves.count; octave++, k++) {
            places->x[k] = at.x;
            places->y[k] = at.y;
            places->z[k] = at.z;
            at = vec3_scale(at, octaves.lambda);
        }
    }
    places->count = k;
}

static inline double clip(double value)
{
    return value < 0 ? 0 : value > 1 ? 1 : value;
}

static inline void generator_values(enum noise_generator generator,
                                    struct coordinates at, int count,
                                    double *values)
{
    float raw[PLACES_MAX];
    if (generator == NOISE_PERLIN) {
        for (int i = 0; i < count; i++)
            values[i] = clip(
                0.795 * perlin_noise(vec3_make(at.x[i], at.y[i], at.z[i])) +
                0.4925);
        return;
    }
    lattice_noise(at, count, raw);
    if (generator == NOISE_CLIPPED)
        for (int i = 0; i < count; i++)
            values[i] = clip((double)raw[i] + 0.5);
    else
        for (int i = 0; i < count; i++)
            values[i] = clip(VALUE_SCALE * (double)raw[i] + VALUE_OFFSET);
}

void noise_values(enum noise_generator generator, const struct spots *spots,
                  double *values)
{
    generator_values(generator,
                     (struct coordinates){ spots->x, spots->y, spots->z },
                     spots->count, values);
}

double noise_value(enum noise_generator generator, vec3 point)
{
    double value;
    generator_values(generator,
                     (struct coordinates){ &point.x, &point.y, &point.z }, 1,
                     &value);
    return value;
}

void noise_octaves(enum noise_generator generator, const struct spots *spots,
                   struct octaves octaves, double *values)
{
    struct places places;
    places_fill(&places, spots, octaves);
    generator_values(generator, places_all(&places), places.count, values);
    if (generator == NOISE_CLIPPED)
        return;
    for (int i = 0; i < places.count; i++)
        values[i] = 2 * values[i] - 0.5;
}

/* The noise at all octaves of each spot. */
static void fields_find(const struct spots *spots, struct octaves octaves,
                        float (*raw)[NOISE_FIELDS])
{
    struct places places;
    places_fill(&places, spots, octaves);
    lattice_noise_fields(places_all(&places), places.count, raw);
}

static inline vec3 field_vector(const float field[NOISE_FIELDS])
{
    return vec3_make((double)field[0], (double)field[1], (double)field[2]);
}

void noise_vector_octaves(vec3 point, struct octaves octaves, vec3 *vectors)
{
    float raw[OCTAVES_MAX][NOISE_FIELDS];
    const struct spots spots = spots_of(point);
    fields_find(&spots, octaves, raw);
    for (int i = 0; i < octaves.count; i++)
        vectors[i] = field_vector(raw[i]);
}

vec3 noise_vector(vec3 point)
{
    float raw[1][NOISE_FIELDS];
    lattice_noise_fields((struct coordinates){ &point.x, &point.y, &point.z },
                         1, raw);
    return vec3_make((double)raw[0][0], (double)raw[0][1], (double)raw[0][2]);
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
    return turbulence->octaves < 1             ? 1
           : turbulence->octaves > OCTAVES_MAX ? OCTAVES_MAX
                                               : turbulence->octaves;
}

static struct octaves octaves_of(const struct turbulence *turbulence)
{
    return (struct octaves){ turbulence_octaves(turbulence),
                             turbulence->lambda };
}

/* Measured: the first octave is cut to [0,1], the others are not. */
void noise_turbulences(enum noise_generator generator,
                       const struct spots *spots,
                       const struct turbulence *turbulence, double *sums)
{
    double values[PLACES_MAX];
    struct octaves octaves = octaves_of(turbulence);
    noise_octaves(generator, spots, octaves, values);
    for (int i = 0; i < spots->count; i++) {
        const double *of = values + i * octaves.count;
        double weight = 1;
        sums[i] = clip(of[0]);
        for (int octave = 1; octave < octaves.count; octave++) {
            weight *= turbulence->omega;
            sums[i] += weight * of[octave];
        }
    }
}

double noise_turbulence(enum noise_generator generator, vec3 point,
                        const struct turbulence *turbulence)
{
    struct spots spots = spots_of(point);
    double sum;
    noise_turbulences(generator, &spots, turbulence, &sum);
    return sum;
}

/* The sum of vectors, each of which counts omega times the one before. */
static inline vec3 fields_sum(const float (*raw)[NOISE_FIELDS], int count,
                              double omega)
{
    vec3 sum = { 0, 0, 0 };
    double weight = 1;
    for (int i = 0; i < count; i++) {
        sum = vec3_along(sum, field_vector(raw[i]), weight);
        weight *= omega;
    }
    return sum;
}

void noise_vector_turbulences(const struct spots *spots,
                              const struct turbulence *turbulence, vec3 *sums)
{
    float raw[PLACES_MAX][NOISE_FIELDS];
    const struct octaves octaves = octaves_of(turbulence);
    fields_find(spots, octaves, raw);
    for (int i = 0; i < spots->count; i++)
        sums[i] = fields_sum(raw + i * octaves.count, octaves.count,
                             turbulence->omega);
}

void noise_vectors_stir(struct spots *spots,
                        const struct turbulence *turbulence)
{
    const vec3 amount = turbulence->amount;
    vec3 sums[SPOTS_MAX];
    noise_vector_turbulences(spots, turbulence, sums);
    for (int i = 0; i < spots->count; i++) {
        spots->x[i] += amount.x * sums[i].x;
        spots->y[i] += amount.y * sums[i].y;
        spots->z[i] += amount.z * sums[i].z;
    }
}

vec3 noise_vector_turbulence(vec3 point, const struct turbulence *turbulence)
{
    const struct spots spots = spots_of(point);
    vec3 sum;
    noise_vector_turbulences(&spots, turbulence, &sum);
    return sum;
}
