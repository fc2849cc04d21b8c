/* Every second pixel of the picture, both ways, with what the camera sees there
 * first. A cell of the lattice is as many pixels wide; points and cells have
 * whole numbers i, j, which may be negative beyond the picture. */
#ifndef LIGHTMESH_PIXEL_LATTICE_H
#define LIGHTMESH_PIXEL_LATTICE_H

#include <stdatomic.h>

#include "scene/camera.h"
#include "shade/first_hits.h"

enum { PIXEL_CELL = 2 }; /* pixels */

/* Where a point is in the world, and the true normal, outward, and 1 if it is
 * turned to the camera, else -1. */
struct pixel_point {
    vec3 place, normal;
    double facing;
};

struct pixel_lattice {
    const struct camera *camera;
    struct first_hits hits;
    int left, top; /* cells */
    int columns, rows;
    struct pixel_point *points;
};

/* All pixels with even coordinates; the camera and hits->at must outlive it.
 * Points that see nothing have no place, and none has once `stop` is set.
 * End with pixel_lattice_end. */
void pixel_lattice_start(struct pixel_lattice *lattice,
                         const struct camera *camera,
                         const struct first_hits *hits, const atomic_int *stop,
                         unsigned threads);
void pixel_lattice_end(struct pixel_lattice *lattice);

/* x, or less: a multiple of `step`. */
static inline int floor_to(int x, int step)
{
    return x - ((x % step) + step) % step;
}

static inline bool pixel_lattice_has(const struct pixel_lattice *lattice, int i,
                                     int j)
{
    return i >= lattice->left && j >= lattice->top &&
           i < lattice->left + lattice->columns &&
           j < lattice->top + lattice->rows;
}

/* The number of a point that it has. */
static inline size_t pixel_lattice_at(const struct pixel_lattice *lattice,
                                      int i, int j)
{
    return (size_t)(j - lattice->top) * (size_t)lattice->columns +
           (size_t)(i - lattice->left);
}

static inline size_t pixel_lattice_size(const struct pixel_lattice *lattice)
{
    return (size_t)lattice->columns * (size_t)lattice->rows;
}

static inline const struct world_hit *
pixel_lattice_hit(const struct pixel_lattice *lattice, int i, int j)
{
    return first_hits_at(&lattice->hits, PIXEL_CELL * i, PIXEL_CELL * j);
}

/* What is seen there, which is something. */
void pixel_lattice_describe(const struct pixel_lattice *lattice, int i, int j,
                            struct ray *ray, struct intersection *at);

#endif
