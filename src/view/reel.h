/* Frames of an animation that have been drawn, to be played. */
#ifndef VIEW_REEL_H
#define VIEW_REEL_H

#include "view/canvas.h"

struct reel {
    unsigned **frames; /* pixels as a canvas's; NULL: not drawn */
    int count;
    int width, height; /* of all of them */
    size_t bytes;      /* that they take */
    bool playing;
    int shown;            /* while playing */
    double next;          /* clock_seconds, of the next one */
    struct canvas screen; /* what is shown while playing */
};

/* Frames take no more than this; of others the drawing is not kept. */
#define REEL_LIMIT ((size_t)1 << 30)

void reel_start(struct reel *reel);
void reel_end(struct reel *reel);

/* Forgets all frames. */
void reel_clear(struct reel *reel);

/* Keeps what the canvas shows as frame `index` of `count`. */
void reel_keep(struct reel *reel, int index, int count, struct canvas *canvas);

bool reel_has(const struct reel *reel, int index);

/* The first after `index`, around the end, that is drawn or not; `index` if
 * there is no other. */
int reel_next(const struct reel *reel, int index, bool drawn);

/* While playing: puts the frame on the screen that is due; whether there was
 * one. */
bool reel_play(struct reel *reel);

#endif
