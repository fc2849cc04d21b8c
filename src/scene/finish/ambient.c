/* ambient: light from everywhere. */
#include "scene/finish.h"

static const struct field fields[] = {
    FINISH_FIELD("ambient", FIELD_RGB, ambient,
                 "times ambient_light: light from everywhere, 0.1"),
    { NULL },
};

const struct finish_item ambient_finish = {
    .name = "ambient",
    .fields = fields,
};
