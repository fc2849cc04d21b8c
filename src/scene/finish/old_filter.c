/* How a filter counts in scenes before 3.7: what the last #version said. */
#include "scene/finish.h"

static const struct field fields[] = {
    FINISH_FIELD("filter of old scenes", FIELD_FLAG, old_filter, NULL),
    { NULL },
};

const struct finish_item old_filter_finish = {
    .name = "old filter",
    .fields = fields,
};
