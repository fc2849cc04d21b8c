/* The grid of an area light: see area.h. */
#include "shade/area.h"

#include <string.h>

#include "base/random.h"

/* How far POV-Ray's round grids are off, in sides (measured). */
static const double area_shift = 0.001;

static uint64_t bits_of(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

/* Axes perpendicular to the view of the point: one level with z, the other
 * upright on both, each as long as the light's first. */
static void area_orient(struct area_grid *grid, vec3 point)
{
    vec3 view = vec3_normalise(vec3_sub(point, grid->light->location));
    double length = vec3_length(grid->axis1);
    vec3 across = vec3_normalise(vec3_make(view.y, -view.x, 0));
    if (vec3_dot(across, across) == 0)
        across = vec3_make(1, 0, 0);
    grid->axis1 = vec3_scale(across, length);
    grid->axis2 = vec3_scale(vec3_cross(view, across), length);
}

/* Half a side, in units of the axis. */
static double side_reach(const struct area_grid *grid, int size)
{
    double step = size > 1 ? 1.0 / (size - 1) : 0;
    return (size > 1 ? 0.5 : 0) + area_shift + (grid->key ? step / 2 : 0);
}

/* From units of the axes to those of the hull. */
static void area_scale(struct area_grid *grid)
{
    grid->scale[0] = 1 / side_reach(grid, grid->size1);
    grid->scale[1] = 1 / side_reach(grid, grid->size2);
}

struct area_grid area_grid_new(const struct lamp *lamp, vec3 point,
                               uint64_t seed)
{
    const struct light *light = lamp->light;
    struct area_grid grid = {
        .light = light,
        .axis1 = light->axis1,
        .axis2 = light->axis2,
        .size1 = light->size1,
        .size2 = light->size2,
        .adaptive = light->adaptive,
    };
    if (light->orient)
        area_orient(&grid, point);
    if (light->jitter) {
        uint64_t key = random_key(seed, (uint64_t)lamp->number);
        key = random_key(key, bits_of(point.x));
        key = random_key(key, bits_of(point.y));
        grid.key = random_key(key, bits_of(point.z)) | 1;
    }
    area_scale(&grid);
    return grid;
}

void area_grid_refine(struct area_grid *grid)
{
    grid->size1 = grid->size1 > 1 ? AREA_FINE + 1 : 1;
    grid->size2 = grid->size2 > 1 ? AREA_FINE + 1 : 1;
    grid->key = 0;
    area_scale(grid);
}

/* The square [-1/2,1/2]^2 pressed into the disc in it along the radii, moved
 * a little, which keeps the middle from dividing by zero (POV-Ray's way). */
static void area_round(double *u, double *v)
{
    *u += area_shift;
    *v += area_shift;
    double length = sqrt(*u * *u + *v * *v);
    double scale = length > 0 ? fmax(fabs(*u), fabs(*v)) / length : 1;
    *u *= scale;
    *v *= scale;
}

/* A point of the grid in units of the axes, from the middle. */
static void area_grid_place(const struct area_grid *grid, int i, int j,
                            double *u, double *v)
{
    const struct light *light = grid->light;
    double x = i, y = j;
    if (grid->key) {
        uint64_t key = random_key(grid->key, (uint64_t)i);
        key = random_key(key, (uint64_t)j);
        x += random_unit(key) - 0.5;
        y += random_unit(key + 1) - 0.5;
    }
    *u = grid->size1 > 1 ? x / (grid->size1 - 1) - 0.5 : 0;
    *v = grid->size2 > 1 ? y / (grid->size2 - 1) - 0.5 : 0;
    if (light->circular ||
        (light->orient && light->size1 > 1 && light->size2 > 1))
        area_round(u, v);
}

void area_grid_hull(const struct area_grid *grid, vec3 half[2])
{
    half[0] = vec3_scale(grid->axis1, 1 / grid->scale[0]);
    half[1] = vec3_scale(grid->axis2, 1 / grid->scale[1]);
}

struct area_point area_grid_at(const struct area_grid *grid, int i, int j)
{
    double u, v;
    area_grid_place(grid, i, j, &u, &v);
    return (struct area_point){
        .location = vec3_along(
            vec3_along(grid->light->location, grid->axis1, u), grid->axis2, v),
        .place = { u * grid->scale[0], v * grid->scale[1] },
    };
}

vec3 area_grid_point(const struct area_grid *grid, int i, int j)
{
    return area_grid_at(grid, i, j).location;
}
