/* crand: grain, a random part of diffuse light that is lost. */
#include "scene/finish.h"

static const struct field fields[] = {
    FINISH_FIELD("crand", FIELD_FLOAT, crand, "grain, 0"),
    { NULL },
};

const struct finish_item crand_finish = {
    .name = "crand",
    .fields = fields,
};
