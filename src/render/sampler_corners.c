/* Antialiasing by method 2: a pixel whose corners differ is cut into quarters,
 * and these again. Measured on POV-Ray 3.7. Pixels that are close together are
 * cut together, a step at a time, so that their rays fill packets. */
#include <string.h>

#include "render/sampler_refine.h"

enum {
    CORNERS_PIXELS = 16,   /* cut together; lightmesh/tuning.h has room for what
                            * as many share: PIXEL_SLOTS */
    CORNERS_PLACES = 4096, /* of them all, if a pixel doesn't need more */
    CORNERS_CELL = 8,      /* pixels close together, across and down */
    ASKED = -2,            /* as opacity: will be sampled next */
};

/* A pixel: a fine grid of (n + 1)^2 places whose corners are known from the
 * start. */
struct quarters {
    int x, y;
    unsigned long long number; /* worker_pixel's */
    float *places;
    bool missing; /* places that decide are not sampled */
};

struct corners {
    const struct sampler *sampler;
    struct worker *worker;
    int n;
    size_t unit; /* floats of a pixel's places */
    float *scratch;
    int count;
    struct quarters of[CORNERS_PIXELS];
    struct sampler_block block;
    float *to[BLOCK_MOST]; /* of the block's places */
};

static size_t corners_unit(const struct sampler *sampler)
{
    size_t n = (size_t)1 << (sampler_depth(sampler) - 1);
    return (n + 1) * (n + 1) * 4;
}

/* How many pixels are cut together. */
static int corners_most(const struct sampler *sampler)
{
    size_t fit = (size_t)4 * CORNERS_PLACES / corners_unit(sampler);
    return fit < 1 ? 1 : fit < CORNERS_PIXELS ? (int)fit : CORNERS_PIXELS;
}

static void corners_see(struct corners *c)
{
    float values[BLOCK_MOST][4];
    block_values(c->sampler, c->worker, &c->block, values);
    for (unsigned i = 0; i < c->block.count; i++)
        memcpy(c->to[i], values[i], sizeof values[i]);
    c->block.count = 0;
}

/* The place will be sampled. */
static void corners_ask(struct corners *c, const struct quarters *q, int i,
                        int j, float *to)
{
    /* A fifth of the distance either way: POV-Ray's jitter, measured. */
    double jitter = 0.4 * c->sampler->options->jitter;
    int number = 2 * (j * (c->n + 1) + i);
    uint64_t key = jitter_key(q->x, q->y);
    double u = i + jitter * jitter_number(key, number);
    double v = j + jitter * jitter_number(key, number + 1);
    unsigned next = c->block.count++;
    sampler_at(c->sampler, q->x + u / c->n, q->y + v / c->n,
               &c->block.places[next]);
    c->block.places[next].pixel = q->number;
    c->to[next] = to;
    if (c->block.count == BLOCK_MOST)
        corners_see(c);
}

/* A sample, or NULL: it is asked for. */
static const float *quarters_place(struct corners *c, struct quarters *q, int i,
                                   int j)
{
    float *place = q->places + (j * (c->n + 1) + i) * 4;
    if (place[3] > (float)UNSEEN)
        return place;
    if (place[3] > (float)ASKED) {
        place[3] = (float)ASKED;
        corners_ask(c, q, i, j, place);
    }
    q->missing = true;
    return NULL;
}

static bool quarters_differ(const struct corners *c, const float *corner[4])
{
    for (int a = 0; a < 4; a++)
        for (int b = a + 1; b < 4; b++)
            if (sampler_differ(c->sampler, corner[a], corner[b]))
                return true;
    return false;
}

static void corners_mean(const float *corner[4], double mean[4])
{
    for (int k = 0; k < 4; k++) {
        mean[k] = 0;
        for (int part = 0; part < 4; part++)
            mean[k] += (double)corner[part][k] / 4;
    }
}

/* The mean over a square of `size` places: of its corners, or of its four
 * quarters if any two corners differ. Nothing while places are missing. */
