/* Pieces of the void: see pieces.h. Connected parts are found as sets of voxels
 * joined in raster order (union-find). */
#include "skeleton/pieces.h"

#include <string.h>

#include "base/memory.h"
#include "base/side.h"

enum {
    WIDTHS = 3,         /* regions of a chamber, the wider ones first */
    FINEST = 32,        /* the least width is so small a part of the grid */
    PIECES_MOST = 4000, /* if there are more, they are cut coarser, */
    COARSER = 6         /* so often at most */
};

/* The side of a cell, in radii of the chamber's widest node. Of 0.7 to 2 the
 * one that was closest to path in examples/light. */
static const double cell_width = 0.75;

/* A node so much narrower than that is where the void is narrow, as below a
 * table; there cells are half as wide, and where it is half as narrow again, a
 * quarter: light isn't even from there to what is beside it. */
static const double narrow = 0.62;

struct cutting {
    const struct voxels *voxels;
    const uint32_t *nearest;
    const struct graph *graph;
    const struct chambers *chambers;
    const struct pieces_kept *root; /* whose cells these are, or NULL */
    struct pieces *pieces;
    double *width;    /* voxels: radius of the widest node of each chamber */
    uint32_t regions; /* of all chambers */
    uint32_t *cell;   /* of each voxel, its region; then its cell, counted over
                       * all regions, or root's piece */
    uint32_t *up;     /* trees of voxels: up leads to an earlier one */
    uint32_t *first;  /* the first cell of each region */
};

static void cells_bound(struct cutting *cutting)
{
    const uint32_t *region = cutting->cell;
    const int *size = cutting->voxels->size;
    size_t voxel = 0;
    for (size_t i = 0; i < cutting->regions; i++)
        for (int axis = 0; axis < 3; axis++) {
            cutting->pieces->cells[i].low[axis] = size[axis];
            cutting->pieces->cells[i].high[axis] = 0;
        }
    for (int z = 0; z < size[2]; z++)
        for (int y = 0; y < size[1]; y++)
            for (int x = 0; x < size[0]; x++, voxel++) {
                if (region[voxel] == PIECE_NONE)
                    continue;
                int at[3] = { x, y, z };
                struct piece_cells *cells =
                    &cutting->pieces->cells[region[voxel]];
                for (int axis = 0; axis < 3; axis++) {
                    if (at[axis] < cells->low[axis])
                        cells->low[axis] = at[axis];
                    if (at[axis] >= cells->high[axis])
                        cells->high[axis] = at[axis] + 1;
                }
            }
}

/* Equal cells along each axis, of about the wanted size; returns how many. */
static uint32_t cells_count(struct piece_cells *cells, double wanted)
{
    uint32_t all = 1;
    for (int axis = 0; axis < 3; axis++) {
        int extent = cells->high[axis] - cells->low[axis];
        if (extent <= 0)
            return 0;
        int count = (int)(extent / wanted + 0.5);
        cells->count[axis] = count > 1 ? count : 1;
        cells->size[axis] = (double)extent / cells->count[axis];
        all *= (uint32_t)cells->count[axis];
    }
    return all;
}

static uint32_t cell_at(const struct piece_cells *cells, int x, int y, int z)
{
    int i = (int)((x - cells->low[0] + 0.5) / cells->size[0]);
    int j = (int)((y - cells->low[1] + 0.5) / cells->size[1]);
    int k = (int)((z - cells->low[2] + 0.5) / cells->size[2]);
    return (uint32_t)((k * cells->count[1] + j) * cells->count[0] + i);
}

/* Turns the region of each voxel into its cell. */
static void cutting_cells(struct cutting *cutting)
{
    const int *size = cutting->voxels->size;
    uint32_t *at = cutting->cell;
    for (int z = 0; z < size[2]; z++)
        for (int y = 0; y < size[1]; y++)
            for (int x = 0; x < size[0]; x++, at++)
                if (*at != PIECE_NONE)
                    *at = cutting->first[*at] +
                          cell_at(&cutting->pieces->cells[*at], x, y, z);
}

static uint32_t root_of(uint32_t *up, uint32_t voxel)
{
    while (up[voxel] != voxel) {
        up[voxel] = up[up[voxel]];
        voxel = up[voxel];
    }
    return voxel;
}

static void cutting_join(struct cutting *cutting, size_t voxel, size_t before)
{
    if (cutting->cell[before] != cutting->cell[voxel])
        return;
    uint32_t a = root_of(cutting->up, (uint32_t)voxel);
    uint32_t b = root_of(cutting->up, (uint32_t)before);
    if (a < b)
        cutting->up[b] = a;
    else
        cutting->up[a] = b;
}

