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

static bool reaches(double linear, double gamma, unsigned level, unsigned top)
{
    return tone_level((float)tone_encode(linear, gamma), top) >= level;
}

/* The least double that reaches the level: near the inverse of the curve. */
static double level_begin(double gamma, unsigned level, unsigned top)
{
    double guess = tone_decode((level - 0.5) / top, gamma);
    double low = guess, high = guess;
    for (double step = 1e-7; low > 0 && reaches(low, gamma, level, top);
         step *= 2)
        low = guess * (1 - step);
    for (double step = 1e-7; !reaches(high, gamma, level, top); step *= 2)
        high = guess * (1 + step);
    for (;;) {
        double middle = low + (high - low) / 2;
        if (!(middle > low && middle < high))
            return high;
        if (reaches(middle, gamma, level, top))
            high = middle;
        else
            low = middle;
    }
}

void tone_table_fill(struct tone_table *table, double gamma, unsigned top)
{
    unsigned level = 0;
    table->top = top;
    table->begin[0] = 0;
    for (unsigned i = 0; i <= top; i++)
        table->number[i] = (float)(i / (double)top);
    for (unsigned i = 1; i <= top; i++)
        table->begin[i] = level_begin(gamma, i, top);
    table->begin[top + 1] = (double)INFINITY;
    for (unsigned i = 0; i <= TONE_PARTS; i++) {
        while (level < top && (double)i / TONE_PARTS >= table->begin[level + 1])
            level++;
        table->level[i] = (unsigned char)level;
    }
}
