/* Planes of numbers: see plane.h. Rows are independent of each other, so the
 * result is the same for any number of threads. */
#include "compare/plane.h"

#include <math.h>
#include <string.h>

#include "base/memory.h"
#include "base/parallel.h"

struct plane plane_new(int width, int height)
{
    size_t count = (size_t)width * (size_t)height;
    return (struct plane){ width, height, memory_new(count * sizeof(float)) };
}

void plane_free(struct plane *plane)
{
    memory_free(plane->values);
    plane->values = NULL;
}

double plane_mean(const struct plane *plane, int margin)
{
    int width = plane->width, height = plane->height;
    if (width <= 2 * margin || height <= 2 * margin)
        margin = 0;
    double sum = 0;
    for (int y = margin; y < height - margin; y++) {
        const float *row = plane->values + (size_t)y * (size_t)width;
        for (int x = margin; x < width - margin; x++)
            sum += (double)row[x];
    }
    return sum / ((double)(width - 2 * margin) * (height - 2 * margin));
}

struct kernel kernel_gaussian(double deviation, int radius)
{
    struct kernel kernel = { .radius = radius };
    double sum = 0;
    for (int i = -radius; i <= radius; i++) {
        double x = i / deviation;
        kernel.weights[i + radius] = exp(-x * x / 2);
        sum += kernel.weights[i + radius];
    }
    for (int i = 0; i <= 2 * radius; i++)
        kernel.weights[i] /= sum;
    return kernel;
}

struct convolution {
    const struct plane *in;
    const struct kernel *kernel;
    struct plane *out;
    double *scratch; /* for each thread a row with a border on both sides */
    size_t scratch_size;
};

static int clamp_index(int i, int count)
{
    return i < 0 ? 0 : i >= count ? count - 1 : i;
}

static void convolve_along_row(void *context, size_t item, unsigned thread)
{
    const struct convolution *work = context;
    int width = work->in->width, radius = work->kernel->radius;
    const float *in = work->in->values + item * (size_t)width;
    float *out = work->out->values + item * (size_t)width;
    double *padded = work->scratch + thread * work->scratch_size;
    double *sums = padded + width + 2 * radius;
    for (int i = 0; i < width + 2 * radius; i++)
        padded[i] = (double)in[clamp_index(i - radius, width)];
    memset(sums, 0, (size_t)width * sizeof *sums);
    for (int k = 0; k <= 2 * radius; k++)
        for (int x = 0; x < width; x++)
            sums[x] += work->kernel->weights[k] * padded[x + k];
    for (int x = 0; x < width; x++)
        out[x] = (float)sums[x];
}

static void convolve_down_columns(void *context, size_t item, unsigned thread)
{
    const struct convolution *work = context;
    int width = work->in->width, radius = work->kernel->radius;
    double *sums = work->scratch + thread * work->scratch_size;
    memset(sums, 0, (size_t)width * sizeof *sums);
    for (int k = -radius; k <= radius; k++) {
        int y = clamp_index((int)item + k, work->in->height);
        const float *in = work->in->values + (size_t)y * (size_t)width;
        for (int x = 0; x < width; x++)
            sums[x] += work->kernel->weights[k + radius] * (double)in[x];
    }
    float *out = work->out->values + item * (size_t)width;
    for (int x = 0; x < width; x++)
        out[x] = (float)sums[x];
}

void plane_convolve(const struct plane *in, const struct kernel *row,
                    const struct kernel *column, struct plane *out)
{
    unsigned threads = parallel_cores();
    size_t rows = (size_t)in->height;
    struct plane middle = plane_new(in->width, in->height);
    struct convolution work = {
        .in = in,
        .kernel = row,
        .out = &middle,
        .scratch_size = 2 * (size_t)in->width + 2 * KERNEL_RADIUS_LIMIT,
    };
    work.scratch = memory_new(threads * work.scratch_size * sizeof(double));
    parallel_run(threads, rows, NULL, convolve_along_row, &work);
    work.in = &middle;
    work.kernel = column;
    work.out = out;
    parallel_run(threads, rows, NULL, convolve_down_columns, &work);
    memory_free(work.scratch);
    plane_free(&middle);
}
