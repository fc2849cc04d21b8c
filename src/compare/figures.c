/* Sums over two pictures: see figures.h. */
#include "compare/figures.h"

#include <math.h>

#include "base/memory.h"

/* The k-th smallest of the values, counted from 0 (Hoare 1961); moves them. */
static float value_select(float *values, size_t count, size_t k)
{
    size_t low = 0, high = count - 1;
    while (low < high) {
        float pivot = values[low + (high - low) / 2];
        size_t i = low, j = high;
        for (;; i++, j--) {
            while (values[i] < pivot)
                i++;
            while (values[j] > pivot)
                j--;
            if (i >= j)
                break;
            float value = values[i];
            values[i] = values[j];
            values[j] = value;
        }
        if (k <= j)
            high = j;
        else
            low = j + 1;
    }
    return values[k];
}

/* The smallest value that at least 99 % of them do not exceed. */
static double value_percentile(float *values, size_t count)
{
    if (count == 0)
        return 0;
    size_t rank = count - count / 100;
    return (double)value_select(values, count, rank - 1);
}

struct sums {
    double difference, relative, squares, largest;
    double a, b, aa, ab;
    float *differences, *relatives;
    size_t count;
};

static void sums_add(struct sums *sums, double a, double b)
{
    double difference = a == b ? 0 : fabs(b - a);
    double relative = difference / fmax(fabs(a), FIGURES_DARK);
    sums->difference += difference;
    sums->relative += relative;
    sums->squares += difference * difference;
    sums->largest = fmax(sums->largest, difference);
    sums->differences[sums->count] = (float)difference;
    sums->relatives[sums->count++] = (float)relative;
    sums->a += a;
    sums->b += b;
    sums->aa += a * a;
    sums->ab += a * b;
}

/* Both may be the same infinity or no number: that is no difference. */
static bool value_is_same(double a, double b)
{
    return a == b || (isnan(a) && isnan(b));
}

static void figures_add_pixel(struct figures *figures, struct sums *sums,
                              const float *a, const float *b, double threshold)
{
    bool over = false, broken = false;
    for (int c = 0; c < 4; c++) {
        double p = (double)a[c], q = (double)b[c];
        bool finite = isfinite(p) && isfinite(q);
        if (finite && c < 3)
            sums_add(sums, p, q);
        broken = broken || (!finite && !value_is_same(p, q));
        over = over || (finite && fabs(p - q) > threshold);
    }
    figures->pixels_over += over || broken;
    figures->broken += broken;
}

/* Least squares; the sums are centred to keep their digits. */
static void figures_fit(struct figures *figures, const struct sums *sums)
{
    double n = (double)sums->count;
    double variance = sums->aa - sums->a * sums->a / n;
    double covariance = sums->ab - sums->a * sums->b / n;
    bool flat = !(variance > 1e-12 * sums->aa);
    figures->slope = flat ? (double)NAN : covariance / variance;
    figures->bias = (sums->b - figures->slope * sums->a) / n;
    figures->ratio = sums->a != 0 ? sums->b / sums->a : (double)NAN;
}

struct figures figures_find(const struct pair *pair, double threshold)
{
    const struct image *a = pair->image[0], *b = pair->image[1];
    size_t pixels = (size_t)a->width * (size_t)a->height;
    struct figures figures = { .pixels = pixels };
    struct sums sums = {
        .differences = memory_new(3 * pixels * sizeof(float)),
        .relatives = memory_new(3 * pixels * sizeof(float)),
    };
    for (size_t i = 0; i < pixels; i++)
        figures_add_pixel(&figures, &sums, a->pixels + 4 * i, b->pixels + 4 * i,
                          threshold);
    double n = fmax((double)sums.count, 1);
    figures.mean = sums.difference / n;
    figures.mean_relative = sums.relative / n;
    figures.largest = sums.largest;
    figures.rmse = sqrt(sums.squares / n);
    figures.psnr = figures.rmse > 0 ? -20 * log10(figures.rmse) : HUGE_VAL;
    figures.percentile = value_percentile(sums.differences, sums.count);
    figures.percentile_relative = value_percentile(sums.relatives, sums.count);
    figures.over = (double)figures.pixels_over / (double)pixels;
    figures_fit(&figures, &sums);
    memory_free(sums.differences);
    memory_free(sums.relatives);
    return figures;
}
