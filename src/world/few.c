/* Boxes two by two: see few.h. */
#include "world/few.h"

#include "base/pair.h"

enum {
    BEAM_WORTH = 4, /* boxes, to look at all rays of a packet as one, */
    ROW_WORTH = 7,  /* and of one ray at a row of them at once */
};

/* Side by side, and as many more as make whole rows. */
struct few_boxes {
    double side[2][3][FEW_MOST]; /* low and high, along x, y and z */
};

enum { FEW_ROW = RAY_LANES };
_Static_assert(FEW_MOST % FEW_ROW == 0 && FEW_ROW % PAIR == 0, "whole rows");

/* A box that fills up the last row is infinitely far away, where no ray meets
 * it. */
struct few few_new(struct arena *arena, const struct solid_list *solids,
                   const struct box3 *boxes)
{
    const vec3 away = { (double)INFINITY, (double)INFINITY, (double)INFINITY };
    struct few few = { .solids = solids };
    few.boxes = ARENA_NEW(arena, struct few_boxes);
    for (size_t i = 0; i < FEW_MOST; i++) {
        struct box3 box =
            i < solids->count ? boxes[i] : (struct box3){ away, away };
        for (int axis = 0; axis < 3; axis++) {
            few.boxes->side[0][axis][i] = vec3_component(box.low, axis);
            few.boxes->side[1][axis][i] = vec3_component(box.high, axis);
        }
    }
    return few;
}

/* Which of both boxes from number i on the ray meets. */
static inline int pair_met(const struct few_boxes *boxes, size_t i,
                           const struct query *query)
{
    const struct slabs *ray = &query->slabs;
    const double(*low)[FEW_MOST] = boxes->side[0],
          (*high)[FEW_MOST] = boxes->side[1];
    pair enter = pair_of(query->tmin), leave = pair_of(query->tmax);
    pair_clip(pair_at(low[0] + i), pair_at(high[0] + i), ray->origin.x,
              ray->inverse.x, &enter, &leave);
    pair_clip(pair_at(low[1] + i), pair_at(high[1] + i), ray->origin.y,
              ray->inverse.y, &enter, &leave);
    pair_clip(pair_at(low[2] + i), pair_at(high[2] + i), ray->origin.z,
              ray->inverse.z, &enter, &leave);
    return pair_ordered(enter, leave);
}

/* Which boxes of the row from number `first` on the ray meets, to the bit as
 * pair_met has it. */
CLONES static void row_met(const struct few_boxes *restrict boxes, size_t first,
                           const struct query *query, lane_flag *restrict met)
{
    const vec3 from = query->slabs.origin, inverse = query->slabs.inverse;
    const double origin[3] = { from.x, from.y, from.z };
    const double by[3] = { inverse.x, inverse.y, inverse.z };
    const double tmin = query->tmin, tmax = query->tmax;
    for (int i = 0; i < FEW_ROW; i++) {
        double enter = tmin, leave = tmax;
        for (int k = 0; k < 3; k++) {
            double a = (boxes->side[0][k][first + i] - origin[k]) * by[k];
            double b = (boxes->side[1][k][first + i] - origin[k]) * by[k];
            enter = greater(enter, lesser(a, b));
            leave = lesser(leave, greater(a, b));
        }
        met[i] = enter <= leave ? -1 : 0;
    }
}

/* Those of the row that are looked at, until the search is over. Once something
 * is met what is farther isn't worth it. */
static bool row_trace(const struct few *few, struct query *query, size_t first)
{
    LANE_LINES lane_flag met[FEW_ROW];
    const double tmax = query->tmax;
    row_met(few->boxes, first, query, met);
    for (unsigned row = rays_bits(met); row; row &= row - 1) {
        size_t i = first + (size_t)__builtin_ctz(row);
        if (query->tmax < tmax &&
            !(pair_met(few->boxes, i & ~(size_t)1, query) >> (i & 1) & 1))
            continue;
        if (query_solid(query, few->solids->items[i]))
            return true;
    }
    return false;
}

