/* The skeleton cut into chambers: rooms end at their doors. */
#ifndef SKELETON_CHAMBER_H
#define SKELETON_CHAMBER_H

#include "skeleton/graph.h"

struct chambers {
    size_t count;
    uint32_t *of_node; /* the chamber of each node */
};

struct chambers *chambers_new(struct arena *arena, const struct graph *graph);

#endif
