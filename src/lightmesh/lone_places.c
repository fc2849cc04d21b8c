/* Places of a pixel that asked for themselves: see lone_places.h. */
#include "lightmesh/lone_places.h"

#include "base/memory.h"
#include "lightmesh/corner.h"
#include "lightmesh/pixel_slots.h"
#include "lightmesh/tuning.h"

/* Of one pixel; the oldest gives way. */
struct lone {
    unsigned count;
    struct {
        struct corner corner;
        struct corner_light light;
        int coarser; /* as of a cell */
    } at[LONE_PLACES];
};

struct lone_places {
    const struct indirect_mesh *mesh;
    struct pixel_slots *lone;
};

struct lone_places *lone_places_new(const struct indirect_mesh *mesh,
                                    unsigned threads)
{
    struct lone_places *places = memory_new(sizeof *places);
    places->mesh = mesh;
    places->lone = pixel_slots_new(threads, sizeof(struct lone));
    return places;
}

void lone_places_free(struct lone_places *places)
{
    if (!places)
        return;
    pixel_slots_free(places->lone);
    memory_free(places);
}

bool lone_places_light(const struct lone_places *places, struct worker *worker,
                       const struct receiver *receiver,
                       struct indirect_share *share)
{
    int coarser = point_mesh_worth(receiver->weight);
    bool fresh;
    struct lone *lone = pixel_slots_at(places->lone, worker, receiver, &fresh);
    if (!lone)
        return false;
    if (fresh)
        lone->count = 0;
    unsigned i = 0, known = lone->count < LONE_PLACES ? lone->count
                                                      : (unsigned)LONE_PLACES;
    while (i < known && !(lone->at[i].coarser == coarser &&
                          corner_serves(&lone->at[i].corner, receiver)))
        i++;
    if (i == known) {
        const struct near_ways *ways = lone->count == 0
                                           ? &places->mesh->near_lone
                                           : &places->mesh->near_more;
        i = lone->count++ % LONE_PLACES;
        lone->at[i].coarser = coarser;
        corner_here(&lone->at[i].corner, places->mesh, receiver);
        corner_ask(&lone->at[i].light, places->mesh, worker, receiver, ways);
    }
    *share = corner_share(&lone->at[i].corner, &lone->at[i].light, receiver);
    return true;
}
