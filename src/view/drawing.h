/* One view of a model, drawn by the options: coarse at first, then finer, at
 * last exactly the picture that glim writes. Its lighting stays, for questions
 * and overlays, until it is freed. */
#ifndef VIEW_DRAWING_H
#define VIEW_DRAWING_H

#include "cli/options.h"
#include "cli/stats.h"
#include "view/canvas.h"
#include "view/heritage.h"
#include "view/model.h"

enum drawing_stage {
    DRAWING_BUILD,  /* the scene for rays */
    DRAWING_COARSE, /* a quick picture is there, or comes */
    DRAWING_LIGHT,  /* the lighting gets ready */
    DRAWING_PIXELS, /* the picture */
};

struct drawing {
    struct arena *arena; /* of the options */
    struct options options;
    struct file_list files; /* that were read; options.parse.asked */
    size_t first_file;      /* of them, that is the scene's */
    int frame;              /* its number */
    struct model *model;
    struct camera camera;
    struct tracer tracer; /* its lighting_state is NULL until it is lit */
    struct photon_map *photons;
    struct image *image;        /* in the working space; NULL: not finished */
    struct picture_shown shown; /* over it; without an arena: nothing */
    struct stats stats;
    double begun;    /* clock_seconds when it was asked for */
    double first;    /* seconds until something was seen; 0: nothing yet */
    double finished; /* until all was */
};

/* Who draws it, and who is told. */
struct drawing_context {
    struct canvas *canvas;
    const atomic_int *stop; /* leave off: something else is wanted */
    const atomic_int *quit; /* leave off even before the first rough picture */
    const struct heritage *before; /* of an earlier drawing, or NULL */
    struct diag *diag;
    void *told;
    void (*stage)(void *told, enum drawing_stage stage);
    void (*share)(void *told, double share); /* any thread */
    /* The first rough picture is there. */
    void (*seen)(void *told);
};

/* Nothing read yet: reads options from the words, of which the first is the
 * program. NULL after an error was printed. */
struct drawing *drawing_new(int argc, char **argv, struct diag *diag);
void drawing_free(struct drawing *drawing);

/* Draws it, model and camera being there. True when it is finished; false when
 * it was stopped, or after an error was printed. */
bool drawing_run(struct drawing *drawing,
                 const struct drawing_context *context);

/* Writes the finished picture where the options say, or to `name`, as glim
 * does; `own` if view or settings are no longer those of the file. False after
 * an error was printed. */
bool drawing_save(const struct drawing *drawing, const char *name, bool own,
                  struct diag *diag);

#endif