static bool pair_trace(const struct few *few, struct query *query, size_t first)
{
    struct solid *const *solids = few->solids->items;
    int met = pair_met(few->boxes, first, query);
    return (met & 1 && query_solid(query, solids[first])) ||
           (met & 2 && query_solid(query, solids[first + 1]));
}

void few_trace(const struct few *few, struct query *query)
{
    const size_t count = few->solids->count;
    bool over = false;
    if (count < ROW_WORTH)
        for (size_t i = 0; !over && i < count; i += PAIR)
            over = pair_trace(few, query, i);
    else
        for (size_t i = 0; !over && i < count; i += FEW_ROW)
            over = row_trace(few, query, i);
}

static struct box3 few_box(const struct few *few, size_t i)
{
    const double(*low)[FEW_MOST] = few->boxes->side[0],
          (*high)[FEW_MOST] = few->boxes->side[1];
    return (struct box3){ { low[0][i], low[1][i], low[2][i] },
                          { high[0][i], high[1][i], high[2][i] } };
}

/* All rays of a packet between their outermost ones. */
struct beam {
    struct {
        bool known;               /* they all go up the axis, or all down it */
        int in;                   /* the side they come in by: low 0, high 1 */
        double in_from, out_from; /* the origin farthest from either side */
        double least, most;       /* inverse of their directions */
        double low, high;         /* if `spread`, all of their ways */
    } axis[3];
    bool spread; /* axes don't tell enough: they go this way and that */
};

enum { FOLD = RAY_LANES / 2 };

/* The lesser and the greater of the lanes i and i + FOLD, of those where `open`
 * is set. */
CLONES static void lanes_fold(const double (*restrict lanes)[RAY_LANES],
                              const lane_flag *restrict open,
                              double (*restrict low)[FOLD],
                              double (*restrict high)[FOLD])
{
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < FOLD; i++) {
            double a = lanes[k][i], b = lanes[k][i + FOLD];
            low[k][i] =
                lesser(open[i] ? a : HUGE_VAL, open[i + FOLD] ? b : HUGE_VAL);
            high[k][i] = greater(open[i] ? a : -HUGE_VAL,
                                 open[i + FOLD] ? b : -HUGE_VAL);
        }
}

/* As far as a ray without end gets: across it, that times nothing is nothing.
 */
static const double few_far = 1e100;

/* The lesser and the greater ends of rays, and a little beyond. */
CLONES static void lanes_ends(const struct rays *restrict rays,
                              const double *restrict length,
                              double (*restrict low)[RAY_LANES],
                              double (*restrict high)[RAY_LANES])
{
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < RAY_LANES; i++) {
            double from = rays->origin[k][i];
            double reach = lesser(length[i], few_far) * (1 + 1e-9);
            double way = reach * rays->direction[k][i];
            low[k][i] = lesser(from, from + way);
            high[k][i] = greater(from, from + way);
        }
}

_Static_assert(FOLD == 4 * PAIR, "four pairs");

static double fold_least(const double *fold)
{
    const pair *of = (const pair *)fold;
    pair least = pair_min(pair_min(of[0], of[1]), pair_min(of[2], of[3]));
    return lesser(least[0], least[1]);
}

static double fold_most(const double *fold)
{
    const pair *of = (const pair *)fold;
    pair most = pair_max(pair_max(of[0], of[1]), pair_max(of[2], of[3]));
    return greater(most[0], most[1]);
}

/* The part of space that they are in. */
static void beam_ends(const struct packet *packet, const lane_flag *open,
                      struct beam *beam)
{
    LANE_LINES double low[3][RAY_LANES], high[3][RAY_LANES];
    LANE_LINES double least[3][FOLD], most[3][FOLD], unused[3][FOLD];
    lanes_ends(packet->rays, packet->span.far, low, high);
    lanes_fold(low, open, least, unused);
    lanes_fold(high, open, unused, most);
    for (int k = 0; k < 3; k++) {
        beam->axis[k].low = fold_least(least[k]);
        beam->axis[k].high = fold_most(most[k]);
    }
}

