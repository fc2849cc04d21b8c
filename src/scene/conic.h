/* A cone or cylinder between two ends, open or closed: what the primitives
 * cylinder and cone have in common. */
#ifndef SCENE_CONIC_H
#define SCENE_CONIC_H

#include "scene/primitive.h"

struct conic {
    vec3 base, apex;
    double base_radius, apex_radius;
    bool open; /* no caps */
    vec3 axis; /* unit, base to apex */
    double height;
    double slope; /* of the radius along the axis */
};

/* Fills axis, height and slope. False if the ends are the same point. */
bool conic_prepare(struct conic *conic);

/* For shapes made of a struct conic. */
bool conic_move(void *shape, const affine *outward, const affine *inward);
struct box3 conic_bounds(const void *shape);
struct box3 conic_told(const void *shape, const affine *place);
void conic_intersect(const void *shape, const struct ray *ray,
                     struct hits *hits);
bool conic_crosses(const void *shape, const struct ray *ray, double tmin,
                   double tmax);
void conic_crosses_many(const void *shape, struct lane_run run,
                        const struct rays *rays, const struct rays_span *span,
                        lane_flag *met);
vec3 conic_normal(const void *shape, const vec3 *at, const struct hit *hit);
void conic_all_many(const void *shape, struct lane_run run,
                    const struct rays *rays, struct rays_crossings *all);
void conic_inside_many(const void *shape, struct lane_run run,
                       const struct lane_points *points, lane_flag *inside);
bool conic_inside(const void *shape, vec3 point);
unsigned conic_meets(const void *shape, const struct cell *cell);

#endif
