/* The list of lighting methods: see lighting.h. */
#include "lighting/lighting.h"

#include "base/listing.h"
#include "scene/scene.h"

#define X(name) extern const struct lighting name##_lighting;
#include "lighting/list.h"
#undef X

static const struct lighting *const lightings[] = {
#define X(name) &name##_lighting,
#include "lighting/list.h"
#undef X
};

LISTING(lighting, lighting, lightings);

const struct lighting *lighting_for(const struct lighting *chosen,
                                    const struct scene *scene)
{
    bool literal = scene->settings.light_mesh.model == MESH_MODEL_SCALAR;
    return chosen == &mesh_lighting && literal ? &paper_lighting : chosen;
}

const struct lighting_view *lighting_view(const struct lighting *lighting,
                                          const char *name)
{
    const struct lighting_view *view = lighting->views;
    for (; view && view->name; view++)
        if (strcmp(view->name, name) == 0)
            return view;
    return NULL;
}
