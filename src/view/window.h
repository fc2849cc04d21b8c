/* The window: a surface to draw on, text, pictures of it. Everything is drawn
 * by the processor, which works on every display. */
#ifndef VIEW_WINDOW_H
#define VIEW_WINDOW_H

#include <stdbool.h>

#include "text/diag.h"
#include "view/canvas.h"

struct window;

/* Of this size, or what fits the display; NULL after an error was printed. */
struct window *window_open(const char *title, int width, int height,
                           struct diag *diag);
void window_close(struct window *window);

void window_resize(struct window *window, int width, int height);

/* The height of a line of text, pixels. */
int window_line(const struct window *window);

/* Begins to draw: black. False if there is nothing to draw on, as of a window
 * that is being changed. */
bool window_begin(struct window *window);
void window_show(struct window *window);

/* Its size, of the last window_begin. */
SDL_Rect window_area(const struct window *window);

/* The canvas into the area. */
void window_picture(struct window *window, struct canvas *canvas,
                    const SDL_Rect *to);

/* The same, but only the part of it from `left` on, pixels of the window. */
void window_picture_from(struct window *window, struct canvas *canvas,
                         const SDL_Rect *to, int left);

/* A rectangle of a colour 0xRRGGBB over what is there, opacity 0..255. */
void window_fill(struct window *window, const SDL_Rect *area, unsigned tint,
                 int opacity);

/* The edge of a rectangle. */
void window_frame(struct window *window, const SDL_Rect *area, unsigned tint);

/* One line of text, cut off at `right`; returns where it ends. */
int window_text(struct window *window, int x, int y, int right, unsigned tint,
                const char *text);

/* How many bytes of the text fit beside each other in `width` pixels: whole
 * words, and what parts them from the next, if one fits; at least one letter.
 */
size_t window_fit(const struct window *window, const char *text, int width);

/* Several, wrapped nowhere, on a dark box with its top left at (x, y). */
void window_box(struct window *window, int x, int y, unsigned tint,
                const char *text);

/* The same at (x, y), or where there is room for all of it. */
void window_label(struct window *window, int x, int y, unsigned tint,
                  const char *text);

/* What is shown, as a PNG. False after an error was printed. */
bool window_save(const struct window *window, const char *path,
                 struct diag *diag);

#endif
