/* The picture: tiles on all cores, antialiasing, progress, interruption. */
#ifndef RENDER_RENDER_H
#define RENDER_RENDER_H

#include <stdatomic.h>

#include "image/area.h"
#include "image/image.h"
#include "render/keeper.h"
#include "render/share.h"
#include "tracer/tracer.h"

struct telling;

/* A part of a picture, row by row. */
struct render_part {
    struct area area;
    const float *pixels; /* RGBA, in the working space */
};

struct render_options {
    int width, height;
    /* The part to render, 0-based, end exclusive; the rest stays black. */
    int column_start, column_end, row_start, row_end;
    struct share share;    /* of these pixels, those that are drawn here; the
                            * others    stay black */
    struct keeper *keeper; /* of finished tiles; or NULL. What it has already is
                            * not drawn again */
    bool antialias;
    int method;             /* +AM: 1 or 2 */
    double threshold;       /* +A: 0.3 */
    int depth;              /* +R: 3 */
    double jitter;          /* +J: 1, 0 for -J */
    double antialias_gamma; /* +AG: 2.5 */
    unsigned threads;
    int tile; /* +BS: edge in pixels, 32 */
    const atomic_int *stop;
    struct telling *telling; /* of the one thread; NULL: nobody asks */
    /* Called now and then from any thread with the share done, 0..1; may be
     * NULL. */
    void (*progress)(void *context, double done);
    /* Whole paths: samples of each pixel at most, and what ends the work
     * earlier: the estimated relative error, and seconds; 0: nothing. */
    int samples;
    int seed; /* of the samples: another one, another noise */
    double target_error, target_time;
    /* Called after each pass over the picture, by one thread; may be NULL. */
    void (*passed)(void *context, int samples, double error);
    void *progress_context;
    /* Called from any thread with each part of the picture that has been
     * looked at: first with first samples, or means of some, later again; the
     * last time with its pixels as they are in the picture. May be NULL. */
    void (*drawn)(void *context, const struct render_part *part);
    void *drawn_context;
    int image_top; /* the row of the picture that is the image's first; 0 but
                    * where bands are drawn */
};

enum { RENDER_BAND = 32 };

/* About how many camera rays that takes. */
double render_camera_rays(const struct render_options *options);

struct render_stats {
    unsigned long long camera_rays, secondary_rays, shadow_rays;
    int samples;  /* of each pixel; 0: not by samples */
    double error; /* estimated, relative; INFINITY: too few passes to tell */
    double share; /* of the pixels, that have been drawn; 1 if not stopped */
};

/* Whether the picture is put together from the keeper's file: `image` is a band
 * of it, or other processes have other parts. */
bool render_is_piece(const struct render_options *options,
                     const struct image *image);

/* Renders into `image` (of width x height, black), in the working space.
 * The same bits for any number of threads, for any share and whatever was kept.
 * Returns false if stopped: the image then has the pixels that were ready.
 *
 * An image of less height than the picture is used for one band of the picture
 * after the other, and holds the last at the end: the keeper has them all. Its
 * height must be a multiple of RENDER_BAND. */
bool render_run(const struct tracer *tracer,
                const struct render_options *options, struct image *image,
                struct render_stats *stats);

#endif
