/* subsurface: light that goes in, and comes out beside (tracer/subsurface.h).
 */
#include "scene/finish.h"

static const struct field inner[] = {
    { "translucency", FIELD_RGB, offsetof(struct finish, translucency), 0,
      HUGE_VAL, "how far light goes within, mm" },
    { NULL },
};

const struct finish_item subsurface_finish = {
    .name = "subsurface",
    .inner = inner,
};
