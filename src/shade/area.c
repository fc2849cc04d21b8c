/* The grid of an area light: see area.h. */
#include "shade/area.h"

#include <string.h>

#include "base/random.h"

/* Points seen are remembered in a table, because neighbouring parts share
 * their edges. A point that has lost its place is seen again. */
enum { AREA_PLACES = 512 };

/* Of refined grids: the most steps along a side, and where the light isn't
 * adaptive. */
enum { AREA_STEPS = 64, AREA_ADAPTIVE = 2 };

struct area_walk {
    const struct area_grid *grid;
    rgb light; /* unshadowed */
    area_visit *visit;
    void *context;
    int64_t known[AREA_PLACES]; /* number of the point, -1: none */
    rgb seen[AREA_PLACES];
};

/* Part of the grid, both ends included. */
struct area_part {
    int i0, i1, j0, j1;
};

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
    return grid;
}

/* At least twice as many steps, a power of two: halves of such sides always
 * share a point. */
static int side_refined(int size)
{
    int steps = 1;
    while (steps < 2 * (size - 1) && steps < AREA_STEPS)
        steps *= 2;
    return size > 1 && size <= AREA_STEPS ? steps + 1 : size;
}

void area_grid_refine(struct area_grid *grid)
{
    grid->size1 = side_refined(grid->size1);
    grid->size2 = side_refined(grid->size2);
    if (grid->adaptive < 0)
        grid->adaptive = AREA_ADAPTIVE;
}

/* The square [-1/2,1/2]^2 pressed into the disc in it along the radii, moved
 * a little, which keeps the middle from dividing by zero (POV-Ray's way: its
 * grids are off by a thousandth). */
static void area_round(double *u, double *v)
{
    *u += 0.001;
    *v += 0.001;
    double length = sqrt(*u * *u + *v * *v);
    double scale = length > 0 ? fmax(fabs(*u), fabs(*v)) / length : 1;
    *u *= scale;
    *v *= scale;
}

vec3 area_grid_point(const struct area_grid *grid, int i, int j)
{
    const struct light *light = grid->light;
    double x = i, y = j, u, v;
    if (grid->key) {
        uint64_t key = random_key(grid->key, (uint64_t)i);
        key = random_key(key, (uint64_t)j);
        x += random_unit(key) - 0.5;
        y += random_unit(key + 1) - 0.5;
    }
    u = grid->size1 > 1 ? x / (grid->size1 - 1) - 0.5 : 0;
    v = grid->size2 > 1 ? y / (grid->size2 - 1) - 0.5 : 0;
    if (light->circular ||
        (light->orient && light->size1 > 1 && light->size2 > 1))
        area_round(&u, &v);
    return vec3_along(vec3_along(light->location, grid->axis1, u), grid->axis2,
                      v);
}

static rgb area_see(struct area_walk *walk, int i, int j)
{
    int64_t number = (int64_t)i * walk->grid->size2 + j;
    size_t place = (size_t)(number % AREA_PLACES);
    if (walk->known[place] != number) {
        vec3 point = area_grid_point(walk->grid, i, j);
        walk->seen[place] = walk->visit(walk->context, point);
        walk->known[place] = number;
    }
    return walk->seen[place];
}

/* POV-Ray's measure: less than 0.1 in all of the light that arrives. */
static bool area_agree(const struct area_walk *walk, rgb a, rgb b)
{
    rgb d = rgb_mul(rgb_sub(a, b), walk->light);
    return fabs(d.r) + fabs(d.g) + fabs(d.b) < 0.1;
}

/* Halves overlap in the middle point where there is one. Depth is limited by
 * the bits of a size. */
static rgb area_part_seen(struct area_walk *walk, struct area_part part,
                          int level)
{
    const struct area_grid *grid = walk->grid;
    rgb a = area_see(walk, part.i0, part.j0);
    rgb b = area_see(walk, part.i1, part.j0);
    rgb c = area_see(walk, part.i0, part.j1);
    rgb d = area_see(walk, part.i1, part.j1);
    bool wide = part.i1 - part.i0 > 1, high = part.j1 - part.j0 > 1;
    bool enough = grid->adaptive >= 0 && level >= grid->adaptive &&
                  area_agree(walk, a, b) && area_agree(walk, a, c) &&
                  area_agree(walk, b, d) && area_agree(walk, c, d);
    if (enough || (!wide && !high))
        return rgb_scale(rgb_add(rgb_add(a, b), rgb_add(c, d)), 0.25);
    rgb sum = rgb_grey(0);
    int columns = wide ? 2 : 1, rows = high ? 2 : 1;
    for (int k = 0; k < columns * rows; k++) {
        struct area_part half = part;
        int i = part.i0 + part.i1, j = part.j0 + part.j1;
        if (wide && k % columns == 0)
            half.i1 = i / 2;
        else if (wide)
            half.i0 = (i + 1) / 2;
        if (high && k / columns == 0)
            half.j1 = j / 2;
        else if (high)
            half.j0 = (j + 1) / 2;
        sum = rgb_add(sum, area_part_seen(walk, half, level + 1));
    }
    return rgb_scale(sum, 1.0 / (columns * rows));
}

rgb area_visibility(const struct area_grid *grid, rgb arriving,
                    area_visit *visit, void *context)
{
    struct area_walk walk;
    walk.grid = grid;
    walk.light = arriving;
    walk.visit = visit;
    walk.context = context;
    memset(walk.known, -1, sizeof walk.known);
    return area_part_seen(
        &walk, (struct area_part){ 0, grid->size1 - 1, 0, grid->size2 - 1 }, 0);
}
