/* Playing frames: see reel.h. */
#include "view/reel.h"

#include <string.h>

#include "base/clock.h"
#include "base/memory.h"

/* Seconds that a frame is shown. */
static const double reel_pause = 1.0 / 25;

void reel_start(struct reel *reel)
{
    *reel = (struct reel){ .count = 0 };
    canvas_start(&reel->screen);
}

void reel_clear(struct reel *reel)
{
    for (int i = 0; i < reel->count; i++)
        memory_free(reel->frames[i]);
    memory_free(reel->frames);
    reel->frames = NULL;
    reel->count = 0;
    reel->bytes = 0;
    reel->playing = false;
}

void reel_end(struct reel *reel)
{
    reel_clear(reel);
    canvas_end(&reel->screen);
}

void reel_keep(struct reel *reel, int index, int count, struct canvas *canvas)
{
    bool playing = reel->playing;
    if (count != reel->count || canvas->width != reel->width ||
        canvas->height != reel->height) {
        reel_clear(reel);
        reel->frames = memory_new((size_t)count * sizeof *reel->frames);
        reel->count = count;
        reel->width = canvas->width;
        reel->height = canvas->height;
        reel->playing = playing;
    }
    size_t bytes = (size_t)reel->width * (size_t)reel->height * 4;
    if (index >= count || reel->bytes + bytes > REEL_LIMIT)
        return;
    if (!reel->frames[index]) {
        reel->frames[index] = memory_new(bytes);
        reel->bytes += bytes;
    }
    SDL_LockMutex(canvas->lock);
    memcpy(reel->frames[index], canvas->pixels, bytes);
    SDL_UnlockMutex(canvas->lock);
}

bool reel_has(const struct reel *reel, int index)
{
    return index < reel->count && reel->frames[index];
}

int reel_next(const struct reel *reel, int index, bool drawn)
{
    for (int i = 1; i <= reel->count; i++)
        if (reel_has(reel, (index + i) % reel->count) == drawn)
            return (index + i) % reel->count;
    return index;
}

bool reel_play(struct reel *reel)
{
    double now = clock_seconds();
    if (!reel->playing || now < reel->next)
        return false;
    int next = reel_next(reel, reel->shown, true);
    if (!reel_has(reel, next))
        return false;
    reel->next = now + reel_pause;
    reel->shown = next;
    size_t bytes = (size_t)reel->width * (size_t)reel->height * 4;
    canvas_resize(&reel->screen, reel->width, reel->height);
    memcpy(reel->screen.pixels, reel->frames[next], bytes);
    return true;
}
