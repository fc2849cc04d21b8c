/* See missing.h. */
#include "lighting/missing.h"

#include "lighting/finishes.h"

/* As much ambient light as finishes have anyway is no lamp's. */
static bool finish_gives_light(const struct finish *finish,
                               const struct settings *settings)
{
    rgb usual = finish_default().ambient;
    rgb ambient = rgb_mul(finish->ambient, settings->ambient_light);
    return rgb_peak(finish->emission) > 0 || rgb_peak(finish->glow) > 0 ||
           rgb_peak(ambient) > rgb_peak(usual);
}

/* Whether what is behind all objects is black. */
static bool scene_is_void(const struct scene *scene)
{
    return !scene->sky && scene->fogs.count == 0 &&
           rgb_peak(colour_rgb(scene->background)) == 0;
}

void missing_tell(const struct scene *scene, size_t lights, size_t objects,
                  struct diag *diag)
{
    if (!scene->camera_said)
        diag_print(diag, DIAG_WARNING, span_none(),
                   "camera { location <0, 1, -5> look_at 0 }",
                   "no camera: it is at <0, 0, 0> and looks along z");
    if (objects == 0 && scene_is_void(scene))
        diag_print(diag, DIAG_WARNING, span_none(),
                   "sphere { 0, 1 pigment { rgb 1 } }",
                   "the picture is black: there is no object in this scene");
    else if (lights == 0 && scene_is_void(scene) &&
             !finishes_find(scene, finish_gives_light))
        diag_print(diag, DIAG_WARNING, span_none(),
                   "light_source { <10, 20, -10> rgb 1 }",
                   "nothing gives light in this scene");
}
