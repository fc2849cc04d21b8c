/* --stats: what a picture took. */
#ifndef CLI_STATS_H
#define CLI_STATS_H

#include "render/render.h"

enum { STATS_ROWS = 100, STATS_NAME = 32 };

struct stats {
    struct render_stats rays;
    size_t leaves, triangles, lights;
    double lap;                                   /* when the last one ended */
    double parsing, building, rendering, writing; /* seconds */
    struct {
        char what[STATS_NAME];
        double amount;
        const char *unit;
    } rows[STATS_ROWS]; /* of the lighting method */
    int row_count;
};

struct stats stats_start(void);

/* Puts the seconds since the last call into *lap. */
void stats_lap(struct stats *stats, double *lap);

/* Counts what is in the world and ends the lap of building it. */
void stats_world(struct stats *stats, const struct world *world);

/* Notes what the lighting method has to tell. */
void stats_lighting(struct stats *stats, const struct tracer *tracer);

/* What keeping finished tiles took, if any were kept. */
void stats_keeper(struct stats *stats, const struct keeper *keeper);

/* Prints the table on standard error. */
void stats_print(const struct stats *stats);

#endif
