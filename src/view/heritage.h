/* What a finished drawing leaves to the next ones: what its lighting method
 * knows, and what was shown of it. Counted, since the window asks it while the
 * next one is drawn. */
#ifndef VIEW_HERITAGE_H
#define VIEW_HERITAGE_H

#include <stdatomic.h>

#include "cli/picture.h"
#include "view/model.h"

enum { HERITAGE_VIEW = 40 };

struct heritage {
    atomic_int users;
    const struct lighting *lighting;
    struct lighting_kept kept;
    int lamp; /* that lit alone, or 0 */
    struct camera camera;
    char view[HERITAGE_VIEW]; /* what was shown, as of --show; empty: nothing */
    struct picture_shown shown;
};

/* Of a lighting's state and the options it was made by. *shown is taken over.
 * The caller is its first user. */
struct heritage *heritage_new(const struct tracer *tracer,
                              const struct options *options, int lamp,
                              struct picture_shown *shown);

struct heritage *heritage_use(struct heritage *heritage);
void heritage_leave(struct heritage *heritage); /* NULL is none */

/* Whether it has what these options show. */
bool heritage_shows(const struct heritage *heritage,
                    const struct options *options);

/* The number of what was shown that is next to (x, y), 0..1 from the top left
 * of a picture of `wide` by `high` pixels, and no more than a few pixels from
 * there, in text[size]; false: there is none. */
bool heritage_value(const struct heritage *heritage,
                    const struct camera *camera, const double at[2],
                    const int size[2], char *text, size_t text_size);

#endif
