/* A coarse look through the camera: see outlook.h. */
#include "lightmesh/outlook.h"

#include <stdlib.h>

#include "base/order.h"

enum {
    OUTLOOK_EDGE = 24,
    OUTLOOK_RAYS = OUTLOOK_EDGE * OUTLOOK_EDGE,
    SQUARES_EDGE = 8, /* of the squares in which crowding is looked at, */
    SQUARE_EDGE = 6,  /* and of the rays of each */
    SQUARE_RAYS = SQUARE_EDGE * SQUARE_EDGE,
};

/* Of pictures of which it isn't said. */
static const double usual_width = 640;

/* What the rays met. */
struct outlook_hits {
    int count;
    double axis[3][OUTLOOK_RAYS]; /* coordinates */
    double pixel[OUTLOOK_RAYS], distance[OUTLOOK_RAYS];
};

static void outlook_ray(struct outlook_hits *hits, const struct world *world,
                        const struct camera *camera, vec3 place, double width)
{
    struct intersection at;
    struct ray ray = camera_ray(camera, place.x, place.y);
    struct ray beside = camera_ray(camera, place.x + 1 / width, place.y);
    if (!world_closest(world, &ray, 1e-4, RAY_CAMERA, &at))
        return;
    vec3 other = vec3_along(beside.origin, beside.direction, at.t);
    int i = hits->count++;
    hits->axis[0][i] = at.point.x;
    hits->axis[1][i] = at.point.y;
    hits->axis[2][i] = at.point.z;
    hits->pixel[i] = vec3_length(vec3_sub(other, at.point));
    hits->distance[i] = vec3_length(vec3_sub(at.point, camera->location));
}

static double sorted_at(const double *sorted, int count, double share)
{
    return sorted[(int)(share * (count - 1))];
}

struct outlook outlook_of(const struct world *world, const struct scene *scene,
                          int width)
{
    struct outlook_hits hits;
    double low[3], high[3], size = 0;
    const struct camera *camera = &scene->camera;
    hits.count = 0;
    double pixels = width > 0 ? width : usual_width;
    for (int i = 0; i < OUTLOOK_RAYS; i++) {
        vec3 place = vec3_make((i % OUTLOOK_EDGE + 0.5) / OUTLOOK_EDGE,
                               (i / OUTLOOK_EDGE + 0.5) / OUTLOOK_EDGE, 0);
        outlook_ray(&hits, world, camera, place, pixels);
    }
    int count = hits.count;
    if (count == 0)
        return (struct outlook){ camera->location, 1, 0.01, 1, 0 };
    for (int axis = 0; axis < 3; axis++) {
        qsort(hits.axis[axis], (size_t)count, sizeof(double), order_double);
        low[axis] = sorted_at(hits.axis[axis], count, 0.1);
        high[axis] = sorted_at(hits.axis[axis], count, 0.9);
        size = fmax(size, high[axis] - low[axis]);
    }
    qsort(hits.pixel, (size_t)count, sizeof(double), order_double);
    qsort(hits.distance, (size_t)count, sizeof(double), order_double);
    double pixel = sorted_at(hits.pixel, count, 0.5);
    struct outlook outlook = {
        .centre = vec3_make((low[0] + high[0]) / 2, (low[1] + high[1]) / 2,
                            (low[2] + high[2]) / 2),
        .pixel = pixel > 0 ? pixel : 1e-3,
        .distance = sorted_at(hits.distance, count, 0.5),
    };
    outlook.across = outlook.pixel * pixels;
    outlook.size = fmax(size, outlook.pixel);
    if (camera->kind != CAMERA_PERSPECTIVE)
        outlook.distance = 0;
    return outlook;
}

static struct lattice_point cell_at(const struct lattice *lattice,
                                    const struct camera *camera, vec3 place)
{
    double coarse;
    const struct lattice_view view = { .eye = camera->location };
    struct lattice_point cell = { .level = lattice_level(lattice, &view, place,
                                                         &coarse) };
    vec3 units = lattice_units(lattice, cell.level, place);
    for (int axis = 0; axis < 3; axis++)
        cell.at[axis] = (int)floor(vec3_component(units, axis));
    return cell;
}

/* What a cell counts: surfaces that are farther away than usual, or slanted,
 * have more of them in a square, (1 + s) (1 + s / cosine) if it is s cells
 * wide there, and 4 are the usual. */
static double cell_counts(const struct outlook *outlook,
                          const struct lattice *lattice, int level,
                          double distance, double cosine)
{
    double away = outlook->distance > 0 ? distance / outlook->distance : 1;
    double s = away * lattice_spacing(lattice, lattice->usual) /
               lattice_spacing(lattice, level);
    return 4 / ((1 + s) * (1 + s / fmax(cosine, 1e-9)));
}

/* How many cells a square of the picture shows, by rays that are `step` apart.
 */
static double square_cells(const struct world *world,
                           const struct camera *camera,
                           const struct outlook *outlook,
                           const struct lattice *lattice,
                           const double corner[2], double step)
{
    uint64_t cells[SQUARE_RAYS];
    int count = 0;
    double sum = 0;
    for (int i = 0; i < SQUARE_RAYS; i++) {
        struct intersection at;
        double x = corner[0] + step * (i % SQUARE_EDGE),
               y = corner[1] + step * (i / SQUARE_EDGE);
        struct ray ray = camera_ray(camera, x, y);
        if (!world_closest(world, &ray, 1e-4, RAY_CAMERA, &at))
            continue;
        int known = 0;
        struct lattice_point cell = cell_at(lattice, camera, at.point);
        cells[count] = lattice_key(&cell);
        while (cells[known] != cells[count])
            known++;
        if (known < count)
            continue;
        sum += cell_counts(outlook, lattice, cell.level, at.t,
                           fabs(vec3_dot(ray.direction, at.face)));
        count++;
    }
    return sum;
}

double outlook_crowding(const struct world *world, const struct camera *camera,
                        const struct outlook *outlook,
                        const struct lattice *lattice)
{
    double width = lattice_spacing(lattice, lattice->usual) / outlook->across;
    int squares = 0;
    double cells = 0;
    for (int i = 0; i < SQUARES_EDGE * SQUARES_EDGE; i++) {
        double corner[2] = { (i % SQUARES_EDGE + 0.5) / SQUARES_EDGE,
                             (i / SQUARES_EDGE + 0.5) / SQUARES_EDGE };
        double found = square_cells(world, camera, outlook, lattice, corner,
                                    width / SQUARE_EDGE);
        cells += found;
        squares += found > 0;
    }
    return squares > 0 ? cells / squares : 0;
}
