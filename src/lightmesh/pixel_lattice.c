/* Every second pixel: see pixel_lattice.h. */
#include "lightmesh/pixel_lattice.h"

#include "base/memory.h"
#include "base/parallel.h"

void pixel_lattice_describe(const struct pixel_lattice *lattice, int i, int j,
                            struct ray *ray, struct intersection *at)
{
    double place[2];
    first_hits_place(&lattice->hits, PIXEL_CELL * i, PIXEL_CELL * j, place);
    *ray = camera_ray(lattice->camera, place[0], place[1]);
    world_describe(ray, pixel_lattice_hit(lattice, i, j), at);
}

static void place_row(void *context, size_t row, unsigned thread)
{
    struct pixel_lattice *lattice = context;
    int j = lattice->top + (int)row;
    (void)thread;
    for (int i = lattice->left; i < lattice->left + lattice->columns; i++) {
        struct intersection at;
        struct ray ray;
        if (!pixel_lattice_hit(lattice, i, j)->leaf)
            continue;
        pixel_lattice_describe(lattice, i, j, &ray, &at);
        double facing = vec3_dot(ray.direction, at.face) < 0 ? 1 : -1;
        lattice->points[pixel_lattice_at(lattice, i, j)] =
            (struct pixel_point){ at.point, at.face, facing };
    }
}

/* From the first even pixel that there is to the last, in cells. */
static void cells_between(int first, int count, int *from, int *cells)
{
    int end = floor_to(first + count - 1, PIXEL_CELL) / PIXEL_CELL;
    *from = floor_to(first + PIXEL_CELL - 1, PIXEL_CELL) / PIXEL_CELL;
    *cells = end - *from + 1;
}

void pixel_lattice_start(struct pixel_lattice *lattice,
                         const struct camera *camera,
                         const struct first_hits *hits, const atomic_int *stop,
                         unsigned threads)
{
    *lattice = (struct pixel_lattice){ .camera = camera, .hits = *hits };
    cells_between(hits->left, hits->columns, &lattice->left, &lattice->columns);
    cells_between(hits->top, hits->rows, &lattice->top, &lattice->rows);
    lattice->points =
        memory_new(pixel_lattice_size(lattice) * sizeof *lattice->points);
    parallel_run(threads, (size_t)lattice->rows, stop, place_row, lattice);
}

void pixel_lattice_end(struct pixel_lattice *lattice)
{
    memory_free(lattice->points);
}
