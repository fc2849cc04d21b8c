/* Antialiasing: see sampler.h. Measured on POV-Ray 3.7. */
#include "render/sampler.h"

#include <string.h>

#include "base/memory.h"
#include "base/random.h"
#include "render/sampler_places.h"

enum { DEPTH_MAX = 9 };

static int sampler_depth(const struct sampler *sampler)
{
    int depth = sampler->options->depth;
    return depth < 1 ? 1 : depth > DEPTH_MAX ? DEPTH_MAX : depth;
}

static int larger(int a, int b)
{
    return a > b ? a : b;
}

static int smaller(int a, int b)
{
    return a < b ? a : b;
}

/* The tiles of method 1 that decide about the wanted pixels: what comes later
 * in a tile's rows, and the row below, may still refine them. */
static struct area centres_tiled(const struct render_options *options)
{
    const int tile = CENTRES_TILE;
    int left = options->column_start, right = options->column_end;
    int top = options->row_start, bottom = options->row_end;
    int more = (tile - right % tile) % tile;
    return (
        struct area){ left - left % tile, top - top % tile,
                      smaller(right + more, options->width),
                      smaller(bottom + (bottom % tile != 0), options->height) };
}

/* Whether method 1 may write a whole picture's first samples into the picture
 * itself. */
static bool sampler_in_place(const struct sampler *sampler,
                             const struct image *image)
{
    const struct area *tiled = &sampler->tiled, *wanted = &sampler->wanted;
    return sampler_centres(sampler) && wanted->left == 0 && wanted->top == 0 &&
           wanted->right == image->width && wanted->bottom == image->height &&
           tiled->right == image->width && tiled->bottom == image->height;
}

static float *sampler_edges_new(const struct sampler *sampler)
{
    size_t across = (size_t)sampler->tiled.right + 1;
    size_t down = (size_t)sampler->tiled.bottom + 1;
    size_t columns = (across + CENTRES_TILE) / CENTRES_TILE;
    size_t pixels = sampler_edge_rows(sampler) * across + columns * down;
    return memory_new(pixels * 4 * sizeof(float));
}

/* Method 1 compares with the pixels to the left and above, outside the picture
 * too, as POV-Ray does. */
struct sampler sampler_new(const struct tracer *tracer,
                           const struct render_options *options,
                           struct image *image)
{
    struct sampler sampler = { .tracer = tracer,
                               .options = options,
                               .image = image };
    struct area wanted = { options->column_start, options->row_start,
                           options->column_end, options->row_end };
    sampler.wanted = sampler.tiled = wanted;
    sampler.tile = options->tile > 0 ? options->tile : 32;
    if (sampler_centres(&sampler)) {
        sampler.tile = CENTRES_TILE;
        sampler.tiled = centres_tiled(options);
    }
    sampler.first = sampler.tiled;
    if (sampler_corners(&sampler)) {
        sampler.first.right++;
        sampler.first.bottom++;
    } else if (sampler_centres(&sampler)) {
        sampler.first.left--;
        sampler.first.top--;
    }
    size_t columns = (size_t)(sampler.first.right - sampler.first.left);
    size_t rows = (size_t)(sampler.first.bottom - sampler.first.top);
    if (options->antialias) {
        double gamma = options->antialias_gamma;
        sampler.perceived = memory_new(sizeof *sampler.perceived);
        perceived_fill(sampler.perceived, gamma > 0 ? 1 / gamma : 1);
    }
    sampler.direct = !options->antialias;
    if (sampler_in_place(&sampler, image))
        sampler.edges = sampler_edges_new(&sampler);
    sampler.grid = sampler.direct || sampler.edges
                       ? image->pixels
                       : memory_new(columns * rows * 4 * sizeof *sampler.grid);
    sampler.states = memory_new(columns * rows);
    return sampler;
}

void sampler_free(struct sampler *sampler)
{
    memory_free(sampler->perceived);
    if (!sampler->direct && !sampler->edges)
        memory_free(sampler->grid);
    memory_free(sampler->states);
    memory_free(sampler->edges);
    sampler->grid = NULL;
}

static void sampler_take(const struct radiance *seen, float out[4])
{
    out[0] = (float)seen->colour.r;
    out[1] = (float)seen->colour.g;
    out[2] = (float)seen->colour.b;
    out[3] = (float)seen->opacity;
}

