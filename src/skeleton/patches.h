/* The walls of the void as light finds them: pieces of their true area
 * (skeleton/wall.h), with what they give back, emit, and get from lamps. */
#ifndef SKELETON_PATCHES_H
#define SKELETON_PATCHES_H

#include "shade/lamp.h"
#include "skeleton/voxels.h"
#include "base/worker.h"
#include "embree/world.h"

/* Single precision: there may be a million. */
struct patch_light {
    float r, g, b;
};

struct wall_patch {
    uint32_t voxel;                      /* the void before it */
    float area;                          /* world units squared */
    struct patch_light albedo, emission; /* times irradiance; by itself */
    struct patch_light direct;           /* irradiance from lamps */
};

struct patches {
    struct wall_patch *items;
    size_t count;
    /* Mean radiance that comes in through the open border of the grid, for a
     * face that looks to -x, +x, -y, +y, -z, +z. */
    rgb sky[6];
};

/* What the light of walls is asked of. */
struct patches_scene {
    const struct world *world;
    const struct scene *scene;
    const struct lamp *lamps;
    size_t lamp_count;
    uint64_t seed;
    unsigned threads;
};

/* The same for any number of threads; freed by patches_free. */
struct patches *patches_new(const struct voxels *voxels,
                            const struct patches_scene *from);
void patches_free(struct patches *patches);

static inline rgb patch_rgb(struct patch_light light)
{
    return rgb_make((double)light.r, (double)light.g, (double)light.b);
}

#endif
