/* Height fields: see height_field.h. How squares are split and what the smooth
 * normals are was measured with POV-Ray 3.7. */
#include "scene/height_field.h"

#include <string.h>

#include "base/clones.h"
#include "base/hash.h"
#include "scene/crossings.h"
#include "scene/height_rays.h"

/* POV-Ray's unit of height, by which its normals are made and rounded. */
static const double unit = 65536;

static const struct field height_arguments[] = {
    { "heights", FIELD_TERMS, offsetof(struct height_field, digest), 0, 0,
      "what they are, in short", false },
    { .name = NULL },
};

static const struct field height_items[] = {
    { "smooth", FIELD_FLAG, offsetof(struct height_field, smooth), 0, 0,
      "normals between those of the corners" },
    { "water_level", FIELD_FLOAT, offsetof(struct height_field, water_level), 0,
      0, "what is lower is not there, 0" },
    { .name = NULL },
};

static void height_digest(struct height_field *field, struct arena *arena)
{
    const struct height_grid *grid = &field->grid;
    uint64_t hash = hash_bytes((uint64_t)grid->width, grid->heights,
                               (size_t)grid->width * (size_t)grid->height * 2);
    double *numbers = ARENA_ARRAY(arena, double, 2);
    numbers[0] = (double)(hash >> 32);
    numbers[1] = (double)(hash & UINT32_MAX);
    field->digest = (struct terms){ numbers, 2 };
}

static const char *height_prepare(void *shape, struct arena *arena,
                                  const char **warning)
{
    struct height_field *field = shape;
    (void)warning;
    field->grid.water = field->water_level * unit;
    height_grid_prepare(&field->grid, arena);
    height_digest(field, arena);
    return NULL;
}

static struct box3 height_bounds(const void *shape)
{
    const struct height_field *field = shape;
    struct height_range range = height_grid_range(&field->grid);
    double low = fmax(range.low / unit, field->water_level);
    if (range.high < field->grid.water)
        return box3_empty();
    return (struct box3){ { 0, low, 0 }, { 1, range.high / unit, 1 } };
}

static vec3 into_grid(const struct height_grid *grid, vec3 p)
{
    return vec3_make(p.x * (grid->width - 1), p.y * unit,
                     (1 - p.z) * (grid->height - 1));
}

static struct ray ray_into_grid(const struct height_grid *grid,
                                const struct ray *ray)
{
    vec3 d = ray->direction;
    return (struct ray){ into_grid(grid, ray->origin),
                         { d.x * (grid->width - 1), d.y * unit,
                           -d.z * (grid->height - 1) } };
}

static void height_crossings(const void *shape, const struct ray *ray,
                             double tmin, double tmax, hit_visit *visit,
                             void *context)
{
    const struct height_field *field = shape;
    struct ray there = ray_into_grid(&field->grid, ray);
    height_grid_crossings(&field->grid, &there, tmin, tmax, visit, context);
}

static void height_intersect(const void *shape, const struct ray *ray,
                             struct hits *hits)
{
    crossings_all(height_crossings, shape, ray, hits);
}

static bool height_first(const void *shape, const struct ray *ray, double tmin,
                         double tmax, struct hit *hit)
{
    return crossings_first(height_crossings, shape, ray, tmin, tmax, hit);
}

static bool height_crosses(const void *shape, const struct ray *ray,
                           double tmin, double tmax)
{
    struct hit hit;
    return height_first(shape, ray, tmin, tmax, &hit);
}

/* All of them in the grid's space. */
CLONES static void rays_into_grid(const struct height_grid *restrict grid,
                                  const struct rays *restrict rays,
                                  struct rays *restrict out)
{
    const double wide = grid->width - 1, deep = grid->height - 1;
    for (int i = 0; i < RAY_LANES; i++) {
        out->origin[0][i] = rays->origin[0][i] * wide;
        out->origin[1][i] = rays->origin[1][i] * unit;
        out->origin[2][i] = (1 - rays->origin[2][i]) * deep;
        out->direction[0][i] = rays->direction[0][i] * wide;
        out->direction[1][i] = rays->direction[1][i] * unit;
        out->direction[2][i] = -rays->direction[2][i] * deep;
    }
}

