/* Colours that stand for numbers: see ramp.h.
 *
 * Magma is that of matplotlib (N. Smith, S. van der Walt, 2015, CC0) at nine
 * places, straight between them. Its lightness rises evenly, so it reads the
 * same to the colour-blind and in grey print. The spectrum's colours are all
 * light enough to be seen on black and strong enough for white. */
#include "image/ramp.h"

#include <math.h>

struct stops {
    int last;
    unsigned char colour[9][3];
};

static const struct stops ramps[] = {
    [RAMP_MAGMA] = { 8,
                     { { 0x00, 0x00, 0x04 },
                       { 0x1d, 0x11, 0x47 },
                       { 0x51, 0x12, 0x7c },
                       { 0x82, 0x26, 0x81 },
                       { 0xb6, 0x36, 0x79 },
                       { 0xe6, 0x51, 0x64 },
                       { 0xfb, 0x88, 0x61 },
                       { 0xfe, 0xc2, 0x87 },
                       { 0xfc, 0xfd, 0xbf } } },
    [RAMP_SPECTRUM] = { 4,
                        { { 0x3c, 0x50, 0xff },
                          { 0x00, 0xb4, 0xe6 },
                          { 0x28, 0xc8, 0x50 },
                          { 0xf5, 0xc8, 0x14 },
                          { 0xff, 0x32, 0x1e } } },
};

void ramp_colour(enum ramp ramp, double value, float colour[3])
{
    const struct stops *stops = &ramps[ramp];
    double place = value > 0 ? fmin(value, 1) * stops->last : 0;
    int i = place < stops->last ? (int)place : stops->last - 1;
    const unsigned char *low = stops->colour[i], *high = stops->colour[i + 1];
    double share = place - i;
    for (int c = 0; c < 3; c++)
        colour[c] = (float)((low[c] * (1 - share) + high[c] * share) / 255);
}

void ramp_range_add(struct ramp_range *range, double number)
{
    if (!isfinite(number) || (range->logarithmic && number <= 0))
        return;
    range->low = range->known ? fmin(range->low, number) : number;
    range->high = range->known ? fmax(range->high, number) : number;
    range->known = true;
}

double ramp_range_place(const struct ramp_range *range, double number)
{
    double low = range->low, high = range->high;
    if (!(number > low) || !(high > low))
        return 0;
    if (range->logarithmic)
        return fmin(log(number / low) / log(high / low), 1);
    return fmin((number - low) / (high - low), 1);
}
