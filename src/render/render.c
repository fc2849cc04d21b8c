/* Tiles on all cores: see render.h. Two passes over the picture, first samples
 * and then pixels, because antialiasing looks at the neighbours. */
#include "render/render.h"

#include "base/memory.h"
#include "base/parallel.h"
#include "render/sampler.h"

struct thread_state {
    struct worker worker;
    float *scratch;
};

struct rendering {
    struct sampler sampler;
    const struct render_options *options;
    struct image *image;
    struct thread_state *threads;
    /* Of the pass at work: the area and how it is cut. */
    int width, height, tile, tiles_across;
    void (*place)(struct rendering *rendering, struct thread_state *thread,
                  int column, int row);
    atomic_size_t tiles_done;
    size_t tiles_total; /* of all passes */
};

static void place_first(struct rendering *rendering,
                        struct thread_state *thread, int column, int row)
{
    sampler_first(&rendering->sampler, &thread->worker, column, row);
}

static void place_pixel(struct rendering *rendering,
                        struct thread_state *thread, int column, int row)
{
    int x = rendering->options->column_start + column;
    int y = rendering->options->row_start + row;
    sampler_pixel(&rendering->sampler, &thread->worker, x, y, thread->scratch,
                  image_pixel(rendering->image, x, y));
}

static int smaller(int a, int b)
{
    return a < b ? a : b;
}

static void render_tile(void *context, size_t item, unsigned number)
{
    struct rendering *rendering = context;
    const struct render_options *options = rendering->options;
    struct thread_state *thread = &rendering->threads[number];
    int left = (int)(item % (size_t)rendering->tiles_across) * rendering->tile;
    int top = (int)(item / (size_t)rendering->tiles_across) * rendering->tile;
    int right = smaller(left + rendering->tile, rendering->width);
    int bottom = smaller(top + rendering->tile, rendering->height);
    for (int row = top; row < bottom; row++)
        for (int column = left; column < right; column++) {
            if (worker_stopped(&thread->worker))
                return;
            rendering->place(rendering, thread, column, row);
        }
    size_t done = atomic_fetch_add(&rendering->tiles_done, 1) + 1;
    if (options->progress)
        options->progress(options->progress_context,
                          (double)done / (double)rendering->tiles_total);
}

static size_t tiles_over(int length, int tile)
{
    return ((size_t)length + (size_t)tile - 1) / (size_t)tile;
}

static bool render_pass(struct rendering *rendering, int width, int height,
                        void (*place)(struct rendering *, struct thread_state *,
                                      int, int))
{
    const struct render_options *options = rendering->options;
    size_t across = tiles_over(width, rendering->tile);
    size_t down = tiles_over(height, rendering->tile);
    rendering->width = width;
    rendering->height = height;
    rendering->place = place;
    rendering->tiles_across = (int)across;
    return parallel_run(options->threads, across * down, options->stop,
                        render_tile, rendering) &&
           !(options->stop && atomic_load(options->stop));
}

static void threads_start(struct rendering *rendering, unsigned count)
{
    size_t scratch = sampler_scratch(&rendering->sampler);
    rendering->threads = memory_new(count * sizeof *rendering->threads);
    for (unsigned i = 0; i < count; i++) {
        struct thread_state *thread = &rendering->threads[i];
        thread->worker.number = i;
        thread->worker.stop = rendering->options->stop;
        thread->worker.scratch = arena_new(0);
        thread->scratch = memory_new(scratch * sizeof *thread->scratch);
    }
}

static void threads_end(struct rendering *rendering, unsigned count,
                        struct render_stats *stats)
{
    for (unsigned i = 0; i < count; i++) {
        struct thread_state *thread = &rendering->threads[i];
        if (stats) {
            stats->camera_rays += thread->worker.counters.camera_rays;
            stats->secondary_rays += thread->worker.counters.secondary_rays;
            stats->shadow_rays += thread->worker.counters.shadow_rays;
        }
        arena_free(thread->worker.scratch);
        memory_free(thread->scratch);
    }
    memory_free(rendering->threads);
}

bool render_run(const struct tracer *tracer,
                const struct render_options *options, struct image *image,
                struct render_stats *stats)
{
    int width = options->column_end - options->column_start;
    int height = options->row_end - options->row_start;
    unsigned threads = options->threads ? options->threads : 1;
    if (stats)
        *stats = (struct render_stats){ 0 };
    if (width <= 0 || height <= 0)
        return true;
    struct tracer ready = *tracer;
    tracer_ready(&ready);
    struct rendering rendering = {
        .sampler = sampler_new(&ready, options),
        .options = options,
        .image = image,
        .tile = options->tile > 0 ? options->tile : 32,
    };
    int columns = rendering.sampler.columns, rows = rendering.sampler.rows;
    rendering.tiles_total =
        tiles_over(width, rendering.tile) * tiles_over(height, rendering.tile) +
        tiles_over(columns, rendering.tile) * tiles_over(rows, rendering.tile);
    threads_start(&rendering, threads);
    bool done = render_pass(&rendering, columns, rows, place_first) &&
                render_pass(&rendering, width, height, place_pixel);
    threads_end(&rendering, threads, stats);
    sampler_free(&rendering.sampler);
    return done;
}
