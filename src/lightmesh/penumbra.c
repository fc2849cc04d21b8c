/* Area lights at the picture's own points: see penumbra.h. */
#include "lightmesh/penumbra.h"

#include "base/memory.h"
#include "base/parallel.h"
#include "lightmesh/tuning.h"
#include "shade/surface.h"

/* The lattice has every second pixel, both ways, and each of its cells as many.
 * Blocks have 1, 2 or 4 cells along a side. */
enum { CELL = 2, BLOCK_MOST = 4 };

/* What a cell holds: the side of the block that it is in, 0 if there is none,
 * and whether all of that is lit. */
enum { SIDES = 7, LIT = 8, TRIED = 16 };

/* Shares that aren't known, and that can't be. */
static const float unknown = -1, none = -2;

/* Of the lattice: where it is in the world, and the true normal, outward, and
 * 1 if it is turned to the camera, else -1. */
struct pixel_point {
    vec3 place, normal;
    double facing;
};

/* A lamp's. */
struct penumbra {
    const struct lamp *lamp;
    uint8_t *cells;
    float (*shares)[3];
};

struct penumbras {
    const struct lamps *lamps;
    const struct camera *camera;
    struct first_hits hits;
    int left, top; /* of the lattice, in cells; may be negative */
    int columns, rows;
    struct pixel_point *points;
    struct penumbra *of; /* by lamp; without shares for those not taken */
    size_t count;
};

/* A pass over the blocks of one size, or over their corners. */
struct penumbra_pass {
    struct penumbras *all;
    struct penumbra *of;
    struct worker *const *workers;
    int side; /* of a block, in cells */
};

bool penumbra_takes(const struct lamps *lamps, const struct lamp *lamp)
{
    const struct light *light = lamp->light;
    return lamps_soft(lamps, lamp) && !light->shadowless &&
           !light->media_attenuation && lamps->quality >= QUALITY_SHADOWS;
}

static int floor_to(int x, int step)
{
    return x - ((x % step) + step) % step;
}

static bool lattice_has(const struct penumbras *all, int i, int j)
{
    return i >= all->left && j >= all->top && i < all->left + all->columns &&
           j < all->top + all->rows;
}

static size_t lattice_at(const struct penumbras *all, int i, int j)
{
    return (size_t)(j - all->top) * (size_t)all->columns +
           (size_t)(i - all->left);
}

static const struct world_hit *lattice_hit(const struct penumbras *all, int i,
                                           int j)
{
    return first_hits_at(&all->hits, CELL * i, CELL * j);
}

/* Returns the camera's ray. */
static struct ray lattice_describe(const struct penumbras *all, int i, int j,
                                   struct intersection *at)
{
    double place[2];
    first_hits_place(&all->hits, CELL * i, CELL * j, place);
    struct ray ray = camera_ray(all->camera, place[0], place[1]);
    world_describe(&ray, lattice_hit(all, i, j), at);
    return ray;
}

static void place_row(void *context, size_t row, unsigned thread)
{
    struct penumbras *all = context;
    int j = all->top + (int)row;
    (void)thread;
    for (int i = all->left; i < all->left + all->columns; i++) {
        struct intersection at;
        if (!lattice_hit(all, i, j)->leaf)
            continue;
        struct ray ray = lattice_describe(all, i, j, &at);
        double facing = vec3_dot(ray.direction, at.face) < 0 ? 1 : -1;
        all->points[lattice_at(all, i, j)] =
            (struct pixel_point){ at.point, at.face, facing };
    }
}

/* A block with its corners, row by row. */
struct block {
    size_t at[4];
    const struct leaf *leaf;
    vec3 middle, normal; /* unit */
    double side, radius; /* in the world */
    double bend;
};

/* The corners of the block at (i, j). False if they are not all on a surface,
 * the same. */
static bool block_corners(const struct penumbras *all, int i, int j, int side,
                          size_t at[4])
{
    if (!lattice_has(all, i, j) || !lattice_has(all, i + side, j + side))
        return false;
    const struct world_hit *first = lattice_hit(all, i, j);
    for (int k = 0; k < 4; k++) {
        int x = i + (k & 1) * side, y = j + (k >> 1) * side;
        at[k] = lattice_at(all, x, y);
        if (!first->leaf || !first_hit_is_on(lattice_hit(all, x, y),
                                             first->leaf, first->hit.part))
            return false;
    }
    return true;
}

