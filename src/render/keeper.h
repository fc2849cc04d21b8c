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
    double begin;           /* clock_seconds(), when it is to be */
    /* Begins it, or returns NULL: then nothing is kept. */
    struct part_file *(*create)(void *context);
    /* Each second called by a thread that has kept a tile, to put the file onto
     * the disk; NULL: somebody else does. */
    void (*settle)(void *context);
    void *context;
    atomic_int state;  /* KEEPER_WAITS at first, KEEPER_READY with a file */
    atomic_int second; /* of clock_seconds(), when it was settled last */
    atomic_ullong nanoseconds; /* that threads worked for it, together */
};

enum { KEEPER_WAITS, KEEPER_BEGINS, KEEPER_READY, KEEPER_OFF };

/* Whether tiles can be kept now; begins the file when it is time to. Any
 * thread. */
bool keeper_ready(struct keeper *keeper);

/* Counts what the calling thread has worked for it since clock_worked_here()
 * was `start`. */
void keeper_count(struct keeper *keeper, double start);

/* Calls `settle` if it is time to, by whoever has put something into the file;
 * keeper_pass_done does. */
void keeper_settle(struct keeper *keeper);

/* The tiles of a pass over a picture, numbered from 0: each is kept once, those
 * that were done before the file was begun as soon as it is. */
struct keeper_pass {
    struct keeper *keeper; /* NULL: nothing is kept */
    atomic_uchar *states;
    size_t count;
    atomic_bool behind; /* some may be done and not kept */
    /* Puts the tile into the file. */
    void (*put)(void *context, size_t tile, unsigned thread);
    void *context;
};

void keeper_pass_start(struct keeper_pass *pass, struct keeper *keeper,
                       size_t count);
void keeper_pass_end(struct keeper_pass *pass);

/* A tile is done: its values don't change any more. */
void keeper_pass_done(struct keeper_pass *pass, size_t tile, unsigned thread);

#endif