/* Where in their pixels the places of the grid are, both ways. */
static double sampler_middle(const struct sampler *sampler)
{
    return sampler_corners(sampler) ? 0 : 0.5;
}

/* (x, y) in pixels from the top left. */
static struct picture_place sampler_at(const struct sampler *sampler, double x,
                                       double y)
{
    const struct render_options *options = sampler->options;
    double middle = sampler_middle(sampler);
    return (struct picture_place){ { x / options->width, y / options->height },
                                   { x - middle, y - middle } };
}

/* What the camera sees there. */
static void sampler_see(const struct sampler *sampler, struct worker *worker,
                        double x, double y, float out[4])
{
    const struct picture_place place = sampler_at(sampler, x, y);
    struct radiance seen = tracer_camera(sampler->tracer, worker, &place);
    arena_reset(worker->scratch);
    sampler_take(&seen, out);
}

/* The same of a place that is another tile's, of which the picture may have
 * been made by now. */
static float *sampler_place_beyond(const struct sampler *sampler, int x, int y)
{
    return sampler->edges ? sampler_edge(sampler, x, y)
                          : sampler_place(sampler, x, y);
}

struct area sampler_foreseen(const struct sampler *sampler)
{
    const struct render_options *options = sampler->options;
    const struct area *first = &sampler->first;
    const int apron = FIRST_HITS_APRON, beyond = FIRST_HITS_BEYOND;
    return (struct area){
        .left = larger(first->left - apron, -beyond),
        .top = larger(first->top - apron, -beyond),
        .right = smaller(first->right + apron, options->width + beyond),
        .bottom = smaller(first->bottom + apron, options->height + beyond),
    };
}

struct first_hits sampler_grid(const struct sampler *sampler)
{
    struct area area = sampler_foreseen(sampler);
    return (struct first_hits){
        .width = sampler->options->width,
        .height = sampler->options->height,
        .left = area.left,
        .top = area.top,
        .columns = area.right - area.left,
        .rows = area.bottom - area.top,
        .apron = FIRST_HITS_APRON,
        .middle = sampler_middle(sampler),
    };
}

enum { BLOCK_MOST = SAMPLER_BLOCK * SAMPLER_BLOCK };

/* Places close together. */
struct sampler_block {
    unsigned count;
    struct picture_place places[BLOCK_MOST];
    struct rays rays;
    struct world_hit hits[BLOCK_MOST];
};

static void block_aim(const struct sampler *sampler,
                      struct sampler_block *block)
{
    _Static_assert((int)BLOCK_MOST <= (int)WORLD_RAYS, "a packet");
    tracer_rays(sampler->tracer, block->places, block->count, &block->rays);
}

/* With `needed` only those that are. Returns whether there are any. */
static bool block_start(const struct sampler *sampler,
                        struct sampler_block *block,
                        const struct first_hits *grid, struct area area,
                        bool needed)
{
    block->count = 0;
    for (int y = area.top; y < area.bottom; y++)
        for (int x = area.left; x < area.right; x++) {
            if (needed && !sampler_needs(sampler, x, y))
                continue;
            struct picture_place *place = &block->places[block->count++];
            place->grid[0] = x;
            place->grid[1] = y;
            first_hits_place(grid, x, y, place->at);
        }
    if (block->count > 0)
        block_aim(sampler, block);
    return block->count > 0;
}

static void block_meet(const struct sampler *sampler,
                       struct sampler_block *block)
{
    tracer_meet_many(sampler->tracer, &block->rays, block->count, block->hits);
}

/* What the camera sees there, of what is met first. */
static void block_see(const struct sampler *sampler, struct worker *worker,
                      const struct sampler_block *block, struct radiance *seen)
{
    const struct tracer_met met = { block->places, &block->rays, block->hits,
                                    block->count };
    tracer_see_many(sampler->tracer, worker, &met, seen);
}

/* Whether what is met there can decide about a place that is needed, if that
 * depends on what is so near to it. */
static bool sampler_needs_near(const struct sampler *sampler, struct area area,
                               int apron)
{
    const struct area *first = &sampler->first;
    int right = smaller(area.right + apron, first->right);
    int bottom = smaller(area.bottom + apron, first->bottom);
    for (int y = larger(area.top - apron, first->top); y < bottom; y++)
        for (int x = larger(area.left - apron, first->left); x < right; x++)
            if (*sampler_state(sampler, x, y) & SAMPLER_NEEDED)
                return true;
    return false;
}

