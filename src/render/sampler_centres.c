/* Antialiasing by method 1: pixels that differ from their neighbours get R x R
 * samples more. Measured on POV-Ray 3.7. */
#include <string.h>

#include "render/sampler_refine.h"

/* The first sample of a place that is another tile's, of which the picture may
 * have been made by now. */
static float *sampler_place_beyond(const struct sampler *sampler, int x, int y)
{
    return sampler->edges ? sampler_edge(sampler, x, y)
                          : sampler_place(sampler, x, y);
}

/* A pixel of method 1. */
struct centre {
    float now[4];     /* as it is by now */
    float refined[4]; /* the mean of the centre and R x R samples, if known */
};

/* What is known of it: that the first samples differ from those to the left or
 * above; that it will most likely be refined; that `refined` is known, and that
 * it is what it is now. */
enum {
    CENTRE_LEFT = 1,
    CENTRE_ABOVE = 2,
    CENTRE_LIKELY = 4,
    CENTRE_KNOWN = 8,
    CENTRE_DONE = 16,
};

enum {
    CENTRES_WIDE = CENTRES_TILE + 1,
    CENTRES_ALL = CENTRES_WIDE * CENTRES_WIDE
};

/* A tile of method 1: its pixels as far as they are done, with one more column
 * to the left and one more row above, which are only looked at. */
struct centre_pixels {
    struct centre at[CENTRES_ALL];
    unsigned char states[CENTRES_ALL];
};

struct centres {
    const struct sampler *sampler;
    struct worker *worker;
    struct area tile;
    struct centre_pixels *pixels;
};

enum {
    CENTRES_RAYS = 4 * BLOCK_MOST, /* so many together fill their packets */
    CENTRES_CELL = 8,              /* pixels close together, across and down */
};

static inline int centres_index(const struct centres *c, int x, int y)
{
    return (y - c->tile.top + 1) * CENTRES_WIDE + x - c->tile.left + 1;
}

static inline bool centres_inside(const struct centres *c, int x, int y)
{
    return x >= c->tile.left && y >= c->tile.top;
}

/* Pixels that are refined together: a sample is the same whoever asks. */
struct centre_group {
    int count, most;
    struct {
        int x, y, index;
        double sum[4];
    } of[CENTRES_RAYS];
};

static void group_add(struct centre_group *group, const struct centres *c,
                      int x, int y)
{
    int i = group->count++, index = centres_index(c, x, y);
    c->pixels->states[index] |= CENTRE_KNOWN;
    group->of[i].x = x;
    group->of[i].y = y;
    group->of[i].index = index;
    for (int k = 0; k < 4; k++)
        group->of[i].sum[k] = (double)c->pixels->at[index].now[k];
}

/* The pixel, and those close to it that will most likely be asked for after it:
 * most of their rays meet the same. Nobody who follows the rays one by one
 * wants others between them. */
static void group_gather(struct centre_group *group, const struct centres *c,
                         int x, int y)
{
    const struct area *tile = &c->tile;
    int n = sampler_depth(c->sampler), few = CENTRES_RAYS / (n * n);
    int left = x - (x - tile->left) % CENTRES_CELL;
    int top = y - (y - tile->top) % CENTRES_CELL;
    struct area cell = { left, top, left + CENTRES_CELL, top + CENTRES_CELL };
    cell = area_both(cell, *tile);
    group->count = 0;
    group->most = c->worker->telling ? 1 : few > 1 ? few : 1;
    group_add(group, c, x, y);
    for (int v = cell.top; v < cell.bottom; v++)
        for (int u = cell.left; u < cell.right; u++) {
            int state = c->pixels->states[centres_index(c, u, v)];
            if (group->count == group->most)
                return;
            if ((state & (CENTRE_LIKELY | CENTRE_KNOWN)) == CENTRE_LIKELY)
                group_add(group, c, u, v);
        }
}

/* Samples that are seen together, and whose they are. */
struct centre_samples {
    struct sampler_block block;
    int of[BLOCK_MOST];
};

static void samples_see(struct centre_samples *samples, const struct centres *c,
                        struct centre_group *group)
{
    struct sampler_block *block = &samples->block;
    float values[BLOCK_MOST][4];
    block_values(c->sampler, c->worker, block, values);
    for (unsigned i = 0; i < block->count; i++)
        for (int k = 0; k < 4; k++)
            group->of[samples->of[i]].sum[k] += (double)values[i][k];
    block->count = 0;
}

static void group_sample(struct centre_group *group, const struct centres *c)
{
    const struct sampler *sampler = c->sampler;
    int n = sampler_depth(sampler);
    double jitter = sampler->options->jitter;
    struct centre_samples samples;
    struct sampler_block *block = &samples.block;
    block->count = 0;
    for (int p = 0; p < group->count; p++) {
        int x = group->of[p].x, y = group->of[p].y;
        unsigned long long number = worker_pixel(c->worker);
        uint64_t key = jitter_key(x, y);
        for (int i = 0, column = 0, row = 0; i < n * n; i++, column++) {
            if (column == n)
                column = 0, row++;
            double u = column + 0.5 + jitter * jitter_number(key, 2 * i);
            double v = row + 0.5 + jitter * jitter_number(key, 2 * i + 1);
            struct picture_place *place = &block->places[block->count];
            *place = sampler_at(sampler, x + u / n, y + v / n);
            place->pixel = number;
            samples.of[block->count++] = p;
            if (block->count == BLOCK_MOST)
                samples_see(&samples, c, group);
        }
    }
    if (block->count > 0)
        samples_see(&samples, c, group);
    for (int p = 0; p < group->count; p++)
        for (int k = 0; k < 4; k++)
            c->pixels->at[group->of[p].index].refined[k] =
                (float)(group->of[p].sum[k] / (n * n + 1));
}

