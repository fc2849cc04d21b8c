/* --stats: what a picture took. */
#ifndef CLI_STATS_H
#define CLI_STATS_H

#include "render/render.h"

struct stats {
    struct render_stats rays;
    size_t leaves, triangles, lights;
    double lap;                                   /* when the last one ended */
    double parsing, building, rendering, writing; /* seconds */
};

struct stats stats_start(void);

/* Puts the seconds since the last call into *lap. */
void stats_lap(struct stats *stats, double *lap);

/* Counts what is in the world and ends the lap of building it. */
void stats_world(struct stats *stats, const struct world *world);

/* Prints the table on standard error. */
void stats_print(const struct stats *stats);

#endif
