/* Noise by its three generators, and sums of its octaves: see noise.h. What is
 * asked for at several places, as octaves are, is worked out for all of them at
 * once. */
#include "scene/noise.h"

#include "base/clones.h"
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

INLINED struct coordinates places_all(const struct places *places)
{
    return (struct coordinates){ places->x, places->y, places->z };
}

/* The first octave of all spots, then the next one ... */
INLINED void places_fill(struct places *places, const struct spots *spots,
                         struct octaves octaves)
{
    int count = spots->count;
    for (int i = 0; i < count; i++) {
        places->x[i] = spots->x[i] * octaves.first;
        places->y[i] = spots->y[i] * octaves.first;
        places->z[i] = spots->z[i] * octaves.first;
    }
    places->count = count * octaves.count;
    for (int i = count; i < places->count; i++) {
        places->x[i] = places->x[i - count] * octaves.lambda;
        places->y[i] = places->y[i - count] * octaves.lambda;
        places->z[i] = places->z[i - count] * octaves.lambda;
    }
}

INLINED double clip(double value)
{
    return value < 0 ? 0 : value > 1 ? 1 : value;
}

/* `even`: as wide as those of NOISE_CLIPPED, whichever it is. */
INLINED void generator_values(enum noise_generator generator, bool even,
                              struct coordinates at, int count, double *values)
{
    const double wide = even && generator != NOISE_CLIPPED ? 2 : 1;
    const double less = even && generator != NOISE_CLIPPED ? 0.5 : 0;
    float raw[PLACES_MAX];
    if (generator == NOISE_PERLIN) {
        for (int i = 0; i < count; i++)
            values[i] = wide * clip(0.795 * perlin_noise(vec3_make(
                                                at.x[i], at.y[i], at.z[i])) +
                                    0.4925) -
                        less;
        return;
    }
    lattice_noise(at, count, raw);
    if (generator == NOISE_CLIPPED)
        for (int i = 0; i < count; i++)
            values[i] = clip((double)raw[i] + 0.5);
    else
        for (int i = 0; i < count; i++)
            values[i] =
                wide * clip(VALUE_SCALE * (double)raw[i] + VALUE_OFFSET) - less;
}

void noise_values(enum noise_generator generator, const struct spots *spots,
                  double *values)
{
    generator_values(generator, false,
                     (struct coordinates){ spots->x, spots->y, spots->z },
                     spots->count, values);
}

double noise_value(enum noise_generator generator, vec3 point)
{
    double value;
    generator_values(generator, false,
                     (struct coordinates){ &point.x, &point.y, &point.z }, 1,
                     &value);
    return value;
}

CLONES void noise_octaves(enum noise_generator generator,
                          const struct spots *spots, struct octaves octaves,
                          double *values)
{
    struct places places;
    places_fill(&places, spots, octaves);
    generator_values(generator, true, places_all(&places), places.count,
                     values);
}

/* The fields at all octaves. */
static void fields_find(const struct spots *spots, struct octaves octaves,
                        float (*raw)[NOISE_ROOM])
{
    struct places places;
    places_fill(&places, spots, octaves);
    lattice_noise_fields(places_all(&places), places.count, raw);
}

static inline vec3 field_vector(const float field[NOISE_ROOM])
{
    return vec3_make((double)field[0], (double)field[1], (double)field[2]);
}

void noise_vector_octaves(const struct spots *spots, struct octaves octaves,
                          vec3 *vectors)
{
    float raw[PLACES_MAX][NOISE_ROOM];
    fields_find(spots, octaves, raw);
    for (int i = 0; i < octaves.count * spots->count; i++)
        vectors[i] = field_vector(raw[i]);
}

void noise_vectors(const struct spots *spots, vec3 *vectors)
{
    noise_vector_octaves(spots, (struct octaves){ 1, 1, 1 }, vectors);
}

vec3 noise_vector(vec3 point)
{
    float raw[1][NOISE_ROOM];
    lattice_noise_fields((struct coordinates){ &point.x, &point.y, &point.z },
                         1, raw);
    return field_vector(raw[0]);
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
    return (struct octaves){ turbulence_octaves(turbulence), 1,
                             turbulence->lambda };
}

/* Measured: the first octave is cut to [0,1], the others are not. */
void noise_turbulences(enum noise_generator generator,
                       const struct spots *spots,
                       const struct turbulence *turbulence, double *sums)
{
    double values[PLACES_MAX], weight = 1;
    struct octaves octaves = octaves_of(turbulence);
    noise_octaves(generator, spots, octaves, values);
    for (int i = 0; i < spots->count; i++)
        sums[i] = clip(values[i]);
    for (int octave = 1; octave < octaves.count; octave++) {
        const double *of = values + octave * spots->count;
        weight *= turbulence->omega;
        for (int i = 0; i < spots->count; i++)
            sums[i] += weight * of[i];
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

/* To each of some numbers the same share of another one. */
CLONES static void numbers_add(double *sum, const float *more, double share,
                               int count)
{
    for (int i = 0; i < count; i++)
        sum[i] += share * (double)more[i];
}

/* Each octave counts omega times the one before. */
void noise_vector_turbulences(const struct spots *spots,
                              const struct turbulence *turbulence, vec3 *sums)
{
    float raw[PLACES_MAX][NOISE_ROOM];
    double sum[SPOTS_MAX][NOISE_ROOM] = { { 0 } }, weight = 1;
    const struct octaves octaves = octaves_of(turbulence);
    int count = spots->count;
    fields_find(spots, octaves, raw);
    for (int octave = 0; octave < octaves.count; octave++) {
        numbers_add(sum[0], raw[octave * count], weight, count * NOISE_ROOM);
        weight *= turbulence->omega;
    }
    for (int i = 0; i < count; i++)
        sums[i] = vec3_make(sum[i][0], sum[i][1], sum[i][2]);
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
