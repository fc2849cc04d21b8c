/* Rays side by side at shapes whose equation along a ray is of degree 4: what
 * quartics.h leaves unknown is asked of the shape ray by ray. */
#ifndef SCENE_QUARTIC_RAYS_H
#define SCENE_QUARTIC_RAYS_H

#include "scene/quartics.h"

/* The equations, and the rays in their parameters: root = length t - shift, as
 * a line's (line_roots.h). */
struct quartic_rays {
    struct quartics quartics;
    double length[RAY_LANES], shift[RAY_LANES];
    double least[RAY_LANES], most[RAY_LANES]; /* roots between these count */
};

/* Who is asked: the shape, by its primitive's first and crosses. */
struct quartic_asked {
    const void *shape;
    bool (*first)(const void *shape, const struct ray *ray, double tmin,
                  double tmax, struct hit *hit);
    bool (*crosses)(const void *shape, const struct ray *ray, double tmin,
                    double tmax);
    struct lane_run run;
    const struct rays *rays;
    const struct rays_span *span;
};

/* As first_many and crosses_many of a primitive; equations of lanes that aren't
 * in the run may be anything. `lanes` NULL: the shape alone is asked. */
void quartic_rays_first(struct quartic_rays *lanes,
                        const struct quartic_asked *asked,
                        struct rays_met *met);
void quartic_rays_cross(struct quartic_rays *lanes,
                        const struct quartic_asked *asked, lane_flag *met);

#endif
