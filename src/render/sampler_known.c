/* What of a picture is known already, and what it still needs: see sampler.h.
 */
#include <string.h>

#include "render/sampler_places.h"

void sampler_give_first(struct sampler *sampler, struct area area,
                        const float *values)
{
    struct area here = area_both(area, sampler->first);
    for (int y = here.top; y < here.bottom; y++)
        for (int x = here.left; x < here.right; x++) {
            size_t row = (size_t)(y - area.top);
            size_t column = (size_t)(x - area.left);
            size_t wide = (size_t)(area.right - area.left);
            const float *value = values + (row * wide + column) * 4;
            if (value[3] > (float)UNSEEN)
                sampler_put(sampler, value, x, y);
        }
}

/* The wanted part of the tile that begins there, if one does. */
static struct area tile_at(const struct sampler *sampler, int left, int top)
{
    const struct area *tiled = &sampler->tiled;
    const int edge = sampler->tile;
    int x = left - (left - tiled->left) % edge;
    int y = top - (top - tiled->top) % edge;
    return area_both((struct area){ x, y, x + edge, y + edge },
                     sampler->wanted);
}

void sampler_give_pixels(struct sampler *sampler, struct area area,
                         const float *values)
{
    struct area tile;
    if (area_is_empty(area_both(area, sampler->wanted)))
        return;
    tile = tile_at(sampler, area.left, area.top);
    if (memcmp(&tile, &area, sizeof tile) != 0)
        return;
    for (int y = area.top; y < area.bottom; y++)
        for (int x = area.left; x < area.right; x++, values += 4) {
            memcpy(sampler_pixel(sampler, x, y), values, 4 * sizeof *values);
            *sampler_state(sampler, x, y) |= SAMPLER_DONE;
        }
}

static bool sampler_lacks(const struct sampler *sampler, struct area area)
{
    for (int y = area.top; y < area.bottom; y++)
        for (int x = area.left; x < area.right; x++)
            if (!(*sampler_state(sampler, x, y) & SAMPLER_DONE))
                return true;
    return false;
}

bool sampler_wants(const struct sampler *sampler, struct area tile)
{
    struct area here = area_both(tile, sampler->wanted);
    const struct render_options *options = sampler->options;
    const int width = options->width, height = options->height;
    const int edge = share_block(width, height);
    for (int y = here.top - here.top % edge; y < here.bottom; y += edge)
        for (int x = here.left - here.left % edge; x < here.right; x += edge) {
            struct area block = { x, y, x + edge, y + edge };
            if (share_has(&options->share, width, height, x, y) &&
                sampler_lacks(sampler, area_both(block, here)))
                return true;
        }
    return false;
}

/* What of the grid decides about the pixels of a tile. */
static struct area tile_grid(const struct sampler *sampler, struct area tile)
{
    struct area here = area_both(tile, sampler->wanted);
    if (sampler_corners(sampler)) {
        here.right++;
        here.bottom++;
    } else if (sampler_centres(sampler)) {
        here = tile;
        here.left--;
        here.top--;
    }
    return area_both(here, sampler->first);
}

static void grid_need(struct sampler *sampler, struct area area)
{
    for (int y = area.top; y < area.bottom; y++)
        for (int x = area.left; x < area.right; x++)
            *sampler_state(sampler, x, y) |= SAMPLER_NEEDED;
}

bool sampler_need(struct sampler *sampler)
{
    const struct area *tiled = &sampler->tiled;
    const int edge = sampler->tile;
    bool any = false;
    for (int y = tiled->top; y < tiled->bottom; y += edge)
        for (int x = tiled->left; x < tiled->right; x += edge) {
            struct area tile =
                area_both((struct area){ x, y, x + edge, y + edge }, *tiled);
            bool needed = sampler_wants(sampler, tile);
            any |= needed;
            sampler->sparse |= !needed;
            if (needed)
                grid_need(sampler, tile_grid(sampler, tile));
        }
    return any;
}

bool sampler_needs(const struct sampler *sampler, int x, int y)
{
    return (*sampler_state(sampler, x, y) & (SAMPLER_NEEDED | SAMPLER_SEEN)) ==
           SAMPLER_NEEDED;
}

bool sampler_needs_any(const struct sampler *sampler, struct area tile)
{
    for (int y = tile.top; y < tile.bottom; y++)
        for (int x = tile.left; x < tile.right; x++)
            if (sampler_needs(sampler, x, y))
                return true;
    return false;
}

/* Whether that is known of all places of a row, and there is one. */
static bool row_is(const struct sampler *sampler, struct area area, int y,
                   int known)
{
    const unsigned char *states = sampler_state(sampler, area.left, y);
    int all = known;
    for (int i = 0; i < area.right - area.left; i++)
        all &= states[i];
    return all && area.right > area.left;
}

static void take_row(const struct sampler *sampler, struct area tile, int y,
                     float *values)
{
    for (int x = tile.left; x < tile.right; x++, values += 4)
        if (*sampler_state(sampler, x, y) & SAMPLER_SEEN)
            memcpy(values, sampler_place(sampler, x, y), 4 * sizeof *values);
        else
            values[3] = UNSEEN;
}

void sampler_take_first(const struct sampler *sampler, struct area tile,
                        float *values)
{
    size_t wide = (size_t)(tile.right - tile.left) * 4;
    for (int y = tile.top; y < tile.bottom; y++, values += wide)
        if (tile.left >= sampler->tiled.left && y >= sampler->tiled.top &&
            row_is(sampler, tile, y, SAMPLER_SEEN))
            memcpy(values, sampler_place(sampler, tile.left, y),
                   wide * sizeof *values);
        else
            take_row(sampler, tile, y, values);
}

struct area sampler_take_pixels(const struct sampler *sampler, struct area tile,
                                float *values)
{
    int known = sampler->direct ? SAMPLER_SEEN : SAMPLER_DONE;
    struct area here = area_both(tile, sampler->wanted);
    size_t wide = (size_t)(here.right - here.left) * 4;
    for (int y = here.top; y < here.bottom; y++, values += wide) {
        if (!row_is(sampler, here, y, known))
            return (struct area){ 0 };
        memcpy(values, sampler_pixel(sampler, here.left, y),
               wide * sizeof *values);
    }
    return here;
}

void sampler_tell(const struct sampler *sampler, struct area tile,
                  float *values)
{
    const struct render_options *options = sampler->options;
    struct area here = area_both(tile, sampler->wanted);
    float *out = values;
    if (!options->drawn || area_is_empty(here))
        return;
    for (int y = here.top; y < here.bottom; y++)
        for (int x = here.left; x < here.right; x++, out += 4)
            memcpy(out,
                   *sampler_state(sampler, x, y) & SAMPLER_DONE
                       ? sampler_pixel(sampler, x, y)
                       : sampler_place(sampler, x, y),
                   4 * sizeof *out);
    const struct render_part part = { here, values };
    options->drawn(options->drawn_context, &part);
}
