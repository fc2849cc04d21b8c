/* Numbers that tell whether a scene is what it was, but for its camera: what
 * light in it depends on. The same scene has the same in every run. */
#ifndef SCENE_FINGERPRINT_H
#define SCENE_FINGERPRINT_H

#include <stdint.h>

#include "scene/scene.h"

struct fingerprint {
    uint64_t objects;      /* shapes and their places */
    uint64_t textures;     /* with interiors */
    uint64_t lights;       /* but not what they look like */
    uint64_t surroundings; /* background, sky_sphere, fog */
    uint64_t kinds; /* what there is, and in which colours, wherever it is: the
                     * same in frames between which things move */
    size_t size;    /* shapes, and triangles of meshes: shared ones once */
};

/* Without `colours`, textures that nothing is seen through, background and
 * sky don't count: they change no shadow. */
struct fingerprint scene_fingerprint(const struct scene *scene, bool colours);

/* Whether both are of one scene. */
static inline bool fingerprint_same(const struct fingerprint *a,
                                    const struct fingerprint *b)
{
    return a->objects == b->objects && a->textures == b->textures &&
           a->lights == b->lights && a->surroundings == b->surroundings;
}

#endif
