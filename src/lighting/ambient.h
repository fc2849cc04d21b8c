/* For scenes whose sky takes the place of ambient light. */
#ifndef LIGHTING_AMBIENT_H
#define LIGHTING_AMBIENT_H

#include "scene/scene.h"
#include "text/diag.h"

/* One warning if a finish of the scene has so much ambient light, which is
 * dropped, that it is meant to glow. */
void ambient_dropped(const struct scene *scene, struct diag *diag);

#endif
