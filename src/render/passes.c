/* Passes of the path tracer: see passes.h.
 *
 * The error is estimated from how the passes differ in a pixel: the standard
 * error of the mean of their means, over that mean. The samples of one pass are
 * spread more evenly than those of two, so it is rather too large. */
#include "render/passes.h"

#include <stdlib.h>
#include <string.h>

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
/* Seconds between two times that the same row is kept. */
static const double keep_pause = 1;

/* What is known of one pixel. */
struct tally {
    double sum[4];          /* of samples: RGB and opacity */
    double bright, squares; /* of the passes' mean brightness */
    uint32_t samples;
};

static void tally_mean(const struct tally *tally, float pixel[4])
{
    for (int k = 0; tally->samples > 0 && k < 4; k++)
        pixel[k] = (float)(tally->sum[k] / tally->samples);
}

_Static_assert(sizeof(struct tally) == PART_TALLY, "tallies are kept so");

/* What is kept of a row. */
struct kept_row {
    double when;        /* last, seconds; 0: never */
    long long place[2]; /* of the last two in the file, the older first; 0:
                         * there is none yet */
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
    struct kept_row *kept;
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

/* The row's means so far, to options->drawn. */
static void passes_tell(const struct passes *passes, size_t row)
{
    const struct render_options *options = passes->options;
    float *means = memory_new(passes->columns * 4 * sizeof *means);
    for (size_t i = 0; i < passes->columns; i++)
        tally_mean(&passes->tallies[row * passes->columns + i], means + 4 * i);
    const int top = options->row_start + (int)row;
    const struct render_part part = {
        { options->column_start, top, options->column_end, top + 1 }, means
    };
    options->drawn(options->drawn_context, &part);
    memory_free(means);
}

static bool pixel_is_ours(const struct passes *passes, size_t column,
                          size_t row)
{
    const struct render_options *options = passes->options;
    return share_has(&options->share, options->width, options->height,
                     options->column_start + (int)column,
                     options->row_start + (int)row);
}

/* Over the last but one, which the last one is better than: the file is no
 * larger than two of all rows. */
static void kept_put(struct kept_row *kept, struct part_file *file,
                     struct area area, const struct tally *tallies)
{
    long long place =
        kept->place[0] ? part_file_replace(file, area, tallies, kept->place[0])
                       : part_file_put(file, PART_TALLIES, area, tallies);
    kept->place[0] = kept->place[1];
    kept->place[1] = place;
}

/* The tallies of a row, a second or more after they were kept last. */
static void passes_keep(struct passes *passes, size_t row)
{
    const struct render_options *options = passes->options;
    struct kept_row *kept = &passes->kept[row];
    double now = clock_seconds();
    if ((kept->when > 0 && now < kept->when + keep_pause) ||
        !keeper_ready(options->keeper))
        return;
    int top = options->row_start + (int)row;
    const struct area area = { options->column_start, top, options->column_end,
                               top + 1 };
    double start = clock_worked_here();
    kept->when = now;
    kept_put(kept, options->keeper->file, area,
             passes->tallies + row * passes->columns);
    keeper_count(options->keeper, start);
    if (keeper_due(options->keeper))
        options->keeper->settle(options->keeper->context);
}

/* A row that was kept may be a pass ahead. */
static bool row_is_ahead(const struct passes *passes, size_t row)
{
    const struct tally *tally = passes->tallies + row * passes->columns;
    for (size_t i = 0; i < passes->columns; i++)
        if (tally[i].samples > passes->first)
            return true;
    return false;
}

static void passes_row(void *context, size_t item, unsigned thread)
{
    struct passes *passes = context;
    const struct render_options *options = passes->options;
    bool ahead = row_is_ahead(passes, item);
    for (size_t i = 0; i < passes->columns && !ahead; i++)
        if (pixel_is_ours(passes, i, item))
            sample_pixel(passes, &passes->workers[thread],
                         options->column_start + (int)i,
                         options->row_start + (int)item,
                         &passes->tallies[item * passes->columns + i]);
    if (!ahead && !worker_stopped(&passes->workers[thread]))
        passes_keep(passes, item);
    if (options->drawn && !worker_stopped(&passes->workers[thread]))
        passes_tell(passes, item);
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

/* Samples of the next pass, so that there are as many as wanted in the end. */
static uint32_t pass_next(const struct passes *passes)
{
    const struct render_options *options = passes->options;
    uint32_t left = (uint32_t)options->samples - passes->first;
    return pass_size(options) < left ? pass_size(options) : left;
}

static uint64_t tallies_samples(const struct tally *tallies, size_t count)
{
    uint64_t samples = 0;
    for (size_t i = 0; i < count; i++)
        samples += tallies[i].samples;
    return samples;
}

/* Those of a row stand in the file in any order: who has more samples is the
 * newest. */
static void take_tallies(void *context, struct area area, const void *values)
{
    struct passes *passes = context;
    const struct render_options *options = passes->options;
    if (area.left != options->column_start ||
        area.right != options->column_end || area.top < options->row_start ||
        area.bottom != area.top + 1)
        return;
    size_t row = (size_t)(area.top - options->row_start);
    struct tally *known = passes->tallies + row * passes->columns;
    if (tallies_samples(values, passes->columns) >
        tallies_samples(known, passes->columns))
        memcpy(known, values, passes->columns * sizeof *known);
}

/* Samples that every pixel has. */
static uint32_t passes_least(const struct passes *passes)
{
    uint32_t least = (uint32_t)passes->options->samples;
    for (size_t i = 0; i < passes->rows; i++)
        for (size_t k = 0; k < passes->columns; k++) {
            uint32_t samples = passes->tallies[i * passes->columns + k].samples;
            if (samples < least && pixel_is_ours(passes, k, i))
                least = samples;
        }
    return least;
}

/* What was drawn before: whole passes over all rows, and rows that are one
 * ahead. */
static void passes_know(struct passes *passes)
{
    const struct render_options *options = passes->options;
    const struct keeper *keeper = options->keeper;
    const struct area all = { options->column_start, options->row_start,
                              options->column_end, options->row_end };
    if (!keeper || !keeper->file)
        return;
    part_file_each(keeper->file, PART_TALLIES, all, take_tallies, passes);
    uint32_t least = passes_least(passes);
    while (passes->first < least) {
        passes->first += pass_next(passes);
        passes->passes++;
    }
    passes->error = passes_error(passes);
}

/* A part's pixels, for those who join it; a band's, for those who write it. */
static void passes_put(const struct passes *passes, const struct image *image)
{
    const struct render_options *options = passes->options;
    const int edge = share_block(options->width, options->height);
    float *values =
        memory_new((size_t)edge * (size_t)edge * 4 * sizeof *values);
    for (int top = options->row_start; top < options->row_end;
         top += edge - top % edge)
        for (int left = options->column_start; left < options->column_end;
             left += edge - left % edge) {
            struct area area = { left, top, left + edge - left % edge,
                                 top + edge - top % edge };
            if (area.right > options->column_end)
                area.right = options->column_end;
            if (area.bottom > options->row_end)
                area.bottom = options->row_end;
            if (!share_has(&options->share, options->width, options->height,
                           left, top))
                continue;
            size_t wide = (size_t)(area.right - left);
            for (int y = top; y < area.bottom; y++)
                memcpy(values + (size_t)(y - top) * wide * 4,
                       image_pixel(image, left, y - options->image_top),
                       wide * 4 * sizeof *values);
            keeper_put_pixels(options->keeper, area, values);
        }
    memory_free(values);
}

static bool passes_all(struct passes *passes)
{
    const struct render_options *options = passes->options;
    passes_know(passes);
    while (!passes_enough(passes)) {
        passes->count = pass_next(passes);
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
        float *pixel = image_pixel(image, x, y - options->image_top);
        const struct tally *tally = &passes->tallies[i];
        known += tally->samples > 0;
        tally_mean(tally, pixel);
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
    passes.kept = memory_new(passes.rows * sizeof *passes.kept);
    bool done = passes_all(&passes);
    double share = passes_show(&passes, image);
    if (done && render_is_piece(options, image) &&
        keeper_ready(options->keeper))
        passes_put(&passes, image);
    memory_free(passes.kept);
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
