/* Areas by lines: a surface with unit normal n is crossed by |n_k| lines along
 * axis k for each square of side h, if the lines are h apart; so crossings that
 * weigh h^2 |n_k| sum to the area times n_x^2 + n_y^2 + n_z^2 = 1 (Cauchy and
 * Crofton's formula with three directions, in which the normals make up for
 * the others). The lines cross the true geometry: areas are not those of
 * voxels, which are larger around bodies and smaller within rooms. */
#include "skeleton/wall.h"

#include "base/memory.h"
#include "base/parallel.h"
#include "base/random.h"
#include "shade/surface.h"
#include "skeleton/matter.h"

enum {
    CROSSINGS = 4096,    /* of a line, at most */
    ENOUGH = 500 * 1000, /* crossings in all; if more, fewer lines do */
    NEAR = 3,            /* voxels from a wall to where the void may begin */
    STRIDE_MAX = 4
};

/* The points of one row of lines. */
struct row {
    struct wall_point *points;
    size_t count, capacity;
    size_t crossings;
};

struct wall_work {
    const struct world *world;
    const struct voxels *voxels;
    const uint8_t *marks;
    struct row *rows;
    int stride;   /* voxels from line to line */
    int first[4]; /* rows along axis k are first[k] .. first[k + 1] - 1 */
};

/* One line of voxels, and the line through them. */
struct line {
    const struct wall_work *work;
    struct row *row;
    int axis;
    int at[3];
    struct ray ray;
    double length;
};

static void row_add(struct row *row, const struct wall_point *point)
{
    if (row->count == row->capacity) {
        row->capacity = 2 * row->capacity + 64;
        row->points =
            memory_resize(row->points, row->capacity * sizeof *row->points);
    }
    row->points[row->count++] = *point;
}

bool wall_stops(const uint8_t *marks, const struct intersection *at)
{
    if (at->texture == at->leaf->look->texture)
        return marks[at->leaf->number] != 0;
    return !at->leaf->look->no_shadow &&
           rgb_brightness(surface_transmittance(at)) <= 0.5;
}

/* The first empty voxel whose middle is in the gap from t to `end`, in which
 * there is nothing; VOXEL_NONE if it is not near. */
static size_t empty_along(const struct line *line, double t, double end)
{
    const struct voxels *v = line->work->voxels;
    int at[3] = { line->at[0], line->at[1], line->at[2] };
    int step = end > t ? 1 : -1, from = (int)(t / v->edge);
    for (int i = 0; i <= NEAR; i++) {
        at[line->axis] = from + i * step;
        double middle = (at[line->axis] + 0.5) * v->edge;
        if ((middle - t) * step < 0)
            continue;
        if ((end - middle) * step < 0 || !voxels_holds(v, at))
            break;
        size_t index = voxels_index(v, at[0], at[1], at[2]);
        if (v->empty[index])
            return index;
    }
    return VOXEL_NONE;
}

/* In corners lines run within the voxels of another wall: the void is beside
 * them, if nothing is between. */
static size_t empty_beside(const struct line *line,
                           const struct intersection *at, double end)
{
    const struct wall_work *work = line->work;
    double gap = end - at->t, near = 0.25 * work->voxels->edge;
    double t = at->t + copysign(fmin(near, fabs(gap) / 2), gap);
    vec3 from = ray_point(&line->ray, t), normal = at->normal;
    if (vec3_component(normal, line->axis) * gap < 0)
        normal = vec3_negate(normal);
    size_t index = voxels_empty_beside(work->voxels, from, normal);
    if (index == VOXEL_NONE)
        return index;
    int place[3];
    voxels_place(work->voxels, index, place);
    vec3 to = voxels_centre(work->voxels, place);
    return matter_hides(work->world, work->marks, from, to) ? VOXEL_NONE
                                                            : index;
}

/* The side of a crossing that faces the gap up to `end`. */
static void measure_side(const struct line *line, const struct intersection *at,
                         double end)
{
    size_t voxel = empty_along(line, at->t, end);
    vec3 direction = line->ray.direction;
    if (voxel == VOXEL_NONE)
        voxel = empty_beside(line, at, end);
    if (voxel == VOXEL_NONE)
        return;
    double apart = line->work->voxels->edge * line->work->stride;
    struct wall_point point = {
        .voxel = voxel,
        .area = apart * apart * fabs(vec3_component(at->normal, line->axis)),
        .direction = end > at->t ? vec3_negate(direction) : direction,
        .at = *at
    };
    row_add(line->row, &point);
}

