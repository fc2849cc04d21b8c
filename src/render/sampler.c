/* Antialiasing: see sampler.h. Measured on POV-Ray 3.7. */
#include "render/sampler.h"

#include <string.h>

#include "base/memory.h"
#include "render/sampler_block.h"

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

/* Whether method 1 may write the first samples into the image itself: it has
 * room for all of them but the row above and the column before. */
static bool sampler_in_place(const struct sampler *sampler)
{
    const struct area *tiled = &sampler->tiled, *wanted = &sampler->wanted;
    return sampler_centres(sampler) && tiled->left == 0 &&
           tiled->right == sampler->image->width &&
           tiled->top == sampler->options->image_top &&
           memcmp(wanted, tiled, sizeof *tiled) == 0;
}

static float *sampler_edges_new(const struct sampler *sampler)
{
    size_t across = sampler_across(sampler), down = sampler_down(sampler);
    size_t columns = (across + CENTRES_TILE) / CENTRES_TILE;
    size_t pixels = sampler_edge_rows(sampler) * across + columns * down;
    return memory_new(pixels * 4 * sizeof(float));
}

/* For the working space of the scene's light. */
static struct perceived *perceived_new(const struct settings *settings,
                                       const struct render_options *options)
{
    struct perceived *perceived = memory_new(sizeof *perceived);
    double gamma = options->antialias_gamma;
    double exponent = gamma > 0 ? 1 / gamma : 1;
    if (settings->gamma_kind == GAMMA_SRGB)
        perceived_fill_srgb(perceived, exponent);
    else
        perceived_fill(perceived, settings->gamma_kind == GAMMA_POWER
                                      ? exponent * settings->assumed_gamma
                                      : exponent);
    return perceived;
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
    if (options->antialias)
        sampler.perceived = perceived_new(&tracer->scene->settings, options);
    sampler.direct = !options->antialias;
    if (sampler_in_place(&sampler))
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

struct area sampler_foreseen(const struct sampler *sampler)
{
    const struct render_options *options = sampler->options;
    const struct area *first = &sampler->first;
    const int apron = FIRST_HITS_APRON, beyond = FIRST_HITS_BEYOND;
    struct area around = { first->left - apron, first->top - apron,
                           first->right + apron, first->bottom + apron };
    struct area picture = { -beyond, -beyond, options->width + beyond,
                            options->height + beyond };
    return area_both(around, picture);
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
            place->pixel = 0;
            place->around = NULL;
            first_hits_place(grid, x, y, place->at);
        }
    if (block->count > 0)
        block_aim(sampler, block);
    return block->count > 0;
}

/* Whether what is met there can decide about a place that is needed, if that
 * depends on what is so near to it. */
static bool sampler_needs_near(const struct sampler *sampler, struct area area,
                               int apron)
{
    struct area near = { area.left - apron, area.top - apron,
                         area.right + apron, area.bottom + apron };
    near = area_both(near, sampler->first);
    for (int y = near.top; y < near.bottom; y++)
        for (int x = near.left; x < near.right; x++)
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
    tracer_meet_many(sampler->tracer, &block.rays, block.count, block.hits);
    for (int y = area.top; y < area.bottom; y++)
        for (int x = area.left; x < area.right; x++)
            *first_hits_at(hits, x, y) = block.hits[count++];
}

/* All of the area, if that is known: neighbours may make use of it. */
static void block_tell(const struct sampler *sampler,
                       struct sampler_block *block, struct area area,
                       struct first_hits *around)
{
    if (!tracer_is_single(sampler->tracer) ||
        block->count < (unsigned)area_pixels(area))
        return;
    *around = sampler_grid(sampler);
    around->left = area.left;
    around->top = area.top;
    around->columns = area.right - area.left;
    around->rows = area.bottom - area.top;
    around->at = block->hits;
    for (unsigned i = 0; i < block->count; i++)
        block->places[i].around = around;
}

void sampler_first(struct sampler *sampler, struct worker *worker,
                   struct area area)
{
    struct first_hits grid = sampler_grid(sampler), around;
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
    block_tell(sampler, &block, area, &around);
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
