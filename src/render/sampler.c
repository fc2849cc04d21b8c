/* Antialiasing: see sampler.h. Measured on POV-Ray 3.7. */
#include "render/sampler.h"

#include <string.h>

#include "base/memory.h"
#include "base/random.h"

enum { DEPTH_MAX = 9 };

static int sampler_depth(const struct sampler *sampler)
{
    int depth = sampler->options->depth;
    return depth < 1 ? 1 : depth > DEPTH_MAX ? DEPTH_MAX : depth;
}

static bool sampler_corners(const struct sampler *sampler)
{
    return sampler->options->antialias && sampler->options->method == 2;
}

/* Method 1 compares with the neighbours: to the left and above also outside
 * the picture, as POV-Ray does; to the right and below only within it. */
struct sampler sampler_new(const struct tracer *tracer,
                           const struct render_options *options)
{
    struct sampler sampler = { .tracer = tracer, .options = options };
    int right = options->column_end, bottom = options->row_end;
    sampler.x = options->column_start;
    sampler.y = options->row_start;
    if (sampler_corners(&sampler)) {
        right++;
        bottom++;
    } else if (options->antialias) {
        sampler.x--;
        sampler.y--;
        right += right < options->width;
        bottom += bottom < options->height;
    }
    sampler.columns = right - sampler.x;
    sampler.rows = bottom - sampler.y;
    sampler.grid = memory_new((size_t)sampler.columns * (size_t)sampler.rows *
                              4 * sizeof *sampler.grid);
    return sampler;
}

void sampler_free(struct sampler *sampler)
{
    memory_free(sampler->grid);
    sampler->grid = NULL;
}

/* What the camera sees at (x, y) in pixels from the top left. */
static void sampler_see(const struct sampler *sampler, struct worker *worker,
                        double x, double y, float out[4])
{
    const struct render_options *options = sampler->options;
    struct radiance seen = tracer_camera(
        sampler->tracer, worker, x / options->width, y / options->height);
    arena_reset(worker->scratch);
    out[0] = (float)seen.colour.r;
    out[1] = (float)seen.colour.g;
    out[2] = (float)seen.colour.b;
    out[3] = (float)seen.opacity;
}

static float *sampler_place(const struct sampler *sampler, int x, int y)
{
    size_t row = (size_t)(y - sampler->y), column = (size_t)(x - sampler->x);
    return sampler->grid + (row * (size_t)sampler->columns + column) * 4;
}

void sampler_first(struct sampler *sampler, struct worker *worker, int column,
                   int row)
{
    int x = sampler->x + column, y = sampler->y + row;
    double middle = sampler_corners(sampler) ? 0 : 0.5;
    sampler_see(sampler, worker, x + middle, y + middle,
                sampler_place(sampler, x, y));
}

static double perceived(float value, double exponent)
{
    return value > 0 ? pow((double)value, exponent) : 0;
}

/* Sum of the differences after gamma correction; opacity counts when it is
 * wanted. */
static bool sampler_differ(const struct sampler *sampler, const float *a,
                           const float *b)
{
    const struct render_options *options = sampler->options;
    double gamma =
        options->antialias_gamma > 0 ? 1 / options->antialias_gamma : 1;
    double sum = 0;
    for (int i = 0; i < 3; i++)
        if (a[i] != b[i])
            sum += fabs(perceived(a[i], gamma) - perceived(b[i], gamma));
    if (sampler->tracer->alpha)
        sum += fabs((double)a[3] - (double)b[3]);
    return sum > options->threshold;
}

/* In [-0.5, 0.5), by the place in the picture alone. */
static double sampler_jitter(int x, int y, int number)
{
    uint64_t key = random_key((uint64_t)(unsigned)x, (uint64_t)(unsigned)y);
    return random_unit(random_key(key, (uint64_t)(unsigned)number)) - 0.5;
}

/* Whether a pixel differs from one of its four neighbours. */
static bool centre_differs(const struct sampler *sampler, int x, int y)
{
    const float *centre = sampler_place(sampler, x, y);
    if (sampler_differ(sampler, centre, sampler_place(sampler, x - 1, y)) ||
        sampler_differ(sampler, centre, sampler_place(sampler, x, y - 1)))
        return true;
    if (x + 1 < sampler->x + sampler->columns &&
        sampler_differ(sampler, centre, sampler_place(sampler, x + 1, y)))
        return true;
    return y + 1 < sampler->y + sampler->rows &&
           sampler_differ(sampler, centre, sampler_place(sampler, x, y + 1));
}