static void height_first_many(const void *shape, struct lane_run run,
                              const struct rays *rays,
                              const struct rays_span *span,
                              struct rays_met *met)
{
    const struct height_field *field = shape;
    struct rays there;
    rays_into_grid(&field->grid, rays, &there);
    height_rays_first(&field->grid, run, &there, span, met);
    memset(met->u, 0, sizeof met->u);
}

static void height_crosses_many(const void *shape, struct lane_run run,
                                const struct rays *rays,
                                const struct rays_span *span, lane_flag *met)
{
    struct rays_met first;
    height_first_many(shape, run, rays, span, &first);
    rays_crosses_met(&first, run, met);
}

enum { CORNERS = 4, AROUND = 4 };

/* At the corners of a square, the slopes that the squares around each have, in
 * this order; `there` is 0 where there is none, else 1. */
struct slopes {
    double x[AROUND * CORNERS], z[AROUND * CORNERS], there[AROUND * CORNERS];
};

/* Those of the corner at (x, y). A step is 1 and heights are in units: steep
 * places all but lie flat. */
static void corner_slopes(const struct height_grid *grid, int x, int y,
                          struct slopes *slopes, int corner)
{
    double here = height_grid_at(grid, x, y);
    for (int k = 0; k < AROUND; k++) {
        int i = k & 2 ? 1 : -1, j = k & 1 ? 1 : -1, at = CORNERS * k + corner;
        bool there = x + i >= 0 && x + i < grid->width && y + j >= 0 &&
                     y + j < grid->height;
        slopes->there[at] = there;
        slopes->x[at] =
            there ? -(height_grid_at(grid, x + i, y) - here) * i : 0;
        slopes->z[at] = there ? (height_grid_at(grid, x, y + j) - here) * j : 0;
    }
}

/* The mean of the unit normals of the squares around, as it is kept, in 16 bits
 * a number, then in the field's own proportions. */
CLONES static void corner_normals(const struct slopes *restrict slopes,
                                  double wide, double deep,
                                  double normals[restrict 3][CORNERS])
{
    double n[3][AROUND * CORNERS];
    for (int k = 0; k < AROUND * CORNERS; k++) {
        vec3 one = vec3_normalise(vec3_make(slopes->x[k], 1, slopes->z[k]));
        n[0][k] = one.x * slopes->there[k];
        n[1][k] = one.y * slopes->there[k];
        n[2][k] = one.z * slopes->there[k];
    }
    for (int c = 0; c < CORNERS; c++) {
        double sum[3];
        for (int axis = 0; axis < 3; axis++)
            sum[axis] = n[axis][c] + n[axis][CORNERS + c] +
                        n[axis][2 * CORNERS + c] + n[axis][3 * CORNERS + c];
        vec3 mean = vec3_scale(
            vec3_normalise(vec3_make(sum[0], sum[1], sum[2])), 32767);
        mean = vec3_normalise(vec3_make(
            trunc(mean.x) * wide, trunc(mean.y) * unit, trunc(mean.z) * deep));
        normals[0][c] = mean.x;
        normals[1][c] = mean.y;
        normals[2][c] = mean.z;
    }
}

/* As much of it as is unit length where the object stands: there normals are
 * blended (measured). */
static vec3 normal_share(vec3 n, const affine *to_object, double share)
{
    vec3 there = to_object ? affine_normal(to_object, n) : n;
    double length = vec3_length(there);
    return vec3_scale(n, length > 0 ? share / length : 0);
}

/* Between the four normals around the point, also where the three at the
 * corners of a face agree. */
static vec3 smooth_normal(const struct height_grid *grid, vec3 point,
                          const affine *to_object)
{
    vec3 p = into_grid(grid, point);
    double x = fmin(fmax(p.x, 0), grid->width - 1);
    double y = fmin(fmax(p.z, 0), grid->height - 1);
    int i = (int)fmin(x, grid->width - 2), j = (int)fmin(y, grid->height - 2);
    double u = x - i, v = y - j, normals[3][CORNERS];
    const double shares[CORNERS] = { (1 - u) * (1 - v), u * (1 - v),
                                     (1 - u) * v, u * v };
    struct slopes slopes;
    vec3 all[CORNERS];
    for (int c = 0; c < CORNERS; c++)
        corner_slopes(grid, i + (c & 1), j + (c >> 1), &slopes, c);
    corner_normals(&slopes, grid->width - 1, grid->height - 1, normals);
    for (int c = 0; c < CORNERS; c++) {
        vec3 n = { normals[0][c], normals[1][c], normals[2][c] };
        all[c] = normal_share(n, to_object, shares[c]);
    }
    return vec3_add(vec3_add(all[0], all[1]), vec3_add(all[2], all[3]));
}

