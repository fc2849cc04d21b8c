/* Solids to voxels by descent: boxes that no surface can meet are dropped
 * (world/overlap.h), the others halved, down to quarters of a voxel, where
 * what the bounds say too much is little. */
#include "skeleton/voxelise.h"

#include "base/array.h"
#include "base/parallel.h"
#include "world/overlap.h"
#include "scene/primitive.h"

enum {
    BLOCK = 32,      /* voxels along the side of what a thread does at once */
    FINER_LEVELS = 2 /* halvings below the voxel */
};

/* So much larger than they are the voxels' cells: what lies on a face is in
 * both voxels, whatever the rounding. */
static const double cell_growth = 1e-6;

struct solid_item {
    const struct solid *solid;
    int low[3], high[3]; /* the voxels it may meet */
    uint8_t marks;       /* of all its parts together */
    int levels;          /* FINER_LEVELS, or 0 if it has to be searched */
};

struct solid_work {
    struct arena *arena;
    const struct voxels *grid;
    const uint8_t *marks;
    uint8_t *out;
    int blocks[3];
    struct {
        struct solid_item *items;
        size_t count, capacity;
    } solids;
};

bool voxels_touched(const struct voxels *grid, struct box3 box, int *low,
                    int *high)
{
    for (int axis = 0; axis < 3; axis++) {
        double origin = vec3_component(grid->origin, axis);
        double a = (vec3_component(box.low, axis) - origin) / grid->edge;
        double b = (vec3_component(box.high, axis) - origin) / grid->edge;
        double last = grid->size[axis] - 1;
        a = floor(a - cell_growth);
        b = floor(b + cell_growth);
        if (!(a <= b) || a > last || b < 0)
            return false;
        low[axis] = (int)fmax(0, a);
        high[axis] = (int)fmin(last, b);
    }
    return true;
}

static bool is_searched(const struct solid *solid)
{
    if (solid->kind == OBJECT_SHAPE && !solid->leaf->object->primitive->meets)
        return true;
    for (size_t i = 0; i < solid->child_count; i++)
        if (is_searched(solid->children[i]))
            return true;
    for (size_t i = 0; i < solid->more->clip_count; i++)
        if (is_searched(solid->more->clips[i]))
            return true;
    return false;
}

static uint8_t marks_of_parts(const struct solid *solid, const uint8_t *marks)
{
    uint8_t all = solid->leaf ? marks[solid->leaf->number] : 0;
    for (size_t i = 0; i < solid->child_count; i++)
        all |= marks_of_parts(solid->children[i], marks);
    return all;
}

static void take_solid(void *context, const struct solid *solid)
{
    struct solid_work *work = context;
    struct solid_item item = { .solid = solid,
                               .marks = marks_of_parts(solid, work->marks) };
    if (!item.marks ||
        !voxels_touched(work->grid, solid->surface, item.low, item.high))
        return;
    item.levels = is_searched(solid) ? 0 : FINER_LEVELS;
    *ARRAY_PUSH(work->arena, &work->solids) = item;
}

static void take_no_mesh(void *context, const struct leaf *leaf)
{
    (void)context;
    (void)leaf;
}

/* Marks found in the cell, looking closer where `levels` are left; no longer
 * than until all of `wanted` are found. */
static uint8_t cell_marks(const struct solid_work *work,
                          const struct solid_item *item, vec3 centre,
                          double half, int levels, uint8_t wanted)
{
    double grown = half + cell_growth * work->grid->edge;
    uint8_t found = 0;
    uint8_t there =
        solid_overlap(item->solid, centre, vec3_make(grown, grown, grown),
                      levels == 0, work->marks)
            .marks;
    if (levels == 0 || !(there & wanted))
        return there;
    half /= 2;
    for (int i = 0; i < 8 && (found & there) != there; i++) {
        vec3 part = { centre.x + (i & 1 ? half : -half),
                      centre.y + (i & 2 ? half : -half),
                      centre.z + (i & 4 ? half : -half) };
        found |= cell_marks(work, item, part, half, levels - 1,
                            (uint8_t)(there & ~found));
    }
    return found;
}

