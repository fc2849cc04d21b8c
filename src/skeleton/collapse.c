/* The collapse: see collapse.h. A free pair is a cell f of which g is the only
 * cell above; removing both is an elementary collapse. All pairs of one
 * direction, orientation and dimension may go at once: no two share a cell.
 * One round goes over the six directions and the three dimensions, and takes
 * one layer: the closure of what was free as it began. So each layer is a list,
 * and the time is in proportion to the number of cells.
 *
 * Branches: an edge is born when no square is left on it. It stays for good
 * once it has lived longer than
 *     (opening - distance) + birth
 * rounds: longer than the place is thick, and longer still off the middle
 * (the rule of Chaussard's and Noel's later programs; without a parameter). */
#include "skeleton/collapse.h"

#include "base/array.h"
#include "base/memory.h"

struct cell_list {
    cell *items;
    size_t count, capacity;
};

struct birth {
    cell edge;
    int round;
};

struct collapse {
    struct complex *complex;
    const struct voxels *voxels;
    const struct collapse_maps *maps;
    uint8_t *kept;   /* cells that must stay */
    uint8_t *border; /* cells of this round's layer */
    uint8_t *known;  /* edges that were born before */
    struct cell_list candidates;
    /* Squares by the axis they lie across, then edges, points and cubes. */
    struct cell_list squares[3], edges, points, cubes;
    struct cell_list pairs; /* f of what a step removes */
    struct {
        struct birth *items;
        size_t count, capacity;
    } births;
    int round;
};

static void list_add(struct cell_list *list, cell c)
{
    if (list->count == list->capacity) {
        list->capacity = list->capacity ? 2 * list->capacity : 1024;
        list->items =
            memory_resize(list->items, list->capacity * sizeof *list->items);
    }
    list->items[list->count++] = c;
}

static struct cell_list *collapse_list(struct collapse *collapse, cell c)
{
    switch (c & 7) {
    case 0:
        return &collapse->points;
    case 3:
        return &collapse->squares[2];
    case 5:
        return &collapse->squares[1];
    case 6:
        return &collapse->squares[0];
    case 7:
        return &collapse->cubes;
    default:
        return &collapse->edges;
    }
}

/* By the axes of a cell: of the byte of its lattice point, the bits of the
 * cells above it. */
static const uint8_t above_bits[8] = {
    1 << 1 | 1 << 2 | 1 << 4, /* a point: edges along x, y, z */
    1 << 3 | 1 << 5,          /* x: squares xy, xz */
    1 << 3 | 1 << 6,          1 << 7, 1 << 5 | 1 << 6, 1 << 7, 1 << 7, 0,
};

/* How many cells of one dimension more have f, up to two; *only is one. Those
 * on the upper side are in the same byte. */
static int cofaces(const struct complex *complex, cell f, cell *only)
{
    const uint8_t *cells = complex->cells;
    unsigned upper = cells[f >> 3] & above_bits[f & 7];
    int count = 0;
    if (upper & (upper - 1))
        return 2;
    if (upper) {
        *only = (f & ~7u) + (cell)__builtin_ctz(upper);
        count = 1;
    }
    for (int axis = 0; axis < 3; axis++) {
        cell below = cell_below(complex, f, axis);
        if (f >> axis & 1 || !complex_has(cells, below))
            continue;
        if (++count == 2)
            return 2;
        *only = below;
    }
    return count;
}

/* Whether f may be collapsed with the only cell above it, *g. */
static bool collapse_free(const struct collapse *collapse, cell f, cell *g)
{
    return complex_has(collapse->complex->cells, f) &&
           cofaces(collapse->complex, f, g) == 1 &&
           !complex_has(collapse->kept, f) && !complex_has(collapse->kept, *g);
}

/* The layer: all faces of what is free now. False if nothing is. */
static bool collapse_layer(struct collapse *collapse)
{
    bool any = false;
    cell g, closure[CLOSURE_MAX];
    for (size_t i = 0; i < collapse->candidates.count; i++) {
        if (!collapse_free(collapse, collapse->candidates.items[i], &g))
            continue;
        any = true;
        int count = cell_closure(collapse->complex, g, closure);
        for (int k = 0; k < count; k++)
            if (!complex_has(collapse->border, closure[k])) {
                complex_set(collapse->border, closure[k]);
                list_add(collapse_list(collapse, closure[k]), closure[k]);
            }
    }
    return any;
}

/* One step: all pairs (f, g) of a list with g on one side of f. What is gone
 * from the complex leaves the list. */
static bool collapse_step(struct collapse *collapse, struct cell_list *list,
                          int axis, bool above)
{
    struct complex *complex = collapse->complex;
    size_t left = 0;
    cell g;
    collapse->pairs.count = 0;
    for (size_t i = 0; i < list->count; i++) {
        cell f = list->items[i];
        if (!complex_has(complex->cells, f)) {
            complex_clear(collapse->border, f);
            continue;
        }
        list->items[left++] = f;
        if (f >> axis & 1)
            continue;
        cell wanted =
            above ? cell_above(f, axis) : cell_below(complex, f, axis);
        if (complex_has(complex->cells, wanted) &&
            complex_has(collapse->border, wanted) &&
            collapse_free(collapse, f, &g))
            list_add(&collapse->pairs, f);
    }
    list->count = left;
    for (size_t i = 0; i < collapse->pairs.count; i++) {
        cell f = collapse->pairs.items[i];
        complex_clear(complex->cells, f);
        complex_clear(complex->cells, above ? cell_above(f, axis)
                                            : cell_below(complex, f, axis));
    }
    return collapse->pairs.count > 0;
}

