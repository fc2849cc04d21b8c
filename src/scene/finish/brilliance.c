/* brilliance: how diffuse light depends on where it comes from. */
#include "scene/finish.h"

static const struct field fields[] = {
    FINISH_FIELD("brilliance", FIELD_FLOAT, brilliance,
                 "exponent of the cosine of diffuse light, 1"),
    { NULL },
};

const struct finish_item brilliance_finish = {
    .name = "brilliance",
    .fields = fields,
};
