/* What --debug-pixel is told while a picture is made: lines, indented by how
 * deep they are, and who gave the first answer. Nobody asks unless a worker's
 * `telling` is set. */
#ifndef BASE_TELLING_H
#define BASE_TELLING_H

#include <stdio.h>

struct telling {
    FILE *out;          /* NULL: no lines */
    int depth;          /* of the next line */
    const char *answer; /* the first one's name; NULL: there is none yet */
};

/* A line; its format as of printf, without the end of line. */
__attribute__((format(printf, 2, 3))) void telling_say(struct telling *telling,
                                                       const char *format, ...);

/* The same, of one who answered and is called `name`, which is kept. */
__attribute__((format(printf, 3, 4))) void
telling_answer(struct telling *telling, const char *name, const char *format,
               ...);

#endif
