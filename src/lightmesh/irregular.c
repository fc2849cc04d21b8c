/* Irregular z-buffers: see irregular.h.
 *
 * What is hidden is decided by planes through the lamp and the edges of a
 * triangle, and by the triangle's own: cells only tell which points to ask, so
 * that neither their number nor their shape can be seen. */
#include "lightmesh/irregular.h"

#include <string.h>

#include "base/memory.h"
#include "lightmesh/cube_cells.h"
#include "lightmesh/lanes.h"

/* Cells along an edge of the cube, for so many points in each. */
enum { EDGE_LEAST = 16, EDGE_MOST = 512 };
static const double cell_points = 1;

_Static_assert((int)CASTER_WIDTH == (int)LANES, "a batch of triangles");

/* Numbers that describe the planes of a triangle. */
enum { PLANES = 13 };

struct irregular {
    float low[3], high[3]; /* of all points */
    const struct casters *casters;
    const struct irregular_points *points;
    int edge;            /* cells */
    uint32_t cell_count; /* of all sides; this cell is for points not asked */
    uint32_t *cell;      /* by point */
    uint32_t *first;     /* by cell: its first point in the order of cells */
    uint32_t *number;    /* by place in that order: the point */
    float *sorted[3];    /* its place, from the lamp */
    int32_t *hidden, *doubt;
};

/* The lamp's view: its place from the casters' centre. */
struct irregular_view {
    struct irregular *irregular;
    float at[3];
    float margin;
    bool shadows;
    float low[3], high[3]; /* of all points, from the lamp */
};

/* Eight triangles from the lamp: the planes of their edges and, last, their
 * own, all turned so that what is hidden is on the positive side; plane 3 is
 * passed by more than its fourth number. Where they lie: the side of the cube
 * that all corners are on, or -1, and there a box of cells. */
struct irregular_batch {
    float plane[PLANES][LANES];
    float corner[9][LANES];
    int32_t side[LANES];
    int32_t low[2][LANES], high[2][LANES];
};

double irregular_margin(const struct casters *casters, vec3 location)
{
    vec3 at = vec3_sub(location, casters->centre);
    double reach = fmax(fabs(at.x), fmax(fabs(at.y), fabs(at.z)));
    return 4e-6 * fmax(reach, casters->size);
}

static int edge_for(size_t points)
{
    double cells = (double)points / cell_points;
    int edge = EDGE_LEAST;
    while (edge < EDGE_MOST && CUBE_SIDES * (double)edge * edge < cells)
        edge += EDGE_LEAST;
    return edge;
}

static void points_bounds(struct irregular *irregular)
{
    const struct irregular_points *points = irregular->points;
    for (int k = 0; k < 3; k++) {
        const float *place = points->place[k];
        irregular->low[k] = irregular->high[k] = place[0];
        for (size_t i = 1; i < points->count; i++) {
            irregular->low[k] = fminf(irregular->low[k], place[i]);
            irregular->high[k] = fmaxf(irregular->high[k], place[i]);
        }
    }
}

/* All arrays are in one block: a large one is quicker to get. */
struct irregular *irregular_new(const struct casters *casters,
                                const struct irregular_points *points)
{
    struct irregular *irregular = memory_new(sizeof *irregular);
    size_t room = irregular_padded(points->count) + LANES;
    int edge = edge_for(points->count);
    uint32_t cells = (uint32_t)(CUBE_SIDES * edge * edge);
    uint32_t *block = memory_new((7 * room + cells + 2) * sizeof(uint32_t));
    *irregular = (struct irregular){
        .casters = casters,
        .points = points,
        .edge = edge,
        .cell_count = cells,
        .cell = block,
        .number = block + room,
        .hidden = (int32_t *)(block + 2 * room),
        .doubt = (int32_t *)(block + 3 * room),
        .first = block + 7 * room,
    };
    for (size_t k = 0; k < 3; k++)
        irregular->sorted[k] = (float *)(block + (4 + k) * room);
    if (points->count > 0)
        points_bounds(irregular);
    return irregular;
}

