/* What the indirect mesh says at grids on the surfaces that the camera sees
 * (surface_grid.h), some pixels apart: its light changes so slowly that pixels
 * between share the answers of their corners, on the same surface (as
 * irradiance gradients do: Ward and Heckbert 1992). A corner is asked for when
 * a pixel near it is, and is a function of its place in the world: what a still
 * surface shows does not change with the camera. Where no corner serves,
 * pixels of a block share (pixel_blocks.h), or else the rays of a pixel that
 * has several.
 */
#ifndef LIGHTMESH_INDIRECT_PIXELS_H
#define LIGHTMESH_INDIRECT_PIXELS_H

#include "lightmesh/indirect.h"
#include "scene/camera.h"

struct indirect_pixels;

/* Of a picture of so many pixels, drawn by so many workers; mesh and camera
 * must outlive it. Frees with indirect_pixels_free, which takes NULL. */
struct indirect_pixels *indirect_pixels_new(const struct indirect_mesh *mesh,
                                            const struct camera *camera,
                                            int width, int height,
                                            unsigned threads);
void indirect_pixels_free(struct indirect_pixels *pixels);

/* The light of a receiver that the camera sees at first sight, as
 * indirect_mesh_light has it. False if the corners around it are on other
 * surfaces, and it is the only ray of its pixel. */
bool indirect_pixels_light(const struct indirect_pixels *pixels,
                           struct worker *worker,
                           const struct receiver *receiver,
                           struct indirect_share *share);

#endif