static void cutting_connect(struct cutting *cutting)
{
    const int *size = cutting->voxels->size;
    size_t rows = (size_t)size[0], slices = rows * (size_t)size[1], voxel = 0;
    for (int z = 0; z < size[2]; z++)
        for (int y = 0; y < size[1]; y++)
            for (int x = 0; x < size[0]; x++, voxel++) {
                cutting->up[voxel] = (uint32_t)voxel;
                if (cutting->cell[voxel] == PIECE_NONE)
                    continue;
                if (x > 0)
                    cutting_join(cutting, voxel, voxel - 1);
                if (y > 0)
                    cutting_join(cutting, voxel, voxel - rows);
                if (z > 0)
                    cutting_join(cutting, voxel, voxel - slices);
            }
}

/* The radius of the widest node of each chamber, in voxels. */
static double *chambers_width(const struct cutting *cutting)
{
    const struct chambers *chambers = cutting->chambers;
    double *width = memory_new(chambers->count * sizeof *width);
    for (size_t i = 0; i < cutting->graph->count; i++) {
        uint32_t chamber = chambers->of_node[i];
        width[chamber] = fmax(width[chamber], cutting->graph->nodes[i].radius /
                                                  cutting->voxels->edge);
    }
    return width;
}

/* Cells of all regions, so many of their radii wide. Where numbers of cells
 * overflow neighbours still hardly ever agree. */
static void cutting_plan(struct cutting *cutting, double radii)
{
    const int *size = cutting->voxels->size;
    double longest = 0;
    uint32_t first = 0;
    for (int axis = 0; axis < 3; axis++)
        longest = fmax(longest, size[axis]);
    for (uint32_t i = 0; i < cutting->regions; i++) {
        double width = cutting->width[i / WIDTHS] / (1 << i % WIDTHS);
        double wanted = fmax(longest / FINEST, width) * radii;
        cutting->first[i] = first;
        first += cells_count(&cutting->pieces->cells[i], wanted);
    }
}

/* Numbers the pieces by their first voxels. */
static void cutting_number(struct cutting *cutting)
{
    struct pieces *pieces = cutting->pieces;
    size_t count = voxels_count(cutting->voxels);
    pieces->count = 0;
    for (size_t i = 0; i < count; i++) {
        uint32_t root = root_of(cutting->up, (uint32_t)i);
        if (cutting->cell[i] == PIECE_NONE)
            pieces->of_voxel[i] = PIECE_NONE;
        else if (root == i)
            pieces->of_voxel[i] = (uint32_t)pieces->count++;
        else
            pieces->of_voxel[i] = pieces->of_voxel[root];
    }
}

/* The chamber of its nearest node, and how narrow that is. */
static uint32_t voxel_region(const struct cutting *cutting, size_t voxel)
{
    uint32_t node = cutting->nearest[voxel], region;
    if (node == GRAPH_NONE)
        return PIECE_NONE;
    uint32_t chamber = cutting->chambers->of_node[node];
    double radius = cutting->graph->nodes[node].radius / cutting->voxels->edge,
           least = narrow * cutting->width[chamber];
    for (region = 0; region < WIDTHS - 1 && radius < least; region++)
        least /= 2;
    return chamber * WIDTHS + region;
}

static void cutting_cut(struct cutting *cutting, double radii)
{
    size_t count = voxels_count(cutting->voxels);
    for (size_t i = 0; i < count; i++)
        cutting->cell[i] = voxel_region(cutting, i);
    cells_bound(cutting);
    cutting_plan(cutting, radii);
    cutting_cells(cutting);
    cutting_connect(cutting);
    cutting_number(cutting);
}

static bool cutting_lacks(const struct cutting *cutting, size_t voxel)
{
    return cutting->cell[voxel] == PIECE_NONE &&
           cutting->nearest[voxel] != GRAPH_NONE;
}

/* Void that no piece of the root had, since there was matter then, becomes part
 * of the cell that is next to it through the void; what none gets to is one
 * cell more. */
static void cutting_spread(struct cutting *cutting)
{
    const struct voxels *voxels = cutting->voxels;
    size_t count = voxels_count(voxels), end = 0;
    uint32_t *reached = memory_new(count * sizeof *reached);
    for (size_t i = 0; i < count; i++)
        if (cutting->cell[i] != PIECE_NONE)
            reached[end++] = (uint32_t)i;
    for (size_t i = 0; i < end; i++)
        for (int side = 0; side < SIDES; side++) {
            int at[3];
            voxels_place(voxels, reached[i], at);
            at[side / 2] += side % 2 ? -1 : 1;
            if (!voxels_holds(voxels, at))
                continue;
            size_t next = voxels_index(voxels, at[0], at[1], at[2]);
            if (!cutting_lacks(cutting, next))
                continue;
            cutting->cell[next] = cutting->cell[reached[i]];
            reached[end++] = (uint32_t)next;
        }
    memory_free(reached);
    for (size_t i = 0; i < count; i++)
        if (cutting_lacks(cutting, i))
            cutting->cell[i] = (uint32_t)cutting->root->pieces.count;
}

