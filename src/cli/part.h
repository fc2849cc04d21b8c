/* The part file of a picture, NAME.glim-part: what has been drawn of it while
 * it is drawn; what is left of it when that was ended; or, of a picture that
 * several share (--part), what one of them has drawn. */
#ifndef CLI_PART_H
#define CLI_PART_H

#include <limits.h>

#include "cli/options.h"
#include "image/output.h"
#include "image/tone.h"

struct part {
    const struct options *options;
    struct diag *diag;
    char path[PATH_MAX];
    char *text;           /* of its head; NULL: there is no such file */
    struct keeper keeper; /* for render_options */
    const char *picture;  /* its name */
    struct output_space space;
    struct tone_table levels; /* of a picture that has them */
    struct ticker *ticker;    /* puts it onto the disk, for when power fails */
    atomic_bool unsettled;    /* there is something for it */
};

/* The name of the part file for the picture `name`, in path[PATH_MAX]. */
void part_name(const struct options *options, const char *name, char *path);

/* Before the drawing. `name` is the picture's, `origin` what it is drawn of
 * (cli/origin.h). With +C what is in the file is taken if it is of the same; if
 * not, says why not. Returns false after an error was printed: of --part the
 * file must be had. */
bool part_start(struct part *part, const struct options *options,
                const struct settings *settings, const char *name,
                const char *origin, struct diag *diag);

/* Whether the picture is drawn in bands, and has its pixels in the file alone.
 */
bool part_has_bands(const struct options *options, const char *name);

/* How many rows a band has of a picture so wide: the more threads the more, so
 * that few wait for a band's last tile. */
int part_band_rows(const struct render_options *options, int width);

/* Writes a picture that was drawn in bands, as picture_write; in the last of
 * them, which it overwrites. */
bool part_write(struct part *part, const struct settings *settings,
                const char *name, const char *origin, struct image *band);

/* Before a whole picture is written: removes a file that could not be filled,
 * as its disk may be full. */
void part_make_room(struct part *part);

/* After it. `done`: the picture is written, or the part is whole; then the file
 * of a picture is removed. Returns false after an error was printed. */
bool part_finish(struct part *part, bool done);

/* Whether there is a file with which +C would go on. */
bool part_is_left(const struct part *part);

/* --join: makes the picture `name` of all its parts. Returns false after an
 * error was printed: parts are missing, damaged or of other pictures. */
bool part_join(const char *name, struct diag *diag);

#endif
