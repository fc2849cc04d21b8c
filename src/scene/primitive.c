/* The list of primitives: see primitive.h. */
#include "scene/primitive.h"

#include <string.h>

#include "base/listing.h"

#define X(name) extern const struct primitive name##_primitive;
#include "scene/primitive/list.h"
#undef X

static const struct primitive *const primitives[] = {
#define X(name) &name##_primitive,
#include "scene/primitive/list.h"
#undef X
};

const void *primitive_moved(struct arena *arena,
                            const struct primitive *primitive,
                            const void *shape, const affine *map)
{
    affine inward;
    if (!primitive->move || !affine_inverse(*map, &inward))
        return NULL;
    void *moved = arena_alloc(arena, primitive->size);
    memcpy(moved, shape, primitive->size);
    return primitive->move(moved, map, &inward) ? moved : NULL;
}

LISTING(primitive, primitive, primitives);
