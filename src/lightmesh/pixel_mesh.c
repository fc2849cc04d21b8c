/* Mesh points of a picture: see pixel_mesh.h. */
#include "lightmesh/pixel_mesh.h"

#include <string.h>

#include "base/memory.h"
#include "base/parallel.h"
#include "lightmesh/stagger.h"
#include "lightmesh/tuning.h"
#include "scene/camera.h"

/* Those that are asked for one place, at most. */
enum { ASKED_MOST = (2 * STAGGER_REACH + 1) * (2 * STAGGER_REACH + 1) };

_Static_assert(STAGGER_DEPTH *STAGGER_REACH + STAGGER_REACH + 2 <=
                   FIRST_HITS_APRON,
               "what decides a point, and then a place");

/* Nearer points, in pixels, count no more. */
static const double same_place = 1e-6;

struct pixel_mesh {
    struct pixel_mesh_options options;
    struct stagger *stagger;
    struct first_hits hits;
    int level;         /* that is being chosen */
    int32_t *number;   /* by place: of its point; -1: it is none */
    size_t *row_first; /* by row: number of its first point */
    struct irregular_points points;
    float *room;                   /* for them */
    struct facet_light *light;     /* of points, or NULL, and else: */
    uint64_t *lit;                 /* by lamp: a bit for each point */
    struct worker *const *workers; /* while it is made */
    unsigned threads;
};

static bool grid_has(const struct first_hits *hits, int x, int y)
{
    return x >= hits->left && y >= hits->top &&
           x < hits->left + hits->columns && y < hits->top + hits->rows;
}

static int32_t *number_at(const struct pixel_mesh *mesh, int x, int y)
{
    const struct first_hits *hits = &mesh->hits;
    return &mesh->number[(size_t)(y - hits->top) * (size_t)hits->columns +
                         (size_t)(x - hits->left)];
}

/* Whether the pixel at (x, y) is a point, of an earlier level than that being
 * chosen, and on the same surface as the hit. */
static bool pixel_serves(const struct pixel_mesh *mesh, int x, int y,
                         const struct world_hit *hit)
{
    return grid_has(&mesh->hits, x, y) &&
           stagger_level(mesh->stagger, x, y) < mesh->level &&
           *number_at(mesh, x, y) >= 0 &&
           first_hit_is_on(first_hits_at(&mesh->hits, x, y), hit->leaf,
                           hit->hit.part);
}

static bool pixel_is_served(const struct pixel_mesh *mesh, int x, int y)
{
    const struct world_hit *hit = first_hits_at(&mesh->hits, x, y);
    const struct servers *first = stagger_servers(mesh->stagger, x, y);
    int reach = mesh->level > 1 ? mesh->stagger->reach : -1;
    for (int i = 0; mesh->level > 0 && i < first->count; i++)
        if (pixel_serves(mesh, x + first->at[i].across, y + first->at[i].down,
                         hit))
            return true;
    for (int down = -reach; down <= reach; down++)
        for (int across = -reach; across <= reach; across++)
            if (pixel_serves(mesh, x + across, y + down, hit))
                return true;
    return false;
}

/* Those of the level that no earlier one serves become points. */
static void choose_row(void *context, size_t row, unsigned thread)
{
    struct pixel_mesh *mesh = context;
    const struct first_hits *hits = &mesh->hits;
    int y = hits->top + (int)row;
    (void)thread;
    int x = stagger_first(mesh->stagger, mesh->level, hits->left, y);
    int step = stagger_step(mesh->stagger, mesh->level);
    for (; x < hits->left + hits->columns; x += step) {
        const struct world_hit *hit = first_hits_at(hits, x, y);
        if (hit->leaf && !first_hit_is_clear(hit) &&
            !pixel_is_served(mesh, x, y))
            *number_at(mesh, x, y) = 0;
    }
}

/* Level by level, so that what a pixel is depends on few others near it. */
static void points_choose(struct pixel_mesh *mesh)
{
    size_t rows = (size_t)mesh->hits.rows;
    size_t columns = (size_t)mesh->hits.columns;
    const atomic_int *stop = mesh->workers[0]->stop;
    mesh->number = memory_new(rows * columns * sizeof *mesh->number);
    mesh->row_first = memory_new(rows * sizeof *mesh->row_first);
    memset(mesh->number, -1, rows * columns * sizeof *mesh->number);
    for (mesh->level = 0; mesh->level <= mesh->stagger->depth; mesh->level++)
        parallel_run(mesh->threads, rows, stop, choose_row, mesh);
    for (size_t row = 0; row < rows; row++) {
        int32_t *number = mesh->number + row * columns;
        mesh->row_first[row] = mesh->points.count;
        for (size_t i = 0; i < columns; i++)
            mesh->points.count += number[i] >= 0;
    }
}

