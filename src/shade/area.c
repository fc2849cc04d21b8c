/* The grid of an area light: see area.h. */
#include "shade/area.h"

#include <string.h>

#include "base/random.h"
#include "base/warp.h"

/* How far POV-Ray's round grids are off, in sides (measured). */
static const double area_shift = 0.001;

static inline uint64_t bits_of(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

static inline double of_bits(uint64_t bits)
{
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
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
static inline void area_round(double *u, double *v)
{
    *u += area_shift;
    *v += area_shift;
    double length = sqrt(*u * *u + *v * *v);
    double a = fabs(*u), b = fabs(*v);
    double scale = length > 0 ? (a > b ? a : b) / length : 1;
    *u *= scale;
    *v *= scale;
}

static inline double side_place(double x, int size)
{
    return size > 1 ? x / (size - 1) - 0.5 : 0;
}

vec3 area_anywhere(const struct lamp *lamp, vec3 point, const double u[2])
{
    const struct light *light = lamp->light;
    struct area_grid grid = area_grid_new(lamp, point, 0);
    bool wide = light->size1 > 1, high = light->size2 > 1;
    double x = u[0] - 0.5, y = u[1] - 0.5;
    if (light->circular || (light->orient && wide && high)) {
        warp_disc(u, &x, &y);
        x /= 2;
        y /= 2;
    }
    return vec3_along(vec3_along(light->location, grid.axis1, wide ? x : 0),
                      grid.axis2, high ? y : 0);
}

/* A whole number below 2^52, and as random_unit has it, by ways that
 * instructions for several lanes know. */
static inline uint64_t whole_number(double x)
{
    return bits_of(x + 0x1p52) & ((1ull << 52) - 1);
}

static inline double unit_number(uint64_t key)
{
    const uint64_t bits = random_mix(key) >> 11;
    const uint64_t low = (bits & 0xffffffff) | 0x433ull << 52;
    const uint64_t high = bits >> 32 | 0x453ull << 52;
    return ((of_bits(high) - 0x1p84) + (of_bits(low) - 0x1p52)) * 0x1p-53;
}

/* How far a point's neighbours let it be moved. */
static inline void area_jitter(uint64_t grid_key, double *i, double *j)
{
    uint64_t key = random_key(grid_key, whole_number(*i));
    key = random_key(key, whole_number(*j));
    *i += unit_number(key) - 0.5;
    *j += unit_number(key + 1) - 0.5;
}

/* Of a point (i, j) that may have been moved. */
static inline void area_locate(const struct area_grid *grid, bool round,
                               struct area_points *points, unsigned k)
{
    double u = side_place(points->place[0][k], grid->size1);
    double v = side_place(points->place[1][k], grid->size2);
    if (round)
        area_round(&u, &v);
    vec3 along = vec3_along(grid->light->location, grid->axis1, u);
    lane_put(points->location, k, vec3_along(along, grid->axis2, v));
    points->place[0][k] = u * grid->scale[0];
    points->place[1][k] = v * grid->scale[1];
}

/* Few points are as many as the widest instructions take, or fewer. */
enum { POINTS_FEW = 8 };

CLONES static void points_jitter(uint64_t grid_key, bool few,
                                 struct area_points *restrict points)
{
    for (int from = 0; from < (few ? POINTS_FEW : RAY_LANES);
         from += POINTS_FEW)
        for (int k = from; k < from + POINTS_FEW; k++)
            area_jitter(grid_key, &points->place[0][k], &points->place[1][k]);
}

CLONES static void points_locate(const struct area_grid *restrict grid,
                                 bool round, bool few,
                                 struct area_points *restrict points)
{
    for (unsigned from = 0; from < (few ? POINTS_FEW : RAY_LANES);
         from += POINTS_FEW)
        for (unsigned k = from; k < from + POINTS_FEW; k++)
            area_locate(grid, round, points, k);
}

/* Lanes that nobody wants are those of the first, all of which are numbers. */
static void points_fill(struct area_points *points)
{
    for (int k = POINTS_FEW; k < RAY_LANES; k++) {
        for (int axis = 0; axis < 2; axis++)
            points->place[axis][k] = points->place[axis][0];
        for (int axis = 0; axis < 3; axis++)
            points->location[axis][k] = points->location[axis][0];
    }
}

void area_grid_hull(const struct area_grid *grid, vec3 half[2])
{
    half[0] = vec3_scale(grid->axis1, 1 / grid->scale[0]);
    half[1] = vec3_scale(grid->axis2, 1 / grid->scale[1]);
}

static bool grid_is_round(const struct area_grid *grid)
{
    const struct light *light = grid->light;
    return light->circular ||
           (light->orient && light->size1 > 1 && light->size2 > 1);
}

/* One without the others. */
static void point_find(const struct area_grid *grid, struct area_points *points)
{
    points->place[0][0] = points->at[0][0];
    points->place[1][0] = points->at[1][0];
    if (grid->key)
        area_jitter(grid->key, &points->place[0][0], &points->place[1][0]);
    area_locate(grid, grid_is_round(grid), points, 0);
}

void area_grid_points(const struct area_grid *grid, struct area_points *points)
{
    if (points->count == 1) {
        point_find(grid, points);
        return;
    }
    for (int k = 0; k < RAY_LANES; k++) {
        int from = k < points->count ? k : 0;
        points->place[0][k] = points->at[0][from];
        points->place[1][k] = points->at[1][from];
    }
    bool few = points->count <= POINTS_FEW;
    if (grid->key)
        points_jitter(grid->key, few, points);
    points_locate(grid, grid_is_round(grid), few, points);
    if (few)
        points_fill(points);
}

vec3 area_grid_point(const struct area_grid *grid, int i, int j)
{
    struct area_points points;
    points.count = 1;
    points.at[0][0] = i;
    points.at[1][0] = j;
    point_find(grid, &points);
    return lane_get((const double(*)[RAY_LANES])points.location, 0);
}
