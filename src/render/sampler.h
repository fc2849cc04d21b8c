/* Antialiasing: which pixels are sampled again, and how (section 5.10 of
 * tests/povray.md). Both methods first sample a grid over the whole picture,
 * then look at it tile by tile. The tiles' places are those of the picture,
 * whatever part of it is wanted, so that every pixel is the same in every part,
 * with any number of threads. */
#ifndef RENDER_SAMPLER_H
#define RENDER_SAMPLER_H

#include "render/perceived.h"
#include "render/render.h"

/* A part of the picture in pixels, ends exclusive. */
struct area {
    int left, top, right, bottom;
};

/* A place of the grid: not yet sampled, sampled, or, as a pixel of the picture,
 * done. */
enum { SAMPLER_UNSEEN, SAMPLER_SEEN, SAMPLER_DONE };

/* The first samples: float RGBA for every place of the grid. Method 1 and no
 * antialiasing: pixel centres; method 2: pixel corners. */
struct sampler {
    const struct tracer *tracer;
    const struct render_options *options;
    struct area wanted; /* pixels to be written */
    struct area first;  /* places of the grid */
    struct area tiled;  /* wanted pixels and those that decide about them */
    int tile;           /* edge of a tile */
    struct perceived *perceived; /* NULL: nothing is sampled again */
    float *grid;
    unsigned char *states; /* of the places of `first` */
    float *edges; /* or NULL; then the grid is the picture, although it is
                   * sampled again: what tiles see of others is kept here */
    const struct first_hits *hits; /* at the grid's places, if known; or NULL */
    bool direct; /* the grid is the picture itself: nothing is sampled again */
};

/* For sampler_tile into `image`. Frees with sampler_free. */
struct sampler sampler_new(const struct tracer *tracer,
                           const struct render_options *options,
                           struct image *image);
void sampler_free(struct sampler *sampler);

/* The grid with its apron (shade/first_hits.h), nothing known of it yet. */
struct area sampler_foreseen(const struct sampler *sampler);
struct first_hits sampler_grid(const struct sampler *sampler);

/* What the camera sees first at some of its places; areas as below. */
void sampler_meet(const struct sampler *sampler, struct first_hits *hits,
                  struct area block);

/* Fills places of the grid, an area of at most SAMPLER_BLOCK by as many. */
enum { SAMPLER_BLOCK = 4 };
void sampler_first(struct sampler *sampler, struct worker *worker,
                   struct area block);

/* Makes the wanted pixels of one tile (its left and top as sampler.tiled has
 * them) from the first samples and, where they differ, more of them. `scratch`
 * holds sampler_scratch floats. Returns early, with pixels missing, when the
 * worker is stopped. */
void sampler_tile(const struct sampler *sampler, struct worker *worker,
                  struct area tile, float *scratch, struct image *image);

/* When the work was stopped: the first sample stands for each pixel that is
 * missing, as far as there is one. Returns the share of pixels that have
 * a sample. */
double sampler_rescue(const struct sampler *sampler, struct image *image);

/* How many floats a thread needs for a tile. */
size_t sampler_scratch(const struct sampler *sampler);

#endif