static void point_fill(struct pixel_mesh *mesh, size_t number, int x, int y)
{
    const struct casters *casters = mesh->options.casters;
    double place[2];
    struct intersection at;
    first_hits_place(&mesh->hits, x, y, place);
    struct ray ray = camera_ray(mesh->options.camera, place[0], place[1]);
    world_describe(&ray, first_hits_at(&mesh->hits, x, y), &at);
    vec3 side = vec3_against(at.face, ray.direction);
    vec3 from = vec3_sub(at.point, casters->centre);
    const double coordinate[3] = { from.x, from.y, from.z };
    const double normal[3] = { side.x, side.y, side.z };
    for (int k = 0; k < 3; k++) {
        mesh->points.place[k][number] = (float)coordinate[k];
        mesh->points.normal[k][number] = (float)normal[k];
    }
}

static void fill_row(void *context, size_t row, unsigned thread)
{
    struct pixel_mesh *mesh = context;
    const struct first_hits *hits = &mesh->hits;
    size_t next = mesh->row_first[row];
    int y = hits->top + (int)row;
    (void)thread;
    for (int x = hits->left; x < hits->left + hits->columns; x++) {
        int32_t *number = number_at(mesh, x, y);
        if (*number < 0)
            continue;
        point_fill(mesh, next, x, y);
        *number = (int32_t)next++;
    }
}

static void points_make(struct pixel_mesh *mesh)
{
    size_t rows = (size_t)mesh->hits.rows;
    const atomic_int *stop = mesh->workers[0]->stop;
    points_choose(mesh);
    size_t padded = irregular_padded(mesh->points.count);
    mesh->room = memory_new(6 * padded * sizeof(float));
    for (size_t k = 0; k < 3; k++) {
        mesh->points.place[k] = mesh->room + k * padded;
        mesh->points.normal[k] = mesh->room + (3 + k) * padded;
    }
    parallel_run(mesh->threads, rows, stop, fill_row, mesh);
}

/* What all lamps give them. */
static void points_ask(struct pixel_mesh *mesh)
{
    struct lamp_sights_options sights = {
        .casters = mesh->options.casters,
        .lamps = mesh->options.lamps,
        .takes = mesh->options.takes,
        .points = &mesh->points,
        .workers = mesh->workers,
        .threads = mesh->threads,
    };
    size_t padded = irregular_padded(mesh->points.count);
    mesh->lit = memory_new(mesh->options.lamps->count * padded / 8);
    lamp_sights_look(&sights, mesh->lit);
    if (mesh->options.each)
        return;
    mesh->light = memory_new(padded * sizeof *mesh->light);
    lamp_sights_sum(&sights, mesh->lit, mesh->light);
    memory_free(mesh->lit);
    mesh->lit = NULL;
}

struct pixel_mesh *pixel_mesh_new(const struct pixel_mesh_options *options,
                                  const struct first_hits *hits,
                                  struct worker *const *workers,
                                  unsigned threads)
{
    struct pixel_mesh *mesh = memory_new(sizeof *mesh);
    mesh->options = *options;
    mesh->stagger = stagger_new(options->apart);
    mesh->hits = *hits;
    mesh->workers = workers;
    mesh->threads = threads;
    points_make(mesh);
    points_ask(mesh);
    return mesh;
}

void pixel_mesh_free(struct pixel_mesh *mesh)
{
    if (!mesh)
        return;
    stagger_free(mesh->stagger);
    memory_free(mesh->number);
    memory_free(mesh->row_first);
    memory_free(mesh->room);
    memory_free(mesh->light);
    memory_free(mesh->lit);
    memory_free(mesh);
}

/* A surface that the camera sees at a place of the grid, and points on it: how
 * far they are from there, in pixels, and what they count. */
struct seen_surface {
    double x, y;
    const struct intersection *at;
    vec3 side;
    int count;
    struct seen_point {
        int32_t number;
        double across, down, weight;
    } points[ASKED_MOST];
};

/* Takes the point at (i, j), if there is one on the same surface. It counts by
 * the inverse square of its distance. */
static void surface_ask(const struct pixel_mesh *mesh,
                        struct seen_surface *seen, int i, int j)
{
    if (!grid_has(&mesh->hits, i, j))
        return;
    int32_t number = *number_at(mesh, i, j);
    if (number < 0 || !first_hit_is_on(first_hits_at(&mesh->hits, i, j),
                                       seen->at->leaf, seen->at->part))
        return;
    vec3 normal = lamp_sights_normal(&mesh->points, (size_t)number);
    double cosine = vec3_dot(normal, seen->side);
    if (cosine < pixel_alike)
        return;
    double across = i - seen->x, down = j - seen->y;
    double square = across * across + down * down + same_place;
    seen->points[seen->count++] =
        (struct seen_point){ number, across, down,
                             cosine * cosine * cosine * cosine / square };
}

