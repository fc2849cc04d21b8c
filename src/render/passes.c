/* Passes of the path tracer: see passes.h.
 *
 * The error is estimated from how the passes differ in a pixel: the standard
 * error of the mean of their means, over that mean. The samples of one pass are
 * spread more evenly than those of two, so it is rather too large. */
#include "render/passes.h"

#include <stdlib.h>

#include "base/clock.h"
#include "base/memory.h"
#include "base/order.h"
#include "base/parallel.h"
#include "render/workers.h"
#include "shade/surface.h"
#include "tracer/integrator.h"

enum {
    PASS_MOST = 16, /* samples of a pass */
    PASS_TIMED = 4, /* the same with a target for the time */
    SLOT_PIXEL = 1 << 24,
};

/* Of a pixel darker than this share of the picture's mean, the error counts as
 * if it were as bright. */
static const double dark_share = 0.05;
/* The worst pixels don't count: a mean with a firefly in it says nothing. */
static const double worst_share = 0.01;

/* What is known of one pixel. */
struct tally {
    double sum[4];          /* of samples: RGB and opacity */
    double bright, squares; /* of the passes' mean brightness */
    uint32_t samples;
};

struct passes {
    const struct tracer *tracer;
    const struct integrator *integrator;
    const struct render_options *options;
    struct worker *workers;
    unsigned threads;
    struct tally *tallies; /* of the wanted part, row by row */
    double *errors;        /* for sorting */
    size_t columns, rows;
    uint32_t first, count; /* samples of the pass */
    int passes;            /* done */
    double started;        /* seconds */
    double error;          /* estimated, relative; INFINITY: not yet */
    atomic_size_t rows_done;
};

static void sample_pixel(const struct passes *passes, struct worker *worker,
                         int x, int y, struct tally *tally)
{
    const struct render_options *options = passes->options;
    uint64_t key = random_key((uint64_t)options->seed, (uint64_t)x);
    struct draws draws = { random_key(key, (uint64_t)y), 0 };
    double bright = 0, u[2];
    for (uint32_t i = 0; i < passes->count; i++) {
        draws.index = passes->first + i;
        draw_pair(&draws, SLOT_PIXEL, u);
        double column = x + 0.5 + options->jitter * (u[0] - 0.5);
        double row = y + 0.5 + options->jitter * (u[1] - 0.5);
        struct radiance seen = passes->integrator->sample(
            passes->tracer, worker, column / options->width,
            row / options->height, &draws);
        arena_reset(worker->scratch);
        if (worker_stopped(worker))
            return;
        tally->samples++;
        tally->sum[0] += seen.colour.r;
        tally->sum[1] += seen.colour.g;
        tally->sum[2] += seen.colour.b;
        tally->sum[3] += seen.opacity;
        bright += rgb_brightness(seen.colour);
    }
    bright /= passes->count;
    tally->bright += bright;
    tally->squares += bright * bright;
}

static double passes_share(const struct passes *passes)
{
    const struct render_options *options = passes->options;
    double rows = (double)atomic_load(&passes->rows_done);
    double done =
        (passes->first + rows / (double)passes->rows * passes->count) /
        options->samples;
    if (options->target_time > 0)
        done = fmax(done,
                    (clock_seconds() - passes->started) / options->target_time);
    if (options->target_error > 0 && isfinite(passes->error)) {
        double ratio = options->target_error / passes->error;
        done = fmax(done, ratio * ratio);
    }
    return fmin(done, 1);
}

static void passes_row(void *context, size_t item, unsigned thread)
{
    struct passes *passes = context;
    const struct render_options *options = passes->options;
    for (size_t i = 0; i < passes->columns; i++)
        sample_pixel(passes, &passes->workers[thread],
                     options->column_start + (int)i,
                     options->row_start + (int)item,
                     &passes->tallies[item * passes->columns + i]);
    atomic_fetch_add(&passes->rows_done, 1);
    if (options->progress)
        options->progress(options->progress_context, passes_share(passes));
}

