/* A text that grows: see writer.h. */
#include "base/writer.h"

#include <stdarg.h>
#include <stdio.h>

#include "base/save.h"

struct writer writer_new(void)
{
    return (struct writer){ .arena = arena_new(0) };
}

void writer_free(struct writer *writer)
{
    arena_free(writer->arena);
}

void writer_add(struct writer *writer, const char *text, size_t length)
{
    if (writer->count + length > writer->capacity)
        ARRAY_RESERVE(writer->arena, writer, 2 * (writer->count + length));
    if (length > 0)
        memcpy(writer->items + writer->count, text, length);
    writer->count += length;
}

void writer_print(struct writer *writer, const char *format, ...)
{
    char text[256];
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    if (length >= (int)sizeof text)
        length = (int)sizeof text - 1;
    writer_add(writer, text, length > 0 ? (size_t)length : 0);
}

bool writer_save(const struct writer *writer, const char *path, char *error,
                 size_t size)
{
    return save_bytes(path, writer->items, writer->count, error, size);
}
