/* Tiles on all cores: see render.h. Two passes over the picture, first samples
 * and then pixels, because antialiasing looks at the neighbours. */
#include "render/render.h"

#include <string.h>

#include "base/clock.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "render/passes.h"
#include "render/sampler.h"
#include "render/tile_order.h"
#include "render/workers.h"
#include "shade/surface.h"
#include "tracer/integrator.h"

struct thread_state {
    struct worker worker;
    float *scratch;
    float *told;   /* of a tile, for options->drawn; or NULL */
    float *values; /* of a tile, on their way to the keeper */
};

struct rendering;

/* What a pass does with a tile. */
struct tile_work {
    /* Whether there is anything to do. */
    bool (*wanted)(const struct sampler *sampler, struct area tile);
    void (*draw)(struct rendering *rendering, struct thread_state *thread,
                 struct area tile);
    bool kept;     /* the keeper gets what it has made of tiles */
    bool replaces; /* the first samples of a tile are of no use after it */
};

struct rendering {
    struct sampler sampler;
    const struct render_options *options;
    struct thread_state *threads;
    const struct tile_work *work; /* of the pass */
    struct area area;             /* of the pass */
    struct tile_order order;
    struct keeper_tiles keeping; /* those of first samples, then pixels' */
    size_t kept_first;           /* how many of them are of first samples */
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
    *block = area_both((struct area){ x, y, x + edge, y + edge }, tile);
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
    sampler_tell(&rendering->sampler, tile, thread->told);
}

static void tile_pixels(struct rendering *rendering,
                        struct thread_state *thread, struct area tile)
{
    sampler_tile(&rendering->sampler, &thread->worker, tile, thread->scratch);
    if (!worker_stopped(&thread->worker))
        sampler_tell(&rendering->sampler, tile, thread->told);
}

/* While pixels take the place of first samples a tile's begin is its
 * neighbours' too, who may have replaced it. */
static struct area first_own(const struct rendering *rendering,
                             struct area tile)
{
    const struct sampler *sampler = &rendering->sampler;
    if (rendering->work->replaces) {
        tile.left += sampler->tiled.left - sampler->first.left;
        tile.top += sampler->tiled.top - sampler->first.top;
    }
    return tile;
}

static void keep_first(struct rendering *rendering, struct thread_state *thread,
                       struct area tile)
{
    tile = first_own(rendering, tile);
    if (tile.left >= tile.right || tile.top >= tile.bottom)
        return;
    sampler_take_first(&rendering->sampler, tile, thread->values);
    part_file_put(rendering->options->keeper->file, PART_FIRST, tile,
                  thread->values);
}

static void keep_pixels(struct rendering *rendering,
                        struct thread_state *thread, struct area tile)
{
    struct area here =
        sampler_take_pixels(&rendering->sampler, tile, thread->values);
    if (area_pixels(here) > 0)
        keeper_put_pixels(rendering->options->keeper, here, thread->values);
}

static const struct tile_work meeting = { NULL, tile_meet, false, false };
static const struct tile_work sampling = { sampler_needs_any, tile_first, true,
                                           false };
/* Without antialiasing: the first samples are the pixels. */
static const struct tile_work drawing = { sampler_needs_any, tile_first, true,
                                          false };
static const struct tile_work refining = { sampler_wants, tile_pixels, true,
                                           true };

static size_t tiles_over(int from, int to, int tile)
{
    return ((size_t)(to - from) + (size_t)tile - 1) / (size_t)tile;
}

static size_t tiles_wide(const struct rendering *rendering, struct area area)
{
    return tiles_over(area.left, area.right, rendering->sampler.tile);
}

static size_t tiles_in(const struct rendering *rendering, struct area area)
{
    return tiles_wide(rendering, area) *
           tiles_over(area.top, area.bottom, rendering->sampler.tile);
}

static struct area tile_of(const struct rendering *rendering, struct area area,
                           size_t index)
{
    int edge = rendering->sampler.tile;
    size_t across = tiles_wide(rendering, area);
    int left = area.left + (int)(index % across) * edge;
    int top = area.top + (int)(index / across) * edge;
    struct area tile = { left, top, left + edge, top + edge };
    return area_both(tile, area);
}

/* keeper_tiles.put */
static void render_keep(void *context, size_t item, unsigned number)
{
    struct rendering *rendering = context;
    const struct sampler *sampler = &rendering->sampler;
    struct thread_state *thread = &rendering->threads[number];
    size_t firsts = rendering->kept_first;
    if (item < firsts)
        keep_first(rendering, thread, tile_of(rendering, sampler->first, item));
    else
        keep_pixels(rendering, thread,
                    tile_of(rendering,
                            sampler->direct ? sampler->first : sampler->tiled,
                            item - firsts));
}

/* Before the pixels of a tile are made: they may take the place of its first
 * samples. */
