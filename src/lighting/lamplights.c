/* Lamps' light at several surfaces: see lamplights.h. */
#include "lighting/lamplights.h"

#include "shade/finish.h"

/* The lamp at hand as all of them see it. */
struct lamp_looks {
    struct lamp_view view[RAY_LANES];
    unsigned lit; /* by it, if nothing is between */
};

static lane_flag flag(bool is)
{
    return is ? -1 : 0;
}

/* One of several layers may face any lamp. */
static void facet_set(struct lamplights *lights, unsigned i)
{
    const struct surface *surface = lights->each[i].surface;
    struct facets *facets = &lights->facets;
    bool layered = surface->count != 1;
    bool twice = surface->at->leaf->double_illuminate || layered;
    const struct finish *finish = surface->layer[0].finish;
    vec3 normal = layered ? surface->normal : surface->layer[0].normal;
    for (int k = 0; k < 3; k++) {
        facets->point[k][i] = vec3_component(surface->point, k);
        facets->normal[k][i] = vec3_component(normal, k);
    }
    facets->twice[i] = flag(twice);
    facets->front[i] = flag(layered || finish_lit_by(finish, 1, twice));
    facets->back[i] = flag(layered || finish_lit_by(finish, -1, twice));
    lights->layered |= layered ? 1u << i : 0;
    lights->ways.span.near[i] = shadow_start(surface->point);
}

/* Where there is no surface: it faces nothing. */
static void facet_clear(struct lamplights *lights, unsigned i)
{
    struct facets *facets = &lights->facets;
    for (int k = 0; k < 3; k++)
        facets->point[k][i] = facets->normal[k][i] = 0;
    facets->twice[i] = facets->front[i] = facets->back[i] = 0;
    lights->ways.span.near[i] = 0;
}

void lamplights_start(struct lamplights *lights, struct lamplight *each,
                      unsigned count)
{
    struct rays *rays = &lights->ways.rays;
    lights->each = each;
    lights->count = count;
    lights->layered = 0;
    for (unsigned i = 0; i < RAY_LANES; i++)
        if (i < count)
            facet_set(lights, i);
        else
            facet_clear(lights, i);
    memcpy(rays->origin, lights->facets.point, sizeof rays->origin);
}

/* What lamp_look finds of a lamp that stands at a place, and the ways there.
 * `faces`: it is before the surface and not at it. */
struct standing {
    double direction[3][RAY_LANES], distance[RAY_LANES], end[RAY_LANES];
    lane_flag faces[RAY_LANES];
};

CLONES static void look_many(const struct facets *restrict facets,
                             vec3 location, struct standing *restrict seen)
{
    for (int i = 0; i < RAY_LANES; i++) {
        vec3 point = { facets->point[0][i], facets->point[1][i],
                       facets->point[2][i] };
        vec3 normal = { facets->normal[0][i], facets->normal[1][i],
                        facets->normal[2][i] };
        double cosine = vec3_dot(normal, vec3_sub(location, point));
        vec3 offset = vec3_sub(point, location);
        double distance = vec3_length(offset);
        vec3 direction = vec3_scale(offset, -1 / distance);
        lane_flag before = (cosine > 0 ? -1 : 0) | facets->twice[i];
        lane_flag behind = cosine < 0 ? -1 : 0;
        seen->direction[0][i] = direction.x;
        seen->direction[1][i] = direction.y;
        seen->direction[2][i] = direction.z;
        seen->distance[i] = distance;
        seen->end[i] = shadow_end(distance);
        seen->faces[i] = ((before & facets->front[i]) |
                          (~before & behind & facets->back[i])) &
                         (distance > 0 ? -1 : 0);
    }
}

/* Whether the spot's cone has no light for them. */
CLONES static void beside_spot(const struct standing *restrict seen, vec3 axis,
                               double cosine_radius, double cosine_falloff,
                               lane_flag *restrict beside)
{
    for (int i = 0; i < RAY_LANES; i++) {
        vec3 direction = { seen->direction[0][i], seen->direction[1][i],
                           seen->direction[2][i] };
        double cosine = -vec3_dot(direction, axis);
        bool outside = (cosine < cosine_radius) & (cosine <= cosine_falloff);
        beside[i] = (cosine <= 0) | outside ? -1 : 0;
    }
}

static void standing_view(const struct standing *seen, unsigned i,
                          struct lamp_view *view)
{
    view->direction = (vec3){ seen->direction[0][i], seen->direction[1][i],
                              seen->direction[2][i] };
    view->distance = seen->distance[i];
    view->attenuation = 1;
}

