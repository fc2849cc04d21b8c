/* For lighting methods without an ambient term. */
#ifndef LIGHTING_AMBIENT_H
#define LIGHTING_AMBIENT_H

#include "scene/scene.h"
#include "text/diag.h"

/* One warning if a finish of the scene asks for ambient light, other than what
 * finishes have by themselves, that this method drops. */
void ambient_dropped(const struct scene *scene, const char *method,
                     struct diag *diag);

#endif
