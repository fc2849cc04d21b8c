/* A source is a text that diagnostics can point into: a scene, an include, an
 * INI file, a Declare= from the command line. It is kept until exit, since
 * late errors (an image that can't be read) still point into it. */
#ifndef TEXT_SOURCE_H
#define TEXT_SOURCE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include "base/arena.h"

struct source;

/* A piece of a source: what a token, an object or an error covers. A span with
 * a NULL source is nowhere ("the command line"). */
struct span {
    const struct source *source;
    uint32_t offset, length;
};

/* As an assignment, which compilers make by one wide register: that would wait
 * for what was just written in parts. */
static inline void span_copy(struct span *to, const struct span *from)
{
    const struct source *source = from->source;
    uint64_t place;
    memcpy(&place, &from->offset, sizeof place);
    __asm__("" : "+r"(source), "+r"(place));
    to->source = source;
    memcpy(&to->offset, &place, sizeof place);
}

struct source {
    const char *name; /* as the user gave or would type it */
    const char *text; /* NUL-terminated; a BOM is not part of it */
    size_t length;
    struct span included_from; /* NULL source for the main file */
};

/* The largest text accepted: spans hold 32-bit offsets. */
#define SOURCE_LIMIT ((size_t)1 << 30)

/* Reads the file at `path` ("-" is standard input, named "<stdin>"). On
 * failure returns NULL and sets *problem to why ("No such file or directory",
 * "is larger than 1 GiB", ...), valid as long as the arena. `included_from` is
 * the place that asked for it, span_none() for the main file. */
const struct source *source_read(struct arena *arena, const char *path,
                                 struct span included_from,
                                 const char **problem);

/* A source made of `text`, copied. */
const struct source *source_from_text(struct arena *arena, const char *name,
                                      const char *text);

/* 1-based line and column (in bytes) of an offset; LF, CR and CRLF end lines.
 * The line's text is [*line_start, *line_end). Any pointer may be NULL. */
struct source_place {
    unsigned line, column;
    size_t line_start, line_end;
};
struct source_place source_locate(const struct source *source, size_t offset);

struct span span_none(void);

/* From the start of `first` to the end of `last` when both are of one source,
 * else `first`. */
struct span span_join(struct span first, struct span last);

#endif
