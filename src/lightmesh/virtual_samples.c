/* Lit places in a cell: see virtual_samples.h. */
#include "lightmesh/virtual_samples.h"

#include "base/morton.h"
#include "base/random.h"
#include "base/side.h"
#include "lightmesh/gather_lamps.h"
#include "lightmesh/gather_paint.h"
#include "lightmesh/gather_rays.h"
#include "lightmesh/tuning.h"
#include "shade/finish.h"

struct sampling {
    struct gather gather;
    struct worker *worker;
    const struct virtual_cell *cell;
    double side, ray_area; /* of the cell, and of it for each ray */
    struct virtual_light *found;
    size_t count;
};

double virtual_light_amount(rgb light)
{
    return fmax(fabs(light.r), fmax(fabs(light.g), fabs(light.b)));
}

/* Of many lamps one is asked by each place: there are many of these. */
static void places_light(const struct sampling *sampling,
                         struct lit_places *lit)
{
    const struct lamps *lamps = sampling->gather.lamps;
    if (lamps->count <= GATHER_EACH) {
        gather_lamps_many(&sampling->gather, sampling->worker, lit);
        return;
    }
    for (unsigned each = lit->lanes; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        lit->light[i] = drawn_lamp_light(
            lamps, sampling->worker, &lit->draws[i], GATHER_LAMP, &lit->at[i]);
    }
}

/* What lamps give the surfaces of the cell that the rays have met. */
static void sent_light(const struct sampling *sampling,
                       struct gather_rays *sent)
{
    for (unsigned i = 0; i < sent->count; i++) {
        const struct intersection *at = &sent->found[i].at;
        if (!gather_rays_may_light(sent, i))
            continue;
        vec3 facing =
            vec3_against(at->face, rays_direction(&sent->rays, (int)i));
        if (cell_key(at->point, side_of(facing), sampling->side) ==
            sampling->cell->key)
            gather_rays_want_light(sent, i);
    }
    places_light(sampling, &sent->lit);
}

/* What a lit surface sends on. */
static void sampling_add(struct sampling *sampling,
                         const struct gather_rays *sent, unsigned i)
{
    const struct ray ray = rays_at(&sent->rays, (int)i);
    const struct intersection *at = &sent->found[i].at;
    struct surface surface;
    if (!(virtual_light_amount(sent->lit.light[i]) > 0))
        return;
    gather_surface(&sampling->gather, &ray, at, &surface);
    rgb albedo = gather_albedo(&surface, surface_sky(&surface));
    rgb light = rgb_mul(albedo, sent->lit.light[i]);
    vec3 normal = vec3_against(at->face, ray.direction);
    if (virtual_light_amount(light) > 0)
        sampling->found[sampling->count++] = (struct virtual_light){
            .point = at->point,
            .normal = normal,
            .light = rgb_scale(light, sampling->cell->worth),
            .area = sampling->ray_area / -vec3_dot(normal, ray.direction),
            .number = sent->draws[i].index,
        };
    arena_reset(sampling->worker->scratch);
}

/* The rays go on behind what they have met. */
static void sent_on(struct gather_rays *sent)
{
    unsigned count = 0;
    for (unsigned i = 0; i < sent->count; i++) {
        if (!sent->found[i].at.leaf)
            continue;
        rays_set(&sent->rays, (int)count, sent->found[i].at.point,
                 rays_direction(&sent->rays, (int)i));
        sent->draws[count++] = sent->draws[i];
    }
    sent->count = count;
}

static void sampling_send(struct sampling *sampling, struct gather_rays *sent)
{
    for (unsigned layer = 0; layer < VIRTUAL_LAYERS && sent->count > 0;
         layer++) {
        gather_rays_meet(&sampling->gather, sampling->worker, sampling->side,
                         sent);
        sent_light(sampling, sent);
        for (unsigned each = sent->lit.lanes; each; each &= each - 1)
            sampling_add(sampling, sent, (unsigned)__builtin_ctz(each));
        sent_on(sent);
    }
    sent->count = 0;
}

/* Rows and columns are shifted against each other: many edges of light are
 * along them. */
static double row_shift(unsigned row)
{
    double turns = (row + 0.5) * 0.61803398874989485;
    return turns - floor(turns);
}

size_t virtual_samples_of(const struct lamps *lamps, struct worker *worker,
                          const struct virtual_cell *cell, double side,
                          unsigned edge, struct virtual_light *found)
{
    struct sampling sampling = { .gather = { .lamps = lamps },
                                 .worker = worker,
                                 .cell = cell,
                                 .side = side,
                                 .ray_area = side * side / (edge * edge),
                                 .found = found };
    struct gather_rays sent;
    double step = side / edge;
    vec3 normal = side_normal(cell->facing), across = side_across(cell->facing),
         down = side_down(cell->facing);
    vec3 front = vec3_along(cell->middle, normal, side / 2);
    front = vec3_along(vec3_along(front, across, -side / 2), down, -side / 2);
    sent.count = 0;
    for (unsigned at = 0; at < edge * edge && !worker_stopped(worker); at++) {
        unsigned i = morton_x(at), j = morton_y(at);
        const struct draws draws = { random_key(lamps->seed, cell->key), at };
        vec3 from = vec3_along(front, across, (i + row_shift(j)) * step);
        gather_rays_add(&sent, &draws,
                        vec3_along(from, down, (j + row_shift(i)) * step),
                        vec3_negate(normal));
        if (sent.count == RAY_LANES || at + 1 == edge * edge)
            sampling_send(&sampling, &sent);
    }
    return sampling.count;
}
