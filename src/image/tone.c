/* Transfer curves: see tone.h. */
#include "image/tone.h"

#include <math.h>
#include <stdbool.h>

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

static bool reaches(const struct tone_table *table, double v, unsigned level)
{
    double light = tone_decode(v, table->from);
    return tone_level((float)tone_encode(light, table->to), table->top) >=
           level;
}

/* The least double that reaches the level: near the inverse of the curves. */
static double level_begin(const struct tone_table *table, unsigned level)
{
    double light = tone_decode((level - 0.5) / table->top, table->to);
    double guess = tone_encode(light, table->from);
    double low = guess, high = guess;
    for (double step = 1e-8; low > 0 && reaches(table, low, level); step *= 2)
        low = guess * (1 - step);
    for (double step = 1e-8; !reaches(table, high, level); step *= 2)
        high = guess * (1 + step);
    for (;;) {
        double middle = low + (high - low) / 2;
        if (!(middle > low && middle < high))
            return high;
        if (reaches(table, middle, level))
            high = middle;
        else
            low = middle;
    }
}

void tone_table_fill(struct tone_table *table, double from, double to,
                     unsigned top)
{
    unsigned level = 0;
    table->top = top;
    table->from = from;
    table->to = to;
    table->begin[0] = 0;
    for (unsigned i = 0; i <= top; i++)
        table->number[i] = (float)(i / (double)top);
    for (unsigned i = 1; i <= top; i++)
        table->begin[i] = level_begin(table, i);
    table->begin[top + 1] = (double)INFINITY;
    for (unsigned i = 0; i <= TONE_PARTS; i++) {
        while (level < top && (double)i / TONE_PARTS >= table->begin[level + 1])
            level++;
        table->level[i] = (unsigned char)level;
    }
}
