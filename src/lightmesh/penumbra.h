/* Area lights where the picture itself sees surfaces. How fast the share of an
 * area light changes along a surface is bounded by how wide the penumbras there
 * are, and they are the wider the farther away the things are that cast them
 * (Soler and Sillion 1998; Egan et al. 2011, Frequency Analysis and Sheared
 * Filtering for Shadow Light Fields of Complex Occluders). So the shares are
 * found on a lattice of pixels, as coarse as the narrowest penumbra there may
 * be allows, and pixels between take them from its corners; where nothing casts
 * a shadow none is found at all, and near to what does nothing is known. */
#ifndef LIGHTMESH_PENUMBRA_H
#define LIGHTMESH_PENUMBRA_H

#include "lightmesh/receiver.h"
#include "scene/camera.h"
#include "shade/first_hits.h"
#include "shade/lamps.h"

/* Whether the lamp's shadow has penumbras that can be known so. */
bool penumbra_takes(const struct lamps *lamps, const struct lamp *lamp);

/* Of all lamps that it takes. Lamps and camera must outlive it, hits->at too;
 * there is a worker for each thread. Of no use once they are told to stop.
 * Frees with penumbras_free. */
struct penumbras;
struct penumbras *penumbras_new(const struct lamps *lamps,
                                const struct camera *camera,
                                const struct first_hits *hits,
                                struct worker *const *workers,
                                unsigned threads);
void penumbras_free(struct penumbras *penumbras);

/* The lamp's share on a receiver that the camera sees at first sight, as
 * lamps_share_fine has it, nearly. False if it must be asked for. */
bool penumbras_share(const struct penumbras *penumbras,
                     const struct receiver *receiver, const struct lamp *lamp,
                     rgb *share);

/* Memory that so many pixels and lamps take, in bytes. */
double penumbras_bytes(double pixels, size_t lamps);

/* How many shares were found, and the memory that was taken. */
size_t penumbras_count(const struct penumbras *penumbras);
double penumbras_memory(const struct penumbras *penumbras);

#endif
