/* conserve_energy: of a layer that mirrors. */
#include "scene/finish.h"

static const struct field fields[] = {
    FINISH_FIELD("conserve_energy", FIELD_FLAG, conserve_energy,
                 "what is reflected is not transmitted"),
    { NULL },
};

const struct finish_item conserve_energy_finish = {
    .name = "conserve_energy",
    .fields = fields,
};
