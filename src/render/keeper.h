/* Keeps finished tiles on disk while a picture is drawn, so that nothing is
 * lost but the last second, and gives those back that are there already. */
#ifndef RENDER_KEEPER_H
#define RENDER_KEEPER_H

#include <stdatomic.h>

#include "image/part_file.h"

/* The file is begun when the work has lasted for a while: most pictures are
 * done by then, and never have one. */
struct keeper {
    struct part_file *file; /* NULL: not begun */
    /* Begins it, or returns NULL: then nothing is kept. */
    struct part_file *(*create)(void *context);
    /* Called by a thread that has put tiles into the file, once a second: they
     * are to go onto the disk. */
    void (*settle)(void *context);
    void *context;
    atomic_int state;  /* KEEPER_WAITS at first, KEEPER_READY with a file */
    atomic_llong next; /* microseconds of clock_seconds(), when something is to
                        * be kept next; the file is begun then */
    atomic_ullong nanoseconds; /* that threads worked for it, together */
};

enum { KEEPER_WAITS, KEEPER_BEGINS, KEEPER_READY, KEEPER_OFF };

/* Nothing is kept before clock_seconds() is `begin`. */
void keeper_start(struct keeper *keeper, double begin);

/* Whether tiles can be kept now; begins the file when it is time to. Any
 * thread. */
bool keeper_ready(struct keeper *keeper);

/* Whether a second has passed since this was last true, and tiles can be kept.
 * Any thread; true for one alone. */
bool keeper_due(struct keeper *keeper);

/* Counts what the calling thread has worked for it since clock_worked_here()
 * was `start`. */
void keeper_count(struct keeper *keeper, double start);

/* The tiles of a pass over a picture, numbered from 0. Those that are done are
 * kept once a second, all together: what a picture that is drawn quickly did in
 * its last second need not be kept at all. */
struct keeper_pass {
    struct keeper *keeper; /* NULL: nothing is kept */
    atomic_uchar *states;
    size_t count;
    atomic_size_t next;  /* tile to be looked at; `count` and more: none */
    atomic_uint putting; /* threads that do */
    /* Puts the tile into the file. */
    void (*put)(void *context, size_t tile, unsigned thread);
    void *context;
};

void keeper_pass_start(struct keeper_pass *pass, struct keeper *keeper,
                       size_t count);

/* A tile is done: its values don't change before the pass ends. */
void keeper_pass_done(struct keeper_pass *pass, size_t tile, unsigned thread);

/* `keep`: what is done and not kept is, by thread 0. All threads are through
 * with it. */
void keeper_pass_end(struct keeper_pass *pass, bool keep);

#endif