static bool collapse_directions(struct collapse *collapse)
{
    bool any = false;
    for (int axis = 0; axis < 3; axis++)
        for (int above = 0; above < 2; above++) {
            any |=
                collapse_step(collapse, &collapse->squares[axis], axis, above);
            any |= collapse_step(collapse, &collapse->edges, axis, above);
            any |= collapse_step(collapse, &collapse->points, axis, above);
        }
    return any;
}

/* The largest value of a map in the voxels around an edge. */
static int edge_value(const struct collapse *collapse, const uint16_t *map,
                      cell edge)
{
    const struct voxels *voxels = collapse->voxels;
    int place[3], value = 0;
    complex_place(collapse->complex, edge, place);
    for (int corner = 0; corner < 8; corner++) {
        int at[3];
        bool there = true;
        for (int axis = 0; axis < 3; axis++) {
            at[axis] = place[axis] - (corner >> axis & 1);
            there = there && at[axis] >= 0 && at[axis] < voxels->size[axis] &&
                    !((int)(edge & (cell)corner) >> axis & 1);
        }
        if (!there)
            continue;
        int here = map[voxels_index(voxels, at[0], at[1], at[2])];
        value = here > value ? here : value;
    }
    return value;
}

/* Has the edge lived long enough to stay? */
static bool birth_keeps(const struct collapse *collapse,
                        const struct birth *birth)
{
    int life = collapse->round - birth->round;
    int opening = edge_value(collapse, collapse->maps->opening, birth->edge);
    int distance = edge_value(collapse, collapse->maps->distance, birth->edge);
    return life > opening - distance + birth->round;
}

static void collapse_bear(struct collapse *collapse, cell edge)
{
    cell above;
    if (complex_has(collapse->known, edge) ||
        cofaces(collapse->complex, edge, &above) > 0)
        return;
    complex_set(collapse->known, edge);
    if (collapse->births.count == collapse->births.capacity) {
        collapse->births.capacity = 2 * collapse->births.capacity + 256;
        collapse->births.items = memory_resize(
            collapse->births.items,
            collapse->births.capacity * sizeof *collapse->births.items);
    }
    collapse->births.items[collapse->births.count++] =
        (struct birth){ edge, collapse->round };
}

/* What is left of a list of the layer is looked at again in the next round. */
static void collapse_next(struct collapse *collapse, struct cell_list *list)
{
    for (size_t i = 0; i < list->count; i++) {
        cell c = list->items[i];
        complex_clear(collapse->border, c);
        if (complex_has(collapse->complex->cells, c))
            list_add(&collapse->candidates, c);
        else
            continue;
        if (collapse->maps && cell_dimension(c) == 1)
            collapse_bear(collapse, c);
    }
    list->count = 0;
}

/* Edges that have lived long enough, and their ends, stay for good. */
static void collapse_keep(struct collapse *collapse)
{
    size_t left = 0;
    cell closure[CLOSURE_MAX];
    for (size_t i = 0; i < collapse->births.count; i++) {
        struct birth birth = collapse->births.items[i];
        if (!complex_has(collapse->complex->cells, birth.edge))
            continue;
        if (!birth_keeps(collapse, &birth)) {
            collapse->births.items[left++] = birth;
            continue;
        }
        int count = cell_closure(collapse->complex, birth.edge, closure);
        for (int k = 0; k < count; k++)
            complex_set(collapse->kept, closure[k]);
    }
    collapse->births.count = left;
}

static bool collapse_round(struct collapse *collapse)
{
    if (!collapse_layer(collapse))
        return false;
    bool any = collapse_directions(collapse);
    collapse->round++;
    collapse->candidates.count = 0;
    for (int axis = 0; axis < 3; axis++)
        collapse_next(collapse, &collapse->squares[axis]);
    collapse_next(collapse, &collapse->edges);
    collapse_next(collapse, &collapse->points);
    collapse_next(collapse, &collapse->cubes);
    collapse_keep(collapse);
    return any;
}

/* Whether all around a lattice point is void: nothing of it is free. */
static bool is_inner(const struct complex *complex, size_t i)
{
    const uint8_t *cells = complex->cells;
    return (cells[i] & cells[i - complex->stride[0] / 8] &
            cells[i - complex->stride[1] / 8] &
            cells[i - complex->stride[2] / 8]) == 0xff;
}

/* Everything that is free as it begins. */
static void collapse_begin(struct collapse *collapse)
{
    const struct complex *complex = collapse->complex;
    cell g;
    for (size_t i = 0; i < complex->count; i++)
        for (cell axes = 0;
             complex->cells[i] && axes < 7 && !is_inner(complex, i); axes++) {
            cell f = (cell)(8 * i) + axes;
            if (collapse_free(collapse, f, &g))
                list_add(&collapse->candidates, f);
        }
}

static void collapse_end(struct collapse *collapse)
{
    memory_free(collapse->kept);
    memory_free(collapse->border);
    memory_free(collapse->known);
    memory_free(collapse->candidates.items);
    memory_free(collapse->edges.items);
    memory_free(collapse->points.items);
    memory_free(collapse->cubes.items);
    memory_free(collapse->pairs.items);
    memory_free(collapse->births.items);
    for (int axis = 0; axis < 3; axis++)
        memory_free(collapse->squares[axis].items);
}

int complex_collapse(struct complex *complex, const struct voxels *voxels,
                     const struct collapse_maps *maps)
{
    struct collapse collapse = {
        .complex = complex,
        .voxels = voxels,
        .maps = maps,
        .kept = memory_new(complex->count),
        .border = memory_new(complex->count),
        .known = memory_new(complex->count),
    };
    collapse_begin(&collapse);
    while (!(maps && maps->stop && atomic_load(maps->stop)) &&
           collapse_round(&collapse))
        continue;
    collapse_end(&collapse);
    return collapse.round;
}
