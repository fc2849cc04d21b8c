/* The picture of one frame as a file: is it there already, can it be written,
 * and writing it. */
#ifndef CLI_PICTURE_H
#define CLI_PICTURE_H

#include <stdio.h>

#include "cli/options.h"

/* +C: whether the file called `name` is a whole picture of the right size. If
 * there is one that isn't, says why it is rendered again. Warns, unless *told
 * already, if the scene's file has been changed since; what it includes is not
 * looked at. */
bool picture_is_there(const struct options *options, const char *name,
                      bool *told, struct diag *diag);

/* Whether `name` (NULL: none) can be written, found out before the work.
 * Returns false after an error was printed. */
bool picture_can_be(const char *name, struct diag *diag);

/* Draws over the picture what --show names, if anything, and says what the
 * colours mean. Returns false if stopped. */
bool picture_show(struct image *image, const struct options *options,
                  const struct tracer *tracer, const atomic_int *stop,
                  struct diag *diag);

/* Turns the picture into the file's numbers, in place, and writes it. Returns
 * false after an error was printed. */
bool picture_write(struct image *image, const struct options *options,
                   const struct settings *settings, const char *name,
                   struct diag *diag);

/* What was written of a picture that was not finished. */
struct unfinished {
    char name[FILENAME_MAX]; /* of its file; empty: none */
    double share;            /* of the pixels, that it has */
};

/* After an interruption, with what render_run left: writes a picture beside
 * `name`, called NAME-unfinished, unless nothing is there to write or `name` is
 * standard output. */
void picture_rescue(struct image *image, const struct options *options,
                    const struct settings *settings, const char *name,
                    const struct render_stats *drawn,
                    struct unfinished *unfinished, struct diag *diag);

#endif