static void beam_of(const struct packet *packet, struct beam *beam)
{
    LANE_LINES lane_flag open[RAY_LANES];
    LANE_LINES double low[3][FOLD], high[3][FOLD];
    LANE_LINES double least[3][FOLD], most[3][FOLD];
    for (int i = 0; i < RAY_LANES; i++)
        open[i] = packet->open >> i & 1 ? -1 : 0;
    lanes_fold(packet->rays->origin, open, low, high);
    lanes_fold(packet->inverse, open, least, most);
    for (int k = 0; k < 3; k++) {
        double origin[2] = { fold_least(low[k]), fold_most(high[k]) };
        double inverse[2] = { fold_least(least[k]), fold_most(most[k]) };
        bool up = inverse[0] > 0;
        beam->axis[k].known = up || inverse[1] < 0;
        beam->axis[k].in = up ? 0 : 1;
        beam->axis[k].in_from = origin[up];
        beam->axis[k].out_from = origin[!up];
        beam->axis[k].least = inverse[0];
        beam->axis[k].most = inverse[1];
    }
    beam->spread =
        !(beam->axis[0].known && beam->axis[1].known && beam->axis[2].known);
    if (beam->spread)
        beam_ends(packet, open, beam);
}

/* Which boxes of the row from number `first` on some ray may meet. */
CLONES static void beam_meets(const struct beam *restrict beam,
                              const struct few_boxes *restrict boxes,
                              size_t first, lane_flag *restrict met)
{
    double enter[FEW_ROW], leave[FEW_ROW];
    for (int i = 0; i < FEW_ROW; i++) {
        enter[i] = -HUGE_VAL;
        leave[i] = HUGE_VAL;
    }
    for (int k = 0; k < 3; k++) {
        const int in = beam->axis[k].in;
        const double *near = boxes->side[in][k] + first;
        const double *far = boxes->side[!in][k] + first;
        const double in_from = beam->axis[k].in_from;
        const double out_from = beam->axis[k].out_from;
        const double least = beam->axis[k].least, most = beam->axis[k].most;
        const double low = beam->axis[k].low, high = beam->axis[k].high;
        const double *bottom = boxes->side[0][k] + first;
        const double *top = boxes->side[1][k] + first;
        for (int i = 0; beam->spread && i < FEW_ROW; i++)
            leave[i] =
                ((bottom[i] > high) | (top[i] < low)) ? -HUGE_VAL : leave[i];
        for (int i = 0; beam->axis[k].known && i < FEW_ROW; i++) {
            double to = near[i] - in_from, from = far[i] - out_from;
            enter[i] = greater(enter[i], lesser(to * least, to * most));
            leave[i] = lesser(leave[i], greater(from * least, from * most));
        }
    }
    for (int i = 0; i < FEW_ROW; i++)
        met[i] = slabs_overlap(enter[i], leave[i]) ? -1 : 0;
}

/* The boxes, bit by bit, that some open ray of the packet may meet. */
static uint32_t few_reached(const struct few *few, const struct packet *packet)
{
    struct beam beam;
    uint32_t reached = 0;
    beam_of(packet, &beam);
    for (size_t first = 0; first < few->solids->count; first += FEW_ROW) {
        LANE_LINES lane_flag met[FEW_ROW];
        beam_meets(&beam, few->boxes, first, met);
        reached |= (uint32_t)rays_bits(met) << first;
    }
    return reached;
}

void few_look(const struct few *few, struct packet *packet)
{
    const size_t count = few->solids->count;
    uint32_t boxes = (uint32_t)(((uint64_t)1 << count) - 1);
    if (count >= BEAM_WORTH)
        boxes &= few_reached(few, packet);
    for (; boxes; boxes &= boxes - 1) {
        size_t i = (size_t)__builtin_ctz(boxes);
        struct box3 box = few_box(few, i);
        unsigned lanes = packet_meets(packet, &box);
        if (packet_look(packet, few->solids->items[i], lanes))
            return;
    }
}