static vec3 facet_normal(const struct height_grid *grid, const struct hit *hit)
{
    int i, j;
    struct height_plane plane = height_grid_part(grid, hit->part, &i, &j);
    return vec3_make(-plane.slope_u * (grid->width - 1), unit,
                     plane.slope_v * (grid->height - 1));
}

static vec3 height_face(const void *shape, const struct hit *hit)
{
    const struct height_field *field = shape;
    return field->smooth ? facet_normal(&field->grid, hit) : vec3_make(0, 0, 0);
}

static vec3 height_normal_placed(const void *shape, const vec3 *at,
                                 const struct hit *hit, const affine *to_object)
{
    const vec3 point = *at;
    const struct height_field *field = shape;
    return field->smooth ? smooth_normal(&field->grid, point, to_object)
                         : facet_normal(&field->grid, hit);
}

static vec3 height_normal(const void *shape, const vec3 *at,
                          const struct hit *hit)
{
    return height_normal_placed(shape, at, hit, NULL);
}

/* All that is under water, too, though nothing is seen there (measured). */
static bool height_inside(const void *shape, vec3 point)
{
    const struct height_field *field = shape;
    vec3 p = into_grid(&field->grid, point);
    double height;
    if (p.y < field->grid.water)
        return p.x >= 0 && p.z >= 0 && p.x <= field->grid.width - 1 &&
               p.z <= field->grid.height - 1;
    return height_grid_over(&field->grid, p.x, p.z, &height) && p.y < height;
}

struct height_meeting {
    const struct height_grid *grid;
    const struct cell *cell;
};

static vec3 grid_point(const struct height_grid *grid, int i, int j)
{
    return vec3_make((double)i / (grid->width - 1),
                     height_grid_at(grid, i, j) / unit,
                     1 - (double)j / (grid->height - 1));
}

static bool square_meets(void *context, int i, int j)
{
    const struct height_meeting *meeting = context;
    const struct height_grid *grid = meeting->grid;
    vec3 a = grid_point(grid, i, j), d = grid_point(grid, i + 1, j + 1);
    return cell_meets_triangle(meeting->cell, a, d,
                               grid_point(grid, i + 1, j)) ||
           cell_meets_triangle(meeting->cell, a, grid_point(grid, i, j + 1), d);
}

static unsigned height_meets(const void *shape, const struct cell *cell)
{
    const struct height_field *field = shape;
    struct height_meeting meeting = { &field->grid, cell };
    struct box3 box = cell_box(cell);
    vec3 a = into_grid(&field->grid, box.low);
    vec3 b = into_grid(&field->grid, box.high);
    struct box3 there = { { a.x, a.y, b.z }, { b.x, b.y, a.z } };
    if (height_grid_search(&field->grid, there, square_meets, &meeting))
        return CELL_SURFACE | CELL_BORDER;
    bool water = a.y <= field->grid.water && b.y >= field->grid.water;
    return water ? CELL_BORDER : 0;
}

const struct primitive height_field_primitive = {
    .name = "height_field",
    .help = "a landscape over a grid of heights",
    .size = sizeof(struct height_field),
    .arguments = height_arguments,
    .items = height_items,
    .solid = true,
    .beyond = true,
    .bounded = BOUNDS_IGNORED,
    .prepare = height_prepare,
    .bounds = height_bounds,
    .intersect = height_intersect,
    .crossings = height_crossings,
    .first = height_first,
    .crosses = height_crosses,
    .crosses_many = height_crosses_many,
    .first_many = height_first_many,
    .lane_by_lane = true,
    .normal = height_normal,
    .normal_placed = height_normal_placed,
    .face = height_face,
    .inside = height_inside,
    .meets = height_meets,
};
