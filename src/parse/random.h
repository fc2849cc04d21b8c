/* The random streams of a scene: seed() and rand(). */
#ifndef PARSE_RANDOM_H
#define PARSE_RANDOM_H

#include <stddef.h>
#include <stdint.h>

#include "base/arena.h"

struct random_streams {
    uint32_t *items; /* the states */
    size_t count, capacity;
};

/* A new stream; what seed() returns, 0 for the first. */
size_t random_seed(struct arena *arena, struct random_streams *streams,
                   int seed);

/* The next number of a stream that exists, in [0,1]. */
double random_next(struct random_streams *streams, size_t stream);

#endif
