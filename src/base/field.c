/* Field tables: see field.h. */
#include "base/field.h"

#include <string.h>

const struct field *field_find(const struct field *table, const char *name)
{
    for (; table && table->name; table++)
        if (strcmp(table->name, name) == 0)
            return table;
    return NULL;
}
