/* The triangles of a mesh{}, cut many at a time: each would be thirty tokens,
 * most of the time and memory of reading it. */
#ifndef TOKEN_TRIANGLES_H
#define TOKEN_TRIANGLES_H

#include "token/numbers.h"
#include "token/word.h"

/* The texture of a triangle, or texture NULL. */
struct triangle_paint {
    const struct word *texture; /* X of texture { X } */
    uint32_t start, end;        /* of that text, from the run's beginning */
};

/* [smooth_]triangle { V, V, V texture { X } }, again and again. */
struct triangle_run {
    bool smooth;
    size_t count;
    double (*vectors)[3]; /* three for each, six for smooth ones */
    struct triangle_paint *paints;
};

/* Where runs are put together: kept from run to run. */
struct triangle_bench {
    struct {
        double (*items)[3];
        size_t count, capacity;
    } vectors;
    struct {
        struct triangle_paint *items;
        size_t count, capacity;
    } paints;
};

enum { TRIANGLES_MOST = 16384 }; /* of one run */

/* The run at the start of `text` (ending in NUL), as far as it is written
 * plainly: numbers, commas, and at most the name of a texture. *length is how
 * far it reaches. NULL: it is to be cut into ordinary tokens. */
const struct triangle_run *triangles_cut(struct arena *arena,
                                         struct word_table *words,
                                         struct triangle_bench *bench,
                                         const char *text, size_t *length);

#endif
