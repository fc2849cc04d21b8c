/* Functions whose loops the compiler makes of wide instructions: they exist
 * once for each kind of processor, and the program takes the best as it starts.
 * Each operation rounds as it does in all the others (the Makefile's
 * -ffp-contract=off): the results are the same to the bit. */
#ifndef BASE_CLONES_H
#define BASE_CLONES_H

#include <stdint.h>

/* glibc finds the one to take; sanitizers aren't there yet when it does. */
#if defined(__x86_64__) && defined(__GLIBC__) && defined(__OPTIMIZE__) &&      \
    !defined(__clang__) && !defined(__SANITIZE_THREAD__) &&                    \
    !defined(__SANITIZE_ADDRESS__)
#define CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define CLONES
#endif

/* Functions that belong to those that call them: for whatever processor these
 * are, and without copies of what they are told. */
#define INLINED static inline __attribute__((always_inline))

/* Arrays of lanes that begin so are lines of the cache: what is read at once
 * never lies in two. */
#define LANE_LINES _Alignas(64)

/* What a loop says of a lane, as wide as a double: -1 for yes, 0 for no. */
typedef int64_t lane_flag;

#endif
