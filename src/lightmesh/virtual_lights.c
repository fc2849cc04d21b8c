/* Virtual lights: see virtual_lights.h. */
#include "lightmesh/virtual_lights.h"

#include "base/draw.h"
#include "base/memory.h"
#include "base/side.h"
#include "base/smooth.h"
#include "lightmesh/gather_ways.h"
#include "lightmesh/tuning.h"
#include "lightmesh/virtual_samples.h"

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
        };
    cell->worth = fmax(cell->worth, disc->worth);
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

/* How many rays along an edge look at a cell: the more, the more it brings. */
static unsigned cell_edge(const struct virtual_lights *lights, double share)
{
    const double rays = lights->times * VIRTUAL_RAYS * share;
    unsigned edge = VIRTUAL_EDGE_LEAST;
    while (edge < VIRTUAL_EDGE_MOST && 2 * edge * edge <= rays)
        edge *= 2;
    return edge;
}

/* A look into all cells. */
struct looking {
    const struct lamps *lamps;
    struct worker *worker;
    double brought; /* by all cells */
    size_t room;    /* for lights */
    uint32_t rays;  /* into cells before, lit or not: what is lit elsewhere
                     * changes no chance */
};

static struct virtual_light *lights_room(struct virtual_lights *lights,
                                         size_t *room)
{
    if (*room - lights->count < VIRTUAL_SAMPLES_MOST) {
        *room = 2 * *room + VIRTUAL_SAMPLES_MOST;
        lights->at = memory_resize(lights->at, *room * sizeof *lights->at);
    }
    return lights->at + lights->count;
}

/* How many are lit: none if they have no power together. */
static size_t looking_into(const struct looking *looking,
                           const struct virtual_cell *cell, double side,
                           unsigned edge, struct virtual_light *at)
{
    size_t count = virtual_samples_of(looking->lamps, looking->worker, cell,
                                      side, edge, at);
    return samples_power(at, count) > 0 ? count : 0;
}

static unsigned light_part(const struct virtual_light *light)
{
    return light->number % GATHER_PARTS;
}

/* Each ray of a grid into a cell that finds light is one, of the part that its
 * number says. Where the coarsest grid finds nothing there is none. */
static void cell_look(struct virtual_lights *lights, struct virtual_cell *cell,
                      struct looking *looking)
{
    struct virtual_light *at = lights_room(lights, &looking->room);
    unsigned edge = cell_edge(lights, cell->brought / looking->brought);
    uint32_t before = looking->rays;
    size_t count =
        looking_into(looking, cell, lights->side, VIRTUAL_EDGE_LEAST, at);
    looking->rays += edge * edge;
    if (count > 0 && edge > VIRTUAL_EDGE_LEAST)
        count = looking_into(looking, cell, lights->side, edge, at);
    if (count == 0) {
        cell->worth = 0;
        return;
    }
    double area = GATHER_PARTS * samples_area(at, count) / (double)count;
    cell->near = virtual_near * sqrt(area);
    for (size_t i = 0; i < count; i++) {
        const struct draws draws = { random_key(looking->lamps->seed,
                                                light_part(&at[i])),
                                     (before + at[i].number) / GATHER_PARTS };
        at[i].chance = draw_unit(&draws, 0);
        at[i].near = cell->near;
        at[i].area *= GATHER_PARTS;
    }
    lights->count += count;
}

static void lanes_new(struct virtual_lanes *lanes, int room)
{
    double *rows = memory_new((size_t)room * VIRTUAL_ROWS * sizeof *rows);
    for (int i = 0; i < VIRTUAL_ROWS; i++)
        lanes->row[i] = rows + (size_t)i * (size_t)room;
    lanes->light = memory_new((size_t)room * sizeof *lanes->light);
    lanes->count = 0;
}

static void lanes_add(struct virtual_lanes *lanes,
                      const struct virtual_light *light)
{
    int i = lanes->count++;
    for (int axis = 0; axis < 3; axis++) {
        lanes->row[VIRTUAL_PLACE + axis][i] =
            vec3_component(light->point, axis);
        lanes->row[VIRTUAL_NORMAL + axis][i] =
            vec3_component(light->normal, axis);
    }
    lanes->row[VIRTUAL_POWER][i] = light_power(light);
    lanes->row[VIRTUAL_NEAR][i] = light->near;
    lanes->light[i] = light;
}

static void lights_part(struct virtual_lights *lights)
{
    int count[GATHER_PARTS] = { 0 };
    for (size_t i = 0; i < lights->count; i++)
        count[light_part(&lights->at[i])]++;
    for (int part = 0; part < GATHER_PARTS; part++)
        lanes_new(&lights->lanes[part], count[part]);
    for (size_t i = 0; i < lights->count; i++)
        lanes_add(&lights->lanes[light_part(&lights->at[i])], &lights->at[i]);
}