/* Of a lamp that shines as brightly everywhere: no more is to be asked. */
static void look_at_even(struct lamplights *lights, unsigned lit,
                         const struct standing *seen, struct lamp_looks *looks)
{
    struct occlusions *ways = &lights->ways;
    memcpy(ways->rays.direction, seen->direction, sizeof seen->direction);
    memcpy(ways->span.far, seen->end, sizeof seen->end);
    looks->lit = lit;
    for (; lit; lit &= lit - 1) {
        unsigned i = (unsigned)__builtin_ctz(lit);
        standing_view(seen, i, &looks->view[i]);
    }
}

static void look_at_uneven(struct lamplights *lights, const struct lamp *lamp,
                           unsigned lit, struct lamp_looks *looks)
{
    struct occlusions *ways = &lights->ways;
    vec3 location = lamp->light->location;
    looks->lit = 0;
    memset(ways->rays.direction, 0, sizeof ways->rays.direction);
    memset(ways->span.far, 0, sizeof ways->span.far);
    for (; lit; lit &= lit - 1) {
        unsigned i = (unsigned)__builtin_ctz(lit);
        struct lamp_view *view = &looks->view[i];
        vec3 point = lights->each[i].surface->point;
        if (!lamp_look(lamp, location, point, view))
            continue;
        rays_set(&ways->rays, (int)i, point, view->direction);
        ways->span.far[i] = shadow_end(view->distance);
        looks->lit |= 1u << i;
    }
}

/* Those of them that face the lamp by what each says for itself. */
static unsigned lamplights_before(const struct lamplights *lights,
                                  const struct lamp *lamp, unsigned asked)
{
    unsigned faced = 0;
    for (; asked; asked &= asked - 1) {
        unsigned i = (unsigned)__builtin_ctz(asked);
        if (!lamplight_is_behind(&lights->each[i], lamp))
            faced |= 1u << i;
    }
    return faced;
}

/* Those that the lamp is for. */
static unsigned lamplights_for(const struct lamplights *lights,
                               const struct lamp *lamp)
{
    unsigned lanes = 0;
    for (unsigned i = 0; i < lights->count; i++)
        lanes |=
            lamp_is_for(lamp, lights->each[i].surface->at->leaf) ? 1u << i : 0;
    return lanes;
}

static void lamplights_look(struct lamplights *lights, const struct lamp *lamp,
                            struct lamp_looks *looks)
{
    unsigned lit = lamplights_for(lights, lamp);
    struct standing seen;
    lane_flag beside[RAY_LANES];
    if (lamp_is_parallel(lamp)) {
        lit = lamplights_before(lights, lamp, lit);
        look_at_uneven(lights, lamp, lit, looks);
        return;
    }
    look_many(&lights->facets, lamp->light->location, &seen);
    lit &= rays_bits(seen.faces);
    if (lit & lights->layered)
        lit &= ~lights->layered |
               lamplights_before(lights, lamp, lit & lights->layered);
    if (lamp->light->kind == LIGHT_SPOT) {
        beside_spot(&seen, lamp->axis, lamp->cosine_radius,
                    lamp->cosine_falloff, beside);
        lit &= ~rays_bits(beside);
    }
    if (lamp->even)
        look_at_even(lights, lit, &seen, looks);
    else
        look_at_uneven(lights, lamp, lit, looks);
}

/* Where all or nothing of the light arrives. */
static void lamplights_give_plain(struct lamplights *lights,
                                  const struct lamp *lamp,
                                  const struct lamp_looks *looks)
{
    const struct lamplight *first = lights->each;
    lights->ways.light = lamp->number;
    unsigned lit = looks->lit;
    lit &= ~shadow_falls_many(first->lamps->world, first->worker, &lights->ways,
                              lit);
    for (; lit; lit &= lit - 1) {
        unsigned i = (unsigned)__builtin_ctz(lit);
        lamplight_visit(&lights->each[i], lamp, &looks->view[i], rgb_grey(1));
    }
}

void lamplights_give(struct lamplights *lights, const struct lamp *lamp)
{
    const struct lamps *lamps = lights->each->lamps;
    struct lamp_looks looks;
    if (lamp->light->area_illumination && lamps_soft(lamps, lamp)) {
        for (unsigned i = 0; i < lights->count; i++)
            lamplight_give(&lights->each[i], lamp);
        return;
    }
    lamplights_look(lights, lamp, &looks);
    if (looks.lit && lamps_plain(lamps, lamp)) {
        lamplights_give_plain(lights, lamp, &looks);
        return;
    }
    for (unsigned lit = looks.lit; lit; lit &= lit - 1) {
        unsigned i = (unsigned)__builtin_ctz(lit);
        lamplight_share(&lights->each[i], lamp, &looks.view[i]);
    }
}
