/* One session with an editor: what it has opened, and what it is answered. */
#ifndef LANGUAGE_SERVER_H
#define LANGUAGE_SERVER_H

#include "language/evaluation.h"
#include "language/grammar.h"
#include "language/outline.h"
#include "language/wire.h"

/* A scene that is read as a whole: an open text that no other includes. */
struct root {
    struct root *next;
    struct page *page;
    struct evaluation *running, *done;
    bool stale;      /* it, or what it includes, changed since */
    json_t *remarks; /* URI to the list that the editor was told */
};

struct server {
    struct wire wire;
    struct library library;
    struct grammar *grammar;
    struct root *roots;
    struct evaluation *dying; /* told to stop; freed when they are over */
    json_t *queue;            /* messages that came and wait */
    int wake[2];              /* a pipe: an evaluation is over */
    bool initialized, shut, exits;
    bool changed; /* texts did, since the roots were told */
};

/* Errors of the protocol. */
enum {
    RPC_PARSE_ERROR = -32700,
    RPC_INVALID_REQUEST = -32600,
    RPC_METHOD_NOT_FOUND = -32601,
    RPC_INVALID_PARAMS = -32602,
    RPC_NOT_INITIALIZED = -32002,
    RPC_CANCELLED = -32800,
    RPC_FAILED = -32803,
};

/* What a request is answered; the caller's reference. NULL: null. A failure
 * sets *error, and *words to why. */
struct request {
    struct server *server;
    const json_t *params;
    struct arena *arena; /* until the answer is written */
    struct page *page;   /* of textDocument, where the method wants one */
    size_t offset;       /* of position */
    int error;
    const char *words;
};

/* Tells the editor something; the reference of `params` is taken. */
void server_notify(struct server *server, const char *name, json_t *params);

/* Answers one message, and frees it. */
void server_message(struct server *server, json_t *message);

/* Waits for messages and works until the editor ends the session. Returns the
 * exit status: 0 after a shutdown, else 1. */
int server_run(struct server *server);

/* roots.c: evaluations begin, end and are told. */
void roots_changed(struct server *server);
void roots_begin(struct server *server); /* when the editor is quiet */
void roots_collect(struct server *server);
void roots_close(struct server *server, const struct page *page);
/* False if an evaluation doesn't end soon: then all is left to the end of the
 * process. */
bool roots_free(struct server *server);
const struct meaning *roots_meaning(const struct server *server,
                                    const char *name);

/* One method in each: see methods.c. */
typedef json_t *method(struct request *request);
method completion_answer, completion_resolve, hover_answer, signature_answer,
    fixes_answer, definition_answer, references_answer, rename_answer,
    symbols_answer, folds_answer, colours_answer, presentation_answer,
    format_answer;

/* How places are written. */
json_t *json_range(struct stretch range);
struct place json_to_place(const json_t *json);
struct stretch json_to_range(const json_t *json);
const char *json_text(const json_t *object, const char *key);
json_t *json_markdown(const char *text);
/* A string of any bytes: what is no UTF-8 becomes '?'. */
json_t *json_words(const char *text, size_t length);

#endif
