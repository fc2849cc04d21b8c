/* Where the values of a sampler are; for the files of it. */
#ifndef RENDER_SAMPLER_PLACES_H
#define RENDER_SAMPLER_PLACES_H

#include <string.h>

#include "render/sampler.h"

enum {
    /* Method 1 decides by what is already refined, in reading order from the
     * beginning of a tile: POV-Ray's default tile, so that its pixels match. */
    CENTRES_TILE = 32,
    UNSEEN = -1, /* as opacity: not sampled */
};

static inline bool sampler_corners(const struct sampler *sampler)
{
    return sampler->options->antialias && sampler->options->method == 2;
}

static inline bool sampler_centres(const struct sampler *sampler)
{
    return sampler->options->antialias && sampler->options->method != 2;
}

_Static_assert((int)RENDER_BAND % CENTRES_TILE == 0, "bands of whole tiles");

/* Places of the grid each way, with the column before and the row above. */
static inline size_t sampler_across(const struct sampler *sampler)
{
    return (size_t)(sampler->tiled.right - sampler->tiled.left + 1);
}

static inline size_t sampler_down(const struct sampler *sampler)
{
    return (size_t)(sampler->tiled.bottom - sampler->tiled.top + 1);
}

/* Rows, then columns, that are above or to the left of a tile. */
static inline size_t sampler_edge_rows(const struct sampler *sampler)
{
    return (sampler_down(sampler) + CENTRES_TILE - 1) / CENTRES_TILE;
}

/* Where it is kept what tiles to the right and below see of a place; NULL: they
 * don't. */
static inline float *sampler_edge(const struct sampler *sampler, int x, int y)
{
    size_t across = sampler_across(sampler), down = sampler_down(sampler);
    size_t column = (size_t)(x - sampler->tiled.left + 1);
    size_t row = (size_t)(y - sampler->tiled.top + 1);
    if (row % CENTRES_TILE == 0)
        return sampler->edges + (row / CENTRES_TILE * across + column) * 4;
    if (column % CENTRES_TILE != 0)
        return NULL;
    size_t before = sampler_edge_rows(sampler) * across;
    return sampler->edges + (before + column / CENTRES_TILE * down + row) * 4;
}

static inline float *sampler_pixel(const struct sampler *sampler, int x, int y)
{
    return image_pixel(sampler->image, x, y - sampler->options->image_top);
}

static inline float *sampler_place(const struct sampler *sampler, int x, int y)
{
    if (sampler->direct)
        return sampler_pixel(sampler, x, y);
    const struct area *first =
        sampler->edges ? &sampler->tiled : &sampler->first;
    if (sampler->edges && (x < first->left || y < first->top))
        return sampler_edge(sampler, x, y);
    size_t columns = (size_t)(first->right - first->left);
    size_t row = (size_t)(y - first->top), column = (size_t)(x - first->left);
    return sampler->grid + (row * columns + column) * 4;
}

static inline unsigned char *sampler_state(const struct sampler *sampler, int x,
                                           int y)
{
    const struct area *first = &sampler->first;
    size_t columns = (size_t)(first->right - first->left);
    size_t row = (size_t)(y - first->top), column = (size_t)(x - first->left);
    return sampler->states + row * columns + column;
}

/* Where the grid is the picture a pixel that is done stays as it is. */
static inline void sampler_put(const struct sampler *sampler,
                               const float value[4], int x, int y)
{
    unsigned char *state = sampler_state(sampler, x, y);
    float *place = sampler_place(sampler, x, y);
    float *edge = sampler->edges ? sampler_edge(sampler, x, y) : NULL;
    bool done = *state & SAMPLER_DONE && (sampler->edges || sampler->direct);
    if (!done)
        memcpy(place, value, 4 * sizeof *place);
    if (edge && (edge != place || done))
        memcpy(edge, value, 4 * sizeof *edge);
    *state |= SAMPLER_SEEN;
}

#endif
