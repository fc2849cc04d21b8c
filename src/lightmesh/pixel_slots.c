/* Slots of pixels that are refined: see pixel_slots.h. */
#include "lightmesh/pixel_slots.h"

#include "base/memory.h"
#include "lightmesh/tuning.h"
#include "shade/first_hits.h"

struct pixel_slots {
    unsigned threads;
    size_t bytes;
    unsigned long long *pixels; /* worker_pixel's, PIXEL_SLOTS a worker */
    unsigned char *slots;       /* in the same order */
};

struct pixel_slots *pixel_slots_new(unsigned threads, size_t bytes)
{
    struct pixel_slots *slots = memory_new(sizeof *slots);
    size_t count = (size_t)threads * PIXEL_SLOTS;
    *slots = (struct pixel_slots){
        .threads = threads,
        .bytes = bytes,
        .pixels = memory_new(count * sizeof *slots->pixels),
        .slots = memory_new(count * bytes),
    };
    return slots;
}

void pixel_slots_free(struct pixel_slots *slots)
{
    if (!slots)
        return;
    memory_free(slots->pixels);
    memory_free(slots->slots);
    memory_free(slots);
}

void *pixel_slots_at(const struct pixel_slots *slots,
                     const struct worker *worker,
                     const struct receiver *receiver, bool *fresh)
{
    unsigned long long pixel = receiver->pixel->pixel;
    if (pixel == 0 || worker->number >= slots->threads)
        return NULL;
    size_t i = worker->number * (size_t)PIXEL_SLOTS + pixel % PIXEL_SLOTS;
    *fresh = slots->pixels[i] != pixel;
    slots->pixels[i] = pixel;
    return slots->slots + i * slots->bytes;
}
