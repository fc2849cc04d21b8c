/* Virtual lights: see virtual_lights.h. */
#include "lightmesh/virtual_lights.h"

#include "base/memory.h"
#include "base/side.h"
#include "base/smooth.h"
#include "lightmesh/gather_ways.h"
#include "lightmesh/tuning.h"
#include "lightmesh/virtual_samples.h"

/* Lit places in all cells, those of one cell together. */
struct samples {
    struct virtual_light *at;
    size_t count, room;
    double brought; /* by all cells that are lit */
    double wanted;  /* lights of a part */
    struct cell_samples {
        size_t count;
        double power; /* in all */
        double step;  /* units, between rays */
    } of[VIRTUAL_SLOTS];
};

_Static_assert(9 * BRIGHT_MOST < VIRTUAL_SLOTS, "a slot is always free");

/* The slot of a cell, or the free one where it would be. */
static unsigned cell_slot(const struct virtual_lights *lights, uint64_t key)
{
    unsigned slot = (unsigned)(key % VIRTUAL_SLOTS);
    while (lights->cell[slot].key && lights->cell[slot].key != key)
        slot = (slot + 1) % VIRTUAL_SLOTS;
    return slot;
}

static struct virtual_cell *cell_add(struct virtual_lights *lights, vec3 place,
                                     const struct bright_disc *disc)
{
    int facing = side_of(disc->normal);
    uint64_t key = cell_key(place, facing, lights->side);
    struct virtual_cell *cell = &lights->cell[cell_slot(lights, key)];
    if (!cell->key)
        *cell = (struct virtual_cell){
            .key = key,
            .middle = cell_middle(place, facing, lights->side),
            .facing = facing,
            .brought = virtual_unseen,
            .seen_at = disc->seen_at,
        };
    cell->worth = fmax(cell->worth, disc->worth);
    cell->seen_at = fmin(cell->seen_at, disc->seen_at);
    return cell;
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
                     disc);
    struct virtual_cell *own = cell_add(lights, disc->centre, disc);
    own->brought = fmax(own->brought, disc->brought);
}

double virtual_light_fade(double near, double distance)
{
    return smooth_step(distance / near - 1);
}

double virtual_lights_share(const struct virtual_lights *lights, vec3 place,
                            vec3 normal, double distance)
{
    uint64_t key = cell_key(place, side_of(normal), lights->side);
    const struct virtual_cell *cell = &lights->cell[cell_slot(lights, key)];
    return cell->worth > 0 && distance > cell->near
               ? cell->worth * virtual_light_fade(cell->near, distance)
               : 0;
}

static double light_power(const struct virtual_light *light)
{
    return virtual_light_amount(light->light) * light->area;
}

static double samples_power(const struct virtual_light *at, size_t count)
{
    double power = 0;
    for (size_t i = 0; i < count; i++)
        power += light_power(&at[i]);
    return power;
}

static double samples_area(const struct virtual_light *at, size_t count)
{
    double area = 0;
    for (size_t i = 0; i < count; i++)
        area += at[i].area;
    return area;
}

/* A first look into all cells: what nothing lights is left out. */
static void samples_begin(struct samples *samples,
                          struct virtual_lights *lights,
                          const struct lamps *lamps, struct worker *worker)
{
    struct virtual_light
        found[VIRTUAL_LAYERS * VIRTUAL_EDGE_LEAST * VIRTUAL_EDGE_LEAST];
    for (int i = 0; i < VIRTUAL_SLOTS; i++) {
        struct virtual_cell *cell = &lights->cell[i];
        if (!cell->key)
            continue;
        size_t count = virtual_samples_of(lamps, worker, cell, lights->side,
                                          VIRTUAL_EDGE_LEAST, found);
        samples->of[i].power = samples_power(found, count);
        if (samples->of[i].power > 0)
            samples->brought += cell->brought;
        else
            cell->worth = 0;
    }
}

/* How many rays along an edge look at a cell: the more, the more it brings. */
static unsigned cell_edge(double share)
{
    unsigned edge = VIRTUAL_EDGE_LEAST;
    while (edge < VIRTUAL_EDGE_MOST && 2 * edge * edge <= VIRTUAL_RAYS * share)
        edge *= 2;
    return edge;
}

static struct virtual_light *samples_room(struct samples *samples)
{
    if (samples->room - samples->count < VIRTUAL_SAMPLES_MOST) {
        samples->room = 2 * samples->room + VIRTUAL_SAMPLES_MOST;
        samples->at =
            memory_resize(samples->at, samples->room * sizeof *samples->at);
    }
    return samples->at + samples->count;
}

/* A closer look into each. */
static void samples_look(struct samples *samples,
                         const struct virtual_lights *lights,
                         const struct lamps *lamps, struct worker *worker)
{
    double side = lights->side, all = samples->brought;
    samples->brought = 0;
    for (int i = 0; i < VIRTUAL_SLOTS && !worker_stopped(worker); i++) {
        const struct virtual_cell *cell = &lights->cell[i];
        struct cell_samples *of = &samples->of[i];
        if (!(of->power > 0))
            continue;
        struct virtual_light *at = samples_room(samples);
        unsigned edge = cell_edge(cell->brought / all);
        of->count = virtual_samples_of(lamps, worker, cell, side, edge, at);
        of->power = samples_power(at, of->count);
        of->step = side / edge;
        samples->count += of->count;
        samples->brought += of->power > 0 ? cell->brought : 0;
        double apart = virtual_apart * cell->seen_at;
        samples->wanted += samples_area(at, of->count) / (apart * apart);
    }
}

