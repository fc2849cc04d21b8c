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
#include "shade/finish.h"
#include "skeleton/matter.h"

enum {
    CROSSINGS = 4096, /* of a line, at most */
    NEAR = 3          /* voxels from a wall to where the void may begin */
};

struct sample {
    size_t voxel;
    float area;
    float albedo[3], emission[3];
};

/* The samples of one row of lines. */
struct row {
    struct sample *samples;
    size_t count, capacity;
};

struct wall_work {
    const struct world *world;
    const struct voxels *voxels;
    const uint8_t *marks;
    struct row *rows;
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

static void row_add(struct row *row, const struct sample *sample)
{
    if (row->count == row->capacity) {
        row->capacity = 2 * row->capacity + 64;
        row->samples =
            memory_resize(row->samples, row->capacity * sizeof *row->samples);
    }
    row->samples[row->count++] = *sample;
}

static bool is_wall(const struct wall_work *work, const struct intersection *at)
{
    if (at->texture == at->leaf->texture)
        return work->marks[at->leaf->number] != 0;
    return !at->leaf->no_shadow &&
           rgb_brightness(surface_transmittance(at)) <= 0.5;
}

/* The light that the surface gives back of, and besides, `irradiance`. */
static rgb surface_glow(const struct surface *surface, rgb irradiance)
{
    rgb sum = rgb_grey(0);
    for (int i = 0; i < surface->count; i++) {
        const struct surface_layer *layer = &surface->layer[i];
        rgb glow = finish_glow(layer, rgb_grey(0), irradiance);
        sum = rgb_add(sum, rgb_mul(layer->weight, glow));
    }
    return sum;
}

/* The side of a crossing that faces against `direction`, seen by the voxel. */
static void add_side(const struct line *line, const struct intersection *at,
                     vec3 direction, size_t voxel)
{
    struct surface surface;
    struct surface_view view = { .direction = direction,
                                 .ior = 1,
                                 .quality = QUALITY_FOG };
    surface_fill(&surface, at, &view);
    rgb emission = surface_glow(&surface, rgb_grey(0));
    rgb albedo = rgb_sub(surface_glow(&surface, rgb_grey(1)), emission);
    double edge = line->work->voxels->edge;
    double area = edge * edge * fabs(vec3_component(at->normal, line->axis));
    struct sample sample = {
        voxel,
        (float)area,
        { (float)albedo.r, (float)albedo.g, (float)albedo.b },
        { (float)emission.r, (float)emission.g, (float)emission.b }
    };
    row_add(line->row, &sample);
}

/* The first empty voxel from place t on, towards the other end of a gap in
 * which there is nothing; VOXEL_NONE if it is not near. */
static size_t empty_along(const struct line *line, double t, double end)
{
    const struct voxels *v = line->work->voxels;
    int at[3] = { line->at[0], line->at[1], line->at[2] };
    int last = v->size[line->axis] - 1, step = end > t ? 1 : -1;
    int from = (int)(t / v->edge), to = (int)(end / v->edge);
    to = to < 0 ? 0 : to > last ? last : to;
    for (int i = from, n = 0; n <= NEAR; i += step, n++) {
        if (i >= 0 && i <= last) {
            at[line->axis] = i;
            size_t index = voxels_index(v, at[0], at[1], at[2]);
            if (v->empty[index])
                return index;
        }
        if (i == to)
            break;
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
    if (voxel != VOXEL_NONE)
        add_side(line, at, end > at->t ? vec3_negate(direction) : direction,
                 voxel);
}

/* All gaps of the line between crossings with walls. */
static void measure_line(const struct line *line)
{
    const struct wall_work *work = line->work;
    struct intersection before, at;
    double offset = 1e-5 * work->voxels->edge, tmin = 0;
    bool begun = false;
    for (int i = 0; i < CROSSINGS; i++) {
        if (!world_closest(work->world, &line->ray, tmin, RAY_REFLECTION,
                           &at) ||
            at.t >= line->length)
            break;
        tmin = at.t + offset;
        if (!is_wall(work, &at))
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

/* The lines of a row, each somewhere within its own voxels. */
static void measure_row(void *context, size_t number, unsigned thread)
{
    const struct wall_work *work = context;
    const struct voxels *v = work->voxels;
    struct line line = { .work = work, .row = &work->rows[number] };
    (void)thread;
    while ((int)number >= work->first[line.axis + 1])
        line.axis++;
    int k = line.axis, a = (k + 1) % 3, b = (k + 2) % 3;
    line.at[b] = (int)number - work->first[k];
    line.length = v->size[k] * v->edge;
    for (line.at[a] = 0; line.at[a] < v->size[a]; line.at[a]++) {
        uint64_t key = random_key(number, (uint64_t)line.at[a]);
        double place[3], direction[3] = { 0 };
        direction[k] = 1;
        place[k] = 0;
        place[a] = (line.at[a] + random_unit(key)) * v->edge;
        place[b] = (line.at[b] + random_unit(key + 1)) * v->edge;
        line.ray.direction =
            vec3_make(direction[0], direction[1], direction[2]);
        line.ray.origin =
            vec3_add(v->origin, vec3_make(place[0], place[1], place[2]));
        measure_line(&line);
    }
}

static rgb rgb_from(const float *c)
{
    return rgb_make((double)c[0], (double)c[1], (double)c[2]);
}

static void wall_add(struct wall *wall, const struct sample *sample)
{
    double area = (double)sample->area;
    wall->area += area;
    wall->albedo = rgb_add_scaled(wall->albedo, rgb_from(sample->albedo), area);
    wall->emission =
        rgb_add_scaled(wall->emission, rgb_from(sample->emission), area);
}

/* The samples of each voxel together, in the order of rows. */
static struct wall *walls_gather(const struct wall_work *work, size_t *count)
{
    size_t voxels = voxels_count(work->voxels), rows = (size_t)work->first[3];
    uint32_t *number = memory_new(voxels * sizeof *number);
    *count = 0;
    for (size_t i = 0; i < rows; i++)
        for (size_t k = 0; k < work->rows[i].count; k++)
            number[work->rows[i].samples[k].voxel] = 1;
    for (size_t i = 0; i < voxels; i++)
        if (number[i])
            number[i] = (uint32_t)(*count)++;
    struct wall *walls = memory_new(*count * sizeof *walls);
    for (size_t i = 0; i < rows; i++)
        for (size_t k = 0; k < work->rows[i].count; k++) {
            const struct sample *sample = &work->rows[i].samples[k];
            struct wall *wall = &walls[number[sample->voxel]];
            wall->voxel = sample->voxel;
            wall_add(wall, sample);
        }
    for (size_t i = 0; i < *count; i++) {
        double share = walls[i].area > 0 ? 1 / walls[i].area : 0;
        walls[i].albedo = rgb_scale(walls[i].albedo, share);
        walls[i].emission = rgb_scale(walls[i].emission, share);
    }
    memory_free(number);
    return walls;
}

struct wall *walls_measure(const struct world *world, const struct voxels *v,
                           const uint8_t *marks, unsigned threads,
                           size_t *count)
{
    struct wall_work work = { world, v, marks, NULL, { 0 } };
    for (int k = 0; k < 3; k++)
        work.first[k + 1] = work.first[k] + v->size[(k + 2) % 3];
    size_t rows = (size_t)work.first[3];
    work.rows = memory_new(rows * sizeof *work.rows);
    parallel_run(threads, rows, NULL, measure_row, &work);
    struct wall *walls = walls_gather(&work, count);
    for (size_t i = 0; i < rows; i++)
        memory_free(work.rows[i].samples);
    memory_free(work.rows);
    return walls;
}
