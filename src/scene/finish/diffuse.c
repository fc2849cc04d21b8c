/* diffuse (kd): what a surface scatters. */
#include "scene/finish.h"

static const struct field fields[] = {
    FINISH_FIELD(
        "diffuse", FIELD_FLOAT, diffuse,
        "share of light that is scattered (kd), 0.6; of light from behind, 0"),
    FINISH_FIELD("diffuse of light from behind", FIELD_FLOAT, diffuse_back,
                 NULL),
    FINISH_FIELD("diffuse sent on to surfaces", FIELD_FLOAT, returned_most,
                 NULL),
    FINISH_FIELD("diffuse albedo", FIELD_FLAG, diffuse_albedo, NULL),
    { NULL },
};

const struct finish_item diffuse_finish = {
    .name = "diffuse",
    .fields = fields,
};