static void render_drop_first(struct rendering *rendering, struct area tile)
{
    const struct area *first = &rendering->sampler.first;
    const int edge = rendering->sampler.tile;
    size_t column = (size_t)((tile.left - first->left) / edge);
    size_t row = (size_t)((tile.top - first->top) / edge);
    keeper_tiles_drop(&rendering->keeping,
                      row * tiles_wide(rendering, *first) + column);
}

static void render_draw(struct rendering *rendering, unsigned number,
                        size_t index, struct area tile)
{
    const struct tile_work *work = rendering->work;
    struct thread_state *thread = &rendering->threads[number];
    if (work->replaces)
        render_drop_first(rendering, tile);
    work->draw(rendering, thread, tile);
    if (work->kept && !worker_stopped(&thread->worker))
        keeper_tiles_done(&rendering->keeping,
                          (work->replaces ? rendering->kept_first : 0) + index,
                          number);
}

static void render_tile(void *context, size_t item, unsigned number)
{
    struct rendering *rendering = context;
    const struct render_options *options = rendering->options;
    const struct tile_work *work = rendering->work;
    size_t index = tile_order_at(&rendering->order, item);
    struct area tile = tile_of(rendering, rendering->area, index);
    double start = clock_seconds();
    if (!work->wanted || work->wanted(&rendering->sampler, tile))
        render_draw(rendering, number, index, tile);
    tile_order_note(&rendering->order, index, clock_seconds() - start);
    size_t done = atomic_fetch_add(&rendering->tiles_done, 1) + 1;
    if (options->progress)
        options->progress(options->progress_context,
                          (double)done / (double)rendering->tiles_total);
}

bool render_is_piece(const struct render_options *options,
                     const struct image *image)
{
    return options->share.count || options->image_top ||
           image->height < options->height;
}

static bool render_pass(struct rendering *rendering, struct area area,
                        const struct tile_work *work)
{
    const struct render_options *options = rendering->options;
    unsigned threads = options->threads ? options->threads : 1;
    rendering->area = area;
    rendering->work = work;
    return parallel_run(threads, tiles_in(rendering, area), options->stop,
                        render_tile, rendering) &&
           !(options->stop && atomic_load(options->stop));
}

/* Of a picture that is there nothing is kept any more; of a piece of one,
 * pixels alone. */
static size_t kept_from(const struct rendering *rendering, bool done)
{
    if (!done)
        return 0;
    return render_is_piece(rendering->options, rendering->sampler.image)
               ? rendering->kept_first
               : rendering->keeping.count;
}

static void threads_start(struct rendering *rendering, unsigned count)
{
    size_t scratch = sampler_scratch(&rendering->sampler);
    size_t edge = (size_t)rendering->sampler.tile;
    rendering->threads = memory_new(count * sizeof *rendering->threads);
    for (unsigned i = 0; i < count; i++) {
        struct thread_state *thread = &rendering->threads[i];
        worker_start(&thread->worker, i, rendering->options->stop);
        thread->scratch = memory_new(scratch * sizeof *thread->scratch);
        thread->values = rendering->options->keeper
                             ? memory_new(edge * edge * 4 * sizeof(float))
                             : NULL;
        if (rendering->options->drawn)
            thread->told = memory_new(edge * edge * 4 * sizeof(float));
    }
}

