/* Boxes two by two: see few.h. */
#include "world/few.h"

#include "base/pair.h"

struct few_pair {
    pair side[2][3]; /* low and high, along x, y and z */
};

/* A box that fills up the last pair is infinitely far away, where no ray meets
 * it. */
struct few few_new(struct arena *arena, const struct solid_list *solids,
                   const struct box3 *boxes)
{
    const vec3 away = { (double)INFINITY, (double)INFINITY, (double)INFINITY };
    struct few few = { .solids = solids };
    few.count = (solids->count + PAIR - 1) / PAIR;
    few.pairs = ARENA_ARRAY(arena, struct few_pair, few.count);
    for (size_t i = 0; i < few.count * PAIR; i++) {
        struct box3 box =
            i < solids->count ? boxes[i] : (struct box3){ away, away };
        struct few_pair *boxed = &few.pairs[i / PAIR];
        for (int axis = 0; axis < 3; axis++) {
            boxed->side[0][axis][i % PAIR] = vec3_component(box.low, axis);
            boxed->side[1][axis][i % PAIR] = vec3_component(box.high, axis);
        }
    }
    return few;
}

/* The part of [*enter, *leave] between two sides of both boxes. */
static inline void pair_clip(const struct few_pair *boxes, int axis,
                             double origin, double inverse, pair *enter,
                             pair *leave)
{
    pair low = (boxes->side[0][axis] - origin) * inverse;
    pair high = (boxes->side[1][axis] - origin) * inverse;
    *enter = pair_max(*enter, pair_min(low, high));
    *leave = pair_min(*leave, pair_max(low, high));
}

/* Which of both boxes the ray meets. */
static inline int pair_met(const struct few_pair *boxes,
                           const struct query *query)
{
    const struct slabs *ray = &query->slabs;
    pair enter = pair_of(query->tmin), leave = pair_of(query->tmax);
    pair_clip(boxes, 0, ray->origin.x, ray->inverse.x, &enter, &leave);
    pair_clip(boxes, 1, ray->origin.y, ray->inverse.y, &enter, &leave);
    pair_clip(boxes, 2, ray->origin.z, ray->inverse.z, &enter, &leave);
    return pair_ordered(enter, leave);
}

void few_trace(const struct few *few, struct query *query)
{
    struct solid *const *solids = few->solids->items;
    for (size_t i = 0; i < few->count; i++, solids += PAIR) {
        int met = pair_met(&few->pairs[i], query);
        if (met & 1 && query_solid(query, solids[0]))
            return;
        if (met & 2 && query_solid(query, solids[1]))
            return;
    }
}

static struct box3 pair_box(const struct few_pair *boxes, size_t i)
{
    const pair(*side)[3] = boxes->side;
    return (struct box3){ { side[0][0][i], side[0][1][i], side[0][2][i] },
                          { side[1][0][i], side[1][1][i], side[1][2][i] } };
}

void few_look(const struct few *few, struct packet *packet)
{
    for (size_t i = 0; i < few->solids->count; i++) {
        struct box3 box = pair_box(&few->pairs[i / PAIR], i % PAIR);
        unsigned lanes = packet_meets(packet, &box);
        if (packet_look(packet, few->solids->items[i], lanes))
            return;
    }
}
