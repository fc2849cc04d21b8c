/* The list of interpolations: see interpolation.h. */
#include "lightmesh/interpolation.h"

#include "base/listing.h"

#define X(name) extern const struct interpolation name##_interpolation;
#include "lightmesh/interpolation/list.h"
#undef X

static const struct interpolation *const interpolations[] = {
#define X(name) &name##_interpolation,
#include "lightmesh/interpolation/list.h"
#undef X
};

LISTING(interpolation, interpolation, interpolations);
