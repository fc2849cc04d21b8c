/* reflection (ks): mirrors. */
#include "scene/finish.h"

static const struct field inner[] = {
    FINISH_FIELD("mirrored at right angles", FIELD_RGB, reflection.minimum,
                 NULL),
    FINISH_FIELD("mirrored at grazing angles", FIELD_RGB, reflection.maximum,
                 NULL),
    FINISH_FIELD("falloff", FIELD_FLOAT, reflection.falloff,
                 "exponent of the change from minimum to maximum, 1"),
    FINISH_FIELD("exponent", FIELD_FLOAT, reflection.exponent,
                 "reflected light is raised to 1/exponent, 1"),
    FINISH_FIELD("metallic reflection", FIELD_FLOAT, reflection.metallic, NULL),
    FINISH_FIELD("fresnel", FIELD_BOOL, reflection.fresnel,
                 "the change follows the interior's ior"),
    { NULL },
};

const struct finish_item reflection_finish = {
    .name = "reflection",
    .inner = inner,
};
