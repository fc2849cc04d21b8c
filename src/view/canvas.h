/* The picture that is shown: 8 bits a colour, as a monitor gets it. Whoever
 * draws writes parts of it from any thread, the window reads it; `lock` is
 * between them. */
#ifndef VIEW_CANVAS_H
#define VIEW_CANVAS_H

#include <SDL2/SDL.h>

#include "image/output.h"
#include "image/tone.h"
#include "render/render.h"

struct canvas {
    SDL_mutex *lock;
    int width, height;
    unsigned *pixels; /* 0x00RRGGBB, row by row from the top */
    unsigned *layer;  /* 0xAARRGGBB, as large, over it; or NULL */
    unsigned changes; /* counts them */
};

/* How a scene's numbers become colours of a monitor. */
struct canvas_tone {
    double gamma; /* of the working space; 0: sRGB */
    bool keep;    /* its numbers are the monitor's */
    bool grey;
    struct tone_table table;
};

void canvas_start(struct canvas *canvas);
void canvas_end(struct canvas *canvas);

/* Gives it another size; what is on it is stretched. */
void canvas_resize(struct canvas *canvas, int width, int height);

/* For pictures that would be written from this space. */
void canvas_tone(struct canvas_tone *tone, const struct output_space *space);

/* Puts a part of the picture, each of whose pixels stands for `step` by `step`
 * of the canvas. */
void canvas_put(struct canvas *canvas, const struct canvas_tone *tone,
                const struct render_part *part, int step);

/* Puts the image, of the canvas's size and premultiplied, over the picture;
 * NULL: nothing any more. */
void canvas_lay(struct canvas *canvas, const struct canvas_tone *tone,
                const struct image *image);

#endif
