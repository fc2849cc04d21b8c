/* What a lighting method shows of what it knows (--show): points and lines in
 * space, each with a number that becomes its colour. Who draws them knows
 * nothing else of the method. */
#ifndef LIGHTING_SHOW_H
#define LIGHTING_SHOW_H

#include "base/array.h"
#include "base/vec.h"

struct show_point {
    vec3 at; /* world */
    double number;
};

struct show_line {
    vec3 from, to;
    double from_number, to_number;
    bool arrow; /* with a head at `to` */
};

struct show {
    struct arena *arena;
    const char *what; /* the numbers are */
    bool logarithmic; /* their colours, numbers being over some powers of ten */
    struct {
        struct show_point *items;
        size_t count, capacity;
    } points;
    struct {
        struct show_line *items;
        size_t count, capacity;
    } lines;
};

/* Nothing yet; freed with show_free. */
struct show show_new(void);
void show_free(struct show *show);

#endif
