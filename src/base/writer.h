/* A text that grows: for files that are written in one step (base/save.h). */
#ifndef BASE_WRITER_H
#define BASE_WRITER_H

#include "base/array.h"

struct writer {
    struct arena *arena;
    char *items;
    size_t count, capacity;
};

/* Empty; freed with writer_free. */
struct writer writer_new(void);
void writer_free(struct writer *writer);

void writer_add(struct writer *writer, const char *text, size_t length);

/* As printf. */
__attribute__((format(printf, 2, 3))) void
writer_print(struct writer *writer, const char *format, ...);

/* Saves the text; as save_bytes. */
bool writer_save(const struct writer *writer, const char *path, char *error,
                 size_t size);

#endif
