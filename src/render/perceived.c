/* Differences as they are seen: see perceived.h. */
#include "render/perceived.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "image/tone.h"
#include "scene/rays.h"

/* Powers below 1 are steepest where a number begins, others where it ends. */
static void fill_slopes(struct perceived *table)
{
    const double g = table->exponent;
    for (int i = 0; i < PERCEIVED_BEGINNINGS; i++) {
        bool usual = i > 0 && i < 255;
        double at = exp2(i - 127 + (g > 1));
        table->slope[i] = usual ? g * pow(at, g - 1) : PERCEIVED_UNKNOWN;
    }
}

/* Linear interpolation of m^g from 1 to 2 in steps of h is off by at most h^2 /
 * 8 times the largest second derivative there; the smallest value is that of 1
 * or of 2. */
void perceived_fill(struct perceived *table, double exponent)
{
    const double h = 1.0 / PERCEIVED_PARTS;
    double g = exponent;
    double bend = fabs(g * (g - 1)) * fmax(1, exp2(g - 2));
    table->exponent = exponent;
    table->decoded = false;
    table->error = 1e-9 + 1.01 * bend * h * h / 8;
    table->rough = !(table->error < 1e-3) || exponent > 4;
    for (int i = 0; i <= PERCEIVED_PARTS; i++)
        table->mantissa[i] = pow(1 + i * h, g);
    for (int i = 0; i < PERCEIVED_EXPONENTS; i++)
        table->power[i] = pow(2, (i + PERCEIVED_LEAST_EXPONENT) * g);
    fill_slopes(table);
}

void perceived_fill_srgb(struct perceived *table, double exponent)
{
    table->exponent = exponent;
    table->decoded = table->rough = true;
    for (int i = 0; i < PERCEIVED_BEGINNINGS; i++)
        table->slope[i] = PERCEIVED_UNKNOWN;
}

/* The number as 2^e m, m from 1 to 2; value > 0 and finite. */
static double perceived_near(const struct perceived *table, float value)
{
    double number = (double)value;
    uint64_t bits;
    memcpy(&bits, &number, sizeof bits);
    int exponent = (int)(bits >> 52) - 1023 - PERCEIVED_LEAST_EXPONENT;
    bits = (bits & ~(UINT64_C(0xfff) << 52)) | UINT64_C(0x3ff) << 52;
    memcpy(&number, &bits, sizeof number);
    double place = (number - 1) * PERCEIVED_PARTS;
    int part = (int)place;
    double low = table->mantissa[part], high = table->mantissa[part + 1];
    return table->power[exponent] * (low + (place - part) * (high - low));
}

static double perceived(const struct perceived *table, float value)
{
    double light =
        table->decoded ? tone_decode((double)value, 0) : (double)value;
    return light > 0 ? pow(light, table->exponent) : 0;
}

static bool differ_exactly(const struct perceived *table, const float *a,
                           const float *b, double more, double threshold)
{
    double sum = 0;
    for (int i = 0; i < 3; i++)
        if (a[i] != b[i])
            sum += fabs(perceived(table, a[i]) - perceived(table, b[i]));
    return sum + more >= threshold;
}

/* With the table. */
bool perceived_differ_closely(const struct perceived *table, const float *a,
                              const float *b, double more, double threshold)
{
    double sum = more, all = 1e-9 * (more + threshold);
    for (int i = 0; i < 3; i++) {
        if (a[i] == b[i])
            continue;
        if (!isfinite(a[i]) || !isfinite(b[i]) || table->rough)
            return differ_exactly(table, a, b, more, threshold);
        double x = a[i] > 0 ? perceived_near(table, a[i]) : 0;
        double y = b[i] > 0 ? perceived_near(table, b[i]) : 0;
        sum += fabs(x - y);
        all += table->error * (x + y);
    }
    if (fabs(sum - threshold) > 2 * all)
        return sum > threshold;
    return differ_exactly(table, a, b, more, threshold);
}

/* With opacity, as perceived_differ has it. */
CLONES static void find_unsure(const struct perceived *restrict table,
                               const float *restrict a, const float *restrict b,
                               const struct perceived_limit *restrict limit,
                               lane_flag *restrict unsure)
{
    const double *restrict slopes = table->slope;
    const uint32_t over = perceived_over(table);
    const double opacity = limit->opacity, threshold = limit->threshold;
    for (int i = 0; i < PERCEIVED_ROW; i++) {
        const float *here = a + 4 * i, *there = b + 4 * i;
        double most = opacity * fabs((double)here[3] - (double)there[3]);
        for (int k = 0; k < 3; k++)
            most += perceived_most(slopes, here[k], there[k], over);
        unsure[i] = most * (1 + 1e-9) < threshold ? 0 : -1;
    }
}

uint32_t perceived_may_differ(const struct perceived *table,
                              const float (*a)[4], const float (*b)[4],
                              struct perceived_limit limit)
{
    LANE_LINES lane_flag unsure[PERCEIVED_ROW];
    uint32_t bits = 0;
    find_unsure(table, a[0], b[0], &limit, unsure);
    for (int i = 0; i < PERCEIVED_ROW; i += RAY_LANES)
        bits |= (uint32_t)rays_bits(unsure + i) << i;
    return bits;
}