void sampler_meet(const struct sampler *sampler, struct first_hits *hits,
                  struct area area)
{
    struct sampler_block block;
    unsigned count = 0;
    if ((sampler->sparse && !sampler_needs_near(sampler, area, hits->apron)) ||
        !block_start(sampler, &block, hits, area, false))
        return;
    block_meet(sampler, &block);
    for (int y = area.top; y < area.bottom; y++)
        for (int x = area.left; x < area.right; x++)
            *first_hits_at(hits, x, y) = block.hits[count++];
}

void sampler_first(struct sampler *sampler, struct worker *worker,
                   struct area area)
{
    struct first_hits grid = sampler_grid(sampler);
    struct sampler_block block;
    struct radiance seen[BLOCK_MOST];
    if (!block_start(sampler, &block, &grid, area, true))
        return;
    if (!sampler->hits)
        block_meet(sampler, &block);
    for (unsigned i = 0; sampler->hits && i < block.count; i++)
        block.hits[i] =
            *first_hits_at(sampler->hits, (int)block.places[i].grid[0],
                           (int)block.places[i].grid[1]);
    block_see(sampler, worker, &block, seen);
    if (worker_stopped(worker)) /* while it was looked at */
        return;
    for (unsigned i = 0; i < block.count; i++) {
        float value[4];
        sampler_take(&seen[i], value);
        sampler_put(sampler, value, (int)block.places[i].grid[0],
                    (int)block.places[i].grid[1]);
    }
}

/* Sum of the differences after gamma correction; opacity counts when it is
 * wanted. */
static bool sampler_differ(const struct sampler *sampler, const float *a,
                           const float *b)
{
    double more =
        sampler->tracer->alpha ? fabs((double)a[3] - (double)b[3]) : 0;
    return perceived_differ(sampler->perceived, a, b, more,
                            sampler->options->threshold);
}

/* In [-0.5, 0.5), by the place in the picture alone. */
static double sampler_jitter(int x, int y, int number)
{
    uint64_t key = random_key((uint64_t)(unsigned)x, (uint64_t)(unsigned)y);
    return random_unit(random_key(key, (uint64_t)(unsigned)number)) - 0.5;
}

/* Adds up what is seen at places of a pixel. */
static void block_sum(const struct sampler *sampler, struct worker *worker,
                      struct sampler_block *block, double sum[4])
{
    struct radiance seen[BLOCK_MOST];
    block_aim(sampler, block);
    block_meet(sampler, block);
    block_see(sampler, worker, block, seen);
    for (unsigned i = 0; i < block->count; i++) {
        float value[4];
        sampler_take(&seen[i], value);
        for (int k = 0; k < 4; k++)
            sum[k] += (double)value[k];
    }
    block->count = 0;
}

/* Method 1: the mean of the centre and R x R samples. */
static void centre_refine(const struct sampler *sampler, struct worker *worker,
                          int x, int y, float pixel[4])
{
    int n = sampler_depth(sampler);
    double sum[4], jitter = sampler->options->jitter;
    struct sampler_block block;
    block.count = 0;
    for (int k = 0; k < 4; k++)
        sum[k] = (double)pixel[k];
    worker_pixel_begin(worker);
    for (int i = 0; i < n * n; i++) {
        double u = i % n + 0.5 + jitter * sampler_jitter(x, y, 2 * i);
        double v = i / n + 0.5 + jitter * sampler_jitter(x, y, 2 * i + 1);
        block.places[block.count++] = sampler_at(sampler, x + u / n, y + v / n);
        if (block.count == BLOCK_MOST || i == n * n - 1)
            block_sum(sampler, worker, &block, sum);
    }
    worker_pixel_end(worker);
    for (int k = 0; k < 4; k++)
        pixel[k] = (float)(sum[k] / (n * n + 1));
}

/* A tile of method 1: its pixels as far as they are done, with one more column
 * to the left and one more row above, which are only looked at. */
struct centres {
    const struct sampler *sampler;
    struct worker *worker;
    struct area tile;
    float *pixels; /* five for each: RGBA, and 1 once it is refined */
};

