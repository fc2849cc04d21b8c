/* The session: see server.h. Messages are taken off the wire before they are
 * answered, so that one that is cancelled while it waits is never begun. */
#include "language/server.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <unistd.h>

enum { QUIET = 20 }; /* milliseconds without a message: the scene is read */

static void server_write(struct server *server, json_t *message)
{
    json_object_set_new(message, "jsonrpc", json_string("2.0"));
    if (!wire_write(&server->wire, message))
        server->exits = true;
}

static void server_fail(struct server *server, const json_t *id, int code,
                        const char *words)
{
    json_t *message =
        json_pack("{s:{s:i,s:s}}", "error", "code", code, "message", words);
    json_object_set_new(message, "id", id ? json_deep_copy(id) : json_null());
    server_write(server, message);
}

void server_notify(struct server *server, const char *name, json_t *params)
{
    server_write(server,
                 json_pack("{s:s,s:o}", "method", name, "params", params));
}

/* ---- texts ---- */

static void text_opened(struct server *server, const json_t *params)
{
    const json_t *document = json_object_get(params, "textDocument");
    const json_t *text = json_object_get(document, "text");
    const char *uri = json_text(document, "uri");
    if (!uri || !json_is_string(text))
        return;
    page_add(&server->library, uri, json_string_value(text),
             json_string_length(text));
    roots_changed(server);
}

static void text_changed(struct server *server, const json_t *params)
{
    const char *uri = json_text(json_object_get(params, "textDocument"), "uri");
    struct page *page = uri ? page_open(&server->library, uri) : NULL;
    const json_t *changes = json_object_get(params, "contentChanges");
    for (size_t i = 0; page && i < json_array_size(changes); i++) {
        const json_t *change = json_array_get(changes, i);
        const json_t *text = json_object_get(change, "text");
        const json_t *range = json_object_get(change, "range");
        const char *words = json_string_value(text);
        if (words && json_is_object(range))
            page_edit(page, json_to_range(range), words,
                      json_string_length(text));
        else if (words)
            page_replace(page, words, json_string_length(text));
    }
    roots_changed(server);
}

static void text_closed(struct server *server, const json_t *params)
{
    const char *uri = json_text(json_object_get(params, "textDocument"), "uri");
    struct page *page = uri ? page_open(&server->library, uri) : NULL;
    if (!page)
        return;
    roots_close(server, page);
    page_remove(&server->library, page);
    roots_changed(server);
}

static void text_saved(struct server *server, const json_t *params)
{
    (void)params;
    roots_changed(server);
}

/* ---- methods ---- */

static const struct {
    const char *name;
    method *answer;
    bool placed; /* it has a position */
} methods[] = {
    { "textDocument/completion", completion_answer, true },
    { "textDocument/hover", hover_answer, true },
    { "textDocument/signatureHelp", signature_answer, true },
    { "textDocument/codeAction", fixes_answer, false },
    { "textDocument/definition", definition_answer, true },
    { "textDocument/references", references_answer, true },
    { "textDocument/rename", rename_answer, true },
    { "textDocument/documentSymbol", symbols_answer, false },
    { "textDocument/foldingRange", folds_answer, false },
    { "textDocument/documentColor", colours_answer, false },
    { "textDocument/colorPresentation", presentation_answer, false },
    { "textDocument/formatting", format_answer, false },
    { "completionItem/resolve", completion_resolve, false },
};

static const struct {
    const char *name;
    void (*hear)(struct server *server, const json_t *params);
} notices[] = {
    { "textDocument/didOpen", text_opened },
    { "textDocument/didChange", text_changed },
    { "textDocument/didClose", text_closed },
    { "textDocument/didSave", text_saved },
    { "workspace/didChangeWatchedFiles", text_saved },
};

static json_t *server_initialize(void)
{
    static const char *const providers[] = {
        "hoverProvider",  "definitionProvider",         "referencesProvider",
        "renameProvider", "documentSymbolProvider",     "foldingRangeProvider",
        "colorProvider",  "documentFormattingProvider",
    };
    json_t *can = json_pack(
        "{s:{s:b,s:i,s:b},s:{s:[s,s,s],s:b},s:{s:[s,s]},s:{s:[s]},s:s}",
        "textDocumentSync", "openClose", 1, "change", 2, "save", 1,
        "completionProvider", "triggerCharacters", "#", "\"", "/",
        "resolveProvider", 1, "signatureHelpProvider", "triggerCharacters", "(",
        ",", "codeActionProvider", "codeActionKinds", "quickfix",
        "positionEncoding", "utf-16");
    for (size_t i = 0; i < sizeof providers / sizeof *providers; i++)
        json_object_set_new(can, providers[i], json_true());
    return json_pack("{s:o,s:{s:s,s:s}}", "capabilities", can, "serverInfo",
                     "name", "glim", "version", GLIM_VERSION);
}

static bool request_place(struct request *request, bool placed)
{
    const json_t *params = request->params;
    const char *uri = json_text(json_object_get(params, "textDocument"), "uri");
    request->page = uri ? page_open(&request->server->library, uri) : NULL;
    if (!request->page)
        return false;
    const json_t *position = json_object_get(params, "position");
    if (placed && !json_is_object(position))
        return false;
    request->offset = page_offset(request->page, json_to_place(position));
    return true;
}

static void server_answer(struct server *server, const json_t *id,
                          struct request *request, json_t *result)
{
    if (request->error) {
        json_decref(result);
        server_fail(server, id, request->error, request->words);
        return;
    }
    json_t *message =
        json_pack("{s:o}", "result", result ? result : json_null());
    json_object_set_new(message, "id", json_deep_copy(id));
    server_write(server, message);
}

