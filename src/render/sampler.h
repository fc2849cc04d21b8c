/* Antialiasing: which pixels are sampled again, and how (section 5.10 of
 * tests/povray.md). Both methods first sample a grid over the whole picture,
 * then look at it tile by tile. The tiles' places are those of the picture,
 * whatever part of it is wanted, so that every pixel is the same in every part,
 * with any number of threads. */
#ifndef RENDER_SAMPLER_H
#define RENDER_SAMPLER_H

#include "image/area.h"
#include "render/perceived.h"
#include "render/render.h"

/* What is known of a place of the grid: whether it is needed, whether it is
 * sampled, and, as a pixel of the picture, done. */
enum { SAMPLER_NEEDED = 1, SAMPLER_SEEN = 2, SAMPLER_DONE = 4 };

/* The first samples: float RGBA for every place of the grid. Method 1 and no
 * antialiasing: pixel centres; method 2: pixel corners. */
struct sampler {
    const struct tracer *tracer;
    const struct render_options *options;
    struct image *image;
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
    bool sparse; /* not all places are needed */
};

/* For sampler_tile into `image`. Frees with sampler_free. */
struct sampler sampler_new(const struct tracer *tracer,
                           const struct render_options *options,
                           struct image *image);
void sampler_free(struct sampler *sampler);

/* Values of tiles that were drawn before, of any part of the picture. First
 * samples must come before pixels; pixels that are no tile's are not taken. */
void sampler_give_first(struct sampler *sampler, struct area area,
                        const float *values);
void sampler_give_pixels(struct sampler *sampler, struct area area,
                         const float *values);

/* Notes which places of the grid are needed for what is wanted, this process's
 * and not done: all other functions look at these alone. Returns whether there
 * are any. */
bool sampler_need(struct sampler *sampler);

/* Whether a place is needed and not sampled; whether any of a tile is. */
bool sampler_needs(const struct sampler *sampler, int x, int y);
bool sampler_needs_any(const struct sampler *sampler, struct area tile);

/* Copies the first samples of a tile, as sampler_give_first wants them. */
void sampler_take_first(const struct sampler *sampler, struct area tile,
                        float *values);

/* The same of its wanted pixels, whose area is returned; it is empty if some
 * are missing. */
struct area sampler_take_pixels(const struct sampler *sampler, struct area tile,
                                float *values);

/* Whether a pixel of the tile is wanted, this process's and not done. */
bool sampler_wants(const struct sampler *sampler, struct area tile);

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
 * them) from the first samples and, where they differ, more of them, unless
 * there is nothing to do. `scratch` holds sampler_scratch floats. Returns
 * early, with pixels missing, when the worker is stopped. */
void sampler_tile(const struct sampler *sampler, struct worker *worker,
                  struct area tile, float *scratch);

/* What is known of a tile's wanted pixels, to options->drawn if there is
 * anybody: the pixels that are done, else first samples. `values` holds four
 * floats for each pixel of the tile. */
void sampler_tell(const struct sampler *sampler, struct area tile,
                  float *values);

/* When the work was stopped: the first sample stands for each pixel that is
 * missing, as far as there is one. Returns the share of pixels that have
 * a sample. */
double sampler_rescue(const struct sampler *sampler);

/* How many floats a thread needs for a tile. */
size_t sampler_scratch(const struct sampler *sampler);

#endif