static void mark_voxel(const struct solid_work *work,
                       const struct solid_item *item, const int *at)
{
    const struct voxels *grid = work->grid;
    uint8_t *out = &work->out[voxels_index(grid, at[0], at[1], at[2])];
    if ((*out & item->marks) != item->marks)
        *out |= cell_marks(work, item, voxels_centre(grid, at), grid->edge / 2,
                           item->levels, item->marks);
}

/* Whether the surface may meet the voxels low..high. */
static bool box_is_met(const struct solid_work *work,
                       const struct solid_item *item, const int *low,
                       const int *high)
{
    double edge = work->grid->edge, grow = 2 * cell_growth;
    vec3 sum = { low[0] + high[0] + 1, low[1] + high[1] + 1,
                 low[2] + high[2] + 1 };
    vec3 size = { high[0] - low[0] + 1 + grow, high[1] - low[1] + 1 + grow,
                  high[2] - low[2] + 1 + grow };
    vec3 centre = vec3_along(work->grid->origin, sum, edge / 2);
    return solid_overlap(item->solid, centre, vec3_scale(size, edge / 2), false,
                         work->marks)
               .marks != 0;
}

static void descend(const struct solid_work *work,
                    const struct solid_item *item, const int *low,
                    const int *high)
{
    int axis = 0, upper[3], lower[3];
    for (int i = 1; i < 3; i++)
        axis = high[i] - low[i] > high[axis] - low[axis] ? i : axis;
    if (high[axis] == low[axis]) {
        mark_voxel(work, item, low);
        return;
    }
    if (!box_is_met(work, item, low, high))
        return;
    for (int i = 0; i < 3; i++) {
        upper[i] = high[i];
        lower[i] = low[i];
    }
    upper[axis] = low[axis] + (high[axis] - low[axis]) / 2;
    lower[axis] = upper[axis] + 1;
    descend(work, item, low, upper);
    descend(work, item, lower, high);
}

/* Everything in one block, which no other thread writes to. */
static void mark_block(void *context, size_t number, unsigned thread)
{
    const struct solid_work *work = context;
    int block[3] = { (int)number % work->blocks[0],
                     (int)number / work->blocks[0] % work->blocks[1],
                     (int)number / work->blocks[0] / work->blocks[1] };
    (void)thread;
    for (size_t i = 0; i < work->solids.count; i++) {
        const struct solid_item *item = &work->solids.items[i];
        int low[3], high[3];
        bool apart = false;
        for (int k = 0; k < 3; k++) {
            int first = block[k] * BLOCK, last = first + BLOCK - 1;
            low[k] = item->low[k] > first ? item->low[k] : first;
            high[k] = item->high[k] < last ? item->high[k] : last;
            apart = apart || low[k] > high[k];
        }
        if (!apart)
            descend(work, item, low, high);
    }
}

void voxelise_solids(const struct world *world, const struct voxels *grid,
                     const uint8_t *marks, unsigned threads,
                     const atomic_int *stop, uint8_t *out)
{
    struct solid_work work = { arena_new(0), grid, marks, out, { 0 }, { 0 } };
    size_t count = 1;
    for (int i = 0; i < 3; i++) {
        work.blocks[i] = (grid->size[i] + BLOCK - 1) / BLOCK;
        count *= (size_t)work.blocks[i];
    }
    world_visit(world, take_solid, take_no_mesh, &work);
    parallel_run(threads, count, stop, mark_block, &work);
    arena_free(work.arena);
}

void voxelise(const struct world *world, const struct voxels *grid,
              const uint8_t *marks, unsigned threads, const atomic_int *stop,
              uint8_t *out)
{
    voxelise_solids(world, grid, marks, threads, stop, out);
    voxelise_meshes(world, grid, marks, threads, stop, out);
}
