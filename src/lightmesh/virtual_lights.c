/* Virtual lights: see virtual_lights.h. */
#include "lightmesh/virtual_lights.h"

#include "base/memory.h"
#include "base/morton.h"
#include "base/side.h"
#include "base/smooth.h"
#include "lightmesh/gather_lamps.h"
#include "lightmesh/gather_paint.h"
#include "lightmesh/gather_ways.h"
#include "lightmesh/tuning.h"
#include "shade/finish.h"
#include "shade/shadow.h"

enum { LAYERS = 3 }; /* of surfaces behind each other in a cell, at most */

/* Places of the surfaces in all cells, those of a cell along a curve. */
struct samples {
    const struct virtual_lights *lights;
    struct gather gather;
    struct worker *worker;
    unsigned edge; /* of the grid of rays into a cell */
    size_t count;
    struct virtual_light *at; /* of area 0: nothing is there */
};

/* The slot of a cell, or the free one where it would be. */
static unsigned cell_slot(const struct virtual_lights *lights, uint64_t key)
{
    unsigned slot = (unsigned)(key % VIRTUAL_SLOTS);
    while (lights->cell[slot].key && lights->cell[slot].key != key)
        slot = (slot + 1) % VIRTUAL_SLOTS;
    return slot;
}

static void cell_add(struct virtual_lights *lights, vec3 place, int facing,
                     double worth)
{
    uint64_t key = cell_key(place, facing, lights->side);
    struct virtual_cell *cell = &lights->cell[cell_slot(lights, key)];
    if (!cell->key)
        *cell = (struct virtual_cell){ key,
                                       cell_middle(place, facing, lights->side),
                                       facing, worth };
    cell->worth = fmax(cell->worth, worth);
}

/* With those beside it: what a survey found there may go on into them. */
static void cells_around(struct virtual_lights *lights,
                         const struct bright_disc *disc)
{
    int facing = side_of(disc->normal);
    vec3 across = vec3_scale(side_across(facing), lights->side),
         down = vec3_scale(side_down(facing), lights->side);
    for (int j = -1; j <= 1; j++)
        for (int i = -1; i <= 1; i++)
            cell_add(lights,
                     vec3_along(vec3_along(disc->centre, across, i), down, j),
                     facing, disc->worth);
}

static double cell_worth(const struct virtual_lights *lights, vec3 place,
                         vec3 normal)
{
    uint64_t key = cell_key(place, side_of(normal), lights->side);
    return lights->cell[cell_slot(lights, key)].worth;
}

double virtual_lights_fade(const struct virtual_lights *lights, double distance)
{
    return smooth_step((distance - lights->near) /
                       (lights->far - lights->near));
}

double virtual_lights_share(const struct virtual_lights *lights, vec3 place,
                            vec3 normal, double distance)
{
    if (distance <= lights->near)
        return 0;
    double worth = cell_worth(lights, place, normal);
    return worth > 0 ? worth * virtual_lights_fade(lights, distance) : 0;
}

/* What lamps make the surface send on. */
static rgb sample_light(const struct samples *samples,
                        const struct surface *surface,
                        const struct draws *draws, vec3 from)
{
    const struct receiver receiver = { .point = surface->point,
                                       .side = surface->side,
                                       .normal = surface->normal,
                                       .from = from,
                                       .weight = 1 };
    rgb light = gather_lamps(&samples->gather, samples->worker, draws, false,
                             surface, &receiver);
    return rgb_mul(gather_albedo(surface, surface_sky(surface)), light);
}

/* The cell's surfaces that a ray meets on its way through it. */
static void samples_look(struct samples *samples,
                         const struct virtual_cell *cell, struct ray ray,
                         size_t first, const struct draws *draws)
{
    double side = samples->lights->side, end = side;
    double area = side * side / (samples->edge * samples->edge);
    for (unsigned i = 0; i < LAYERS; i++) {
        struct intersection at;
        struct surface surface;
        const struct glimpse glimpse = { surface_offset(ray.origin), end,
                                         gather_spread };
        samples->worker->counters.shadow_rays++;
        if (!world_glimpse(samples->gather.lamps->world, &ray, glimpse,
                           RAY_REFLECTION, &at))
            return;
        gather_surface(&samples->gather, &ray, &at, &surface);
        vec3 normal = vec3_against(at.face, ray.direction);
        if (cell_key(at.point, side_of(normal), side) == cell->key)
            samples->at[first + i] = (struct virtual_light){
                at.point, normal,
                rgb_scale(sample_light(samples, &surface, draws, ray.origin),
                          cell->worth),
                area / -vec3_dot(normal, ray.direction)
            };
        end -= at.t;
        ray.origin = at.point;
    }
}

