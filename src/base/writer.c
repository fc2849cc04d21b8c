/* A text that grows: see writer.h. */
#include "base/writer.h"

#include <stdarg.h>
#include <stdio.h>

#include "base/memory.h"
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
    char few[256], *text = few;
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    int length = vsnprintf(few, sizeof few, format, arguments);
    va_end(arguments);
    if (length >= (int)sizeof few) {
        text = memory_new((size_t)length + 1);
        vsnprintf(text, (size_t)length + 1, format, again);
    }
    va_end(again);
    writer_add(writer, text, length > 0 ? (size_t)length : 0);
    if (text != few)
        memory_free(text);
}

bool writer_save(const struct writer *writer, const char *path, char *error,
                 size_t size)
{
    return save_bytes(path, writer->items, writer->count, error, size);
}