/* False if it isn't nearly flat. */
static bool block_measure(const struct penumbras *all, struct block *block)
{
    const struct pixel_point *p[4];
    for (int k = 0; k < 4; k++)
        p[k] = &all->points[block->at[k]];
    vec3 low = vec3_add(p[0]->place, p[3]->place);
    vec3 high = vec3_add(p[1]->place, p[2]->place);
    vec3 normal = vec3_add(vec3_add(p[0]->normal, p[3]->normal),
                           vec3_add(p[1]->normal, p[2]->normal));
    block->middle = vec3_scale(vec3_add(low, high), 0.25);
    block->normal = vec3_normalise(normal);
    block->side = block->radius = block->bend = 0;
    for (int k = 0; k < 4; k++) {
        vec3 next = p[k == 0 ? 1 : k == 1 ? 3 : k == 3 ? 2 : 0]->place;
        vec3 side = vec3_sub(next, p[k]->place);
        vec3 out = vec3_sub(p[k]->place, block->middle);
        vec3 turn = vec3_sub(p[k]->normal, block->normal);
        block->side = fmax(block->side, vec3_length(side));
        block->radius = fmax(block->radius, vec3_length(out));
        block->bend = fmax(block->bend, vec3_length(turn));
    }
    double swell = vec3_length(vec3_sub(low, high)) / 4;
    return block->bend < penumbra_bend && swell < penumbra_swell * block->side;
}

/* Whether the lamp is before a surface that is seen. */
static bool lamp_is_before(const struct lamp *lamp, vec3 place, vec3 normal,
                           double facing, struct lamp_view *view)
{
    return lamp_look(lamp, lamp->light->location, place, view) &&
           facing * vec3_dot(view->direction, normal) > 0;
}

/* What there is to be of a block: 0, its side, and LIT. */
static uint8_t block_try(const struct penumbra_pass *pass, int i, int j)
{
    const struct penumbras *all = pass->all;
    const struct lamp *lamp = pass->of->lamp;
    struct block block;
    if (!block_corners(all, i, j, pass->side, block.at) ||
        !block_measure(all, &block))
        return 0;
    struct intersection at = { .leaf = lattice_hit(all, i, j)->leaf,
                               .face = block.normal };
    struct lamp_target target = { .point = block.middle, .at = &at };
    double facing = all->points[block.at[0]].facing;
    if (!lamp_is_before(lamp, block.middle, block.normal, facing, &target.view))
        return 0;
    double blur = lamps_blur(all->lamps, lamp, &target, block.radius,
                             2 * block.bend, penumbra_wide * block.side);
    if (blur < penumbra_wide * block.side)
        return 0;
    return (uint8_t)(pass->side | (blur < HUGE_VAL ? TRIED : LIT));
}

static void block_fill(const struct penumbra_pass *pass, int i, int j,
                       uint8_t value)
{
    for (int y = j; y < j + pass->side; y++)
        for (int x = i; x < i + pass->side; x++)
            if (lattice_has(pass->all, x, y))
                pass->of->cells[lattice_at(pass->all, x, y)] = value;
}

static void try_row(void *context, size_t row, unsigned thread)
{
    const struct penumbra_pass *pass = context;
    const struct penumbras *all = pass->all;
    int side = pass->side, first = floor_to(all->left, side);
    int j = floor_to(all->top, side) + (int)row * side;
    (void)thread;
    for (int i = first; i < all->left + all->columns; i += side) {
        if (!lattice_has(all, i, j) ||
            pass->of->cells[lattice_at(all, i, j)] != 0)
            continue;
        uint8_t value = block_try(pass, i, j);
        if (value)
            block_fill(pass, i, j, value);
    }
}

/* Whether the cell is in a block of that side, whose corners are asked for. */
static bool cell_asks(const struct penumbra_pass *pass, int i, int j)
{
    return lattice_has(pass->all, i, j) &&
           pass->of->cells[lattice_at(pass->all, i, j)] == (pass->side | TRIED);
}

static void corner_ask(const struct penumbra_pass *pass, int i, int j,
                       struct worker *worker)
{
    const struct penumbras *all = pass->all;
    const struct lamp *lamp = pass->of->lamp;
    struct intersection at;
    size_t number = lattice_at(all, i, j);
    float *share = pass->of->shares[number];
    lattice_describe(all, i, j, &at);
    struct lamp_target target = { .point = at.point, .at = &at };
    share[0] = none;
    if (!lamp_is_before(lamp, at.point, at.face, all->points[number].facing,
                        &target.view))
        return;
    rgb seen = lamps_share_fine(all->lamps, lamp, worker, &target);
    share[0] = (float)seen.r;
    share[1] = (float)seen.g;
    share[2] = (float)seen.b;
}

