/* One scene drawn by POV-Ray and by glim. */
#ifndef COMPARE_SCENE_H
#define COMPARE_SCENE_H

#include <stdatomic.h>

#include "compare/choices.h"
#include "compare/report.h"

/* POV-Ray's picture and glim's, in a directory of their own. */
struct scene_pictures {
    const char *directory; /* NULL: there is none */
    const char *paths[2];
    struct times times[2];
};

/* "dir/name.pov" -> "dir/name-compare.png". */
const char *scene_strip_name(const char *scene, struct arena *arena);

/* Draws the scene of `choices` by both, 640 x 480 pixels unless said
 * otherwise. False after an error was printed, or once *stop is non-zero.
 * scene_clean is due in any case. */
bool scene_draw(struct scene_pictures *pictures, const struct choices *choices,
                const atomic_int *stop, struct arena *arena, struct diag *diag);

/* Removes the directory and all that is in it. */
void scene_clean(struct scene_pictures *pictures);

#endif
