/* emission (the Emiss of the light-mesh paper), and what ambient light becomes
 * that is meant to glow. */
#include "scene/finish.h"

static const struct field fields[] = {
    FINISH_FIELD("emission", FIELD_RGB, emission,
                 "light of its own (Emiss), 0"),
    FINISH_FIELD("glow of ambient", FIELD_RGB, glow, NULL),
    { NULL },
};

const struct finish_item emission_finish = {
    .name = "emission",
    .fields = fields,
};
