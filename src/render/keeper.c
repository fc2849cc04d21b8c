/* Tiles to disk, without threads waiting for each other: see keeper.h. */
#include "render/keeper.h"

#include <sched.h>

#include "base/clock.h"
#include "base/memory.h"
#include "image/output.h"

enum { TILE_OPEN, TILE_DONE, TILE_PUTTING, TILE_CLOSED };

static const double pause = 1; /* seconds */
/* What keeping takes at most of all time, nearly: a 64th. */
static const double rest = 64;

static long long microseconds(double seconds)
{
    return (long long)(1e6 * seconds);
}

void keeper_start(struct keeper *keeper, double begin)
{
    atomic_store(&keeper->next, microseconds(begin));
    atomic_store(&keeper->state, keeper->file ? KEEPER_READY : KEEPER_WAITS);
}

bool keeper_ready(struct keeper *keeper)
{
    int state = keeper ? atomic_load(&keeper->state) : KEEPER_OFF;
    if (state != KEEPER_WAITS ||
        microseconds(clock_seconds()) < atomic_load(&keeper->next))
        return state == KEEPER_READY;
    if (!atomic_compare_exchange_strong(&keeper->state, &state, KEEPER_BEGINS))
        return state == KEEPER_READY;
    if (!keeper->file)
        keeper->file = keeper->create(keeper->context);
    state = keeper->file ? KEEPER_READY : KEEPER_OFF;
    atomic_store(&keeper->state, state);
    return state == KEEPER_READY;
}

bool keeper_due(struct keeper *keeper)
{
    double now = clock_seconds();
    long long next = atomic_load(&keeper->next);
    return microseconds(now) >= next && keeper_ready(keeper) &&
           atomic_compare_exchange_strong(&keeper->next, &next,
                                          microseconds(now + pause));
}

void keeper_count(struct keeper *keeper, double start)
{
    double worked = clock_worked_here() - start;
    atomic_fetch_add(&keeper->nanoseconds, (unsigned long long)(1e9 * worked));
}

/* In place. That the picture needs them isn't the keeper's doing. */
static void levels_put(struct keeper *keeper, float *values, size_t pixels)
{
    double start = clock_worked_here();
    output_levels_of(keeper->levels, values, pixels, (unsigned char *)values);
    double worked = clock_worked_here() - start;
    atomic_fetch_sub(&keeper->nanoseconds, (unsigned long long)(1e9 * worked));
}

void keeper_put_pixels(struct keeper *keeper, struct area area, float *values)
{
    if (keeper->levels)
        levels_put(keeper, values, area_pixels(area));
    part_file_put(keeper->file, keeper->levels ? PART_LEVELS : PART_PIXELS,
                  area, values);
}

struct taking {
    const struct tone_table *levels;
    part_take *take;
    void *context;
};

static void take_levels(void *context, struct area area, const void *values)
{
    const struct taking *taking = context;
    size_t pixels = area_pixels(area);
    float *floats = memory_resize(NULL, pixels * 4 * sizeof *floats);
    output_levels_working(taking->levels, values, pixels, floats);
    taking->take(taking->context, area, floats);
    memory_free(floats);
}

void keeper_each_pixels(const struct keeper *keeper, struct area within,
                        part_take *take, void *context)
{
    struct taking taking = { keeper->levels, take, context };
    if (keeper->levels)
        part_file_each(keeper->file, PART_LEVELS, within, take_levels, &taking);
    else
        part_file_each(keeper->file, PART_PIXELS, within, take, context);
}

void keeper_tiles_start(struct keeper_tiles *tiles, struct keeper *keeper,
                        size_t count)
{
    tiles->keeper = keeper;
    tiles->count = count;
    tiles->states = keeper ? memory_new(count) : NULL;
    atomic_store(&tiles->next, count);
}

static void tile_put(struct keeper_tiles *tiles, size_t tile, unsigned thread)
{
    unsigned char done = TILE_DONE;
    if (!atomic_compare_exchange_strong(&tiles->states[tile], &done,
                                        TILE_PUTTING))
        return;
    tiles->put(tiles->context, tile, thread);
    atomic_store(&tiles->states[tile], TILE_CLOSED);
}

/* The longer it took the longer nothing is kept. */
static void tiles_rest(struct keeper_tiles *tiles)
{
    long long now = microseconds(clock_seconds());
    long long took = now - atomic_load(&tiles->since);
    long long then = now + (long long)(rest * (double)took);
    if (then > atomic_load(&tiles->keeper->next))
        atomic_store(&tiles->keeper->next, then);
}

/* Whoever comes helps; the last to leave has it put onto the disk. */
static void tiles_put(struct keeper_tiles *tiles, unsigned thread)
{
    size_t tile;
    double start = clock_worked_here();
    atomic_fetch_add(&tiles->putting, 1);
    while ((tile = atomic_fetch_add(&tiles->next, 1)) < tiles->count)
        tile_put(tiles, tile, thread);
    bool last = atomic_fetch_sub(&tiles->putting, 1) == 1;
    keeper_count(tiles->keeper, start);
    if (!last)
        return;
    tiles_rest(tiles);
    tiles->keeper->settle(tiles->keeper->context);
}

void keeper_tiles_done(struct keeper_tiles *tiles, size_t tile, unsigned thread)
{
    if (!tiles->keeper)
        return;
    atomic_store(&tiles->states[tile], TILE_DONE);
    if (keeper_due(tiles->keeper)) {
        atomic_store(&tiles->since, microseconds(clock_seconds()));
        atomic_store(&tiles->next, 0);
    }
    if (atomic_load(&tiles->next) < tiles->count)
        tiles_put(tiles, thread);
}

/* Copying a tile takes microseconds: waiting for that needs no lock. */
void keeper_tiles_drop(struct keeper_tiles *tiles, size_t tile)
{
    unsigned char state = TILE_DONE;
    if (!tiles->keeper || atomic_compare_exchange_strong(&tiles->states[tile],
                                                         &state, TILE_CLOSED))
        return;
    while (atomic_load(&tiles->states[tile]) == TILE_PUTTING)
        sched_yield();
}

void keeper_tiles_end(struct keeper_tiles *tiles, size_t from)
{
    if (tiles->keeper && from < tiles->count && keeper_ready(tiles->keeper)) {
        atomic_store(&tiles->since, microseconds(clock_seconds()));
        atomic_store(&tiles->next, from);
        tiles_put(tiles, 0);
    }
    memory_free(tiles->states);
    tiles->states = NULL;
}
