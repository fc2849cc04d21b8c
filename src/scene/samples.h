/* Values of a function at some points of space: what tells it from others, from
 * one run to the next, where there is nothing else to compare. */
#ifndef SCENE_SAMPLES_H
#define SCENE_SAMPLES_H

#include "base/arena.h"
#include "base/field.h"

struct terms samples_take(struct arena *arena,
                          double (*value)(const void *thing, vec3 point),
                          const void *thing);

#endif
