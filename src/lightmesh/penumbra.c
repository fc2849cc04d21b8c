/* Area lights at the picture's own points: see penumbra.h. */
#include "lightmesh/penumbra.h"

#include "base/memory.h"
#include "base/parallel.h"
#include "lightmesh/pixel_lattice.h"
#include "lightmesh/tuning.h"
#include "shade/surface.h"

/* Blocks have 1, 2 or 4 cells of the lattice along a side. */
enum { BLOCK_MOST = 4 };

/* What a cell holds: the side of the block that it is in, 0 if there is none,
 * and whether all of that is lit. */
enum { SIDES = 7, LIT = 8, TRIED = 16 };

/* Shares that aren't known, and that can't be. */
static const float unknown = -1, none = -2;

/* A lamp's. */
struct penumbra {
    const struct lamp *lamp;
    uint8_t *cells;
    float (*shares)[3];
};

struct penumbras {
    const struct lamps *lamps;
    struct pixel_lattice lattice;
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
    const struct pixel_lattice *lattice = &all->lattice;
    if (!pixel_lattice_has(lattice, i, j) ||
        !pixel_lattice_has(lattice, i + side, j + side))
        return false;
    const struct world_hit *first = pixel_lattice_hit(lattice, i, j);
    for (int k = 0; k < 4; k++) {
        int x = i + (k & 1) * side, y = j + (k >> 1) * side;
        at[k] = pixel_lattice_at(lattice, x, y);
        if (!first->leaf || !first_hit_is_on(pixel_lattice_hit(lattice, x, y),
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
        p[k] = &all->lattice.points[block->at[k]];
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
    const struct pixel_lattice *lattice = &all->lattice;
    const struct lamp *lamp = pass->of->lamp;
    struct block block;
    if (!block_corners(all, i, j, pass->side, block.at) ||
        !block_measure(all, &block))
        return 0;
    struct lamp_target middle = { block.middle, .face = block.normal };
    struct lamp_piece piece = { middle, block.radius, 2 * block.bend };
    double facing = lattice->points[block.at[0]].facing;
    double least = penumbra_wide * block.side;
    piece.middle.leaf = pixel_lattice_hit(lattice, i, j)->leaf;
    if (!lamp_is_before(lamp, block.middle, block.normal, facing,
                        &piece.middle.view))
        return 0;
    double blur = lamps_blur(all->lamps, lamp, &piece, least);
    uint8_t tried = (uint8_t)(pass->side | (blur < HUGE_VAL ? TRIED : LIT));
    return blur < least ? 0 : tried;
}

static void block_fill(const struct penumbra_pass *pass, int i, int j,
                       uint8_t value)
{
    const struct pixel_lattice *lattice = &pass->all->lattice;
    for (int y = j; y < j + pass->side; y++)
        for (int x = i; x < i + pass->side; x++)
            if (pixel_lattice_has(lattice, x, y))
                pass->of->cells[pixel_lattice_at(lattice, x, y)] = value;
}

static void try_row(void *context, size_t row, unsigned thread)
{
    const struct penumbra_pass *pass = context;
    const struct pixel_lattice *lattice = &pass->all->lattice;
    int side = pass->side, first = floor_to(lattice->left, side);
    int j = floor_to(lattice->top, side) + (int)row * side;
    (void)thread;
    for (int i = first; i < lattice->left + lattice->columns; i += side) {
        if (!pixel_lattice_has(lattice, i, j) ||
            pass->of->cells[pixel_lattice_at(lattice, i, j)] != 0)
            continue;
        uint8_t value = block_try(pass, i, j);
        if (value)
            block_fill(pass, i, j, value);
    }
}

/* Whether the cell is in a block of that side, whose corners are asked for. */
static bool cell_asks(const struct penumbra_pass *pass, int i, int j)
{
    const struct pixel_lattice *lattice = &pass->all->lattice;
    return pixel_lattice_has(lattice, i, j) &&
           pass->of->cells[pixel_lattice_at(lattice, i, j)] ==
               (pass->side | TRIED);
}

static void corner_ask(const struct penumbra_pass *pass, int i, int j,
                       struct worker *worker)
{
    const struct penumbras *all = pass->all;
    const struct pixel_lattice *lattice = &all->lattice;
    const struct lamp *lamp = pass->of->lamp;
    struct intersection at;
    struct ray ray;
    size_t number = pixel_lattice_at(lattice, i, j);
    float *share = pass->of->shares[number];
    pixel_lattice_describe(lattice, i, j, &ray, &at);
    struct lamp_target target = { at.point, .leaf = at.leaf, .face = at.face };
    share[0] = none;
    if (!lamp_is_before(lamp, at.point, at.face, lattice->points[number].facing,
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
    const struct pixel_lattice *lattice = &pass->all->lattice;
    int j = floor_to(lattice->top, pass->side) + (int)row * pass->side;
    if (j < lattice->top || j >= lattice->top + lattice->rows)
        return;
    for (int i = floor_to(lattice->left, pass->side);
         i < lattice->left + lattice->columns; i += pass->side)
        if (i >= lattice->left &&
            pass->of->shares[pixel_lattice_at(lattice, i, j)][0] == unknown &&
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
    const struct pixel_lattice *lattice = &pass->all->lattice;
    int side = pass->side, first = floor_to(lattice->left, side);
    int j = floor_to(lattice->top, side) + (int)row * side;
    (void)thread;
    for (int i = first; i < lattice->left + lattice->columns; i += side)
        if (cell_asks(pass, i, j))
            block_fill(pass, i, j,
                       block_is_even(pass, i, j) ? (uint8_t)side : 0);
}

static void penumbra_find(struct penumbra_pass *pass, unsigned threads)
{
    const struct pixel_lattice *lattice = &pass->all->lattice;
    const atomic_int *stop = pass->workers[0]->stop;
    for (pass->side = BLOCK_MOST; pass->side >= 1; pass->side /= 2) {
        int top = floor_to(lattice->top, pass->side);
        size_t rows =
            (size_t)((lattice->top + lattice->rows - top - 1) / pass->side + 1);
        parallel_run(threads, rows, stop, try_row, pass);
        parallel_run(threads, rows, stop, ask_row, pass);
        parallel_run(threads, rows, stop, settle_row, pass);
    }
}

static void penumbra_start(struct penumbras *all, struct penumbra *of,
                           const struct lamp *lamp)
{
    size_t size = pixel_lattice_size(&all->lattice);
    of->lamp = lamp;
    of->cells = memory_new(size);
    of->shares = memory_new(size * sizeof *of->shares);
    for (size_t i = 0; i < size; i++)
        of->shares[i][0] = unknown;
}

struct penumbras *penumbras_new(const struct lamps *lamps,
                                const struct camera *camera,
                                const struct first_hits *hits,
                                struct worker *const *workers, unsigned threads)
{
    struct penumbras *all = memory_new(sizeof *all);
    all->lamps = lamps;
    pixel_lattice_start(&all->lattice, camera, hits, workers[0]->stop, threads);
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
    pixel_lattice_end(&all->lattice);
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
    const struct pixel_lattice *lattice = &all->lattice;
    const struct pixel_point *first = &lattice->points[place->at[0]];
    const struct pixel_point *last = &lattice->points[place->at[3]];
    vec3 middle = vec3_make(0, 0, 0);
    vec3 across = vec3_sub(last->place, first->place);
    vec3 turn = vec3_sub(at->face, first->normal);
    for (int k = 0; k < 4; k++)
        middle = vec3_along(middle, lattice->points[place->at[k]].place,
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
    const struct pixel_lattice *lattice = &all->lattice;
    int i = (int)floor(x / PIXEL_CELL), j = (int)floor(y / PIXEL_CELL);
    if (!pixel_lattice_has(lattice, i, j))
        return false;
    place->cell = cells[pixel_lattice_at(lattice, i, j)];
    int side = place->cell & SIDES;
    if (side == 0)
        return false;
    i = floor_to(i, side);
    j = floor_to(j, side);
    const struct world_hit *first = pixel_lattice_hit(lattice, i, j);
    if (!first_hit_is_on(first, at->leaf, at->part))
        return false;
    double u = (x / PIXEL_CELL - i) / side, v = (y / PIXEL_CELL - j) / side;
    for (int k = 0; k < 4; k++) {
        place->at[k] =
            pixel_lattice_at(lattice, i + (k & 1) * side, j + (k >> 1) * side);
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
    double lattice = pixels / (PIXEL_CELL * PIXEL_CELL);
    return lattice * (sizeof(struct pixel_point) +
                      (double)lamps * (1 + 3 * sizeof(float)));
}

size_t penumbras_count(const struct penumbras *all)
{
    size_t count = 0;
    for (size_t i = 0; i < all->lamps->count; i++)
        for (size_t k = 0;
             all->of[i].shares && k < pixel_lattice_size(&all->lattice); k++)
            count += all->of[i].shares[k][0] >= 0;
    return count;
}

double penumbras_memory(const struct penumbras *all)
{
    size_t lamps = 0;
    for (size_t i = 0; i < all->lamps->count; i++)
        lamps += all->of[i].shares != NULL;
    return penumbras_bytes((double)pixel_lattice_size(&all->lattice) *
                               PIXEL_CELL * PIXEL_CELL,
                           lamps);
}
