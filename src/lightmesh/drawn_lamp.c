/* One lamp of many: see drawn_lamp.h. */
#include "lightmesh/drawn_lamp.h"

#include "lightmesh/tuning.h"
#include "shade/surface.h"

/* A lamp and the light it gives a place where it is seen. */
struct candidate {
    const struct lamp *lamp;
    struct lamp_view view;
    rgb light;
};

static bool candidate_lights(struct candidate *candidate,
                             const struct lamp *lamp,
                             const struct lit_place *place)
{
    const struct light *light = lamp->light;
    if ((place->leaf && !lamp_is_for(lamp, place->leaf)) ||
        !lamp_look(lamp, light->location, place->point, &candidate->view))
        return false;
    double cosine = vec3_dot(candidate->view.direction, place->normal);
    candidate->lamp = lamp;
    candidate->light =
        rgb_scale(light->colour, cosine * candidate->view.attenuation);
    return cosine > 0;
}

/* Number i of so many that are spread evenly over all lamps. */
static size_t candidate_number(const struct lamps *lamps, size_t count,
                               size_t i, double offset)
{
    double step = (double)lamps->count / (double)count;
    size_t number = (size_t)(((double)i + offset) * step);
    return number < lamps->count ? number : lamps->count - 1;
}

/* What gets to the place, of which nothing may. */
static rgb candidate_light(const struct candidate *candidate,
                           const struct lamps *lamps, struct worker *worker,
                           const struct draws *draws, uint32_t slot, vec3 place)
{
    struct lamp_target target = { .point = place,
                                  .view = candidate->view,
                                  .spread = gather_spread };
    if (lamps_soft(lamps, candidate->lamp)) {
        double u[2];
        draw_pair(draws, slot, u);
        lamp_look(candidate->lamp,
                  lamps_location(lamps, candidate->lamp, place, u), place,
                  &target.view);
    }
    rgb seen = lamps_share_point(lamps, candidate->lamp, worker, &target);
    return rgb_mul(candidate->light, seen);
}

rgb drawn_lamp_light(const struct lamps *lamps, struct worker *worker,
                     const struct draws *draws, uint32_t slot,
                     const struct lit_place *place)
{
    struct candidate at[DRAWN_LAMPS];
    double sums[DRAWN_LAMPS], sum = 0, which[2] = { 0, 0 }, share;
    size_t count = lamps->count < DRAWN_LAMPS ? lamps->count : DRAWN_LAMPS;
    size_t lit = 0;
    if (count < lamps->count)
        draw_pair(draws, slot, which);
    for (size_t i = 0; i < count; i++) {
        size_t number = candidate_number(lamps, count, i, which[0]);
        if (count == lamps->count)
            number = i;
        if (!candidate_lights(&at[lit], &lamps->items[number], place))
            continue;
        sum += fabs(rgb_brightness(at[lit].light));
        sums[lit++] = sum;
    }
    if (!(sum > 0))
        return rgb_grey(0);
    if (lit > 1 && count == lamps->count)
        draw_pair(draws, slot, which);
    const struct candidate *drawn =
        &at[draw_share(sums, lit, which[1], &share)];
    double times = (double)lamps->count / (double)count / share;
    return rgb_scale(
        candidate_light(drawn, lamps, worker, draws, slot + 1, place->point),
        times);
}

rgb each_lamp_light(const struct lamps *lamps, struct worker *worker,
                    const struct draws *draws, uint32_t slot,
                    const struct lit_place *place)
{
    rgb sum = rgb_grey(0);
    for (size_t i = 0; i < lamps->count; i++) {
        struct candidate at;
        if (candidate_lights(&at, &lamps->items[i], place))
            sum = rgb_add(sum, candidate_light(&at, lamps, worker, draws,
                                               slot + 1, place->point));
    }
    return sum;
}