static void threads_end(struct rendering *rendering, unsigned count,
                        struct render_stats *stats)
{
    for (unsigned i = 0; i < count; i++) {
        struct thread_state *thread = &rendering->threads[i];
        worker_end(&thread->worker, stats);
        memory_free(thread->scratch);
        memory_free(thread->told);
        memory_free(thread->values);
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
    hits->at = (rendering->sampler.sparse ? memory_new_sparse : memory_new)(
        places * sizeof *hits->at);
    rendering->tiles_total += tiles_in(rendering, all);
    if (!render_pass(rendering, all, &meeting))
        return false;
    struct worker **workers = memory_new(threads * sizeof(void *));
    for (unsigned i = 0; i < threads; i++)
        workers[i] = &rendering->threads[i].worker;
    lighting->prepare(tracer->lighting_state, hits, workers, threads);
    memory_free(workers);
    rendering->sampler.hits = hits;
    return true;
}

static void take_first(void *context, struct area area, const void *values)
{
    sampler_give_first(context, area, values);
}

static void take_pixels(void *context, struct area area, const void *values)
{
    sampler_give_pixels(context, area, values);
}

/* What was drawn before. Returns whether there is anything left to draw. */
static bool render_know(struct rendering *rendering)
{
    struct sampler *sampler = &rendering->sampler;
    const struct keeper *keeper = rendering->options->keeper;
    struct part_file *file = keeper ? keeper->file : NULL;
    if (file && !sampler->direct)
        part_file_each(file, PART_FIRST, sampler->first, take_first, sampler);
    if (file)
        keeper_each_pixels(keeper, sampler->wanted, take_pixels, sampler);
    return sampler_need(sampler);
}

/* First samples, and from them pixels; a tile costs about as much in the second
 * pass as in the first. */
static bool render_both(struct rendering *rendering, unsigned threads)
{
    const struct area first = rendering->sampler.first;
    const struct area tiled = rendering->sampler.tiled;
    struct tile_order *order = &rendering->order;
    if (threads > 1)
        tile_order_start(order, tiles_wide(rendering, first),
                         tiles_in(rendering, first));
    bool done = render_pass(rendering, first, &sampling);
    if (done && threads > 1)
        tile_order_sort(order, tiles_wide(rendering, tiled),
                        tiles_in(rendering, tiled));
    done = done && render_pass(rendering, tiled, &refining);
    tile_order_end(order);
    return done;
}

static bool render_passes(struct rendering *rendering,
                          const struct tracer *tracer, unsigned threads)
{
    const struct sampler *sampler = &rendering->sampler;
    bool done = render_foresee(rendering, tracer, threads);
    rendering->threads[0].worker.telling = rendering->options->telling;
    if (sampler->direct)
        return done && render_pass(rendering, sampler->first, &drawing);
    return done && render_both(rendering, threads);
}

static bool render_tiles(const struct tracer *tracer,
                         const struct render_options *options,
                         struct image *image, struct render_stats *stats)
{
    unsigned threads = options->threads ? options->threads : 1;
    struct rendering rendering = {
        .sampler = sampler_new(tracer, options, image),
        .options = options,
        .keeping = { .put = render_keep, .context = &rendering },
    };
    size_t firsts = tiles_in(&rendering, rendering.sampler.first);
    rendering.kept_first = rendering.sampler.direct ? 0 : firsts;
    rendering.tiles_total =
        rendering.sampler.direct
            ? firsts
            : firsts + tiles_in(&rendering, rendering.sampler.tiled);
    threads_start(&rendering, threads);
    keeper_tiles_start(&rendering.keeping, options->keeper,
                       rendering.tiles_total);
    bool done =
        !render_know(&rendering) || render_passes(&rendering, tracer, threads);
    keeper_tiles_end(&rendering.keeping, kept_from(&rendering, done));
    if (stats)
        stats->share = done ? 1 : sampler_rescue(&rendering.sampler);
    threads_end(&rendering, threads, stats);
    if (!rendering.sampler.hits) /* else they are the lighting's */
        memory_free(rendering.hits.at);
    sampler_free(&rendering.sampler);
    return done;
}

/* One band of a picture after the other. */
struct bands {
    const struct render_options *options;
    int done, count;
};

static void bands_progress(void *context, double done)
{
    const struct bands *bands = context;
    const struct render_options *options = bands->options;
    if (options->progress)
        options->progress(options->progress_context,
                          (bands->done + done) / bands->count);
}

static bool render_band(const struct tracer *tracer,
                        const struct render_options *options,
                        struct image *image, struct render_stats *stats)
{
    return integrator_for(tracer->lighting)->sample
               ? passes_run(tracer, options, image, stats)
               : render_tiles(tracer, options, image, stats);
}

static bool render_bands(const struct tracer *tracer,
                         const struct render_options *options,
                         struct image *image, struct render_stats *stats)
{
    struct bands bands = { options, 0, 0 };
    struct render_options band = *options;
    size_t values = (size_t)image->width * (size_t)image->height * 4;
    double share = 0;
    bool done = true;
    bands.count = (options->height + image->height - 1) / image->height;
    band.progress = bands_progress;
    band.progress_context = &bands;
    band.passed = NULL;
    for (; done && bands.done < bands.count; bands.done++) {
        band.image_top = bands.done * image->height;
        int bottom = smaller(band.image_top + image->height, options->height);
        band.row_start = options->row_start > band.image_top
                             ? options->row_start
                             : band.image_top;
        band.row_end = smaller(options->row_end, bottom);
        memset(image->pixels, 0, values * sizeof *image->pixels);
        if (band.row_start >= band.row_end)
            continue;
        done = render_band(tracer, &band, image, stats);
        share += stats->share / bands.count;
    }
    stats->share = share;
    return done;
}

bool render_run(const struct tracer *tracer,
                const struct render_options *options, struct image *image,
                struct render_stats *stats)
{
    struct render_stats unused;
    if (!stats)
        stats = &unused;
    *stats = (struct render_stats){ 0 };
    if (options->column_end <= options->column_start ||
        options->row_end <= options->row_start)
        return true;
    struct tracer ready = *tracer;
    tracer_ready(&ready);
    return image->height < options->height
               ? render_bands(&ready, options, image, stats)
               : render_band(&ready, options, image, stats);
}
