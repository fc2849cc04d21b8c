/* Boxes two by two: see few.h. A ray meets one of the two sides of each slab
 * first, the same for all boxes, so that they are clipped without branches. */
#include "world/few.h"

#include "base/pair.h"

struct few_pair {
    pair side[2][3]; /* low and high, along x, y and z */
};

/* A box that fills up the last pair is met by no ray. */
struct few few_new(struct arena *arena, const struct solid_list *solids,
                   const struct box3 *boxes)
{
    struct few few = { .solids = solids };
    few.count = (solids->count + PAIR - 1) / PAIR;
    few.pairs = ARENA_ARRAY(arena, struct few_pair, few.count);
    for (size_t i = 0; i < few.count * PAIR; i++) {
        struct box3 box = i < solids->count ? boxes[i] : box3_empty();
        struct few_pair *boxed = &few.pairs[i / PAIR];
        for (int axis = 0; axis < 3; axis++) {
            boxed->side[0][axis][i % PAIR] = vec3_component(box.low, axis);
            boxed->side[1][axis][i % PAIR] = vec3_component(box.high, axis);
        }
    }
    return few;
}

/* The ray as pairs need it. */
struct few_ray {
    pair origin[3], inverse[3];
    int first[3]; /* side that it meets first */
};

static struct few_ray few_ray(const struct slabs *slabs)
{
    struct few_ray ray;
    for (int axis = 0; axis < 3; axis++) {
        double inverse = vec3_component(slabs->inverse, axis);
        ray.origin[axis] = pair_of(vec3_component(slabs->origin, axis));
        ray.inverse[axis] = pair_of(inverse);
        ray.first[axis] = inverse < 0;
    }
    return ray;
}

/* Which of both boxes the ray meets between tmin and tmax. */
static inline int pair_met(const struct few_pair *boxes,
                           const struct few_ray *ray, double tmin, double tmax)
{
    pair enter = pair_of(tmin), leave = pair_of(tmax);
    for (int axis = 0; axis < 3; axis++) {
        int first = ray->first[axis];
        pair near = boxes->side[first][axis] - ray->origin[axis];
        pair far = boxes->side[!first][axis] - ray->origin[axis];
        enter = pair_max(enter, near * ray->inverse[axis]);
        leave = pair_min(leave, far * ray->inverse[axis]);
    }
    return pair_ordered(enter, leave);
}

void few_trace(const struct few *few, struct query *query)
{
    struct solid *const *solids = few->solids->items;
    struct few_ray ray = few_ray(&query->slabs);
    for (size_t i = 0; i < few->count; i++, solids += PAIR) {
        int met = pair_met(&few->pairs[i], &ray, query->tmin, query->tmax);
        if (met & 1 && query_solid(query, solids[0]))
            return;
        if (met & 2 && query_solid(query, solids[1]))
            return;
    }
}
