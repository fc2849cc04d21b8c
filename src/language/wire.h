/* Messages as the Language Server Protocol frames them: header lines, an empty
 * line, as many bytes of JSON as Content-Length says. */
#ifndef LANGUAGE_WIRE_H
#define LANGUAGE_WIRE_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

enum {
    WIRE_HEADER_LIMIT = 4096,    /* bytes of a header */
    WIRE_BODY_LIMIT = 256 << 20, /* bytes of a message */
};

struct wire {
    int in, out; /* file descriptors */
    char *bytes; /* that were read and not taken yet */
    size_t count, capacity;
};

enum wire_state { WIRE_MORE, WIRE_MESSAGE, WIRE_BROKEN };

void wire_free(struct wire *wire);

/* Reads what is there, waiting for it. False at the end of the input. */
bool wire_read(struct wire *wire);

/* Takes the next message, if it is whole: its JSON in *message, NULL if it is
 * none. WIRE_BROKEN: the input is no protocol; *problem says why. */
enum wire_state wire_take(struct wire *wire, json_t **message,
                          const char **problem);

/* Writes a message, whose reference is taken. False if nobody reads. */
bool wire_write(struct wire *wire, json_t *message);

#endif