/* The mean over the pixels but the worst. */
static double passes_error(const struct passes *passes)
{
    size_t count = passes->columns * passes->rows;
    double n = passes->passes, mean = 0, sum = 0;
    if (passes->passes < 2)
        return (double)INFINITY;
    for (size_t i = 0; i < count; i++)
        mean += fabs(passes->tallies[i].bright) / n / (double)count;
    for (size_t i = 0; i < count; i++) {
        const struct tally *tally = &passes->tallies[i];
        double bright = tally->bright / n;
        double variance = tally->squares / n - bright * bright;
        double level = fmax(fabs(bright), dark_share * mean);
        passes->errors[i] =
            variance > 0 && level > 0 ? sqrt(variance / (n - 1)) / level : 0;
    }
    qsort(passes->errors, count, sizeof *passes->errors, order_double);
    size_t kept = count - (size_t)(worst_share * (double)count);
    for (size_t i = 0; i < kept; i++)
        sum += passes->errors[i];
    return sum / (double)kept;
}

static uint32_t pass_size(const struct render_options *options)
{
    int size = options->samples / 8;
    int most = options->target_time > 0 ? PASS_TIMED : PASS_MOST;
    return (uint32_t)(size < 1 ? 1 : size > most ? most : size);
}

/* Whether what is there is good enough. */
static bool passes_enough(const struct passes *passes)
{
    const struct render_options *options = passes->options;
    if (passes->first >= (uint32_t)options->samples)
        return true;
    if (options->target_error > 0 && passes->error <= options->target_error)
        return true;
    return options->target_time > 0 &&
           clock_seconds() - passes->started >= options->target_time;
}

static bool passes_all(struct passes *passes)
{
    const struct render_options *options = passes->options;
    while (!passes_enough(passes)) {
        uint32_t left = (uint32_t)options->samples - passes->first;
        passes->count = pass_size(options) < left ? pass_size(options) : left;
        atomic_store(&passes->rows_done, 0);
        if (!parallel_run(passes->threads, passes->rows, options->stop,
                          passes_row, passes) ||
            (options->stop && atomic_load(options->stop)))
            return false;
        passes->first += passes->count;
        passes->passes++;
        passes->error = passes_error(passes);
        if (options->passed)
            options->passed(options->progress_context, (int)passes->first,
                            passes->error);
    }
    return true;
}

/* Returns the share of pixels that have a sample: not all, if it was stopped.
 */
static double passes_show(const struct passes *passes, struct image *image)
{
    size_t known = 0;
    const struct render_options *options = passes->options;
    for (size_t i = 0; i < passes->columns * passes->rows; i++) {
        int x = options->column_start + (int)(i % passes->columns);
        int y = options->row_start + (int)(i / passes->columns);
        float *pixel = image_pixel(image, x, y);
        const struct tally *tally = &passes->tallies[i];
        known += tally->samples > 0;
        for (int k = 0; tally->samples > 0 && k < 4; k++)
            pixel[k] = (float)(tally->sum[k] / tally->samples);
    }
    return (double)known / (double)(passes->columns * passes->rows);
}

bool passes_run(const struct tracer *tracer,
                const struct render_options *options, struct image *image,
                struct render_stats *stats)
{
    struct tracer ready = *tracer;
    struct passes passes = {
        .tracer = &ready,
        .integrator = integrator_for(tracer->lighting),
        .options = options,
        .threads = options->threads ? options->threads : 1,
        .columns = (size_t)(options->column_end - options->column_start),
        .rows = (size_t)(options->row_end - options->row_start),
        .started = clock_seconds(),
        .error = (double)INFINITY,
    };
    size_t count = passes.columns * passes.rows;
    passes.tallies = memory_new(count * sizeof *passes.tallies);
    passes.errors = memory_new(count * sizeof *passes.errors);
    passes.workers = memory_new(passes.threads * sizeof *passes.workers);
    for (unsigned i = 0; i < passes.threads; i++)
        worker_start(&passes.workers[i], i, options->stop);
    passes.integrator->ready(&ready, &passes.workers[0]);
    bool done = passes_all(&passes);
    double share = passes_show(&passes, image);
    if (stats) {
        stats->share = share;
        stats->samples = (int)passes.first;
        stats->error = passes.error;
    }
    memory_free(passes.errors);
    memory_free(passes.tallies);
    for (unsigned i = 0; i < passes.threads; i++)
        worker_end(&passes.workers[i], stats);
    memory_free(passes.workers);
    return done;
}