static float *centres_place(const struct centres *c, int x, int y)
{
    int row = y - c->tile.top + 1, column = x - c->tile.left + 1;
    return c->pixels + (row * (CENTRES_TILE + 1) + column) * 5;
}

static void centres_refine(const struct centres *c, int x, int y)
{
    float *pixel = centres_place(c, x, y);
    if (x < c->tile.left || y < c->tile.top || pixel[4] != 0)
        return;
    pixel[4] = 1;
    centre_refine(c->sampler, c->worker, x, y, pixel);
}

static bool centres_differ(const struct centres *c, int x, int y, int other_x,
                           int other_y)
{
    return sampler_differ(c->sampler, centres_place(c, x, y),
                          centres_place(c, other_x, other_y));
}

/* The pixel is compared with its neighbours as they are by now, refined or
 * not; where they differ both are refined, if they aren't yet. */
static void centres_pixel(const struct centres *c, int x, int y)
{
    bool left = centres_differ(c, x, y, x - 1, y);
    bool above = centres_differ(c, x, y, x, y - 1);
    if (left)
        centres_refine(c, x - 1, y);
    if (above)
        centres_refine(c, x, y - 1);
    if (left || above)
        centres_refine(c, x, y);
}

static void centres_tile(const struct centres *c)
{
    const struct area *tile = &c->tile;
    for (int y = tile->top - 1; y < tile->bottom; y++)
        for (int x = tile->left - 1; x < tile->right; x++) {
            bool beyond = x < tile->left || y < tile->top;
            float *pixel = centres_place(c, x, y);
            float *first = beyond ? sampler_place_beyond(c->sampler, x, y)
                                  : sampler_place(c->sampler, x, y);
            memcpy(pixel, first, 4 * sizeof *pixel);
            pixel[4] = 0;
        }
    for (int y = tile->top; y < tile->bottom; y++)
        for (int x = tile->left; x < tile->right; x++) {
            if (worker_stopped(c->worker))
                return;
            centres_pixel(c, x, y);
        }
}

/* One pixel of method 2: a fine grid of (n + 1)^2 places whose corners are
 * known from the start. */
struct quarters {
    const struct sampler *sampler;
    struct worker *worker;
    int x, y, n;
    float *places;
};

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

void sampler_tile(const struct sampler *sampler, struct worker *worker,
                  struct area tile, float *scratch)
{
    struct centres centres = { sampler, worker, tile, scratch };
    if (sampler->direct || (sampler->sparse && !sampler_wants(sampler, tile)))
        return;
    if (sampler_centres(sampler))
        centres_tile(&centres);
    const struct area *wanted = &sampler->wanted;
    int left = larger(tile.left, wanted->left);
    int right = smaller(tile.right, wanted->right);
    int bottom = smaller(tile.bottom, wanted->bottom);
    for (int y = larger(tile.top, wanted->top); y < bottom; y++)
        for (int x = left; x < right; x++) {
            float pixel[4];
            if (sampler_corners(sampler))
                corners_pixel(sampler, worker, x, y, scratch, pixel);
            else
                memcpy(pixel, centres_place(&centres, x, y), sizeof pixel);
            if (worker_stopped(worker))
                return;
            memcpy(sampler_pixel(sampler, x, y), pixel, sizeof pixel);
            *sampler_state(sampler, x, y) |= SAMPLER_DONE;
        }
}

double sampler_rescue(const struct sampler *sampler)
{
    const struct area *wanted = &sampler->wanted;
    double known = 0, all = 0;
    for (int y = wanted->top; y < wanted->bottom; y++)
        for (int x = wanted->left; x < wanted->right; x++) {
            unsigned char state = *sampler_state(sampler, x, y);
            bool seen = state & SAMPLER_SEEN, done = state & SAMPLER_DONE;
            if (seen && !done && !sampler->direct && !sampler->edges)
                memcpy(sampler_pixel(sampler, x, y),
                       sampler_place(sampler, x, y), 4 * sizeof(float));
            known += seen || done;
            all++;
        }
    return known / all;
}

size_t sampler_scratch(const struct sampler *sampler)
{
    size_t n = (size_t)1 << (sampler_depth(sampler) - 1);
    if (sampler_corners(sampler))
        return (n + 1) * (n + 1) * 4;
    return sampler_centres(sampler)
               ? (size_t)(CENTRES_TILE + 1) * (CENTRES_TILE + 1) * 5
               : 0;
}
