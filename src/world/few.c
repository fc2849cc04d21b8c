/* Boxes two by two: see few.h. */
#include "world/few.h"

#include "base/pair.h"

enum { FEW_REACHED = 3 }; /* for fewer boxes the whole packet isn't asked */

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

/* How a packet goes along an axis, all of it forwards or all backwards: it
 * comes first to the sides `near`, last to the others, from origins that are
 * nearest to either. */
struct advance {
    int axis, near;
    pair first, last; /* of the origins, for the near and the far sides */
    pair inverse[2];  /* least and greatest */
};

static int advances_of(const struct packet_reach *reach,
                       struct advance advances[3])
{
    int count = 0;
    for (int axis = 0; axis < 3; axis++) {
        double least = reach->inverse[0][axis], most = reach->inverse[1][axis];
        bool back = most < 0;
        if (!back && !(least > 0))
            continue;
        advances[count++] = (struct advance){
            axis,
            back,
            pair_of(reach->origin[!back][axis]),
            pair_of(reach->origin[back][axis]),
            { pair_of(least), pair_of(most) },
        };
    }
    return count;
}

/* Which of both boxes any ray of the packet may meet: no ray is at a side
 * before the least product of the intervals' ends, nor after the greatest (S.
 * Boulos et al., Geometric and Arithmetic Culling Methods for Entire Ray
 * Packets, 2006). Rounding keeps that order. */
static int pair_reached(const struct few_pair *boxes,
                        const struct advance *advances, int count,
                        const struct packet_reach *reach)
{
    pair enter = pair_of(reach->near), leave = pair_of(reach->far);
    for (int k = 0; k < count; k++) {
        const struct advance *a = &advances[k];
        pair near = boxes->side[a->near][a->axis] - a->first;
        pair far = boxes->side[!a->near][a->axis] - a->last;
        enter = pair_max(enter,
                         pair_min(near * a->inverse[0], near * a->inverse[1]));
        leave =
            pair_min(leave, pair_max(far * a->inverse[0], far * a->inverse[1]));
    }
    return pair_ordered(enter, leave);
}

/* Bits for the solids. */
static uint32_t few_reached(const struct few *few, const struct packet *packet)
{
    struct packet_reach reach;
    struct advance advances[3];
    packet_reach(packet, &reach);
    int count = advances_of(&reach, advances);
    uint32_t reached = 0;
    for (size_t i = 0; i < few->count; i++) {
        int both = pair_reached(&few->pairs[i], advances, count, &reach);
        reached |= (uint32_t)both << i * PAIR;
    }
    return reached;
}

void few_look(const struct few *few, struct packet *packet)
{
    uint32_t all = (uint32_t)(((uint64_t)1 << few->solids->count) - 1);
    if (few->solids->count >= FEW_REACHED)
        all &= few_reached(few, packet);
    for (; all; all &= all - 1) {
        size_t i = (size_t)__builtin_ctz(all);
        struct box3 box = pair_box(&few->pairs[i / PAIR], i % PAIR);
        unsigned lanes = packet_meets(packet, &box);
        if (packet_look(packet, few->solids->items[i], lanes))
            return;
    }
}
