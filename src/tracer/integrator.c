/* The list of integrators: see integrator.h. */
#include "tracer/integrator.h"

#include <string.h>

#define X(name) extern const struct integrator name##_integrator;
#include "tracer/integrator/list.h"
#undef X

static const struct integrator *const integrators[] = {
#define X(name) &name##_integrator,
#include "tracer/integrator/list.h"
#undef X
};

enum { INTEGRATORS = sizeof integrators / sizeof *integrators };

const struct integrator *integrator_for(const struct lighting *lighting)
{
    for (size_t i = 0; i < INTEGRATORS; i++)
        if (integrators[i]->own == lighting)
            return integrators[i];
    return integrators[0];
}

const struct lighting *integrator_lighting_at(size_t index)
{
    size_t count = 0;
    while (lighting_at(count))
        count++;
    if (index < count)
        return lighting_at(index);
    for (size_t i = 0; i < INTEGRATORS; i++)
        if (integrators[i]->own && count++ == index)
            return integrators[i]->own;
    return NULL;
}

const struct lighting *integrator_lighting_find(const char *name)
{
    const struct lighting *lighting;
    for (size_t i = 0; (lighting = integrator_lighting_at(i)); i++)
        if (strcmp(lighting->name, name) == 0)
            return lighting;
    return NULL;
}
