/* What a scene needs to show anything, and may have been forgotten. */
#ifndef LIGHTING_MISSING_H
#define LIGHTING_MISSING_H

#include "scene/scene.h"
#include "text/diag.h"

/* Warns if there is no camera, and if there is nothing to see or nothing that
 * gives light; `lights` and `objects`: how many there are of light sources and
 * of shapes. */
void missing_tell(const struct scene *scene, size_t lights, size_t objects,
                  struct diag *diag);

#endif
