/* Differences to look at: a heat map, and the strip A | B | heat map. */
#ifndef COMPARE_HEAT_H
#define COMPARE_HEAT_H

#include "compare/pair.h"
#include "compare/plane.h"
#include "text/diag.h"

/* Between the pictures of a strip. */
enum { STRIP_GAP = 4 };

/* The plane as colours; `top` and above gets the last. sRGB-encoded. Freed by
 * image_free. */
struct image *heat_picture(const struct plane *plane, double top);

/* Both pictures, as displayed, and the heat map side by side. NULL if that
 * would be wider than a picture can be. */
struct image *heat_strip(const struct pair *pair, const struct image *heat);

/* Whether heat_write can write `path`, by its directory and extension. False
 * after an error was printed. */
bool heat_writable(const char *path, struct diag *diag);

/* Writes an sRGB-encoded picture as the kind of file its name says. False
 * after an error was printed. Converts it in place for float files. */
bool heat_write(struct image *image, const char *path, struct diag *diag);

#endif
