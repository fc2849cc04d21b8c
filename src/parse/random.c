/* POV-Ray's generator, so that scattered things land where POV-Ray puts them:
 * a linear congruential one modulo 2^32 (constants found by measurement, see
 * "rand" in notes/scene-language.md). */
#include "parse/random.h"

#include "base/array.h"

size_t random_seed(struct arena *arena, struct random_streams *streams,
                   int seed)
{
    *ARRAY_PUSH(arena, streams) = (uint32_t)seed;
    return streams->count - 1;
}

double random_next(struct random_streams *streams, size_t stream)
{
    uint32_t *state = &streams->items[stream];
    *state = *state * 1812433253u + 12345u;
    return (double)*state / 4294967295.0;
}
