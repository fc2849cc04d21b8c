/* What the window shows: the picture, the status line, messages, the keys. */
#ifndef VIEW_PAINT_H
#define VIEW_PAINT_H

#include "view/view.h"

/* Pixels: the strip below the picture; of a new window without it, at least. */
enum { PAINT_STATUS = 40, PAINT_WIDTH = 640, PAINT_HEIGHT = 480 };

/* False if there is nothing to draw on now. */
bool paint_window(struct view *view);

#endif
