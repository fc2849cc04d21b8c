/* How far a picture is, on standard error. */
#ifndef CLI_PROGRESS_H
#define CLI_PROGRESS_H

#include <stdatomic.h>

#include "cli/options.h"
#include "cli/picture.h"

struct progress {
    bool live;          /* on a terminal: one line, rewritten */
    bool lines;         /* +V elsewhere: a line for each tenth */
    const char *name;   /* of the picture */
    double start;       /* seconds */
    atomic_int next;    /* milliseconds after start, or tenths, not yet told */
    atomic_int samples; /* of each pixel so far, if it goes by samples */
    atomic_int error;   /* estimated, in 1/10000; -1: not yet */
};

/* Ready for the picture `name`. */
void progress_start(struct progress *progress, const struct options *options,
                    const char *name);

/* For render_options.progress; any thread, `done` is 0..1. */
void progress_tell(void *progress, double done);

/* For render_options.passed. */
void progress_passed(void *progress, int samples, double error);

/* Takes the line away. */
void progress_clear(const struct progress *progress);

/* "scene.png: 800 x 600 pixels in 1.2 s", where progress was to be told. */
void progress_finish(const struct progress *progress,
                     const struct options *options);

/* Says that a signal ended the work in the index-th frame, and what is left of
 * that. */
void progress_interrupted(const struct frames *frames, int index,
                          const struct unfinished *unfinished);

#endif
