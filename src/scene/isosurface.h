/* Isosurfaces: where a function of space has a value, within a box or a ball.
 */
#ifndef SCENE_ISOSURFACE_H
#define SCENE_ISOSURFACE_H

#include "scene/container.h"
#include "scene/primitive.h"

struct function;
struct spots;

/* Of hits: of the function, and of the container from there on. */
enum { ISOSURFACE_FUNCTION, ISOSURFACE_CONTAINER };

struct isosurface {
    const struct function *function;
    struct terms samples; /* of the function: what tells it from others */
    struct container container;
    double threshold;    /* inside is what is below it */
    double accuracy;     /* two crossings nearer to each other may be missed */
    double max_gradient; /* the function changes no faster */
    bool open;           /* the box or ball is not seen */
    int max_trace; /* of a ray in CSG or clipped, the first crossings count */
    bool all_intersections; /* instead */
};

extern const struct primitive isosurface_primitive;

/* How far the function is from the threshold. */
double isosurface_value(const struct isosurface *surface, vec3 point);
void isosurface_values(const struct isosurface *surface,
                       const struct spots *spots, double *values);

/* How large max_gradient must be, measured on so many chords; 0 if nothing
 * crosses the surface twice. */
double isosurface_gradient(const struct isosurface *surface, int chords);

/* With POV-Ray's defaults. */
void isosurface_init(struct isosurface *surface);

#endif