/* The root's cells: what moves may part them, or give them more void. */
static void cutting_follow(struct cutting *cutting)
{
    const struct pieces *root = &cutting->root->pieces;
    size_t count = voxels_count(cutting->voxels);
    memcpy(cutting->pieces->cells, root->cells,
           root->regions * sizeof *root->cells);
    for (size_t i = 0; i < count; i++)
        cutting->cell[i] =
            cutting->nearest[i] == GRAPH_NONE ? PIECE_NONE : root->of_voxel[i];
    cutting_spread(cutting);
    cutting_connect(cutting);
    cutting_number(cutting);
}

static void cutting_own(struct cutting *cutting)
{
    double radii = cell_width;
    cutting_cut(cutting, radii);
    for (int i = 0; i < COARSER && cutting->pieces->count > PIECES_MOST; i++)
        cutting_cut(cutting, radii *= 1.5);
}

/* The root's region of a voxel; of what is in none of them the first will do.
 */
static uint32_t root_region(const struct cutting *cutting, size_t voxel)
{
    const struct pieces *root = &cutting->root->pieces;
    uint32_t piece = cutting->cell[voxel];
    return piece < root->count ? root->region[piece] : 0;
}

/* The region of each piece, which all of its voxels are in. */
static void cutting_name(struct cutting *cutting)
{
    struct pieces *pieces = cutting->pieces;
    size_t count = voxels_count(cutting->voxels);
    for (size_t i = 0; i < count; i++)
        if (pieces->of_voxel[i] != PIECE_NONE)
            pieces->region[pieces->of_voxel[i]] =
                (cutting->root ? root_region : voxel_region)(cutting, i);
}

static bool voxels_alike(const struct voxels *a, const struct voxels *b)
{
    return memcmp(a->size, b->size, sizeof a->size) == 0 &&
           a->edge == b->edge &&
           memcmp(&a->origin, &b->origin, sizeof a->origin) == 0;
}

struct pieces *pieces_new(struct arena *arena, const struct voxels *voxels,
                          const uint32_t *nearest, const struct graph *graph,
                          const struct pieces_kept *root)
{
    struct pieces *pieces = ARENA_NEW(arena, struct pieces);
    const struct chambers *chambers = chambers_new(arena, graph);
    bool follows =
        root && root->pieces.count > 0 && voxels_alike(&root->grid, voxels);
    size_t count = voxels_count(voxels);
    struct cutting cutting = {
        .voxels = voxels,
        .nearest = nearest,
        .graph = graph,
        .chambers = chambers,
        .root = follows ? root : NULL,
        .pieces = pieces,
        .regions = (uint32_t)chambers->count * WIDTHS,
        .cell = memory_new(count * sizeof *cutting.cell),
        .up = memory_new(count * sizeof *cutting.up),
        .first = memory_new(chambers->count * WIDTHS * sizeof *cutting.first),
    };
    cutting.width = chambers_width(&cutting);
    pieces->regions = follows ? root->pieces.regions : cutting.regions;
    pieces->cells = ARENA_ARRAY(arena, struct piece_cells, pieces->regions);
    pieces->of_voxel = ARENA_ARRAY(arena, uint32_t, count);
    (follows ? cutting_follow : cutting_own)(&cutting);
    pieces->region = ARENA_ARRAY(arena, uint32_t, pieces->count);
    cutting_name(&cutting);
    memory_free(cutting.width);
    memory_free(cutting.cell);
    memory_free(cutting.up);
    memory_free(cutting.first);
    return pieces;
}

/* The next so many bytes of a block, with a copy in them. */
static void *block_copy(char **at, const void *from, size_t size)
{
    void *copy = memcpy(*at, from, size);
    *at += size;
    return copy;
}

struct pieces_kept *pieces_keep(const struct pieces *pieces,
                                const struct voxels *voxels)
{
    size_t cells = pieces->regions * sizeof *pieces->cells;
    size_t of_voxel = voxels_count(voxels) * sizeof *pieces->of_voxel;
    size_t region = pieces->count * sizeof *pieces->region;
    struct pieces_kept *kept =
        memory_new(sizeof *kept + cells + of_voxel + region);
    char *at = (char *)(kept + 1);
    kept->grid = *voxels;
    kept->grid.empty = NULL;
    kept->pieces = *pieces;
    kept->pieces.cells = block_copy(&at, pieces->cells, cells);
    kept->pieces.of_voxel = block_copy(&at, pieces->of_voxel, of_voxel);
    kept->pieces.region = block_copy(&at, pieces->region, region);
    return kept;
}
