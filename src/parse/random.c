/* rand() and seed(): POV-Ray's generator, so that scattered things land where
 * POV-Ray puts them. */
#include "parse/random.h"

#include "base/array.h"
#include "base/random.h"

size_t random_seed(struct arena *arena, struct random_streams *streams,
                   int seed)
{
    *ARRAY_PUSH(arena, streams) = (uint32_t)seed;
    return streams->count - 1;
}

double random_next(struct random_streams *streams, size_t stream)
{
    uint32_t *state = &streams->items[stream];
    *state = random_step(*state);
    return (double)*state / 4294967295.0;
}
