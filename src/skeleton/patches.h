/* The walls of the void as light finds them: pieces of their true area
 * (skeleton/wall.h), with what they give back, emit, and get from lamps. */
#ifndef SKELETON_PATCHES_H
#define SKELETON_PATCHES_H

#include "shade/ambience.h"
#include "shade/lamp.h"
#include "skeleton/voxels.h"
#include "base/worker.h"
#include "world/world.h"

/* Single precision: there may be a million. */
struct patch_light {
    float r, g, b;
};

struct wall_patch {
    vec3 point, normal;                  /* unit, into the void */
    uint32_t voxel;                      /* the void before it */
    float area;                          /* world units squared */
    struct patch_light albedo, emission; /* times irradiance; by itself */
    struct patch_light direct;           /* irradiance from lamps */
};

struct patches {
    struct wall_patch *items;
    size_t count;
};

/* What the light of walls is asked of. */
struct patches_scene {
    const struct world *world;
    const struct ambience *ambience;
    const struct lamp *lamps;
    size_t lamp_count;
    const struct emitters *emitters; /* while walls find what glows; or NULL */
    uint64_t seed;
    unsigned threads;
    const atomic_int *stop; /* non-zero: leave off; NULL: never */
};

/* The same for any number of threads; freed by patches_free. */
struct patches *patches_new(const struct voxels *voxels,
                            const struct patches_scene *from);
void patches_free(struct patches *patches);

/* The light that comes along a ray from outside of the voxels: of the sky, or
 * of what the ray meets there (`at`; NULL: nothing) by the light of lamps and
 * of the sky above it. */
rgb patches_beyond(const struct patches_scene *from, vec3 direction,
                   const struct intersection *at, uint64_t key);

/* The irradiance that a surface gets from lamps where a ray of this direction
 * meets it; what it gives back of irradiance into *albedo. */
rgb patches_lit(const struct patches_scene *from, vec3 direction,
                const struct intersection *at, uint64_t key, rgb *albedo);

/* The light that a surface gives by itself, where a ray of this direction meets
 * it. */
rgb patches_glow(vec3 direction, const struct intersection *at);

static inline rgb patch_rgb(struct patch_light light)
{
    return rgb_make((double)light.r, (double)light.g, (double)light.b);
}

#endif