static void quarters_mean(struct corners *c, struct quarters *q, int i, int j,
                          int size, double mean[4])
{
    const float *corner[4];
    bool known = true;
    for (int part = 0; part < 4; part++) {
        corner[part] =
            quarters_place(c, q, i + part % 2 * size, j + part / 2 * size);
        known &= corner[part] != NULL;
    }
    for (int k = 0; k < 4; k++)
        mean[k] = 0;
    if (!known)
        return;
    bool cut = size > 1 && quarters_differ(c, corner);
    for (int part = 0; part < 4; part++) {
        double value[4];
        for (int k = 0; k < 4; k++)
            value[k] = (double)corner[part][k];
        if (cut)
            quarters_mean(c, q, i + part % 2 * (size / 2),
                          j + part / 2 * (size / 2), size / 2, value);
        for (int k = 0; k < 4; k++)
            mean[k] += value[k] / 4;
    }
}

static void corners_finish(const struct corners *c, const double mean[4], int x,
                           int y)
{
    float pixel[4];
    for (int k = 0; k < 4; k++)
        pixel[k] = (float)mean[k];
    sampler_finish(c->sampler, pixel, x, y, 1);
}

/* A look at the pixel as far as it is known; finishes it if that suffices. */
static void quarters_look(struct corners *c, struct quarters *q)
{
    double mean[4];
    q->missing = false;
    quarters_mean(c, q, 0, 0, c->n, mean);
    if (!q->missing && !worker_stopped(c->worker))
        corners_finish(c, mean, q->x, q->y);
}

/* All pixels by turns, until nothing is missing. */
static void corners_resolve(struct corners *c)
{
    while (c->count > 0 && !worker_stopped(c->worker)) {
        int left = 0;
        for (int i = 0; i < c->count; i++) {
            quarters_look(c, &c->of[i]);
            if (c->of[i].missing)
                c->of[left++] = c->of[i];
        }
        c->count = left;
        if (c->block.count > 0)
            corners_see(c);
    }
}

static void corners_begin(struct corners *c, int x, int y,
                          const float *corner[4])
{
    const struct sampler *sampler = c->sampler;
    struct quarters *q = &c->of[c->count];
    size_t n = (size_t)c->n;
    *q = (struct quarters){ .x = x, .y = y };
    q->number = worker_pixel(c->worker);
    q->places = c->scratch + (size_t)c->count * c->unit;
    for (size_t i = 3; i < c->unit; i += 4)
        q->places[i] = (float)UNSEEN;
    for (size_t part = 0; part < 4; part++) {
        size_t place = part / 2 * n * (n + 1) + part % 2 * n;
        memcpy(q->places + 4 * place, corner[part], 4 * sizeof(float));
    }
    /* Nobody who follows the rays one by one wants others between them. */
    if (++c->count == corners_most(sampler) || c->worker->telling)
        corners_resolve(c);
}

/* Is done at once if its corners are alike. */
static void corners_pixel(struct corners *c, int x, int y)
{
    const float *corner[4];
    for (int part = 0; part < 4; part++)
        corner[part] = sampler_place(c->sampler, x + part % 2, y + part / 2);
    if (c->n > 1 && quarters_differ(c, corner)) {
        corners_begin(c, x, y, corner);
        return;
    }
    double mean[4];
    corners_mean(corner, mean);
    corners_finish(c, mean, x, y);
}

void corners_tile(const struct sampler *sampler, struct worker *worker,
                  struct area tile, float *scratch)
{
    struct corners c = {
        .sampler = sampler,
        .worker = worker,
        .n = 1 << (sampler_depth(sampler) - 1),
        .unit = corners_unit(sampler),
        .scratch = scratch,
    };
    struct area wanted = area_both(tile, sampler->wanted);
    const int cell = CORNERS_CELL;
    for (int top = wanted.top; top < wanted.bottom; top += cell)
        for (int left = wanted.left; left < wanted.right; left += cell) {
            struct area near = { left, top, left + cell, top + cell };
            near = area_both(near, wanted);
            for (int y = near.top; y < near.bottom; y++)
                for (int x = near.left; x < near.right; x++) {
                    if (worker_stopped(worker))
                        return;
                    corners_pixel(&c, x, y);
                }
        }
    corners_resolve(&c);
}

size_t corners_scratch(const struct sampler *sampler)
{
    return (size_t)corners_most(sampler) * corners_unit(sampler);
}
