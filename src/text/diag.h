/* The one printer of messages:
 *
 *     scene.pov:2:21: error: unknown item 'pigmnt' in 'sphere'
 *         2 | sphere { <0,0,0>, 1 pigmnt { rgb 1 } }
 *           |                     ^~~~~~
 *           |                     pigment
 *     scene.pov:1:1: note: to match this '{'
 *
 * GCC's first line, so that editors jump there; the hint is what to type. */
#ifndef TEXT_DIAG_H
#define TEXT_DIAG_H

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>

#include "text/source.h"

enum diag_level {
    DIAG_ERROR,
    DIAG_WARNING,
    DIAG_NOTE,
    DIAG_MESSAGE, /* #debug: the text alone */
};

enum {
    DIAG_ERROR_LIMIT = 20,    /* after so many, the reader should give up */
    DIAG_WARNING_LIMIT = 100, /* more are counted, not printed */
};

/* Hears a message instead of `out`: its text without place and level. */
typedef void diag_listener(void *context, enum diag_level level,
                           struct span span, const char *hint,
                           const char *text);

struct diag {
    FILE *out;             /* normally stderr; NULL prints nothing (fuzzing) */
    diag_listener *listen; /* NULL: messages are printed */
    void *listener;        /* its context */
    const char *program;   /* begins messages without a place; NULL: "glim" */
    bool quiet_warnings, quiet_messages;
    unsigned errors, warnings;
    bool muted; /* the last error was beyond the limit: drop its notes */
    bool open;  /* what the scene said last has not ended its line */
};

/* Prints to stderr. */
struct diag diag_new(void);

/* One message. `hint` (may be NULL) is printed under the carets. A span
 * nowhere prints "glim: error: ...". Notes belong to the error or warning
 * printed before them and vanish with it. Errors and warnings are counted. */
__attribute__((format(printf, 5, 6))) void
diag_print(struct diag *diag, enum diag_level level, struct span span,
           const char *hint, const char *format, ...);
void diag_vprint(struct diag *diag, enum diag_level level, struct span span,
                 const char *hint, const char *format, va_list arguments);

#endif
