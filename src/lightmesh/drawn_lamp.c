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
                             const struct lamp *lamp, vec3 place, vec3 normal)
{
    const struct light *light = lamp->light;
    if (!lamp_look(lamp, light->location, place, &candidate->view))
        return false;
    double cosine = vec3_dot(candidate->view.direction, normal);
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

rgb drawn_lamp_light(const struct lamps *lamps, struct worker *worker,
                     const struct draws *draws, uint32_t slot, vec3 place,
                     vec3 normal)
{
    struct candidate at[DRAWN_LAMPS];
    double sums[DRAWN_LAMPS], sum = 0, which[2] = { 0, 0 }, u[2], share;
    size_t count = lamps->count < DRAWN_LAMPS ? lamps->count : DRAWN_LAMPS;
    size_t lit = 0;
    if (lamps->count > 1)
        draw_pair(draws, slot, which);
    for (size_t i = 0; i < count; i++) {
        size_t number = candidate_number(lamps, count, i, which[0]);
        if (count == lamps->count)
            number = i;
        if (!candidate_lights(&at[lit], &lamps->items[number], place, normal))
            continue;
        sum += fabs(rgb_brightness(at[lit].light));
        sums[lit++] = sum;
    }
    if (!(sum > 0))
        return rgb_grey(0);
    const struct candidate *drawn =
        &at[draw_share(sums, lit, which[1], &share)];
    struct lamp_target target = { .point = place, .view = drawn->view };
    if (lamps_soft(lamps, drawn->lamp)) {
        draw_pair(draws, slot + 1, u);
        lamp_look(drawn->lamp, lamps_location(lamps, drawn->lamp, place, u),
                  place, &target.view);
    }
    rgb seen = lamps_share_point(lamps, drawn->lamp, worker, &target);
    double times = (double)lamps->count / (double)count / share;
    return rgb_scale(rgb_mul(drawn->light, seen), times);
}
