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
    /* Finished pixels are kept as levels of the picture's file; NULL: as they
     * are. Set before there is a file. */
    const struct tone_table *levels;
    /* Begins it, or returns NULL: then nothing is kept. */
    struct part_file *(*create)(void *context);
    /* Called by a thread that has put tiles into the file, at most once a
     * second: they are to go onto the disk. */
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

/* Whether tiles are to be kept again, a second after this was last true or
 * later. Any thread; true for one alone. */
bool keeper_due(struct keeper *keeper);

/* Puts finished pixels into the file, four floats each, which are not to be
 * used after it. */
void keeper_put_pixels(struct keeper *keeper, struct area area, float *values);

/* Gives those of the file that touch `within` to `take`, as part_file_each,
 * four floats for each pixel. */
void keeper_each_pixels(const struct keeper *keeper, struct area within,
                        part_take *take, void *context);

/* Counts what the calling thread has worked for it since clock_worked_here()
 * was `start`. */
void keeper_count(struct keeper *keeper, double start);

/* The tiles of a picture, those of all its passes, numbered from 0. Those that
 * are done are kept once a second, or more seldom where that takes long, all
 * together: what was replaced by a later
 * pass in the meantime, or is drawn in the picture's last second, need not be
 * kept at all. */
struct keeper_tiles {
    struct keeper *keeper; /* NULL: nothing is kept */
    atomic_uchar *states;
    size_t count;
    atomic_size_t next;  /* tile to be looked at; `count` and more: none */
    atomic_uint putting; /* threads that do */
    atomic_llong since;  /* microseconds of clock_seconds(), when they began */
    /* Puts the tile into the file. */
    void (*put)(void *context, size_t tile, unsigned thread);
    void *context;
};

void keeper_tiles_start(struct keeper_tiles *tiles, struct keeper *keeper,
                        size_t count);

/* A tile is done: its values don't change before it is dropped. */
void keeper_tiles_done(struct keeper_tiles *tiles, size_t tile,
                       unsigned thread);

/* The tile's values are about to change: it is not put after this. */
void keeper_tiles_drop(struct keeper_tiles *tiles, size_t tile);

/* Tiles from number `from` on are put as far as they are done and were not, by
 * thread 0; `count`: none. All threads are through with it. */
void keeper_tiles_end(struct keeper_tiles *tiles, size_t from);

#endif
