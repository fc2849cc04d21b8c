/* Features of POV-Ray that glim does not have yet: never silently ignored. */
#ifndef PARSE_UNSUPPORTED_H
#define PARSE_UNSUPPORTED_H

#include "parse/parser.h"

/* A feature met while a #declare was read: the declaration stands, so that the
 * standard includes can be read whole, and its use is the error. */
struct unsupported {
    const char *feature;
    struct span span;
};

/* If the next token is an identifier whose declaration had an error or an
 * unsupported feature, reports that (once) and returns true. */
bool unsupported_use(struct parser *p);

/* The same for a value taken from an array or alike, called `word`. `why` may
 * be NULL: its error was reported. */
void unsupported_report(struct parser *p, struct span span,
                        const struct word *word, const struct unsupported *why);

#endif
