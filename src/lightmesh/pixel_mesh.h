/* Mesh points where the picture itself sees surfaces. Section 1.6 of the
 * light-mesh paper lets any points be mesh points, and first finds out which
 * are needed, then computes them all (steps 6 and 9): here they are the first
 * hits of every few pixels' camera rays, and one lamp after another looks at
 * all of them at once (irregular.h), so that each knows every lamp exactly.
 * Pixels between share what their neighbours on the same surface know; one that
 * has no such neighbour is a point itself. (Interleaved sampling with a filter
 * that respects surfaces: Keller and Heidrich 2001; Segovia et al. 2006.)
 *
 * They belong to one picture: mirrors, glass and other pictures ask the meshes
 * that are in space. */
#ifndef LIGHTMESH_PIXEL_MESH_H
#define LIGHTMESH_PIXEL_MESH_H

#include "lightmesh/lamp_sights.h"
#include "lightmesh/receiver.h"
#include "shade/first_hits.h"

struct pixel_mesh_options {
    const struct casters *casters;
    const struct lamps *lamps;
    const bool *takes; /* by lamp: what lamp_sights_take says */
    const struct camera *camera;
    int apart; /* of so many pixels one is a point: as stagger_apart has it */
    bool each; /* points know each lamp, and not the sum: all must be taken for
                * that */
};

/* Casters, lamps, takes and camera must outlive it, hits->at and the workers,
 * one for each thread, last as long as pixel_mesh_light is called. Of no use
 * once they are told to stop. Frees with pixel_mesh_free. */
struct pixel_mesh;
struct pixel_mesh *pixel_mesh_new(const struct pixel_mesh_options *options,
                                  const struct first_hits *hits,
                                  struct worker *const *workers,
                                  unsigned threads);
void pixel_mesh_free(struct pixel_mesh *mesh);

/* The light of all lamps before a receiver that the camera sees at first sight.
 * False if no point near its pixel is on the same surface. */
bool pixel_mesh_light(const struct pixel_mesh *mesh,
                      const struct receiver *receiver,
                      struct facet_light *light);

/* Of a mesh that knows each lamp: whether this one shines on the surface that
 * the camera sees at a place. False if there is no point at that very place, or
 * the lamp can't look at many. */
bool pixel_mesh_sees(const struct pixel_mesh *mesh,
                     const struct picture_place *place, const struct lamp *lamp,
                     bool *shines);

/* How many points there are, and what memory they took, in bytes. */
size_t pixel_mesh_count(const struct pixel_mesh *mesh);
size_t pixel_mesh_bytes(const struct pixel_mesh *mesh);

/* Calls visit for each point. */
typedef void pixel_mesh_visit(void *context, vec3 place,
                              const struct facet_light *light);
void pixel_mesh_each(const struct pixel_mesh *mesh, pixel_mesh_visit *visit,
                     void *context);

#endif
