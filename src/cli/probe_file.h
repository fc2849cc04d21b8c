/* The points of --probe: a text with one on each line, and the table of light
 * that answers it. */
#ifndef CLI_PROBE_FILE_H
#define CLI_PROBE_FILE_H

#include "render/probe.h"
#include "text/diag.h"

enum { PROBE_POINTS_LIMIT = 4000000 };

/* What follows the numbers of a line, in the source's text. */
struct probe_label {
    uint32_t offset, length;
};

struct probe_file {
    const struct source *source;
    struct {
        struct probe_point *items;
        size_t count, capacity;
    } at;
    struct {
        struct probe_label *items; /* as many */
        size_t count, capacity;
    } labels;
};

/* Reads the file ("-": standard input): lines `x y z`, with `nx ny nz` for
 * irradiance, and a label if anything follows; `#` begins comments. Returns
 * false after errors were printed, one for each bad line, at most 20. */
bool probe_file_read(struct probe_file *points, const char *path,
                     struct arena *arena, struct diag *diag);

/* Writes a line for each point to `name` ("-": standard output): its numbers,
 * red, green, blue, where light comes from if that is known, its label.
 * Returns false after an error was printed. */
bool probe_file_write(const struct probe_file *points,
                      const struct probe_light *light, const char *name,
                      struct diag *diag);

#endif
