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

static size_t field_wide(enum field_kind kind)
{
    switch (kind) {
    case FIELD_VECTOR2:
    case FIELD_PAIR:
        return 2;
    case FIELD_VECTOR:
    case FIELD_RGB:
        return 3;
    case FIELD_VECTOR5:
    case FIELD_COLOUR:
        return 5;
    default:
        return 0;
    }
}

static double field_number(const struct field *field, const void *at)
{
    int whole;
    double number;
    switch (field->kind) {
    case FIELD_FLOAT:
        memcpy(&number, at, sizeof number);
        return number;
    case FIELD_INTEGER:
    case FIELD_CHOICE:
        memcpy(&whole, at, sizeof whole);
        return whole;
    default:
        return *(const bool *)at;
    }
}

size_t field_numbers(const struct field *table, const void *values,
                     enum field_width width, double *out)
{
    size_t count = 0;
    for (; table->name; table++) {
        const char *at = (const char *)values + table->offset;
        size_t wide = field_wide(table->kind);
        if (table->dark || (width == FIELDS_NARROW && wide) ||
            (width == FIELDS_WIDE && !wide))
            continue;
        if (wide)
            memcpy(&out[count], at, wide * sizeof *out);
        else
            out[count] = field_number(table, at);
        count += wide ? wide : 1;
    }
    return count;
}