/* Method 1: the mean of the centre and R x R samples. */
static void centre_refine(const struct sampler *sampler, struct worker *worker,
                          int x, int y, float pixel[4])
{
    int n = sampler_depth(sampler);
    double sum[4], jitter = sampler->options->jitter;
    for (int k = 0; k < 4; k++)
        sum[k] = (double)sampler_place(sampler, x, y)[k];
    for (int i = 0; i < n * n; i++) {
        double u = i % n + 0.5 + jitter * sampler_jitter(x, y, 2 * i);
        double v = i / n + 0.5 + jitter * sampler_jitter(x, y, 2 * i + 1);
        float seen[4];
        sampler_see(sampler, worker, x + u / n, y + v / n, seen);
        for (int k = 0; k < 4; k++)
            sum[k] += (double)seen[k];
    }
    for (int k = 0; k < 4; k++)
        pixel[k] = (float)(sum[k] / (n * n + 1));
}

/* One pixel of method 2: a fine grid of (n + 1)^2 places whose corners are
 * known from the start. */
struct quarters {
    const struct sampler *sampler;
    struct worker *worker;
    int x, y, n;
    float *places;
};

enum { UNSEEN = -1 }; /* as opacity */

static float *quarters_place(struct quarters *q, int i, int j)
{
    float *place = q->places + (j * (q->n + 1) + i) * 4;
    if (place[3] > (float)UNSEEN)
        return place;
    /* A fifth of the distance either way: POV-Ray's jitter, measured. */
    double jitter = 0.4 * q->sampler->options->jitter;
    int number = 2 * (j * (q->n + 1) + i);
    double u = i + jitter * sampler_jitter(q->x, q->y, number);
    double v = j + jitter * sampler_jitter(q->x, q->y, number + 1);
    sampler_see(q->sampler, q->worker, q->x + u / q->n, q->y + v / q->n, place);
    return place;
}

/* The mean over a square of `size` places: of its corners, or of its four
 * quarters if any two corners differ. */
static void quarters_mean(struct quarters *q, int i, int j, int size,
                          double mean[4])
{
    const float *corner[4] = {
        quarters_place(q, i, j),
        quarters_place(q, i + size, j),
        quarters_place(q, i, j + size),
        quarters_place(q, i + size, j + size),
    };
    bool differ = false;
    for (int a = 0; a < 4 && size > 1; a++)
        for (int b = a + 1; b < 4 && !differ; b++)
            differ = sampler_differ(q->sampler, corner[a], corner[b]);
    for (int k = 0; k < 4; k++)
        mean[k] = 0;
    for (int part = 0; part < 4; part++) {
        double value[4];
        for (int k = 0; k < 4; k++)
            value[k] = (double)corner[part][k];
        if (differ)
            quarters_mean(q, i + part % 2 * (size / 2),
                          j + part / 2 * (size / 2), size / 2, value);
        for (int k = 0; k < 4; k++)
            mean[k] += value[k] / 4;
    }
}

static void corners_pixel(const struct sampler *sampler, struct worker *worker,
                          int x, int y, float *scratch, float pixel[4])
{
    int n = 1 << (sampler_depth(sampler) - 1);
    struct quarters q = { sampler, worker, x, y, n, scratch };
    for (int i = 0; i < (n + 1) * (n + 1); i++)
        scratch[i * 4 + 3] = (float)UNSEEN;
    for (int i = 0; i < 4; i++) {
        int right = i % 2, down = i / 2;
        memcpy(scratch + (down * n * (n + 1) + right * n) * 4,
               sampler_place(sampler, x + right, y + down), 4 * sizeof(float));
    }
    double mean[4];
    quarters_mean(&q, 0, 0, n, mean);
    for (int k = 0; k < 4; k++)
        pixel[k] = (float)mean[k];
}

void sampler_pixel(const struct sampler *sampler, struct worker *worker, int x,
                   int y, float *scratch, float pixel[4])
{
    if (sampler_corners(sampler)) {
        corners_pixel(sampler, worker, x, y, scratch, pixel);
        return;
    }
    memcpy(pixel, sampler_place(sampler, x, y), 4 * sizeof *pixel);
    if (sampler->options->antialias && centre_differs(sampler, x, y))
        centre_refine(sampler, worker, x, y, pixel);
}

size_t sampler_scratch(const struct sampler *sampler)
{
    size_t n = (size_t)1 << (sampler_depth(sampler) - 1);
    return sampler_corners(sampler) ? (n + 1) * (n + 1) * 4 : 0;
}