struct virtual_lights *virtual_lights_new(const struct bright *lit,
                                          const struct lamps *lamps, int times,
                                          struct worker *worker)
{
    struct virtual_lights *lights = memory_new(sizeof *lights);
    struct looking looking = { .lamps = lamps, .worker = worker };
    lights->times = times;
    lights->side = bright_side(lit);
    for (int i = 0; i < lit->count; i++) {
        cells_around(lights, &lit->at[i]);
        looking.brought += lit->at[i].brought;
    }
    for (int i = 0; i < VIRTUAL_SLOTS && !worker_stopped(worker); i++)
        if (lights->cell[i].key)
            cell_look(lights, &lights->cell[i], &looking);
    lights_part(lights);
    return lights;
}

void virtual_lights_free(struct virtual_lights *lights)
{
    for (int part = 0; lights && part < GATHER_PARTS; part++) {
        memory_free(lights->lanes[part].row[0]);
        memory_free(lights->lanes[part].light);
    }
    if (lights)
        memory_free(lights->at);
    memory_free(lights);
}

static int lanes_left(const struct virtual_lanes *lanes, int first)
{
    int left = lanes->count - first;
    return left < VIRTUAL_LANES ? left : VIRTUAL_LANES;
}

/* What so many from `first` on give a place, in whatever direction; returns the
 * sum. */
CLONES static double lanes_give(const struct virtual_lanes *lanes, int first,
                                int count, const double at[3],
                                double *restrict give)
{
    const double px = at[0], py = at[1], pz = at[2];
    const double *restrict lx = lanes->row[VIRTUAL_PLACE] + first,
                           *restrict ly = lanes->row[VIRTUAL_PLACE + 1] + first,
                           *restrict lz = lanes->row[VIRTUAL_PLACE + 2] + first,
                           *restrict nx = lanes->row[VIRTUAL_NORMAL] + first,
                           *restrict ny =
                               lanes->row[VIRTUAL_NORMAL + 1] + first,
                           *restrict nz =
                               lanes->row[VIRTUAL_NORMAL + 2] + first,
                           *restrict power = lanes->row[VIRTUAL_POWER] + first,
                           *restrict near = lanes->row[VIRTUAL_NEAR] + first;
    double sum = 0;
    for (int i = 0; i < count; i++) {
        double x = px - lx[i], y = py - ly[i], z = pz - lz[i];
        double square = x * x + y * y + z * z, distance = sqrt(square);
        double facing = x * nx[i] + y * ny[i] + z * nz[i];
        double t = distance / near[i] - 1;
        t = t < 0 ? 0 : t;
        t = t > 1 ? 1 : t;
        double fade = t * t * (3 - 2 * t);
        double each = power[i] * facing * fade / (square * distance);
        give[i] = ((facing > 0) & (t > 0)) ? each : 0;
    }
    for (int i = 0; i < count; i++)
        sum += give[i];
    return sum;
}

/* A draw of some lights. */
struct picking {
    const struct virtual_lights *lights;
    double share;         /* of a pick for each of what a light gives */
    double passed, along; /* sums of what isn't picked for sure, and of picks of
                           * these */
    double stands;        /* for so much all picks do */
    struct virtual_pick *picks;
    int count;
};

/* What should have more than one pick has one, of the others some do: evenly
 * along the curve, or, if they are to stay, by chance, of which each has its
 * own for good (Brewer, Early and Joyce, Selecting Several Samples from a
 * Single Population, 1972): what stands still asks the same ones in the next
 * picture of an animation, whatever else is lit otherwise there [flicker].
 * Chances side by side are spread evenly. */
static void picking_offer(struct picking *picking,
                          const struct virtual_light *light, double give)
{
    const double often = give * picking->share;
    if (often < 1) {
        picking->passed += often;
        if (picking->lights->times > 1
                ? !(often > light->chance)
                : !(picking->passed > picking->along + 0.5))
            return;
        picking->along++;
    }
    if (picking->count == VIRTUAL_PICKS_MOST)
        return;
    struct virtual_pick pick = { light, fmin(often, 1) };
    picking->stands += give / pick.often;
    picking->picks[picking->count++] = pick;
}

/* What all would give were they seen is known: those that are picked stand for
 * that (ratio estimation: Hajek 1971). */
int virtual_lights_pick(const struct virtual_lights *lights, vec3 place,
                        unsigned part, int wanted, struct virtual_pick *picks)
{
    const double at[3] = { place.x, place.y, place.z };
    const struct virtual_lanes *lanes = &lights->lanes[part];
    double give[VIRTUAL_LANES], sum = 0;
    for (int first = 0; first < lanes->count; first += VIRTUAL_LANES)
        sum += lanes_give(lanes, first, lanes_left(lanes, first), at, give);
    struct picking picking = { .lights = lights,
                               .share = wanted / sum,
                               .picks = picks };
    for (int first = 0; sum > 0 && first < lanes->count;
         first += VIRTUAL_LANES) {
        int left = lanes_left(lanes, first);
        if (lanes->count > VIRTUAL_LANES)
            lanes_give(lanes, first, left, at, give);
        for (int i = 0; i < left; i++)
            if (give[i] > 0)
                picking_offer(&picking, lanes->light[first + i], give[i]);
    }
    for (int i = 0; i < picking.count; i++)
        picks[i].often *= picking.stands / sum;
    return picking.count;
}
