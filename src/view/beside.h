/* The same view by POV-Ray, drawn in the background, and how it differs. */
#ifndef VIEW_BESIDE_H
#define VIEW_BESIDE_H

#include "view/canvas.h"
#include "view/drawing.h"

enum beside_state {
    BESIDE_NONE,
    BESIDE_DRAWING, /* POV-Ray is at work */
    BESIDE_DRAWN,   /* its picture is there */
    BESIDE_COMPARING,
    BESIDE_DONE, /* and the heat map */
    BESIDE_FAILED,
};

enum { BESIDE_TEXT = 400 };

struct beside;

struct beside *beside_new(void);
/* Stops what is at work. */
void beside_free(struct beside *beside);

/* What POV-Ray is to draw: the options' words, and the camera if it is not the
 * file's. Copied. */
struct beside_view {
    int argc;
    char **argv;
    bool moved;
    struct camera camera;
    int frame; /* its index */
};

/* Begins anew. */
void beside_start(struct beside *beside, const struct beside_view *view);

/* Forgets it: the view is another one. */
void beside_forget(struct beside *beside);

/* To be called now and then: once POV-Ray's picture is there, compares it with
 * that of the canvas, if this is `finished`. */
enum beside_state beside_look(struct beside *beside, struct canvas *canvas,
                              bool finished);

/* POV-Ray's picture, and the heat map (empty before BESIDE_DONE). */
struct canvas *beside_picture(struct beside *beside);
struct canvas *beside_heat(struct beside *beside);

/* Figures, or why there are none. */
const char *beside_text(const struct beside *beside);

#endif
