/* Field tables: see field.h. */
#include "base/field.h"

#include <stdio.h>
#include <string.h>

const struct field *field_find(const struct field *table, const char *name)
{
    for (; table && table->name; table++)
        if (strcmp(table->name, name) == 0)
            return table;
    return NULL;
}

int field_choice(const struct field *field, const char *word)
{
    for (int i = 0; field->choices[i]; i++)
        if (strcmp(field->choices[i], word) == 0)
            return i;
    return -1;
}

void field_choices(const struct field *field, char *text, size_t size)
{
    size_t length = 0;
    text[0] = '\0';
    for (int i = 0; field->choices[i] && length < size; i++)
        length += (size_t)snprintf(text + length, size - length, "%s'%s'",
                                   i ? " or " : "", field->choices[i]);
}

static size_t field_size(const struct field *field)
{
    switch (field->kind) {
    case FIELD_FLOAT:
        return sizeof(double);
    case FIELD_INTEGER:
    case FIELD_CHOICE:
        return sizeof(int);
    case FIELD_BOOL:
    case FIELD_FLAG:
        return sizeof(bool);
    case FIELD_NAME:
        return sizeof(const char *);
    default:
        return 0;
    }
}

void field_copy(const struct field *field, void *to, const void *from)
{
    memcpy((char *)to + field->offset, (const char *)from + field->offset,
           field_size(field));
}
