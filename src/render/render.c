/* Tiles on all cores: see render.h. Two passes over the picture, first samples
 * and then pixels, because antialiasing looks at the neighbours. */
#include "render/render.h"

#include "base/memory.h"
#include "base/parallel.h"
#include "render/passes.h"
#include "render/sampler.h"
#include "render/workers.h"
#include "shade/surface.h"
#include "tracer/integrator.h"

struct thread_state {
    struct worker worker;
    float *scratch;
};

struct rendering {
    struct sampler sampler;
    const struct render_options *options;
    struct image *image;
    struct thread_state *threads;
    struct area area; /* of the pass at work */
    size_t tiles_across;
    void (*work)(struct rendering *rendering, struct thread_state *thread,
                 struct area tile);
    atomic_size_t tiles_done;
    size_t tiles_total;     /* of all passes */
    struct first_hits hits; /* while they are used */
};

static int smaller(int a, int b)
{
    return a < b ? a : b;
}

/* The part of a tile that is `number` blocks to the right and down. False past
 * the end. */
static bool tile_block(struct area tile, int number, struct area *block)
{
    const int edge = SAMPLER_BLOCK;
    int across = (tile.right - tile.left + edge - 1) / edge;
    int x = tile.left + number % across * edge;
    int y = tile.top + number / across * edge;
    *block = (struct area){ x, y, smaller(x + edge, tile.right),
                            smaller(y + edge, tile.bottom) };
    return y < tile.bottom;
}

static void tile_meet(struct rendering *rendering, struct thread_state *thread,
                      struct area tile)
{
    struct area block;
    for (int i = 0; tile_block(tile, i, &block); i++) {
        if (worker_stopped(&thread->worker))
            return;
        sampler_meet(&rendering->sampler, &rendering->hits, block);
    }
}

static void tile_first(struct rendering *rendering, struct thread_state *thread,
                       struct area tile)
{
    struct area block;
    for (int i = 0; tile_block(tile, i, &block); i++) {
        if (worker_stopped(&thread->worker))
            return;
        sampler_first(&rendering->sampler, &thread->worker, block);
    }
}

static void tile_pixels(struct rendering *rendering,
                        struct thread_state *thread, struct area tile)
{
    sampler_tile(&rendering->sampler, &thread->worker, tile, thread->scratch,
                 rendering->image);
}

static void render_tile(void *context, size_t item, unsigned number)
{
    struct rendering *rendering = context;
    const struct render_options *options = rendering->options;
    const struct area *area = &rendering->area;
    int edge = rendering->sampler.tile;
    struct area tile;
    tile.left = area->left + (int)(item % rendering->tiles_across) * edge;
    tile.top = area->top + (int)(item / rendering->tiles_across) * edge;
    tile.right = smaller(tile.left + edge, area->right);
    tile.bottom = smaller(tile.top + edge, area->bottom);
    rendering->work(rendering, &rendering->threads[number], tile);
    size_t done = atomic_fetch_add(&rendering->tiles_done, 1) + 1;
    if (options->progress)
        options->progress(options->progress_context,
                          (double)done / (double)rendering->tiles_total);
}

static size_t tiles_over(int from, int to, int tile)
{
    return ((size_t)(to - from) + (size_t)tile - 1) / (size_t)tile;
}

static size_t tiles_in(const struct rendering *rendering, struct area area)
{
    int tile = rendering->sampler.tile;
    return tiles_over(area.left, area.right, tile) *
           tiles_over(area.top, area.bottom, tile);
}

static bool render_pass(struct rendering *rendering, struct area area,
                        void (*work)(struct rendering *, struct thread_state *,
                                     struct area))
{
    const struct render_options *options = rendering->options;
    unsigned threads = options->threads ? options->threads : 1;
    rendering->area = area;
    rendering->work = work;
    rendering->tiles_across =
        tiles_over(area.left, area.right, rendering->sampler.tile);
    return parallel_run(threads, tiles_in(rendering, area), options->stop,
                        render_tile, rendering) &&
           !(options->stop && atomic_load(options->stop));
}