void irregular_free(struct irregular *irregular)
{
    if (!irregular)
        return;
    memory_free(irregular->cell);
    memory_free(irregular);
}

/* The side of the cube that a direction goes through: twice the axis, one more
 * if that is negative; and where on it, 0 to 2 half. */
INLINED lanes_mask lanes_side(const lanes p[3], float half, lanes *u, lanes *v)
{
    lanes x = lanes_abs(p[0]), y = lanes_abs(p[1]), z = lanes_abs(p[2]);
    lanes_mask is_x = (x >= y) & (x >= z), is_y = ~is_x & (y >= z);
    lanes depth = lanes_choose(is_x, p[0], lanes_choose(is_y, p[1], p[2]));
    lanes scale = half / lanes_abs(depth);
    *u = lanes_choose(is_x, p[1], p[0]) * scale + half;
    *v = lanes_choose(is_x | is_y, p[2], p[1]) * scale + half;
    return (is_y & 2) | (~is_x & ~is_y & 4) | ((depth < 0) & 1);
}

/* The cell of each point that faces the lamp. */
INLINED void sort_into_cells(const struct irregular_view *view)
{
    struct irregular *own = view->irregular;
    const struct irregular_points *points = own->points;
    float half = (float)own->edge / 2, last = (float)(own->edge - 1);
    int32_t edge = own->edge, none = (int32_t)own->cell_count;
    for (size_t i = 0; i < points->count; i += LANES) {
        lanes p[3], u, v, rise = { 0 };
        for (int k = 0; k < 3; k++) {
            p[k] = lanes_load(points->place[k] + i) - view->at[k];
            rise += p[k] * lanes_load(points->normal[k] + i);
        }
        lanes_mask side = lanes_side(p, half, &u, &v);
        lanes_mask column = lanes_whole(lanes_min(u, (lanes){ 0 } + last));
        lanes_mask row = lanes_whole(lanes_min(v, (lanes){ 0 } + last));
        lanes_mask cell = (side * edge + row) * edge + column;
        lanes_mask faces = rise < 0;
        cell = (faces & cell) | (~faces & none);
        memcpy(own->cell + i, &cell, sizeof cell);
    }
}

/* Counting sort. Cells of points that are not numbers are out of bounds. */
static void sort_points(const struct irregular_view *view)
{
    struct irregular *own = view->irregular;
    const struct irregular_points *points = own->points;
    uint32_t none = own->cell_count, sum = 0;
    memset(own->first, 0, (none + 2) * sizeof *own->first);
    for (size_t i = 0; i < points->count; i++) {
        own->cell[i] = own->cell[i] < none ? own->cell[i] : none;
        own->first[own->cell[i]]++;
    }
    for (uint32_t c = 0; c <= none; c++) {
        sum += own->first[c];
        own->first[c] = sum;
    }
    own->first[none] = own->first[none - 1];
    for (size_t i = points->count; i-- > 0;) {
        if (own->cell[i] == none)
            continue;
        uint32_t place = --own->first[own->cell[i]];
        own->number[place] = (uint32_t)i;
        for (int k = 0; k < 3; k++)
            own->sorted[k][place] = points->place[k][i] - view->at[k];
    }
    memset(own->hidden, 0, own->first[none] * sizeof *own->hidden);
    memset(own->doubt, 0, own->first[none] * sizeof *own->doubt);
}

