/* Where rays of an antialiased pixel had to ask for themselves, since no
 * corners of the grid are on their surface: what they got serves others of the
 * same pixel as corners do. */
#ifndef LIGHTMESH_LONE_PLACES_H
#define LIGHTMESH_LONE_PLACES_H

#include "lightmesh/indirect.h"
#include "lightmesh/receiver.h"

struct lone_places;

/* For so many workers; the caller frees it. The mesh must outlive it. */
struct lone_places *lone_places_new(const struct indirect_mesh *mesh,
                                    unsigned threads);
void lone_places_free(struct lone_places *places);

/* By a place of the same pixel that serves the receiver: known, or itself.
 * False: it is the only ray of its pixel. */
bool lone_places_light(const struct lone_places *places, struct worker *worker,
                       const struct receiver *receiver,
                       struct indirect_share *share);

#endif
