/* Transfer curves: what stands in files <-> linear light. */
#ifndef IMAGE_TONE_H
#define IMAGE_TONE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* The sRGB transfer curve (IEC 61966-2-1). Its straight foot goes on below
 * zero, as in POV-Ray (measured: srgb -0.2 decodes to -0.01548). */
double tone_srgb_encode(double linear);
double tone_srgb_decode(double encoded);

/* v^(1/gamma) and v^gamma; below zero 0, as in POV-Ray (measured). gamma 0
 * stands for the sRGB curve. */
double tone_encode(double linear, double gamma);
double tone_decode(double encoded, double gamma);

/* Rounds v in 0..1 to one of 0..top, up to 65535; NaN is 0. In floats, where
 * 0.9 * 255 is 229.5 and goes up, as in POV-Ray. */
static inline unsigned tone_level(float v, unsigned top)
{
    v = v > 0 ? v : 0;
    return (unsigned)(int)((v < 1 ? v : 1) * (float)top + 0.5f);
}

/* The same to one of 2^bits levels, 1 to 16, that are spread over 0..top. */
static inline unsigned tone_spread(float v, int bits, unsigned top)
{
    unsigned levels = (1u << bits) - 1, level = tone_level(v, levels);
    if (levels == top)
        return level;
    return (unsigned)((float)level * ((float)top / (float)levels) + 0.5f);
}

enum { TONE_TOP = 255, TONE_PARTS = 4096 };

/* tone_level(tone_encode(tone_decode(v, from), to), top) without computing
 * powers for each number: where the levels begin, found with those functions.
 * Its numbers are as wide as floats, so that many are looked up at once. */
struct tone_table {
    unsigned top;
    double from, to;               /* gammas */
    float begin[TONE_TOP + 2];     /* of each level; above all none */
    int32_t level[TONE_PARTS + 1]; /* at each 1/4096 */
    bool steep;                    /* several begin within one of these */
    float number[TONE_TOP + 1];    /* of each level, in 0..1 */
};

/* For `top` of 1..255. */
void tone_table_fill(struct tone_table *table, double from, double to,
                     unsigned top);

/* The levels of numbers: below 0 and NaN is 0, above 1 the top. */
void tone_table_levels(const struct tone_table *table, const float *numbers,
                       size_t count, int32_t *levels);

/* Of one. */
static inline unsigned tone_table_level(const struct tone_table *table, float v)
{
    int32_t level;
    tone_table_levels(table, &v, 1, &level);
    return (unsigned)level;
}

#endif