static void threads_start(struct rendering *rendering, unsigned count)
{
    size_t scratch = sampler_scratch(&rendering->sampler);
    rendering->threads = memory_new(count * sizeof *rendering->threads);
    for (unsigned i = 0; i < count; i++) {
        struct thread_state *thread = &rendering->threads[i];
        worker_start(&thread->worker, i, rendering->options->stop);
        thread->scratch = memory_new(scratch * sizeof *thread->scratch);
    }
}

static void threads_end(struct rendering *rendering, unsigned count,
                        struct render_stats *stats)
{
    for (unsigned i = 0; i < count; i++) {
        struct thread_state *thread = &rendering->threads[i];
        worker_end(&thread->worker, stats);
        memory_free(thread->scratch);
    }
    memory_free(rendering->threads);
}

double render_camera_rays(const struct render_options *options)
{
    double columns = options->column_end - options->column_start;
    double rows = options->row_end - options->row_start;
    return columns * rows * (options->antialias ? 2 : 1);
}

/* Shows the lighting what the camera sees first, if it wants to know. */
static bool render_foresee(struct rendering *rendering,
                           const struct tracer *tracer, unsigned threads)
{
    const struct lighting *lighting = tracer->lighting;
    struct first_hits *hits = &rendering->hits;
    *hits = sampler_grid(&rendering->sampler);
    if (!lighting->foresees || tracer->quality < QUALITY_LIT ||
        !lighting->foresees(tracer->lighting_state, hits))
        return true;
    struct area all = sampler_foreseen(&rendering->sampler);
    size_t places = (size_t)hits->columns * (size_t)hits->rows;
    hits->at = memory_new(places * sizeof *hits->at);
    rendering->tiles_total += tiles_in(rendering, all);
    if (!render_pass(rendering, all, tile_meet))
        return false;
    struct worker **workers = memory_new(threads * sizeof(void *));
    for (unsigned i = 0; i < threads; i++)
        workers[i] = &rendering->threads[i].worker;
    lighting->prepare(tracer->lighting_state, hits, workers, threads);
    memory_free(workers);
    rendering->sampler.hits = hits;
    return true;
}

static bool render_tiles(const struct tracer *tracer,
                         const struct render_options *options,
                         struct image *image, struct render_stats *stats)
{
    unsigned threads = options->threads ? options->threads : 1;
    struct rendering rendering = {
        .sampler = sampler_new(tracer, options, image),
        .options = options,
        .image = image,
    };
    rendering.tiles_total = tiles_in(&rendering, rendering.sampler.first) +
                            tiles_in(&rendering, rendering.sampler.tiled);
    threads_start(&rendering, threads);
    bool done = render_foresee(&rendering, tracer, threads);
    rendering.threads[0].worker.telling = options->telling;
    done = done &&
           render_pass(&rendering, rendering.sampler.first, tile_first) &&
           render_pass(&rendering, rendering.sampler.tiled, tile_pixels);
    if (stats)
        stats->share = done ? 1 : sampler_rescue(&rendering.sampler, image);
    threads_end(&rendering, threads, stats);
    sampler_free(&rendering.sampler);
    memory_free(rendering.hits.at);
    return done;
}

bool render_run(const struct tracer *tracer,
                const struct render_options *options, struct image *image,
                struct render_stats *stats)
{
    if (stats)
        *stats = (struct render_stats){ 0 };
    if (options->column_end <= options->column_start ||
        options->row_end <= options->row_start)
        return true;
    struct tracer ready = *tracer;
    tracer_ready(&ready);
    return integrator_for(tracer->lighting)->sample
               ? passes_run(&ready, options, image, stats)
               : render_tiles(&ready, options, image, stats);
}
