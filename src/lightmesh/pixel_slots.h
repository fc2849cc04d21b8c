/* Where each worker keeps something for each of the pixels that it refines by
 * now, for a few at a time. */
#ifndef LIGHTMESH_PIXEL_SLOTS_H
#define LIGHTMESH_PIXEL_SLOTS_H

#include <stdbool.h>
#include <stddef.h>

#include "base/worker.h"
#include "lightmesh/receiver.h"

struct pixel_slots;

/* Slots of so many bytes, for so many workers; the caller frees it. */
struct pixel_slots *pixel_slots_new(unsigned threads, size_t bytes);
void pixel_slots_free(struct pixel_slots *slots);

/* The slot of the receiver's pixel, of this worker. `fresh`: it holds nothing
 * of that pixel yet. NULL: the receiver is the only one of its pixel. */
void *pixel_slots_at(const struct pixel_slots *slots,
                     const struct worker *worker,
                     const struct receiver *receiver, bool *fresh);

#endif