static void ask_row(void *context, size_t row, unsigned thread)
{
    const struct penumbra_pass *pass = context;
    const struct penumbras *all = pass->all;
    int j = floor_to(all->top, pass->side) + (int)row * pass->side;
    if (j < all->top || j >= all->top + all->rows)
        return;
    for (int i = floor_to(all->left, pass->side); i < all->left + all->columns;
         i += pass->side)
        if (i >= all->left &&
            pass->of->shares[lattice_at(all, i, j)][0] == unknown &&
            (cell_asks(pass, i, j) || cell_asks(pass, i - 1, j) ||
             cell_asks(pass, i, j - 1) || cell_asks(pass, i - 1, j - 1)))
            corner_ask(pass, i, j, pass->workers[thread]);
}

/* Whether all corners are known and nearly agree. */
static bool block_is_even(const struct penumbra_pass *pass, int i, int j)
{
    size_t at[4];
    block_corners(pass->all, i, j, pass->side, at);
    float(*shares)[3] = pass->of->shares;
    for (int c = 0; c < 3; c++) {
        float low = shares[at[0]][c], high = low;
        for (int k = 0; k < 4; k++) {
            if (shares[at[k]][0] < 0)
                return false;
            low = fminf(low, shares[at[k]][c]);
            high = fmaxf(high, shares[at[k]][c]);
        }
        if (high - low > penumbra_even ||
            (high > low && (low <= 0 || high >= 1)))
            return false;
    }
    return true;
}

static void settle_row(void *context, size_t row, unsigned thread)
{
    const struct penumbra_pass *pass = context;
    const struct penumbras *all = pass->all;
    int side = pass->side, first = floor_to(all->left, side);
    int j = floor_to(all->top, side) + (int)row * side;
    (void)thread;
    for (int i = first; i < all->left + all->columns; i += side)
        if (cell_asks(pass, i, j))
            block_fill(pass, i, j,
                       block_is_even(pass, i, j) ? (uint8_t)side : 0);
}

static void penumbra_find(struct penumbra_pass *pass, unsigned threads)
{
    const struct penumbras *all = pass->all;
    const atomic_int *stop = pass->workers[0]->stop;
    for (pass->side = BLOCK_MOST; pass->side >= 1; pass->side /= 2) {
        int top = floor_to(all->top, pass->side);
        size_t rows =
            (size_t)((all->top + all->rows - top - 1) / pass->side + 1);
        parallel_run(threads, rows, stop, try_row, pass);
        parallel_run(threads, rows, stop, ask_row, pass);
        parallel_run(threads, rows, stop, settle_row, pass);
    }
}

static size_t lattice_size(const struct penumbras *all)
{
    return (size_t)all->columns * (size_t)all->rows;
}

static void penumbra_start(struct penumbras *all, struct penumbra *of,
                           const struct lamp *lamp)
{
    size_t size = lattice_size(all);
    of->lamp = lamp;
    of->cells = memory_new(size);
    of->shares = memory_new(size * sizeof *of->shares);
    for (size_t i = 0; i < size; i++)
        of->shares[i][0] = unknown;
}

/* All pixels with even coordinates. */
static void lattice_start(struct penumbras *all)
{
    const struct first_hits *hits = &all->hits;
    all->left = floor_to(hits->left + CELL - 1, CELL) / CELL;
    all->top = floor_to(hits->top + CELL - 1, CELL) / CELL;
    all->columns =
        floor_to(hits->left + hits->columns - 1, CELL) / CELL - all->left + 1;
    all->rows =
        floor_to(hits->top + hits->rows - 1, CELL) / CELL - all->top + 1;
    all->points = memory_new(lattice_size(all) * sizeof *all->points);
}

struct penumbras *penumbras_new(const struct lamps *lamps,
                                const struct camera *camera,
                                const struct first_hits *hits,
                                struct worker *const *workers, unsigned threads)
{
    struct penumbras *all = memory_new(sizeof *all);
    all->lamps = lamps;
    all->camera = camera;
    all->hits = *hits;
    lattice_start(all);
    parallel_run(threads, (size_t)all->rows, workers[0]->stop, place_row, all);
    all->of = memory_new(lamps->count * sizeof *all->of);
    for (size_t i = 0; i < lamps->count; i++) {
        struct penumbra_pass pass = { all, &all->of[i], workers, 0 };
        if (!penumbra_takes(lamps, &lamps->items[i]))
            continue;
        penumbra_start(all, &all->of[i], &lamps->items[i]);
        penumbra_find(&pass, threads);
    }
    return all;
}

