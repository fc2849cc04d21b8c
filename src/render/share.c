/* Blocks dealt out like cards: see share.h. Of each `count` blocks that follow
 * each other every part gets one; who gets which is turned by chance, or parts
 * would be columns. */
#include "render/share.h"

#include "base/random.h"

enum { BLOCK_SMALL = 64, BLOCK_LARGE = 256 };

static const double large_picture = 16e6; /* pixels */

int share_block(int width, int height)
{
    double pixels = (double)width * height;
    return pixels < large_picture ? BLOCK_SMALL : BLOCK_LARGE;
}

int share_owner(int count, int width, int height, int x, int y)
{
    int edge = share_block(width, height);
    int across = (width + edge - 1) / edge;
    unsigned parts = (unsigned)count;
    uint64_t block =
        (uint64_t)(y / edge) * (unsigned)across + (unsigned)(x / edge);
    uint64_t turn = random_mix(block / parts + 1) % parts;
    return (int)((block + turn) % parts) + 1;
}

bool share_has(const struct share *share, int width, int height, int x, int y)
{
    return share->count < 2 ||
           share_owner(share->count, width, height, x, y) == share->number;
}
