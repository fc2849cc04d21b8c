/* The functions of functions.inc by number: see internal.h. */
#include "scene/internal.h"

#include <stddef.h>

const struct internal_function *internal_find(int number)
{
    static const struct internal_function *const tables[] = {
        internal_algebraic, internal_shapes, internal_noises
    };
    for (size_t i = 0; i < sizeof tables / sizeof *tables; i++)
        for (const struct internal_function *f = tables[i]; f->arguments; f++)
            if (f->number == number)
                return f;
    return NULL;
}
