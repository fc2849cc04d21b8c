/* When lamps are asked from the picture's own points (pixel_mesh.h, and
 * penumbra.h for area lights), and when from those in space or by surfaces. */
#ifndef LIGHTING_MESH_PIXELS_H
#define LIGHTING_MESH_PIXELS_H

#include "lightmesh/knower.h"
#include "scene/light_settings.h"

struct mesh_pixels {
    bool off;  /* they can't be, or something was said of the mesh itself */
    bool each; /* few lamps: pixels know each of them, and are all points */
    bool soft; /* area lights can be asked so */
    const struct plan *plan;
    double detail; /* what is nearer to a surface may be lost */
    const struct lamps *lamps;
    const struct scene *scene;
    struct casters casters;
    bool *takes;             /* by lamp: it can look at many points at once */
    struct world_hit *hits;  /* those that both of these look at */
    struct pixel_mesh *mesh; /* or NULL */
    struct penumbras *penumbras; /* or NULL */
};

/* `pixel` is the size of what one shows, in the world. */
struct mesh_pixels mesh_pixels_new(const struct lamps *lamps,
                                   const struct scene *scene,
                                   const struct plan *plan, double pixel);
void mesh_pixels_free(struct mesh_pixels *pixels);

/* As foresees and prepare of lighting/lighting.h. The first forgets what the
 * second made for an earlier band. */
bool mesh_pixels_wanted(struct mesh_pixels *pixels, struct first_hits *grid);
void mesh_pixels_make(struct mesh_pixels *pixels, const struct first_hits *hits,
                      struct worker *const *workers, unsigned threads);

#endif
