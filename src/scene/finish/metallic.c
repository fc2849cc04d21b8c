/* metallic: highlights in the pigment's colour. */
#include "scene/finish.h"

static const struct field fields[] = {
    FINISH_FIELD("metallic", FIELD_FLOAT, metallic,
                 "how much highlights have the pigment's colour, 0; alone 1"),
    { NULL },
};

const struct finish_item metallic_finish = {
    .name = "metallic",
    .fields = fields,
};
