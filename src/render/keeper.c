/* Tiles to disk, without threads waiting for each other: see keeper.h. */
#include "render/keeper.h"

#include "base/clock.h"
#include "base/memory.h"

enum { TILE_OPEN, TILE_DONE, TILE_KEPT };

bool keeper_ready(struct keeper *keeper)
{
    int state = keeper ? atomic_load(&keeper->state) : KEEPER_OFF;
    if (state != KEEPER_WAITS || clock_seconds() < keeper->begin)
        return state == KEEPER_READY;
    if (!atomic_compare_exchange_strong(&keeper->state, &state, KEEPER_BEGINS))
        return state == KEEPER_READY;
    if (!keeper->file)
        keeper->file = keeper->create(keeper->context);
    state = keeper->file ? KEEPER_READY : KEEPER_OFF;
    atomic_store(&keeper->state, state);
    return state == KEEPER_READY;
}

void keeper_count(struct keeper *keeper, double start)
{
    double worked = clock_worked_here() - start;
    atomic_fetch_add(&keeper->nanoseconds, (unsigned long long)(1e9 * worked));
}

void keeper_settle(struct keeper *keeper)
{
    int now = (int)clock_seconds(), last = atomic_load(&keeper->second);
    if (keeper->settle && now != last &&
        atomic_compare_exchange_strong(&keeper->second, &last, now))
        keeper->settle(keeper->context);
}

void keeper_pass_start(struct keeper_pass *pass, struct keeper *keeper,
                       size_t count)
{
    pass->keeper = keeper;
    pass->count = count;
    pass->states = keeper ? memory_new(count) : NULL;
    atomic_store(&pass->behind, true);
}

void keeper_pass_end(struct keeper_pass *pass)
{
    memory_free(pass->states);
    pass->states = NULL;
}

static void pass_keep(struct keeper_pass *pass, size_t tile, unsigned thread)
{
    unsigned char done = TILE_DONE;
    if (atomic_compare_exchange_strong(&pass->states[tile], &done, TILE_KEPT))
        pass->put(pass->context, tile, thread);
}

void keeper_pass_done(struct keeper_pass *pass, size_t tile, unsigned thread)
{
    if (!pass->keeper)
        return;
    atomic_store(&pass->states[tile], TILE_DONE);
    if (!keeper_ready(pass->keeper))
        return;
    double start = clock_worked_here();
    pass_keep(pass, tile, thread);
    if (atomic_exchange(&pass->behind, false))
        for (size_t i = 0; i < pass->count; i++)
            pass_keep(pass, i, thread);
    keeper_count(pass->keeper, start);
    keeper_settle(pass->keeper);
}