static void lanes_set(struct virtual_lanes *lanes, int i,
                      const struct virtual_light *light)
{
    for (int axis = 0; axis < 3; axis++) {
        lanes->place[axis][i] = vec3_component(light->point, axis);
        lanes->normal[axis][i] = vec3_component(light->normal, axis);
    }
    lanes->power[i] = light_power(light);
    lanes->near[i] = light->near;
}

/* So many of a cell for each part, all of the same power, evenly along the
 * curve. What moves in another cell changes none of them. */
static void cell_take(struct virtual_lights *lights,
                      const struct virtual_cell *cell,
                      const struct cell_samples *of,
                      const struct virtual_light *samples, int each_part)
{
    int count = each_part * GATHER_PARTS, next = 0;
    struct virtual_light *at = &lights->at[lights->count * GATHER_PARTS];
    double each = of->power / count, sum = 0;
    for (size_t i = 0; i < of->count && next < count; i++) {
        sum += light_power(&samples[i]);
        for (; next < count && sum > (next + 0.5) * each; next++) {
            at[next] = samples[i];
            at[next].near = cell->near;
            at[next].area =
                each * GATHER_PARTS / virtual_light_amount(samples[i].light);
        }
    }
    lights->count += next / GATHER_PARTS;
}

/* About so many for each part. */
static void lights_take(struct virtual_lights *lights,
                        const struct samples *samples, double wanted)
{
    const struct virtual_light *at = samples->at;
    lights->at = memory_new(VIRTUAL_LANES * GATHER_PARTS * sizeof *lights->at);
    for (int i = 0; i < VIRTUAL_SLOTS; i++) {
        const struct cell_samples *of = &samples->of[i];
        struct virtual_cell *cell = &lights->cell[i];
        double area = samples_area(at, of->count);
        double each_part =
            fmax(round(wanted * cell->brought / samples->brought), 1);
        cell->near = virtual_near * fmax(sqrt(area / each_part), of->step);
        if (of->power > 0)
            cell_take(lights, cell, of, at, (int)each_part);
        else
            cell->worth = 0;
        at += of->count;
    }
    lights->lanes = memory_new(GATHER_PARTS * sizeof *lights->lanes);
    for (int i = 0; i < lights->count * GATHER_PARTS; i++)
        lanes_set(&lights->lanes[i % GATHER_PARTS], i / GATHER_PARTS,
                  &lights->at[i]);
}

static void lights_choose(struct virtual_lights *lights,
                          const struct samples *samples, int times)
{
    double wanted =
        times * fmin(fmax(samples->wanted, VIRTUAL_LEAST), VIRTUAL_MOST);
    if (samples->brought > 0)
        lights_take(lights, samples, wanted);
}

struct virtual_lights *virtual_lights_new(const struct bright *lit,
                                          const struct lamps *lamps, int times,
                                          struct worker *worker)
{
    struct virtual_lights *lights = memory_new(sizeof *lights);
    struct samples *samples = memory_new(sizeof *samples);
    lights->side = bright_side(lit);
    for (int i = 0; i < lit->count; i++)
        cells_around(lights, &lit->at[i]);
    samples_begin(samples, lights, lamps, worker);
    samples_look(samples, lights, lamps, worker);
    lights_choose(lights, samples, times);
    memory_free(samples->at);
    memory_free(samples);
    return lights;
}

void virtual_lights_free(struct virtual_lights *lights)
{
    if (lights) {
        memory_free(lights->at);
        memory_free(lights->lanes);
    }
    memory_free(lights);
}

/* What each gives a place, in whatever direction; returns the sum. */
CLONES static double lanes_give(const struct virtual_lanes *lanes, int count,
                                const double at[3], double *give)
{
    const double px = at[0], py = at[1], pz = at[2];
    double sum = 0;
    for (int i = 0; i < count; i++) {
        double x = px - lanes->place[0][i], y = py - lanes->place[1][i],
               z = pz - lanes->place[2][i];
        double square = x * x + y * y + z * z, distance = sqrt(square);
        double facing = x * lanes->normal[0][i] + y * lanes->normal[1][i] +
                        z * lanes->normal[2][i];
        double t = distance / lanes->near[i] - 1;
        t = t < 0 ? 0 : t;
        t = t > 1 ? 1 : t;
        double fade = t * t * (3 - 2 * t);
        double each = lanes->power[i] * facing * fade / (square * distance);
        give[i] = ((facing > 0) & (t > 0)) ? each : 0;
    }
    for (int i = 0; i < count; i++)
        sum += give[i];
    return sum;
}

int virtual_lights_pick(const struct virtual_lights *lights, vec3 place,
                        unsigned part, int wanted, struct virtual_pick *picks)
{
    const double at[3] = { place.x, place.y, place.z };
    double give[VIRTUAL_LANES];
    if (lights->count == 0)
        return 0;
    double sum = lanes_give(&lights->lanes[part], lights->count, at, give);
    double each = sum / wanted, passed = 0, next = each / 2;
    int count = 0;
    for (int i = 0; i < lights->count && count < wanted; i++) {
        int times = 0;
        passed += give[i];
        for (; next < passed; next += each)
            times++;
        if (times > 0)
            picks[count++] = (struct virtual_pick){ i, give[i] / each / times };
    }
    return count;
}
