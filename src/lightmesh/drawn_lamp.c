/* One lamp of many: see drawn_lamp.h. */
#include "lightmesh/drawn_lamp.h"

#include "lightmesh/tuning.h"
#include "shade/finish.h"
#include "shade/shadow.h"
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
    if (!(cosine > 0))
        return false;
    candidate->lamp = lamp;
    if (place->finish)
        cosine = finish_cosine(place->finish, cosine);
    candidate->light =
        rgb_scale(light->colour, cosine * candidate->view.attenuation);
    return true;
}

/* Number i of so many that are spread evenly over all lamps. */
static size_t candidate_number(const struct lamps *lamps, size_t count,
                               size_t i, double offset)
{
    double step = (double)lamps->count / (double)count;
    size_t number = (size_t)(((double)i + offset) * step);
    return number < lamps->count ? number : lamps->count - 1;
}

/* Where a shadow ray to it goes. */
static struct lamp_target candidate_target(const struct candidate *candidate,
                                           const struct lamps *lamps,
                                           const struct draws *draws,
                                           uint32_t slot, vec3 place)
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
    return target;
}

/* What gets to the place, of which nothing may. */
static rgb candidate_light(const struct candidate *candidate,
                           const struct lamps *lamps, struct worker *worker,
                           const struct draws *draws, uint32_t slot, vec3 place)
{
    const struct lamp_target target =
        candidate_target(candidate, lamps, draws, slot, place);
    return rgb_mul(candidate->light,
                   lamps_share_point(lamps, candidate->lamp, worker, &target));
}

rgb drawn_lamp_light(const struct lamps *lamps, struct worker *worker,
                     const struct draws *draws, uint32_t slot,
                     const struct lit_place *place)
{
    struct candidate at[DRAWN_LAMPS];
    double sums[DRAWN_LAMPS], sum = 0, dark = 0, which[2] = { 0, 0 }, share;
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
        double light = rgb_brightness(at[lit].light);
        sum += fabs(light);
        dark += fmax(-light, 0);
        sums[lit++] = sum;
    }
    if (!(sum > 0))
        return rgb_grey(0);
    /* Where some take light away one would stand for more than there is. */
    if (dark > 0 && count == lamps->count)
        return each_lamp_light(lamps, worker, draws, slot, place);
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

/* What gets from a lamp to those of `lanes`, which targets stand for, if that
 * can be told of all of them together. */
static void targets_fall(const struct lamps *lamps, struct worker *worker,
                         const struct lamp_target targets[RAY_LANES],
                         const struct lamp *lamp, unsigned lanes,
                         struct shadows *found)
{
    const struct interiors *const inside[RAY_LANES] = { NULL };
    const struct shadow_around around = lamps_around(lamps, lamp, inside);
    struct occlusions ways = { .light = lamp->number };
    for (unsigned each = lanes; each; each &= each - 1) {
        int i = __builtin_ctz(each);
        const struct lamp_target *target = &targets[i];
        rays_set(&ways.rays, i, target->point, target->view.direction);
        ways.span.near[i] = shadow_start(target->point, target->view.distance);
        ways.span.far[i] = shadow_end(target->view.distance);
    }
    shadow_falls_many(lamps->world, worker, &ways, lanes, &around, found);
}

/* A lamp's light on all of them. */
static void places_lamp(const struct lamps *lamps, struct worker *worker,
                        const struct lamp *lamp, uint32_t slot,
                        struct lit_places *places)
{
    struct candidate of[RAY_LANES];
    struct lamp_target targets[RAY_LANES];
    unsigned lit = 0;
    for (unsigned each = places->lanes; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        if (!candidate_lights(&of[i], lamp, &places->at[i]))
            continue;
        targets[i] = candidate_target(&of[i], lamps, &places->draws[i], slot,
                                      places->at[i].point);
        lit |= 1u << i;
    }
    struct shadows found = { .left = lit };
    if (lit & (lit - 1) && lamps_ways_together(lamps, lamp))
        targets_fall(lamps, worker, targets, lamp, lit, &found);
    for (unsigned each = lit; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        rgb share = found.left >> i & 1
                        ? lamps_share_point(lamps, lamp, worker, &targets[i])
                        : shadows_along(&found, i);
        places->light[i] =
            rgb_add(places->light[i], rgb_mul(of[i].light, share));
    }
}

void each_lamp_many(const struct lamps *lamps, struct worker *worker,
                    uint32_t slot, struct lit_places *places)
{
    for (unsigned each = places->lanes; each; each &= each - 1)
        places->light[__builtin_ctz(each)] = rgb_grey(0);
    for (size_t i = 0; i < lamps->count; i++)
        places_lamp(lamps, worker, &lamps->items[i], slot + 1, places);
}
