/* Looks for finishes that glow by ambient light: see ambient.h. */
#include "lighting/ambient.h"

#include "lighting/finishes.h"

static bool ambient_glows(const struct finish *finish,
                          const struct settings *settings)
{
    return finish_is_to_glow(finish, settings->ambient_light);
}

void ambient_dropped(const struct scene *scene, struct diag *diag)
{
    const struct object *found = finishes_find(scene, ambient_glows);
    if (found)
        diag_print(diag, DIAG_WARNING, found->span,
                   "finish { emission 1 ambient 0 }",
                   "there is no ambient light where sky and background light "
                   "the scene; to make this glow write 'emission'");
}
