/* Places in a square by one number, along a curve on which neighbours are
 * mostly neighbours (Morton 1966). */
#ifndef BASE_MORTON_H
#define BASE_MORTON_H

#include <stdint.h>

/* The 16 lower bits with a 0 before each. */
static inline uint32_t morton_apart(uint32_t bits)
{
    bits &= 0xffff;
    bits = (bits | bits << 8) & 0x00ff00ff;
    bits = (bits | bits << 4) & 0x0f0f0f0f;
    bits = (bits | bits << 2) & 0x33333333;
    return (bits | bits << 1) & 0x55555555;
}

/* Of x and y below 2^16. */
static inline uint32_t morton_place(uint32_t x, uint32_t y)
{
    return morton_apart(x) | morton_apart(y) << 1;
}

/* Every second of the bits, together. */
static inline uint32_t morton_together(uint32_t bits)
{
    bits &= 0x55555555;
    bits = (bits | bits >> 1) & 0x33333333;
    bits = (bits | bits >> 2) & 0x0f0f0f0f;
    bits = (bits | bits >> 4) & 0x00ff00ff;
    return (bits | bits >> 8) & 0xffff;
}

/* Back again. */
static inline uint32_t morton_x(uint32_t place)
{
    return morton_together(place);
}

static inline uint32_t morton_y(uint32_t place)
{
    return morton_together(place >> 1);
}

#endif
