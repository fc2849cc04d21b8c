/* What scenes older than 3.1 say here of the interior; the parser gives it
 * that. */
#include "scene/finish.h"

static const struct field fields[] = {
    FINISH_FIELD("ior of old scenes", FIELD_FLOAT, ior, NULL),
    { "caustics of old scenes", FIELD_FLOAT, offsetof(struct finish, caustics),
      .dark = "the interior has it" },
    { NULL },
};

const struct finish_item old_interior_finish = {
    .name = "old interior",
    .fields = fields,
};
