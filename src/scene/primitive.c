/* The list of primitives: see primitive.h. */
#include "scene/primitive.h"

#include <string.h>

#define X(name) extern const struct primitive name##_primitive;
#include "scene/primitive/list.h"
#undef X

static const struct primitive *const primitives[] = {
#define X(name) &name##_primitive,
#include "scene/primitive/list.h"
#undef X
};

const struct primitive *primitive_at(size_t index)
{
    return index < sizeof primitives / sizeof *primitives ? primitives[index]
                                                          : NULL;
}

const struct primitive *primitive_find(const char *name)
{
    for (size_t i = 0; i < sizeof primitives / sizeof *primitives; i++)
        if (strcmp(primitives[i]->name, name) == 0)
            return primitives[i];
    return NULL;
}
