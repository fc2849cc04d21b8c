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
};

/* Without `colours`, textures that nothing is seen through, background and
 * sky don't count: they change no shadow. */
struct fingerprint scene_fingerprint(const struct scene *scene, bool colours);

#endif
