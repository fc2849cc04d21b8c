/* The picture of one frame as a file: can it be written, and writing it. */
#ifndef CLI_PICTURE_H
#define CLI_PICTURE_H

#include <stdio.h>

#include "cli/options.h"
#include "image/output.h"
#include "image/ramp.h"
#include "lighting/show.h"

/* Whether `name` (NULL: none) can be written, found out before the work.
 * Returns false after an error was printed. */
bool picture_can_be(const char *name, struct diag *diag);

/* How the scene's numbers become those of the file. */
struct output_space picture_space(const struct options *options,
                                  const struct settings *settings);

/* What --show has drawn, to be drawn again; `show` freed with show_free. */
struct picture_shown {
    struct show show;
    struct ramp_range range;
};

/* Draws over the picture what --show names, if anything, and says what the
 * colours mean. *shown (NULL: not wanted) gets it, or an arena of NULL. Returns
 * false if stopped. */
bool picture_show(struct image *image, const struct options *options,
                  const struct tracer *tracer, const atomic_int *stop,
                  struct picture_shown *shown, struct diag *diag);

/* A picture's file. */
struct picture_file {
    const struct options *options;
    const struct settings *settings;
    const char *name;   /* NULL: there is none */
    const char *origin; /* it carries (cli/origin.h), or NULL */
};

/* How the picture's file is written, and what numbers it has. */
void picture_describe(const struct options *options,
                      const struct settings *settings,
                      struct image_format *format, struct output_space *space);

/* Turns the picture into the file's numbers, in place, and writes it. Returns
 * false after an error was printed. */
bool picture_write(struct image *image, const struct picture_file *file,
                   struct diag *diag);

/* What was written of a picture that was not finished. */
struct unfinished {
    char name[FILENAME_MAX]; /* of its file; empty: none */
    double share;            /* of the pixels, that it has */
};

/* After an interruption, with what render_run left: writes a picture beside the
 * file, called NAME-unfinished, unless nothing is there to write or the file is
 * standard output. */
void picture_rescue(struct image *image, const struct picture_file *file,
                    const struct render_stats *drawn,
                    struct unfinished *unfinished, struct diag *diag);

/* Once the picture `name` (NULL: none) is written: removes what an earlier run
 * left so beside it, if it says that it is such (a PNG or an EXR). */
void picture_forget_unfinished(const char *name);

#endif
