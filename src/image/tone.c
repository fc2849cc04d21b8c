/* Transfer curves: see tone.h. */
#include "image/tone.h"

#include <math.h>
#include <stdbool.h>
#include <string.h>

#include "base/clones.h"

double tone_srgb_encode(double linear)
{
    if (linear <= 0.0031308)
        return linear * 12.92;
    return 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

double tone_srgb_decode(double encoded)
{
    if (encoded <= 0.04045)
        return encoded / 12.92;
    return pow((encoded + 0.055) / 1.055, 2.4);
}

double tone_encode(double linear, double gamma)
{
    if (gamma == 0)
        return tone_srgb_encode(linear);
    if (gamma == 1)
        return linear;
    return linear > 0 ? pow(linear, 1 / gamma) : 0;
}

double tone_decode(double encoded, double gamma)
{
    if (gamma == 0)
        return tone_srgb_decode(encoded);
    if (gamma == 1)
        return encoded;
    return encoded > 0 ? pow(encoded, gamma) : 0;
}

static bool reaches(const struct tone_table *table, float v, unsigned level)
{
    double light = tone_decode((double)v, table->from);
    return tone_level((float)tone_encode(light, table->to), table->top) >=
           level;
}

/* Positive floats in their order. */
static int32_t place_of(float v)
{
    int32_t place;
    memcpy(&place, &v, sizeof place);
    return place;
}

static float float_at(int32_t place)
{
    float v;
    memcpy(&v, &place, sizeof v);
    return v;
}

/* The least float that reaches the level: near the inverse of the curves. */
static float level_begin(const struct tone_table *table, unsigned level)
{
    double light = tone_decode((level - 0.5) / table->top, table->to);
    double guess = tone_encode(light, table->from);
    int32_t low = guess > 0 ? place_of((float)guess) : 0, high = low;
    for (int32_t step = 1; low > 0 && reaches(table, float_at(low), level);
         step *= 2)
        low = low > step ? low - step : 0;
    for (int32_t step = 1; !reaches(table, float_at(high), level); step *= 2)
        high += step;
    while (high - low > 1) {
        int32_t middle = low + (high - low) / 2;
        if (reaches(table, float_at(middle), level))
            high = middle;
        else
            low = middle;
    }
    return float_at(high);
}

void tone_table_fill(struct tone_table *table, double from, double to,
                     unsigned top)
{
    unsigned level = 0, before = 0;
    table->top = top;
    table->from = from;
    table->to = to;
    table->steep = false;
    table->begin[0] = 0;
    for (unsigned i = 0; i <= top; i++)
        table->number[i] = (float)(i / (double)top);
    for (unsigned i = 1; i <= top; i++)
        table->begin[i] = level_begin(table, i);
    table->begin[top + 1] = INFINITY;
    for (unsigned i = 0; i <= TONE_PARTS; i++) {
        while (level < top && (float)i / TONE_PARTS >= table->begin[level + 1])
            level++;
        table->level[i] = (int32_t)level;
        table->steep |= level > before + 1;
        before = level;
    }
}

static inline float share_of_1(float v)
{
    v = v > 0 ? v : 0;
    return v < 1 ? v : 1;
}

/* The level of the part or the next. */
CLONES static void levels_near(const struct tone_table *table,
                               const float *restrict numbers, size_t count,
                               int32_t *restrict levels)
{
    for (size_t i = 0; i < count; i++) {
        float v = share_of_1(numbers[i]);
        int32_t level = table->level[(int32_t)(v * TONE_PARTS)];
        levels[i] = level + (v >= table->begin[level + 1]);
    }
}

void tone_table_levels(const struct tone_table *table, const float *numbers,
                       size_t count, int32_t *levels)
{
    levels_near(table, numbers, count, levels);
    for (size_t i = 0; table->steep && i < count; i++)
        while (share_of_1(numbers[i]) >= table->begin[levels[i] + 1])
            levels[i]++;
}