void penumbras_free(struct penumbras *all)
{
    if (!all)
        return;
    for (size_t i = 0; i < all->lamps->count; i++) {
        memory_free(all->of[i].cells);
        memory_free(all->of[i].shares);
    }
    memory_free(all->of);
    memory_free(all->points);
    memory_free(all);
}

/* Where a place is in a block, and what of each corner counts there. */
struct block_place {
    uint8_t cell; /* what it holds */
    size_t at[4];
    double weight[4];
};

/* Whether what is seen there is the block's surface: on the same leaf may be
 * another sheet of it. */
static bool place_is_near(const struct penumbras *all,
                          const struct block_place *place,
                          const struct intersection *at)
{
    const struct pixel_point *first = &all->points[place->at[0]];
    const struct pixel_point *last = &all->points[place->at[3]];
    vec3 middle = vec3_make(0, 0, 0);
    vec3 across = vec3_sub(last->place, first->place);
    vec3 turn = vec3_sub(at->face, first->normal);
    for (int k = 0; k < 4; k++)
        middle = vec3_along(middle, all->points[place->at[k]].place,
                            place->weight[k]);
    vec3 off = vec3_sub(at->point, middle);
    return vec3_dot(off, off) <=
               penumbra_swell * penumbra_swell * vec3_dot(across, across) &&
           vec3_dot(turn, turn) <= 4 * penumbra_bend * penumbra_bend;
}

static bool block_place(const struct penumbras *all, const uint8_t *cells,
                        double x, double y, const struct intersection *at,
                        struct block_place *place)
{
    int i = (int)floor(x / CELL), j = (int)floor(y / CELL);
    if (!lattice_has(all, i, j))
        return false;
    place->cell = cells[lattice_at(all, i, j)];
    int side = place->cell & SIDES;
    if (side == 0)
        return false;
    i = floor_to(i, side);
    j = floor_to(j, side);
    const struct world_hit *first = lattice_hit(all, i, j);
    if (!first_hit_is_on(first, at->leaf, at->part))
        return false;
    double u = (x / CELL - i) / side, v = (y / CELL - j) / side;
    for (int k = 0; k < 4; k++) {
        place->at[k] = lattice_at(all, i + (k & 1) * side, j + (k >> 1) * side);
        place->weight[k] = (k & 1 ? u : 1 - u) * (k >> 1 ? v : 1 - v);
    }
    return place_is_near(all, place, at);
}

bool penumbras_share(const struct penumbras *all,
                     const struct receiver *receiver, const struct lamp *lamp,
                     rgb *share)
{
    const struct penumbra *of = &all->of[lamp->number];
    const double *grid = receiver->pixel->grid;
    struct block_place in;
    if (!of->cells ||
        !block_place(all, of->cells, grid[0], grid[1], receiver->at, &in))
        return false;
    *share = rgb_grey(1);
    if (in.cell & LIT)
        return true;
    float sum[3] = { 0, 0, 0 };
    for (int k = 0; k < 4; k++)
        for (int c = 0; c < 3; c++)
            sum[c] += (float)in.weight[k] * of->shares[in.at[k]][c];
    *share = (rgb){ (double)sum[0], (double)sum[1], (double)sum[2] };
    return true;
}

double penumbras_bytes(double pixels, size_t lamps)
{
    double lattice = pixels / (CELL * CELL);
    return lattice * (sizeof(struct pixel_point) +
                      (double)lamps * (1 + 3 * sizeof(float)));
}

size_t penumbras_count(const struct penumbras *all)
{
    size_t count = 0;
    for (size_t i = 0; i < all->lamps->count; i++)
        for (size_t k = 0; all->of[i].shares && k < lattice_size(all); k++)
            count += all->of[i].shares[k][0] >= 0;
    return count;
}

double penumbras_memory(const struct penumbras *all)
{
    size_t lamps = 0;
    for (size_t i = 0; i < all->lamps->count; i++)
        lamps += all->of[i].shares != NULL;
    return penumbras_bytes((double)lattice_size(all) * CELL * CELL, lamps);
}
