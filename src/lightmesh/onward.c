/* Rays that go on: see onward.h. */
#include "lightmesh/onward.h"

#include "base/memory.h"
#include "base/warp.h"
#include "lightmesh/gather.h"

struct onward {
    double chance;
    vec3 way;
};

struct draws onward_draws(const struct draws *draws, uint32_t met)
{
    return draws_within(draws, GATHER_ONWARD + met);
}

struct onwards onwards_new(uint64_t key, uint32_t count)
{
    struct onwards onwards = { key, count,
                               memory_new(count * sizeof *onwards.at) };
    for (uint32_t i = 0; i < count; i++) {
        const struct draws draws = { key, i };
        onwards.at[i].chance = onward_chance(NULL, &draws, 0);
        onwards.at[i].way = onward_way(NULL, &draws, 0);
    }
    return onwards;
}

void onwards_set(struct onwards *onwards, uint32_t index, double chance,
                 vec3 way)
{
    onwards->at[index] = (struct onward){ chance, way };
}

void onwards_free(struct onwards *onwards)
{
    memory_free(onwards->at);
}

/* NULL: it is none of them. */
static const struct onward *onward_find(const struct onwards *known,
                                        const struct draws *draws, uint32_t met)
{
    bool is = known && met == 0 && draws->key == known->key &&
              draws->index < known->count;
    return is ? &known->at[draws->index] : NULL;
}

double onward_chance(const struct onwards *known, const struct draws *draws,
                     uint32_t met)
{
    const struct onward *onward = onward_find(known, draws, met);
    const struct draws further = onward_draws(draws, met);
    return onward ? onward->chance : draw_unit(&further, GATHER_CHANCE);
}

vec3 onward_way(const struct onwards *known, const struct draws *draws,
                uint32_t met)
{
    const struct onward *onward = onward_find(known, draws, met);
    const struct draws further = onward_draws(draws, met);
    double u[2];
    if (onward)
        return onward->way;
    draw_pair(&further, GATHER_DIRECTION, u);
    return warp_lambert(u);
}