INLINED void lanes_cross(const lanes a[3], const lanes b[3], lanes out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* Triangles seen edge on hide nothing, nor do those behind all points, as the
 * ground does: their fourth number is endless. Products of edges, which are
 * short, lose less to rounding than those of corners. */
INLINED void batch_planes(const struct irregular_view *view,
                          const lanes p[3][3], struct irregular_batch *batch)
{
    lanes plane[PLANES], edge[3][3];
    for (int k = 0; k < 3; k++)
        for (int axis = 0; axis < 3; axis++)
            edge[k][axis] = p[(k + 1) % 3][axis] - p[k][axis];
    for (int k = 0; k < 3; k++)
        lanes_cross(p[k], edge[k], plane + 3 * k);
    lanes_cross(edge[0], edge[1], plane + 9);
    lanes depth =
        plane[9] * p[0][0] + plane[10] * p[0][1] + plane[11] * p[0][2];
    lanes_mask sign = (lanes_mask)depth & (int32_t)0x80000000;
    lanes size = { 0 };
    for (int k = 0; k < 12; k++)
        plane[k] = (lanes)((lanes_mask)plane[k] ^ sign);
    for (int k = 9; k < 12; k++)
        size += lanes_abs(plane[k]);
    depth = lanes_abs(depth);
    plane[12] = depth + size * view->margin;
    lanes farthest = { 0 };
    for (int k = 0; k < 3; k++)
        farthest += lanes_max(plane[9 + k] * view->low[k],
                              plane[9 + k] * view->high[k]);
    plane[12] = lanes_choose((depth > 0) & (farthest >= plane[12]), plane[12],
                             (lanes){ 0 } + __builtin_inff());
    memcpy(batch->plane, plane, sizeof plane);
}

INLINED void batch_fill(const struct irregular_view *view,
                        const struct caster_triangles *triangles, size_t first,
                        struct irregular_batch *batch)
{
    const struct irregular *own = view->irregular;
    float half = (float)own->edge / 2, last = (float)(own->edge - 1);
    lanes p[3][3], u[3], v[3];
    lanes_mask side[3];
    for (int k = 0; k < 9; k++)
        p[k / 3][k % 3] =
            lanes_load(triangles->corner[k] + first) - view->at[k % 3];
    memcpy(batch->corner, p, sizeof p);
    batch_planes(view, (const lanes(*)[3])p, batch);
    for (int k = 0; k < 3; k++)
        side[k] = lanes_side(p[k], half, &u[k], &v[k]);
    lanes_mask same = (side[0] == side[1]) & (side[1] == side[2]);
    side[0] |= ~same;
    memcpy(batch->side, &side[0], sizeof side[0]);
    lanes zero = { 0 }, most = zero + last;
    for (int axis = 0; axis < 2; axis++) {
        const lanes *at = axis ? v : u;
        lanes low = lanes_min(at[0], lanes_min(at[1], at[2])) - CELL_SLACK;
        lanes high = lanes_max(at[0], lanes_max(at[1], at[2])) + CELL_SLACK;
        lanes_mask from = lanes_whole(lanes_max(low, zero));
        lanes_mask to = lanes_whole(lanes_min(high, most));
        memcpy(batch->low[axis], &from, sizeof from);
        memcpy(batch->high[axis], &to, sizeof to);
    }
}

/* Hides those points from `first` to before `end` that are behind the triangle.
 * Up to LANES - 1 that follow are asked too, which does no harm. */
INLINED void hide_run(const struct irregular *own, int32_t *hidden,
                      uint32_t first, uint32_t end, const float e[PLANES])
{
    const float *px = own->sorted[0], *py = own->sorted[1];
    const float *pz = own->sorted[2];
    for (uint32_t i = first; i < end; i += LANES) {
        lanes x = lanes_load(px + i), y = lanes_load(py + i);
        lanes z = lanes_load(pz + i);
        lanes_mask hides = (x * e[0] + y * e[1] + z * e[2] >= 0) &
                           (x * e[3] + y * e[4] + z * e[5] >= 0) &
                           (x * e[6] + y * e[7] + z * e[8] >= 0) &
                           (x * e[9] + y * e[10] + z * e[11] >= e[12]);
        *(lanes_mask *)(hidden + i) |= hides;
    }
}

INLINED void hide_box(const struct irregular *own, int32_t *hidden,
                      const struct cube_box *box, const float e[PLANES])
{
    size_t edge = (size_t)own->edge;
    const uint32_t *row =
        own->first + ((size_t)box->side * edge + (size_t)box->top) * edge;
    int left = box->left, end = box->right + 1;
    for (int y = box->top; y <= box->bottom; y++, row += edge)
        if (row[left] != row[end])
            hide_run(own, hidden, row[left], row[end], e);
}

/* A triangle that is on several sides of the cube. */
INLINED void hide_across(const struct irregular *own, int32_t *hidden,
                         const struct irregular_batch *batch, int lane,
                         const float e[PLANES])
{
    float triangle[3][3];
    for (int k = 0; k < 9; k++)
        triangle[k / 3][k % 3] = batch->corner[k][lane];
    for (int side = 0; side < CUBE_SIDES; side++) {
        struct cube_box box;
        if (cube_box_of(triangle, side, own->edge, &box))
            hide_box(own, hidden, &box, e);
    }
}

INLINED void hide_batch(const struct irregular *own, int32_t *hidden,
                        const struct irregular_batch *batch)
{
    for (int lane = 0; lane < LANES; lane++) {
        float e[PLANES];
        struct cube_box box = { batch->side[lane], batch->low[0][lane],
                                batch->low[1][lane], batch->high[0][lane],
                                batch->high[1][lane] };
        if (!(batch->plane[12][lane] < HUGE_VALF))
            continue;
        for (int k = 0; k < PLANES; k++)
            e[k] = batch->plane[k][lane];
        if (box.side >= 0)
            hide_box(own, hidden, &box, e);
        else
            hide_across(own, hidden, batch, lane, e);
    }
}

/* Sets *hidden of the points behind some of the triangles. */
INLINED void hide_behind(const struct irregular_view *view,
                         const struct caster_triangles *triangles,
                         int32_t *hidden)
{
    struct irregular_batch batch;
    for (size_t i = 0; i < triangles->count; i += LANES) {
        batch_fill(view, triangles, i, &batch);
        hide_batch(view->irregular, hidden, &batch);
    }
}

INLINED void view_look(const struct irregular_view *view)
{
    const struct irregular *own = view->irregular;
    sort_into_cells(view);
    sort_points(view);
    if (!view->shadows)
        return;
    hide_behind(view, &own->casters->certain, own->hidden);
    hide_behind(view, &own->casters->doubtful, own->doubt);
}

LANES_WIDE static void view_look_wide(const struct irregular_view *view)
{
    view_look(view);
}

static void view_look_plain(const struct irregular_view *view)
{
    view_look(view);
}

static void sight_fill(const struct irregular *own,
                       const struct irregular_sight *sight)
{
    size_t bytes = irregular_padded(own->points->count) / 8;
    memset(sight->lit, 0, bytes);
    memset(sight->doubt, 0, bytes);
    for (uint32_t i = 0; i < own->first[own->cell_count]; i++) {
        uint32_t word = own->number[i] / 64, bit = own->number[i] % 64;
        uint64_t seen = ~(uint32_t)own->hidden[i] & 1;
        sight->lit[word] |= seen << bit;
        sight->doubt[word] |= (seen & (uint32_t)own->doubt[i]) << bit;
    }
}

void irregular_look(struct irregular *irregular, vec3 location, bool shadows,
                    const struct irregular_sight *sight)
{
    const struct casters *casters = irregular->casters;
    vec3 at = vec3_sub(location, casters->centre);
    struct irregular_view view = {
        .irregular = irregular,
        .at = { (float)at.x, (float)at.y, (float)at.z },
        .margin = (float)irregular_margin(casters, location),
        .shadows = shadows,
    };
    for (int k = 0; k < 3; k++) {
        view.low[k] = irregular->low[k] - view.at[k];
        view.high[k] = irregular->high[k] - view.at[k];
    }
    if (lanes_are_wide())
        view_look_wide(&view);
    else
        view_look_plain(&view);
    sight_fill(irregular, sight);
}
