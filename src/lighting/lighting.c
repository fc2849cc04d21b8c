/* The list of lighting methods: see lighting.h. */
#include "lighting/lighting.h"

#include "base/listing.h"

#define X(name) extern const struct lighting name##_lighting;
#include "lighting/list.h"
#undef X

static const struct lighting *const lightings[] = {
#define X(name) &name##_lighting,
#include "lighting/list.h"
#undef X
};

LISTING(lighting, lighting, lightings);
