/* What the rays of an antialiased pixel were told of indirect light, which is
 * too smooth to differ within a pixel: further ones that meet the same surface
 * beside them get the same. */
#ifndef LIGHTMESH_PIXEL_ANSWERS_H
#define LIGHTMESH_PIXEL_ANSWERS_H

#include "lightmesh/indirect.h"
#include "lightmesh/receiver.h"

struct pixel_answers;

/* For so many workers; the caller frees it. */
struct pixel_answers *pixel_answers_new(unsigned threads);
void pixel_answers_free(struct pixel_answers *answers);

/* Whether a ray of the same pixel has been told. It depends on those that asked
 * before, which are this worker's, in an order that is the pixel's own. */
bool pixel_answers_find(const struct pixel_answers *answers,
                        const struct worker *worker,
                        const struct receiver *receiver,
                        struct indirect_share *share);

/* Keeps what the receiver was told, for those no farther off than `reach`,
 * units. Of several the oldest gives way. */
void pixel_answers_keep(const struct pixel_answers *answers,
                        const struct worker *worker,
                        const struct receiver *receiver, double reach,
                        const struct indirect_share *share);

#endif
