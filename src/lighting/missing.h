/* What a scene needs to show anything, and may have been forgotten. */
#ifndef LIGHTING_MISSING_H
#define LIGHTING_MISSING_H

#include "scene/scene.h"
#include "text/diag.h"

/* Warns if there is no camera, and if nothing gives light; `lights`: how many
 * light sources there are. */
void missing_tell(const struct scene *scene, size_t lights, struct diag *diag);

#endif
