/* Looks for finishes that glow by ambient light: see ambient.h. */
#include "lighting/ambient.h"

#include "lighting/finishes.h"

/* Most ambient light stands for that of other surfaces, which the method finds
 * by itself. More than finishes have anyway, and than they would scatter in
 * surroundings half as bright as white: then the surface is to glow. */
static bool ambient_glows(const struct finish *finish,
                          const struct settings *settings)
{
    double ambient =
        rgb_peak(rgb_mul(finish->ambient, settings->ambient_light));
    return ambient > rgb_peak(finish_default().ambient) &&
           ambient > 0.5 * finish->diffuse;
}

void ambient_dropped(const struct scene *scene, const char *method,
                     struct diag *diag)
{
    const struct object *found = finishes_find(scene, ambient_glows);
    if (found)
        diag_print(diag, DIAG_WARNING, found->span, NULL,
                   "'--lighting %s' has no ambient light: for surfaces that "
                   "glow, write 'emission' in place of 'ambient'",
                   method);
}
