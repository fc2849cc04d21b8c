/* Indirect light where the corners of a surface's grid are on other surfaces
 * (indirect_pixels.h): along edges, on what is thin. There pixels of a block
 * share what few places in it know, which the camera sees through the block, so
 * that a blade of grass asks once and not for each of its pixels. All of it is
 * a function of the block's place in the picture; workers keep the last that
 * they came by. */
#ifndef LIGHTMESH_PIXEL_BLOCKS_H
#define LIGHTMESH_PIXEL_BLOCKS_H

#include "lightmesh/corner.h"
#include "scene/camera.h"

struct pixel_blocks;

/* Of a picture of so many pixels, where corners are so many pixels apart;
 * mesh and camera must outlive it. All who ask it are far sides, or none is.
 * Frees with pixel_blocks_free, which takes NULL. */
struct pixel_blocks *pixel_blocks_new(const struct indirect_mesh *mesh,
                                      const struct camera *camera,
                                      const int size[2], double apart,
                                      unsigned threads);
void pixel_blocks_free(struct pixel_blocks *blocks);

/* The light of the receiver, which the camera sees at first sight, by a place
 * that serves it; false if there is none. */
bool pixel_blocks_light(const struct pixel_blocks *blocks,
                        struct worker *worker, const struct receiver *receiver,
                        struct indirect_share *share);

#endif