/* Rows and columns are shifted against each other: many edges of light are
 * along them. */
static double row_shift(unsigned row)
{
    double turns = (row + 0.5) * 0.61803398874989485;
    return turns - floor(turns);
}

/* Those in one cell, by rays from its front. */
static void samples_cell(struct samples *samples,
                         const struct virtual_cell *cell, size_t first)
{
    double side = samples->lights->side, step = side / samples->edge;
    vec3 normal = side_normal(cell->facing), across = side_across(cell->facing),
         down = side_down(cell->facing);
    vec3 front = vec3_along(cell->middle, normal, side / 2);
    front = vec3_along(vec3_along(front, across, -side / 2), down, -side / 2);
    for (unsigned j = 0; j < samples->edge; j++)
        for (unsigned i = 0; i < samples->edge; i++) {
            size_t at = first + morton_place(i, j);
            struct draws draws = { samples->gather.lamps->seed, (uint32_t)at };
            vec3 from = vec3_along(front, across, (i + row_shift(j)) * step);
            struct ray ray = { vec3_along(from, down,
                                          (j + row_shift(i)) * step),
                               vec3_negate(normal) };
            samples_look(samples, cell, ray, at * LAYERS, &draws);
            arena_reset(samples->worker->scratch);
        }
}

/* Lamps may be negative, in one colour or all. */
static double light_amount(rgb light)
{
    return fmax(fabs(light.r), fmax(fabs(light.g), fabs(light.b)));
}

static double light_power(const struct virtual_light *light)
{
    return light_amount(light->light) * light->area;
}

/* So many of them that have the same power each, evenly along the curve. */
static void lights_take(struct virtual_lights *lights,
                        const struct samples *samples, double power)
{
    size_t count = (size_t)lights->count * GATHER_PARTS, next = 0;
    double each = power / (double)count, sum = 0;
    lights->at = memory_new(count * sizeof *lights->at);
    for (size_t i = 0; i < samples->count && next < count; i++) {
        const struct virtual_light *sample = &samples->at[i];
        sum += light_power(sample);
        while (next < count && sum > ((double)next + 0.5) * each) {
            lights->at[next] = *sample;
            lights->at[next++].area =
                each * GATHER_PARTS / light_amount(sample->light);
        }
    }
    lights->count = (int)(next / GATHER_PARTS);
}

static void lights_choose(struct virtual_lights *lights,
                          const struct samples *samples, int times)
{
    double power = 0, area = 0, side = lights->side;
    for (size_t i = 0; i < samples->count; i++) {
        double part = light_power(&samples->at[i]);
        power += part;
        area += part > 0 ? samples->at[i].area : 0;
    }
    if (!(power > 0) || !isfinite(power))
        return;
    double wanted = area * virtual_cell * virtual_cell / (side * side);
    wanted = times * fmin(fmax(ceil(wanted), VIRTUAL_LEAST), VIRTUAL_MOST);
    lights->count = (int)wanted;
    lights->near = virtual_near * sqrt(area / wanted);
    lights->far = virtual_far * sqrt(area / wanted);
    lights_take(lights, samples, power);
}

struct virtual_lights *virtual_lights_new(const struct bright *lit,
                                          const struct lamps *lamps, int times,
                                          struct worker *worker)
{
    struct virtual_lights *lights = memory_new(sizeof *lights);
    struct samples samples = { .lights = lights,
                               .gather = { .lamps = lamps },
                               .worker = worker,
                               .edge = VIRTUAL_EDGE };
    lights->side = bright_side(lit);
    for (int i = 0; i < lit->count; i++)
        cells_around(lights, &lit->at[i]);
    size_t cells = 0, rays;
    for (int i = 0; i < VIRTUAL_SLOTS; i++)
        cells += lights->cell[i].key != 0;
    while (samples.edge > VIRTUAL_EDGE_LEAST &&
           samples.edge * samples.edge * cells > VIRTUAL_RAYS)
        samples.edge /= 2;
    rays = (size_t)samples.edge * samples.edge;
    samples.count = cells * rays * LAYERS;
    samples.at = memory_new((samples.count + 1) * sizeof *samples.at);
    cells = 0;
    for (int i = 0; i < VIRTUAL_SLOTS && !worker_stopped(worker); i++)
        if (lights->cell[i].key)
            samples_cell(&samples, &lights->cell[i], cells++ * rays);
    lights_choose(lights, &samples, times);
    memory_free(samples.at);
    return lights;
}

void virtual_lights_free(struct virtual_lights *lights)
{
    if (lights)
        memory_free(lights->at);
    memory_free(lights);
}
