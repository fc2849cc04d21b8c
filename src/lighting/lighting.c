/* The list of lighting methods: see lighting.h. */
#include "lighting/lighting.h"

#include <string.h>

#define X(name) extern const struct lighting name##_lighting;
#include "lighting/list.h"
#undef X

static const struct lighting *const lightings[] = {
#define X(name) &name##_lighting,
#include "lighting/list.h"
#undef X
};

const struct lighting *lighting_at(size_t index)
{
    return index < sizeof lightings / sizeof *lightings ? lightings[index]
                                                        : NULL;
}

const struct lighting *lighting_find(const char *name)
{
    for (size_t i = 0; i < sizeof lightings / sizeof *lightings; i++)
        if (strcmp(lightings[i]->name, name) == 0)
            return lightings[i];
    return NULL;
}