static void centres_refine(const struct centres *c, int x, int y)
{
    int index = centres_index(c, x, y);
    struct centre *pixel = &c->pixels->at[index];
    unsigned char *state = &c->pixels->states[index];
    if (!centres_inside(c, x, y) || *state & CENTRE_DONE)
        return;
    if (!(*state & CENTRE_KNOWN)) {
        struct centre_group group;
        group_gather(&group, c, x, y);
        group_sample(&group, c);
    }
    memcpy(pixel->now, pixel->refined, sizeof pixel->now);
    *state |= CENTRE_DONE;
}

static bool centres_differ(const struct centres *c, int a, int b)
{
    return sampler_differ(c->sampler, c->pixels->at[a].now,
                          c->pixels->at[b].now);
}

/* The pixel is compared with its neighbours as they are by now, refined or
 * not; where they differ both are refined, if they aren't yet. */
static void centres_pixel(const struct centres *c, int x, int y)
{
    const unsigned char *states = c->pixels->states;
    int here = centres_index(c, x, y), beside = here - 1;
    int over = here - CENTRES_WIDE;
    bool left = states[beside] & CENTRE_DONE ? centres_differ(c, here, beside)
                                             : states[here] & CENTRE_LEFT;
    bool above = states[over] & CENTRE_DONE ? centres_differ(c, here, over)
                                            : states[here] & CENTRE_ABOVE;
    if (left)
        centres_refine(c, x - 1, y);
    if (above)
        centres_refine(c, x, y - 1);
    if (left || above)
        centres_refine(c, x, y);
}

/* Compares the first samples. Who differs from the next to the right or below
 * will be refined, if not before then because of it. */
static void centres_compare(const struct centres *c)
{
    const struct area *tile = &c->tile;
    unsigned char *states = c->pixels->states;
    for (int y = tile->top; y < tile->bottom; y++)
        for (int x = tile->left; x < tile->right; x++) {
            int here = centres_index(c, x, y), over = here - CENTRES_WIDE;
            if (centres_differ(c, here, here - 1)) {
                states[here] |= CENTRE_LEFT;
                states[here - 1] |= CENTRE_LIKELY;
            }
            if (centres_differ(c, here, over)) {
                states[here] |= CENTRE_ABOVE;
                states[over] |= CENTRE_LIKELY;
            }
        }
}

/* And who differs from one that nothing refines before: what is refined may
 * not differ any more. */
static void centres_foresee(const struct centres *c)
{
    const struct area *tile = &c->tile;
    unsigned char *states = c->pixels->states;
    const int differs = CENTRE_LEFT | CENTRE_ABOVE;
    for (int y = tile->top; y < tile->bottom; y++)
        for (int x = tile->left; x < tile->right; x++) {
            int here = centres_index(c, x, y), over = here - CENTRES_WIDE;
            bool right = x + 1 < tile->right && states[over + 1] & CENTRE_LEFT;
            if ((states[here] & CENTRE_LEFT && !(states[here - 1] & differs)) ||
                (states[here] & CENTRE_ABOVE && !(states[over] & differs) &&
                 !right))
                states[here] |= CENTRE_LIKELY;
        }
}

/* Takes the first samples, and foresees what will be refined. */
static void centres_look(const struct centres *c)
{
    const struct area *tile = &c->tile;
    memset(c->pixels->states, 0, sizeof c->pixels->states);
    for (int y = tile->top - 1; y < tile->bottom; y++)
        for (int x = tile->left - 1; x < tile->right; x++) {
            float *pixel = c->pixels->at[centres_index(c, x, y)].now;
            memcpy(pixel,
                   centres_inside(c, x, y)
                       ? sampler_place(c->sampler, x, y)
                       : sampler_place_beyond(c->sampler, x, y),
                   4 * sizeof *pixel);
        }
    centres_compare(c);
    centres_foresee(c);
}

void centres_tile(const struct sampler *sampler, struct worker *worker,
                  struct area tile, float *scratch)
{
    struct centres c = { sampler, worker, tile, (void *)scratch };
    centres_look(&c);
    for (int y = tile.top; y < tile.bottom; y++)
        for (int x = tile.left; x < tile.right; x++) {
            if (worker_stopped(worker))
                return;
            centres_pixel(&c, x, y);
        }
    struct area wanted = area_both(tile, sampler->wanted);
    for (int y = wanted.top; y < wanted.bottom && !worker_stopped(worker); y++)
        for (int x = wanted.left; x < wanted.right; x++)
            sampler_finish(sampler, c.pixels->at[centres_index(&c, x, y)].now,
                           x, y);
}

size_t centres_scratch(void)
{
    return sizeof(struct centre_pixels) / sizeof(float) + 1;
}
