/* Looks through the finishes of a scene. */
#ifndef LIGHTING_FINISHES_H
#define LIGHTING_FINISHES_H

#include "scene/scene.h"

typedef bool finish_test(const struct finish *finish,
                         const struct settings *settings);

/* The first object with a finish that passes the test, or NULL. In scenes of
 * very many parts the last are not looked at. */
const struct object *finishes_find(const struct scene *scene,
                                   finish_test *test);

#endif
