/* Sources: see source.h. */
#include "text/source.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool source_is_utf16(const char *text, size_t length)
{
    return length >= 2 && (memcmp(text, "\xff\xfe", 2) == 0 ||
                           memcmp(text, "\xfe\xff", 2) == 0);
}

static const char *source_skip_bom(const char *text, size_t *length)
{
    if (*length >= 3 && memcmp(text, "\xef\xbb\xbf", 3) == 0) {
        *length -= 3;
        return text + 3;
    }
    return text;
}

/* How long, in milliseconds, to wait for somebody to write into a pipe. */
enum { PIPE_PATIENCE = 3000, PIPE_STEP = 50 };

/* Bytes of room for what has no size: of files that say they are empty most
 * are, but not those of /proc. */
enum { UNSIZED = 1 << 16, EMPTY = 1 << 10 };

/* As read(). A pipe is open without blocking: nobody writes into it when there
 * is nothing (0), its writer has nothing to say yet when that would block. */
static ssize_t source_bytes(int file, char *to, size_t room, bool fresh_pipe)
{
    struct pollfd wait = { .fd = file, .events = POLLIN };
    for (int waited = 0;; waited += PIPE_STEP) {
        ssize_t count = read(file, to, room);
        if (count < 0 && errno == EAGAIN) {
            if (poll(&wait, 1, -1) < 0)
                return -1;
        } else if (count != 0 || !fresh_pipe) {
            return count;
        } else if (waited >= PIPE_PATIENCE) {
            errno = EPIPE;
            return -1;
        } else if (poll(NULL, 0, PIPE_STEP) < 0) {
            return -1;
        }
    }
}

static const char *source_problem(struct arena *arena)
{
    if (errno == EPIPE)
        return "it is a pipe that nobody writes into";
    return arena_printf(arena, "%s", strerror(errno));
}

/* Reads to the end: pipes have no size to ask for. `expected` is a guess that
 * saves moving what was read. The text ends in NUL. */
static char *source_slurp(struct arena *arena, int file, size_t expected,
                          bool pipe, size_t *length, const char **problem)
{
    size_t capacity = expected + 1, used = 0;
    char *text = arena_alloc(arena, capacity + 1);
    for (;;) {
        ssize_t count =
            source_bytes(file, text + used, capacity - used, pipe && used == 0);
        if (count < 0)
            *problem = source_problem(arena);
        else if (used + (size_t)count > SOURCE_LIMIT)
            *problem = "it is larger than 1 GiB, glim's limit for a text";
        if (count < 0 || used + (size_t)count > SOURCE_LIMIT)
            return NULL;
        used += (size_t)count;
        *length = used;
        if (count == 0)
            return text;
        if (used < capacity)
            continue;
        char *larger = arena_alloc(arena, 2 * capacity + 1);
        memcpy(larger, text, used);
        text = larger;
        capacity *= 2;
    }
}

const struct source *source_read(struct arena *arena, const char *path,
                                 struct span included_from,
                                 const char **problem)
{
    bool standard_input = strcmp(path, "-") == 0;
    int file = standard_input ? STDIN_FILENO
                              : open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    struct stat status;
    if (file < 0 || fstat(file, &status) != 0) {
        *problem = source_problem(arena);
        return NULL;
    }
    size_t expected = UNSIZED, length = 0;
    if (S_ISREG(status.st_mode) && (size_t)status.st_size <= SOURCE_LIMIT)
        expected = status.st_size > 0 ? (size_t)status.st_size : EMPTY;
    bool pipe = !standard_input && S_ISFIFO(status.st_mode);
    const char *text = NULL;
    if (S_ISDIR(status.st_mode))
        *problem = "it is a directory";
    else
        text = source_slurp(arena, file, expected, pipe, &length, problem);
    if (!standard_input)
        close(file);
    if (text && source_is_utf16(text, length)) {
        *problem = "it is UTF-16: keep it as UTF-8 or ASCII";
        return NULL;
    }
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
