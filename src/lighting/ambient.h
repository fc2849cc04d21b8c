/* For lighting methods without an ambient term. */
#ifndef LIGHTING_AMBIENT_H
#define LIGHTING_AMBIENT_H

#include "scene/scene.h"
#include "text/diag.h"

/* One warning if a finish of the scene has so much ambient light, which this
 * method drops, that it is meant to glow. */
void ambient_dropped(const struct scene *scene, const char *method,
                     struct diag *diag);

#endif
