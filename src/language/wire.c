/* Framing: see wire.h. */
#include "language/wire.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

#include "base/memory.h"

void wire_free(struct wire *wire)
{
    memory_free(wire->bytes);
}

bool wire_read(struct wire *wire)
{
    if (wire->capacity - wire->count < 65536) {
        wire->capacity = 2 * wire->capacity + 65536;
        wire->bytes = memory_resize(wire->bytes, wire->capacity);
    }
    ssize_t got;
    do
        got = read(wire->in, wire->bytes + wire->count,
                   wire->capacity - wire->count);
    while (got < 0 && errno == EINTR);
    if (got <= 0)
        return false;
    wire->count += (size_t)got;
    return true;
}

/* The length of the header with its empty line, 0: it isn't whole yet. */
static size_t wire_header(const struct wire *wire)
{
    for (size_t i = 3; i < wire->count && i < WIRE_HEADER_LIMIT; i++)
        if (memcmp(wire->bytes + i - 3, "\r\n\r\n", 4) == 0)
            return i + 1;
    return 0;
}

/* What Content-Length says, or -1. */
static long wire_length(const struct wire *wire, size_t header)
{
    static const char name[] = "Content-Length:";
    long length = -1;
    for (size_t at = 0; at < header;) {
        const char *line = wire->bytes + at;
        const char *end = memchr(line, '\n', header - at);
        char *rest;
        if ((size_t)(end - line) > sizeof name &&
            strncasecmp(line, name, sizeof name - 1) == 0) {
            length = strtol(line + sizeof name - 1, &rest, 10);
            if (rest == line + sizeof name - 1 || *rest != '\r')
                return -1;
        }
        at = (size_t)(end - wire->bytes) + 1;
    }
    return length;
}

enum wire_state wire_take(struct wire *wire, json_t **message,
                          const char **problem)
{
    size_t header = wire_header(wire);
    if (!header && wire->count < WIRE_HEADER_LIMIT)
        return WIRE_MORE;
    *problem = "a header of more than 4096 bytes";
    if (!header)
        return WIRE_BROKEN;
    long length = wire_length(wire, header);
    *problem = "a header without 'Content-Length: bytes'";
    if (length < 0)
        return WIRE_BROKEN;
    *problem = "a message of more than 256 MiB";
    if (length > WIRE_BODY_LIMIT)
        return WIRE_BROKEN;
    size_t size = header + (size_t)length;
    if (wire->count < size)
        return WIRE_MORE;
    *message = json_loadb(wire->bytes + header, (size_t)length,
                          JSON_ALLOW_NUL | JSON_DECODE_ANY, NULL);
    wire->count -= size;
    memmove(wire->bytes, wire->bytes + size, wire->count);
    return WIRE_MESSAGE;
}

static bool wire_put(struct wire *wire, const char *bytes, size_t count)
{
    while (count > 0) {
        ssize_t done = write(wire->out, bytes, count);
        if (done < 0 && errno == EINTR)
            continue;
        if (done <= 0)
            return false;
        bytes += done;
        count -= (size_t)done;
    }
    return true;
}

bool wire_write(struct wire *wire, json_t *message)
{
    char header[64];
    char *text = json_dumps(message, JSON_COMPACT);
    json_decref(message);
    if (!text)
        return true;
    size_t length = strlen(text);
    int size =
        snprintf(header, sizeof header, "Content-Length: %zu\r\n\r\n", length);
    bool done =
        wire_put(wire, header, (size_t)size) && wire_put(wire, text, length);
    free(text);
    return done;
}
