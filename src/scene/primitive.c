/* The list of primitives: see primitive.h. */
#include "scene/primitive.h"

#include "base/listing.h"

#define X(name) extern const struct primitive name##_primitive;
#include "scene/primitive/list.h"
#undef X

static const struct primitive *const primitives[] = {
#define X(name) &name##_primitive,
#include "scene/primitive/list.h"
#undef X
};

LISTING(primitive, primitive, primitives);
