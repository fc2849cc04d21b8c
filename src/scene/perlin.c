/* Gradient noise: K. Perlin, "An Image Synthesizer", SIGGRAPH 1985, in the form
 * of D. Ebert et al., "Texturing and Modeling", ch. 2: each point of the
 * integer lattice has a random unit gradient, between them the eight linear
 * functions are blended by 3t^2 - 2t^3.
 *
 * The gradients and the permutation that hashes the lattice are POV-Ray's for
 * noise_generator 3, recovered from the values of its f_noise_generator: both
 * are drawn from the generator of rand(), seeded with 1. */
#include "scene/perlin.h"

#include <string.h>

#include "base/parallel.h"
#include "base/random.h"
#include "scene/noise_cell.h"

enum { PERIOD = 2048, MASK = PERIOD - 1 };

/* Where POV-Ray's lattice is, modulo the period. */
#define ORIGIN 1664.023157213

typedef float lanes __attribute__((vector_size(16)));

static struct {
    lanes gradient[PERIOD]; /* the last is 0 */
    uint16_t permutation[PERIOD];
} made;
static struct once tables_made;

static int random_below(uint32_t *state, int limit)
{
    return (int)random_bits(state) % limit;
}

/* A direction: a point of the ball of radius PERIOD. */
static lanes random_direction(uint32_t *state)
{
    for (;;) {
        int x = random_below(state, 2 * PERIOD) - PERIOD;
        int y = random_below(state, 2 * PERIOD) - PERIOD;
        int z = random_below(state, 2 * PERIOD) - PERIOD;
        if (x * x + y * y + z * z <= PERIOD * PERIOD) {
            vec3 unit = vec3_normalise(vec3_make(x, y, z));
            return (lanes){ (float)unit.x, (float)unit.y, (float)unit.z, 0 };
        }
    }
}

/* Only every other number is given another's place, and the shuffle starts one
 * beyond the end: a 0 comes in and a number is lost. */
static void make_tables(void)
{
    uint32_t state = 1;
    uint16_t shuffled[PERIOD + 1] = { 0 };
    for (int i = 0; i < PERIOD; i++) {
        made.gradient[i] = random_direction(&state);
        shuffled[i] = (uint16_t)i;
    }
    for (int i = PERIOD; i > 0; i -= 2) {
        int other = random_below(&state, PERIOD);
        uint16_t kept = shuffled[i];
        shuffled[i] = shuffled[other];
        shuffled[other] = kept;
    }
    memcpy(made.permutation, shuffled, sizeof made.permutation);
}

/* The lattice plane below a coordinate, and how far above it is. */
static inline uint32_t origin_below(double coordinate, float *place)
{
    coordinate += ORIGIN;
    int64_t low = plane_below(&coordinate);
    *place = (float)(coordinate - (double)low);
    return (uint32_t)low;
}

static inline uint32_t hash_step(uint32_t hash, uint32_t plane)
{
    return made.permutation[(hash + plane) & MASK];
}

double perlin_noise(vec3 point)
{
    once_only(&tables_made, make_tables);
    float place[3], blend[3];
    uint32_t x = origin_below(point.x, &place[0]);
    uint32_t y = origin_below(point.y, &place[1]);
    uint32_t z = origin_below(point.z, &place[2]);
    for (int i = 0; i < 3; i++)
        blend[i] = plane_blend(place[i]);
    lanes sum = { 0, 0, 0, 0 };
    for (uint32_t corner = 0; corner < 8; corner++) {
        uint32_t i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
        float weight = corner_weight(blend, i, j, k);
        uint32_t hash = hash_step(hash_step(0, x + i), y + j);
        lanes away = { place[0] - (float)i, place[1] - (float)j,
                       place[2] - (float)k, 0 };
        sum += made.gradient[(hash + z + k) & MASK] * (away * weight);
    }
    return (double)(sum[0] + sum[1] + sum[2]);
}
