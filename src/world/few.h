/* Few solids, which a ray looks at one after the other: setting out through
 * Embree takes longer. */
#ifndef WORLD_FEW_H
#define WORLD_FEW_H

#include "world/flatten.h"
#include "world/packet.h"

enum { FEW_MOST = 32 };

struct few {
    const struct solid_list *solids; /* NULL: there are not few */
    struct few_boxes *boxes;
};

/* All of them, at most FEW_MOST, each with a box that holds it; in `arena`. */
struct few few_new(struct arena *arena, const struct solid_list *solids,
                   const struct box3 *boxes);

/* As geometry_trace (geometry.h). */
void few_trace(const struct few *few, struct query *query);

/* As geometry_look. */
void few_look(const struct few *few, struct packet *packet);

#endif