static void server_request(struct server *server, const char *name,
                           const json_t *id, const json_t *params)
{
    struct request request = { .server = server, .params = params };
    if (strcmp(name, "shutdown") == 0) {
        server->shut = true;
        server_answer(server, id, &request, NULL);
        return;
    }
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        if (strcmp(methods[i].name, name) != 0)
            continue;
        bool document = strncmp(name, "textDocument/", 13) == 0;
        if (document && !request_place(&request, methods[i].placed)) {
            server_fail(server, id, RPC_INVALID_PARAMS,
                        "the text is not open, or no position is given");
            return;
        }
        request.arena = arena_new(0);
        json_t *result = methods[i].answer(&request);
        server_answer(server, id, &request, result);
        arena_free(request.arena);
        return;
    }
    server_fail(server, id, RPC_METHOD_NOT_FOUND, "glim has no such method");
}

static void server_notice(struct server *server, const char *name,
                          const json_t *params)
{
    if (strcmp(name, "exit") == 0)
        server->exits = true;
    for (size_t i = 0; server->initialized && !server->shut &&
                       i < sizeof notices / sizeof *notices;
         i++)
        if (strcmp(notices[i].name, name) == 0)
            notices[i].hear(server, params);
}

void server_message(struct server *server, json_t *message)
{
    const char *name = json_text(message, "method");
    const json_t *id = json_object_get(message, "id");
    const json_t *params = json_object_get(message, "params");
    bool answer =
        json_object_get(message, "result") || json_object_get(message, "error");
    if (!json_is_object(message) || (!name && !answer)) {
        server_fail(server, id, RPC_INVALID_REQUEST, "this is no request");
    } else if (!name) {
        json_decref(message); /* answers to what glim never asks */
        return;
    } else if (!id) {
        server_notice(server, name, params);
    } else if (strcmp(name, "initialize") == 0 && !server->initialized) {
        struct request request = { .server = server };
        server->initialized = true;
        server_answer(server, id, &request, server_initialize());
    } else if (!server->initialized) {
        server_fail(server, id, RPC_NOT_INITIALIZED,
                    "'initialize' comes first");
    } else if (server->shut || strcmp(name, "initialize") == 0) {
        server_fail(server, id, RPC_INVALID_REQUEST,
                    server->shut ? "the server was shut down"
                                 : "'initialize' comes once");
    } else {
        server_request(server, name, id, params);
    }
    json_decref(message);
}

/* ---- the loop ---- */

/* Takes a request off the queue that waits there. */
static void server_cancel(struct server *server, const json_t *message)
{
    const json_t *id =
        json_object_get(json_object_get(message, "params"), "id");
    size_t i;
    json_t *waiting;
    json_array_foreach(server->queue, i, waiting)
    {
        const json_t *other = json_object_get(waiting, "id");
        if (!id || !other || !json_equal(id, other) ||
            !json_text(waiting, "method"))
            continue;
        server_fail(server, id, RPC_CANCELLED, "cancelled");
        json_array_remove(server->queue, i);
        return;
    }
}

/* All whole messages that came. False: what came is no protocol. */
static bool server_take(struct server *server)
{
    for (;;) {
        json_t *message = NULL;
        const char *problem;
        enum wire_state state = wire_take(&server->wire, &message, &problem);
        if (state == WIRE_MORE)
            return true;
        if (state == WIRE_BROKEN) {
            fprintf(stderr,
                    "glim: error: standard input is not the Language Server "
                    "Protocol: %s\n",
                    problem);
            return false;
        }
        const char *name = json_text(message, "method");
        if (!message) {
            server_fail(server, NULL, RPC_PARSE_ERROR, "this is no JSON");
        } else if (name && strcmp(name, "$/cancelRequest") == 0) {
            server_cancel(server, message);
            json_decref(message);
        } else {
            json_array_append_new(server->queue, message);
        }
    }
}

/* Waits for messages, the end of an evaluation, or quiet. False at the end of
 * the input. */
static bool server_wait(struct server *server)
{
    char wakes[64];
    bool waiting = json_array_size(server->queue) > 0;
    struct pollfd files[] = { { .fd = server->wire.in, .events = POLLIN },
                              { .fd = server->wake[0], .events = POLLIN } };
    int ready = poll(files, 2, waiting ? 0 : server->changed ? QUIET : -1);
    if (ready < 0)
        return errno == EINTR;
    if (ready == 0 && !waiting)
        roots_begin(server);
    if (files[1].revents && read(server->wake[0], wakes, sizeof wakes) > 0)
        roots_collect(server);
    return !files[0].revents ||
           (wire_read(&server->wire) && server_take(server));
}

int server_run(struct server *server)
{
    if (pipe(server->wake) != 0) {
        fprintf(stderr, "glim: error: the system gives no pipe\n");
        return 1;
    }
    fcntl(server->wake[0], F_SETFL, O_NONBLOCK);
    fcntl(server->wake[1], F_SETFL, O_NONBLOCK);
    server->queue = json_array();
    bool open = true;
    while (!server->exits && (open || json_array_size(server->queue) > 0)) {
        open = open && server_wait(server);
        if (json_array_size(server->queue) == 0)
            continue;
        json_t *message = json_incref(json_array_get(server->queue, 0));
        json_array_remove(server->queue, 0);
        server_message(server, message);
    }
    int status = server->shut ? 0 : 1;
    if (!roots_free(server))
        _exit(status);
    json_decref(server->queue);
    return status;
}