/* All gaps of the line between crossings with walls. */
static void measure_line(const struct line *line)
{
    const struct wall_work *work = line->work;
    struct intersection before, at;
    double offset = 1e-5 * work->voxels->edge, tmin = 0;
    bool begun = false;
    for (int i = 0; i < CROSSINGS; i++) {
        if (!world_closest(work->world, &line->ray, tmin, RAY_GATHER, &at) ||
            at.t >= line->length)
            break;
        tmin = at.t + offset;
        line->row->crossings++;
        if (!wall_stops(work->marks, &at))
            continue;
        if (begun)
            measure_side(line, &before, at.t);
        measure_side(line, &at, begun ? before.t : 0);
        before = at;
        begun = true;
    }
    if (begun)
        measure_side(line, &before, line->length);
}

/* The line through a place across its axis, in voxels. */
static void line_begin(struct line *line, double across, double along_row)
{
    const struct voxels *v = line->work->voxels;
    int k = line->axis, a = (k + 1) % 3, b = (k + 2) % 3;
    double place[3], direction[3] = { 0 };
    direction[k] = 1;
    place[k] = 0;
    place[a] = across;
    place[b] = along_row;
    line->at[a] = (int)across;
    line->at[b] = (int)along_row;
    line->length = v->size[k] * v->edge;
    line->ray.direction = vec3_make(direction[0], direction[1], direction[2]);
    vec3 offset = { place[0], place[1], place[2] };
    line->ray.origin = vec3_along(v->origin, offset, v->edge);
}

/* The lines of a row, each somewhere within its own square. */
static void measure_row(void *context, size_t number, unsigned thread)
{
    const struct wall_work *work = context;
    const struct voxels *v = work->voxels;
    struct line line = { .work = work, .row = &work->rows[number] };
    (void)thread;
    while ((int)number >= work->first[line.axis + 1])
        line.axis++;
    int a = (line.axis + 1) % 3, b = (line.axis + 2) % 3;
    int row = (int)number - work->first[line.axis];
    for (int i = 0; i * work->stride < v->size[a]; i++) {
        uint64_t key = random_key(number, (uint64_t)i);
        double across = (i + random_unit(key)) * work->stride;
        double along = (row + random_unit(key + 1)) * work->stride;
        if (across >= v->size[a] || along >= v->size[b])
            continue;
        line_begin(&line, across, along);
        measure_line(&line);
    }
}

/* All lines so many voxels apart; the number of crossings. */
static size_t measure(struct wall_work *work, int stride, unsigned threads,
                      const atomic_int *stop)
{
    size_t crossings = 0;
    work->stride = stride;
    for (int k = 0; k < 3; k++)
        work->first[k + 1] =
            work->first[k] +
            (work->voxels->size[(k + 2) % 3] + stride - 1) / stride;
    size_t rows = (size_t)work->first[3];
    work->rows = memory_new(rows * sizeof *work->rows);
    parallel_run(threads, rows, stop, measure_row, work);
    for (size_t i = 0; i < rows; i++)
        crossings += work->rows[i].crossings;
    return crossings;
}

static void rows_free(struct wall_work *work)
{
    for (size_t i = 0; i < (size_t)work->first[3]; i++)
        memory_free(work->rows[i].points);
    memory_free(work->rows);
}

/* The points of all rows, in their order. */
static struct wall_point *gather(const struct wall_work *work, size_t *count)
{
    size_t rows = (size_t)work->first[3], n = 0;
    *count = 0;
    for (size_t i = 0; i < rows; i++)
        *count += work->rows[i].count;
    struct wall_point *all = memory_new(*count * sizeof *all);
    for (size_t i = 0; i < rows; i++)
        for (size_t k = 0; k < work->rows[i].count; k++)
            all[n++] = work->rows[i].points[k];
    return all;
}

/* A few lines tell how many may be sent. */
struct wall_point *wall_points(const struct world *world,
                               const struct voxels *v, unsigned threads,
                               const atomic_int *stop, size_t *count)
{
    struct arena *arena = arena_new(0);
    struct wall_work work = { .world = world, .voxels = v };
    work.marks = matter_marks(world, voxels_box(v), arena);
    int stride = STRIDE_MAX;
    size_t crossings = measure(&work, stride, threads, stop);
    while (stride > 1 && crossings * 4 <= ENOUGH) {
        stride /= 2;
        crossings *= 4;
    }
    if (stride < STRIDE_MAX) {
        rows_free(&work);
        measure(&work, stride, threads, stop);
    }
    struct wall_point *points = gather(&work, count);
    rows_free(&work);
    arena_free(arena);
    return points;
}
