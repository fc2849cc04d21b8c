/* Tiles to disk, without threads waiting for each other: see keeper.h. */
#include "render/keeper.h"

#include "base/clock.h"
#include "base/memory.h"

enum { TILE_OPEN, TILE_DONE, TILE_KEPT };

static const double pause = 1; /* seconds */

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

void keeper_pass_start(struct keeper_pass *pass, struct keeper *keeper,
                       size_t count)
{
    pass->keeper = keeper;
    pass->count = count;
    pass->states = keeper ? memory_new(count) : NULL;
    atomic_store(&pass->next, count);
}

static void pass_keep(struct keeper_pass *pass, size_t tile, unsigned thread)
{
    unsigned char done = TILE_DONE;
    if (atomic_compare_exchange_strong(&pass->states[tile], &done, TILE_KEPT))
        pass->put(pass->context, tile, thread);
}

/* Whoever comes helps; the last to leave has it put onto the disk. */
static void pass_keep_all(struct keeper_pass *pass, unsigned thread)
{
    size_t tile;
    double start = clock_worked_here();
    atomic_fetch_add(&pass->putting, 1);
    while ((tile = atomic_fetch_add(&pass->next, 1)) < pass->count)
        pass_keep(pass, tile, thread);
    bool last = atomic_fetch_sub(&pass->putting, 1) == 1;
    keeper_count(pass->keeper, start);
    if (last)
        pass->keeper->settle(pass->keeper->context);
}

void keeper_pass_done(struct keeper_pass *pass, size_t tile, unsigned thread)
{
    if (!pass->keeper)
        return;
    atomic_store(&pass->states[tile], TILE_DONE);
    if (keeper_due(pass->keeper))
        atomic_store(&pass->next, 0);
    if (atomic_load(&pass->next) < pass->count)
        pass_keep_all(pass, thread);
}

void keeper_pass_end(struct keeper_pass *pass, bool keep)
{
    if (pass->keeper && keep && keeper_ready(pass->keeper)) {
        atomic_store(&pass->next, 0);
        pass_keep_all(pass, 0);
    }
    memory_free(pass->states);
    pass->states = NULL;
}
