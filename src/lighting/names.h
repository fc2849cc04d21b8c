/* What a scene or an option chose by name among the plug-ins of light meshes
 * and of skeletons. */
#ifndef LIGHTING_NAMES_H
#define LIGHTING_NAMES_H

#include "lightmesh/interpolation.h"
#include "scene/scene.h"
#include "skeleton/heuristic.h"
#include "text/diag.h"

/* The one that is named, or the default if none is; NULL after an error. */
const struct interpolation *names_interpolation(const struct settings *settings,
                                                struct diag *diag);
const struct heuristic *names_heuristic(const struct settings *settings,
                                        struct diag *diag);

/* Whether both can be found, whatever method is to use them; after an error
 * false. */
bool names_good(const struct settings *settings, struct diag *diag);

#endif
