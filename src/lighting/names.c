/* Names to plug-ins: see names.h. */
#include "lighting/names.h"

#include "base/text.h"

/* A name that a scene says is shown there. */
static void names_unknown(struct diag *diag, struct span place,
                          const char *kind, const char *owner,
                          const struct text_nearest *nearest,
                          const char *instead)
{
    const char *type = nearest->best ? nearest->best : instead;
    if (place.source)
        diag_print(diag, DIAG_ERROR, place, type, "there is no %s '%s' of %s",
                   kind, nearest->word, owner);
    else
        diag_print(diag, DIAG_ERROR, place, NULL,
                   "there is no %s '%s' of %s: type %s", kind, nearest->word,
                   owner, type);
}

const struct interpolation *names_interpolation(const struct settings *settings,
                                                struct diag *diag)
{
    const char *name = settings->light_mesh.interpolation;
    const struct interpolation *found =
        name ? interpolation_find(name) : interpolation_at(0);
    if (found)
        return found;
    struct text_nearest nearest = text_nearest_start(name);
    for (size_t i = 0; interpolation_at(i); i++)
        text_nearest_try(&nearest, interpolation_at(i)->name);
    names_unknown(diag, settings->light_mesh.interpolation_place,
                  "interpolation", "light meshes", &nearest,
                  interpolation_at(0)->name);
    return NULL;
}

const struct heuristic *names_heuristic(const struct settings *settings,
                                        struct diag *diag)
{
    const char *name = settings->skeleton.heuristic;
    const struct heuristic *found =
        name ? heuristic_find(name) : heuristic_at(0);
    if (found)
        return found;
    struct text_nearest nearest = text_nearest_start(name);
    for (size_t i = 0; heuristic_at(i); i++)
        text_nearest_try(&nearest, heuristic_at(i)->name);
    names_unknown(diag, settings->skeleton.heuristic_place, "heuristic",
                  "skeletons", &nearest, heuristic_at(0)->name);
    return NULL;
}

bool names_good(const struct settings *settings, struct diag *diag)
{
    bool good = names_interpolation(settings, diag);
    return names_heuristic(settings, diag) && good;
}
