/* Sources: see source.h. */
#include "text/source.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static const char *source_skip_bom(const char *text, size_t *length)
{
    if (*length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) {
        *length -= 3;
        return text + 3;
    }
    return text;
}

/* Reads to the end of the stream: pipes have no size to ask for. `expected`
 * is a guess that saves moving what was read. The text ends in NUL. */
static char *source_slurp(struct arena *arena, FILE *file, size_t expected,
                          size_t *length, const char **problem)
{
    size_t capacity = expected + 1, used = 0;
    char *text = arena_alloc(arena, capacity + 1);
    for (;;) {
        used += fread(text + used, 1, capacity - used, file);
        if (used < capacity || capacity > SOURCE_LIMIT)
            break;
        char *larger = arena_alloc(arena, 2 * capacity + 1);
        memcpy(larger, text, used);
        text = larger;
        capacity *= 2;
    }
    *length = used;
    if (ferror(file))
        *problem = arena_printf(arena, "%s", strerror(errno));
    else if (used > SOURCE_LIMIT)
        *problem = "it is larger than 1 GiB, glim's limit for a text";
    else
        return text;
    return NULL;
}

const struct source *source_read(struct arena *arena, const char *path,
                                 struct span included_from,
                                 const char **problem)
{
    bool standard_input = strcmp(path, "-") == 0;
    struct stat status = { .st_size = 0 };
    if (!standard_input && stat(path, &status) == 0 &&
        S_ISDIR(status.st_mode)) {
        *problem = "it is a directory";
        return NULL;
    }
    size_t expected = 1 << 16;
    if (S_ISREG(status.st_mode) && status.st_size > 0 &&
        (size_t)status.st_size <= SOURCE_LIMIT)
        expected = (size_t)status.st_size;
    FILE *file = standard_input ? stdin : fopen(path, "rb");
    if (!file) {
        *problem = arena_printf(arena, "%s", strerror(errno));
        return NULL;
    }
    size_t length = 0;
    const char *text = source_slurp(arena, file, expected, &length, problem);
    if (!standard_input)
        fclose(file);
    if (!text)
        return NULL;
    struct source *source = ARENA_NEW(arena, struct source);
    source->name =
        standard_input ? "<stdin>" : arena_copy_text(arena, path, strlen(path));
    source->text = source_skip_bom(text, &length);
    source->length = length;
    source->included_from = included_from;
    return source;
}

const struct source *source_from_text(struct arena *arena, const char *name,
                                      const char *text)
{
    struct source *source = ARENA_NEW(arena, struct source);
    source->name = arena_copy_text(arena, name, strlen(name));
    source->length = strlen(text);
    source->text = arena_copy_text(arena, text, source->length);
    return source;
}

static bool source_line_ends(const struct source *source, size_t i)
{
    char c = source->text[i];
    return c == '\n' || (c == '\r' && source->text[i + 1] != '\n');
}

struct source_place source_locate(const struct source *source, size_t offset)
{
    struct source_place place = { .line = 1 };
    if (offset > source->length)
        offset = source->length;
    for (size_t i = 0; i < offset; i++) {
        if (source_line_ends(source, i)) {
            place.line++;
            place.line_start = i + 1;
        }
    }
    place.column = (unsigned)(offset - place.line_start) + 1;
    place.line_end = offset;
    while (place.line_end < source->length &&
           source->text[place.line_end] != '\n' &&
           source->text[place.line_end] != '\r')
        place.line_end++;
    return place;
}

struct span span_none(void)
{
    return (struct span){ NULL, 0, 0 };
}

struct span span_join(struct span first, struct span last)
{
    if (first.source != last.source || last.offset < first.offset)
        return first;
    first.length = last.offset + last.length - first.offset;
    return first;
}
