/* How far a picture is, on standard error. */
#ifndef CLI_PROGRESS_H
#define CLI_PROGRESS_H

#include <stdatomic.h>

#include "cli/options.h"
#include "cli/picture.h"

struct progress {
    bool live;                   /* on a terminal: one line, rewritten */
    bool lines;                  /* +V elsewhere: a line for each tenth */
    bool json;                   /* a line of JSON each second */
    char frame[48];              /* "frame 3 of 40, ", or nothing */
    const char *name;            /* of the picture */
    const struct tracer *tracer; /* while it is drawn; or NULL */
    double all;                  /* seconds: when the first frame began, */
    double begun;                /* this one, */
    double start;                /* and its drawing */
    struct ticker *ticker;       /* while nothing is drawn yet; or NULL */
    _Atomic(const char *) doing; /* meanwhile: "reading" */
    atomic_int next;    /* milliseconds after start, or tenths, not yet told */
    atomic_int samples; /* of each pixel so far, if it goes by samples */
    atomic_int error;   /* estimated, in 1/10000; -1: not yet */
};

/* The index-th frame begins, a picture called `name`: from now on a terminal
 * says what is being done before there is anything to draw, if that takes long.
 */
void progress_begin(struct progress *progress, const struct options *options,
                    const char *name, int index);
void progress_doing(struct progress *progress, const char *doing);

/* The drawing starts; the tracer lasts until progress_finish or the next
 * frame. */
void progress_start(struct progress *progress, const struct tracer *tracer);

/* The frame is over, drawn or not. */
void progress_end(struct progress *progress);

/* For render_options.progress; any thread, `done` is 0..1. */
void progress_tell(void *progress, double done);

/* For render_options.passed. */
void progress_passed(void *progress, int samples, double error);

/* Takes the line away. */
void progress_clear(const struct progress *progress);

/* "scene.png: 800 x 600 pixels in 1.2 s", where progress was to be told: all
 * the time from progress_begin on. */
void progress_finish(const struct progress *progress,
                     const struct options *options);

/* "40 frames in 48 s", likewise, if there were several. */
void progress_total(const struct progress *progress,
                    const struct frames *frames);

/* Says that +C goes on with the part file of that name. */
void progress_left(const char *part);

/* Says that a signal ended the work in the index-th frame, and what is left of
 * that: a picture, and the part file called `part`, or "". */
void progress_interrupted(const struct frames *frames, int index,
                          const struct unfinished *unfinished,
                          const char *part);

#endif
