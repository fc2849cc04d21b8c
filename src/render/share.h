/* Which pixels of a picture are whose, when several processes draw it: blocks
 * that are spread over the picture, so that all have the same to do. */
#ifndef RENDER_SHARE_H
#define RENDER_SHARE_H

#include <stdbool.h>

/* Part `number`, from 1, of `count`; count 0: all of it is drawn here. */
struct share {
    int number, count;
};

enum { SHARE_LIMIT = 100000 };

/* The edge of the blocks, a multiple of 32 (the tiles of antialiasing), the
 * same for all parts of a picture. */
int share_block(int width, int height);

/* The part, from 1 to count, that has the pixel of the picture. */
int share_owner(int count, int width, int height, int x, int y);

/* Whether the pixel is this part's. */
bool share_has(const struct share *share, int width, int height, int x, int y);

#endif