static double corner_share(const struct seen_point *a,
                           const struct seen_point *b)
{
    return fmax(a->across * b->down - a->down * b->across, 0);
}

/* Where all corners of the triangle are known they are all there is to know:
 * what changes evenly over the picture is met exactly. */
static bool surface_ask_triangle(const struct pixel_mesh *mesh,
                                 struct seen_surface *seen,
                                 const struct servers *first, int x, int y)
{
    struct seen_point *p = seen->points;
    for (int i = 0; i < 3 && i < first->count; i++)
        surface_ask(mesh, seen, x + first->at[i].across, y + first->at[i].down);
    if (seen->count < 3)
        return false;
    p[0].weight = corner_share(&p[1], &p[2]);
    p[1].weight = corner_share(&p[2], &p[0]);
    p[2].weight = corner_share(&p[0], &p[1]);
    return true;
}

/* Else points of the first level know more of what is around than others. */
static void surface_ask_all(const struct pixel_mesh *mesh,
                            struct seen_surface *seen)
{
    int x = (int)floor(seen->x + 0.5), y = (int)floor(seen->y + 0.5);
    const struct servers *first = stagger_servers(mesh->stagger, x, y);
    int reach = mesh->stagger->reach;
    if (surface_ask_triangle(mesh, seen, first, x, y))
        return;
    for (int i = 3; i < first->count; i++)
        surface_ask(mesh, seen, x + first->at[i].across, y + first->at[i].down);
    for (int down = -reach; seen->count == 0 && down <= reach; down++)
        for (int across = -reach; across <= reach; across++)
            surface_ask(mesh, seen, x + across, y + down);
}

static bool surface_blend(const struct pixel_mesh *mesh,
                          struct seen_surface *seen, struct facet_light *light)
{
    double sum = 0;
    surface_ask_all(mesh, seen);
    for (int i = 0; i < seen->count; i++)
        sum += seen->points[i].weight;
    if (!(sum > 0))
        return false;
    *light = (struct facet_light){ { 0 }, { 0 }, { 0 } };
    for (int i = 0; i < seen->count; i++)
        facet_light_mix(light, &mesh->light[seen->points[i].number],
                        seen->points[i].weight / sum);
    return true;
}

/* The point at this very place of the grid; -1: there is none. */
static int32_t point_at(const struct pixel_mesh *mesh,
                        const struct picture_place *place)
{
    double x = floor(place->grid[0]), y = floor(place->grid[1]);
    bool there = place->grid[0] == x && place->grid[1] == y &&
                 grid_has(&mesh->hits, (int)x, (int)y);
    return there ? *number_at(mesh, (int)x, (int)y) : -1;
}

bool pixel_mesh_light(const struct pixel_mesh *mesh,
                      const struct receiver *receiver,
                      struct facet_light *light)
{
    struct seen_surface seen;
    int32_t own = point_at(mesh, receiver->pixel);
    if (own >= 0) {
        *light = mesh->light[own];
        return true;
    }
    seen.x = receiver->pixel->grid[0];
    seen.y = receiver->pixel->grid[1];
    seen.at = receiver->at;
    seen.side = receiver->side;
    seen.count = 0;
    return surface_blend(mesh, &seen, light);
}

bool pixel_mesh_sees(const struct pixel_mesh *mesh,
                     const struct picture_place *place, const struct lamp *lamp,
                     bool *shines)
{
    int32_t own = point_at(mesh, place);
    if (own < 0 || !mesh->options.takes[lamp->number])
        return false;
    size_t words = irregular_padded(mesh->points.count) / 64;
    size_t word = (size_t)lamp->number * words + (size_t)own / 64;
    *shines = mesh->lit[word] >> (own % 64) & 1;
    return true;
}

size_t pixel_mesh_count(const struct pixel_mesh *mesh)
{
    return mesh->points.count;
}

size_t pixel_mesh_bytes(const struct pixel_mesh *mesh)
{
    size_t points = irregular_padded(mesh->points.count);
    size_t places = (size_t)mesh->hits.rows * (size_t)mesh->hits.columns;
    return points * (6 * sizeof(float) + sizeof *mesh->light) +
           places * sizeof *mesh->number +
           mesh->options.lamps->count * points / 8;
}

void pixel_mesh_each(const struct pixel_mesh *mesh, pixel_mesh_visit *visit,
                     void *context)
{
    for (size_t i = 0; i < mesh->points.count; i++)
        visit(context,
              lamp_sights_place(mesh->options.casters, &mesh->points, i),
              &mesh->light[i]);
}
