/* A coarse look through the camera: see outlook.h. */
#include "lightmesh/outlook.h"

#include <stdlib.h>

#include "base/order.h"
#include "lightmesh/tuning.h"
#include "shade/shadow.h"
#include "shade/surface.h"

enum { OUTLOOK_RAYS = OUTLOOK_EDGE * OUTLOOK_EDGE };

/* What the rays met. */
struct outlook_hits {
    int count;
    double axis[3][OUTLOOK_RAYS]; /* coordinates */
    double pixel[OUTLOOK_RAYS], distance[OUTLOOK_RAYS];
};

/* What the camera sees of surfaces that take light, which a sky painted on a
 * sphere doesn't: it is no place for mesh points; through panes, be it the
 * wall of a lens or of a fog that it stands in. False: none. */
static bool outlook_meets(const struct world *world, const struct ray *ray,
                          struct intersection *at)
{
    double from = 1e-4;
    for (int i = 0; i < SURVEY_PANES; i++) {
        if (!world_closest(world, ray, from, RAY_SIGHT, at))
            return false;
        if (rgb_brightness(surface_transmittance(at)) < pane_least)
            return texture_takes_light(at->texture);
        from = at->t + surface_offset(at->point);
    }
    return false;
}

static void outlook_ray(struct outlook_hits *hits, const struct world *world,
                        const struct camera *camera, vec3 place, double width)
{
    struct intersection at;
    struct ray ray = camera_ray(camera, place.x, place.y);
    struct ray beside = camera_ray(camera, place.x + 1 / width, place.y);
    if (!outlook_meets(world, &ray, &at))
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
        low[axis] = sorted_at(hits.axis[axis], count, outlook_beside);
        high[axis] = sorted_at(hits.axis[axis], count, 1 - outlook_beside);
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
    if (camera->kind->lines == CAMERA_PARALLEL ||
        camera->kind->lines == CAMERA_SCATTERED)
        outlook.distance = 0; /* what is farther off is seen as large */
    if (camera->kind->lines == CAMERA_BENT)
        outlook.distance *= outlook_bent;
    return outlook;
}
