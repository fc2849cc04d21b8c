/* Scenes that are read as a whole, one at a time, when the editor is quiet; and
 * what the editor is told of them. */
#include "language/remarks.h"
#include "language/server.h"

#include "base/memory.h"

void roots_changed(struct server *server)
{
    server->changed = true;
    for (struct root *root = server->roots; root; root = root->next)
        if (root->running)
            atomic_store(&root->running->stop, 1);
}

static struct root *root_of(const struct server *server,
                            const struct page *page)
{
    for (struct root *root = server->roots; root; root = root->next)
        if (root->page == page)
            return root;
    return NULL;
}

/* Whether another open text includes this one, and is not included by it. */
static bool page_is_included(struct server *server, struct page *page)
{
    struct arena *arena = arena_new(0);
    bool included = false;
    for (struct page *other = server->library.pages; other && !included;
         other = other->next) {
        struct page_list below = { 0 }, back = { 0 };
        if (!other->open || other == page)
            continue;
        pages_below(&server->library, other, arena, &below);
        bool has = false, returns = false;
        for (size_t i = 0; i < below.count; i++)
            has |= below.items[i] == page;
        if (has)
            pages_below(&server->library, page, arena, &back);
        for (size_t i = 0; i < back.count; i++)
            returns |= back.items[i] == other;
        included = has && !returns;
    }
    arena_free(arena);
    return included;
}

/* The lists of all roots for one text, as one. */
static void roots_tell(struct server *server, const char *uri)
{
    json_t *all = json_array();
    for (struct root *root = server->roots; root; root = root->next)
        json_array_extend(all, json_object_get(root->remarks, uri));
    server_notify(server, "textDocument/publishDiagnostics",
                  json_pack("{s:s,s:o}", "uri", uri, "diagnostics", all));
}

/* Other remarks than before, whose reference is taken; those of texts that
 * have none any more are told too. */
static void root_tell(struct server *server, struct root *root, json_t *remarks)
{
    json_t *before = root->remarks;
    const char *uri;
    json_t *list;
    root->remarks = remarks;
    json_object_foreach(before, uri, list) if (!json_object_get(remarks, uri))
        roots_tell(server, uri);
    json_object_foreach(remarks, uri, list) roots_tell(server, uri);
    json_decref(before);
}

/* Nobody waits for it: what it is in the midst of may take long. */
static void root_abandon(struct server *server, struct root *root)
{
    struct evaluation *running = root->running;
    root->running = NULL;
    if (!running)
        return;
    atomic_store(&running->stop, 1);
    running->next = server->dying;
    server->dying = running;
}

static void roots_bury(struct server *server)
{
    struct evaluation **link = &server->dying;
    while (*link) {
        struct evaluation *dead = *link;
        if (!atomic_load(&dead->over)) {
            link = &dead->next;
            continue;
        }
        *link = dead->next;
        evaluation_free(dead);
    }
}

static void root_remove(struct server *server, struct root *root)
{
    struct root **link = &server->roots;
    root_abandon(server, root);
    root_tell(server, root, json_object());
    while (*link != root)
        link = &(*link)->next;
    *link = root->next;
    evaluation_free(root->done);
    json_decref(root->remarks);
    memory_free(root);
}

void roots_close(struct server *server, const struct page *page)
{
    struct root *root = root_of(server, page);
    if (root)
        root_remove(server, root);
}

bool roots_free(struct server *server)
{
    while (server->roots) {
        struct root *root = server->roots;
        server->roots = root->next;
        root_abandon(server, root);
        evaluation_free(root->done);
        json_decref(root->remarks);
        memory_free(root);
    }
    roots_bury(server);
    return !server->dying;
}

static void roots_renew(struct server *server)
{
    for (struct page *page = server->library.pages; page; page = page->next) {
        if (!page->open)
            continue;
        bool included = page_is_included(server, page);
        struct root *root = root_of(server, page);
        if (included && root)
            root_remove(server, root);
        else if (!included && !root) {
            root = memory_new(sizeof *root);
            root->page = page;
            root->remarks = json_object();
            root->next = server->roots;
            server->roots = root;
        }
    }
    for (struct root *root = server->roots; root; root = root->next)
        root->stale = true;
}

static void roots_next(struct server *server)
{
    for (struct root *root = server->roots; root; root = root->next)
        if (root->running)
            return;
    for (struct root *root = server->roots; root; root = root->next) {
        if (!root->stale)
            continue;
        root->stale = false;
        root->running =
            evaluation_start(&server->library, root->page, server->wake[1]);
        if (root->running)
            return;
    }
}

void roots_begin(struct server *server)
{
    server->changed = false;
    roots_renew(server);
    roots_next(server);
}

/* One that was cancelled tells nothing. */
static void root_collect(struct server *server, struct root *root)
{
    struct evaluation *evaluation = root->running;
    root->running = NULL;
    evaluation_finish(evaluation);
    bool cancelled = server->changed || root->stale;
    if (cancelled && !evaluation->late) {
        evaluation_free(evaluation);
        return;
    }
    evaluation_free(root->done);
    root->done = evaluation;
    root_tell(server, root, remarks_json(server, root));
}

void roots_collect(struct server *server)
{
    roots_bury(server);
    for (struct root *root = server->roots; root; root = root->next)
        if (root->running && atomic_load(&root->running->over))
            root_collect(server, root);
    if (!server->changed)
        roots_next(server);
}

const struct meaning *roots_meaning(const struct server *server,
                                    const char *name)
{
    for (const struct root *root = server->roots; root; root = root->next) {
        const struct meaning *meaning = evaluation_meaning(root->done, name);
        if (meaning)
            return meaning;
    }
    return NULL;
}
