/* Boxes two by two: see few.h. */
#include "world/few.h"

#include "base/pair.h"

enum { BEAM_WORTH = 4 }; /* boxes, to look at all rays of a packet as one */

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

/* All rays of a packet between their outermost ones. */
struct beam {
    struct {
        bool known;               /* they all go up the axis, or all down it */
        int in;                   /* the side they come in by: low 0, high 1 */
        double in_from, out_from; /* the origin farthest from either side */
        double least, most;       /* inverse of their directions */
    } axis[3];
};

/* The least and the greatest of the lanes where `open` is set. */
CLONES static void lanes_range(const double *restrict lanes,
                               const lane_flag *restrict open,
                               double *restrict range)
{
    double low[RAY_LANES], high[RAY_LANES];
    for (int i = 0; i < RAY_LANES; i++) {
        low[i] = open[i] ? lanes[i] : HUGE_VAL;
        high[i] = open[i] ? lanes[i] : -HUGE_VAL;
    }
    for (int rest = RAY_LANES / 2; rest > 0; rest /= 2)
        for (int i = 0; i < rest; i++) {
            low[i] = slab_min(low[i], low[i + rest]);
            high[i] = slab_max(high[i], high[i + rest]);
        }
    range[0] = low[0];
    range[1] = high[0];
}

static void beam_of(const struct packet *packet, struct beam *beam)
{
    LANE_LINES lane_flag open[RAY_LANES];
    double origin[2], inverse[2];
    for (int i = 0; i < RAY_LANES; i++)
        open[i] = packet->open >> i & 1 ? -1 : 0;
    for (int k = 0; k < 3; k++) {
        lanes_range(packet->rays->origin[k], open, origin);
        lanes_range(packet->inverse[k], open, inverse);
        bool up = inverse[0] > 0;
        beam->axis[k].known = up || inverse[1] < 0;
        beam->axis[k].in = up ? 0 : 1;
        beam->axis[k].in_from = origin[up];
        beam->axis[k].out_from = origin[!up];
        beam->axis[k].least = inverse[0];
        beam->axis[k].most = inverse[1];
    }
}

/* Which of both boxes some ray may meet. */
static inline int beam_met(const struct beam *beam,
                           const struct few_pair *boxes)
{
    pair enter = pair_of(-HUGE_VAL), leave = pair_of(HUGE_VAL);
    for (int k = 0; k < 3; k++) {
        int in = beam->axis[k].in;
        if (!beam->axis[k].known)
            continue;
        pair to = boxes->side[in][k] - beam->axis[k].in_from;
        pair from = boxes->side[!in][k] - beam->axis[k].out_from;
        double least = beam->axis[k].least, most = beam->axis[k].most;
        enter = pair_max(enter, pair_min(to * least, to * most));
        leave = pair_min(leave, pair_max(from * least, from * most));
    }
    return pair_ordered(enter, leave);
}

void few_look(const struct few *few, struct packet *packet)
{
    const size_t count = few->solids->count;
    struct beam beam;
    int met = 0;
    bool worth = count >= BEAM_WORTH;
    if (worth)
        beam_of(packet, &beam);
    for (size_t i = 0; i < count; i++) {
        const struct few_pair *boxes = &few->pairs[i / PAIR];
        if (i % PAIR == 0)
            met = worth ? beam_met(&beam, boxes) : -1;
        if (!(met >> i % PAIR & 1))
            continue;
        struct box3 box = pair_box(boxes, i % PAIR);
        unsigned lanes = packet_meets(packet, &box);
        if (packet_look(packet, few->solids->items[i], lanes))
            return;
    }
}
