/* The list of interpolations: see interpolation.h. */
#include "lightmesh/interpolation.h"

#include <string.h>

#define X(name) extern const struct interpolation name##_interpolation;
#include "lightmesh/interpolation/list.h"
#undef X

static const struct interpolation *const interpolations[] = {
#define X(name) &name##_interpolation,
#include "lightmesh/interpolation/list.h"
#undef X
};

const struct interpolation *interpolation_at(size_t index)
{
    return index < sizeof interpolations / sizeof *interpolations
               ? interpolations[index]
               : NULL;
}

const struct interpolation *interpolation_find(const char *name)
{
    for (size_t i = 0; interpolation_at(i); i++)
        if (strcmp(interpolations[i]->name, name) == 0)
            return interpolations[i];
    return NULL;
}
