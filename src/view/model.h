/* A scene that was read, with its world: what stays while the camera moves and
 * the lighting changes. Counted, since clicks ask it while it is drawn. */
#ifndef VIEW_MODEL_H
#define VIEW_MODEL_H

#include <stdatomic.h>

#include "cli/options.h"
#include "world/world.h"

enum { MODEL_REGIONS = 16 };

/* What the window has of its own. */
struct model_changes {
    int lamp; /* this one lights alone, counted from 1 as in the file; 0: all */
    struct mesh_region regions[MODEL_REGIONS]; /* of the light mesh, besides */
    int region_count;
};

struct model {
    atomic_int users;
    struct arena *sources;
    const struct source *source; /* the main text */
    struct scene *scene;
    struct camera camera; /* as the file says */
    int lamp;             /* of the changes */
    struct world *world;  /* NULL: not built yet */
};

/* Reads the scene of `options` for a frame (its number), with the changes. NULL
 * after an error was printed, or when *stop was set. The caller is its first
 * user. */
struct model *model_read(const struct options *options, int frame,
                         const struct model_changes *changes,
                         const atomic_int *stop, struct diag *diag);

/* Builds its world, unless it is there. False after an error was printed. */
bool model_build(struct model *model, const struct options *options,
                 struct diag *diag);

/* One user more, one less; the last one frees it. NULL is none. */
struct model *model_use(struct model *model);
void model_leave(struct model *model);

#endif
