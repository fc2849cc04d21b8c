/* From a name to where it is declared and used, over includes and macros. */
#include <ctype.h>
#include <unistd.h>

#include "language/context.h"
#include "language/describe.h"

static json_t *token_location(struct page *page, size_t token)
{
    const struct token *at = &page->tokens->tokens[token];
    return json_pack("{s:s,s:o}", "uri", page->uri, "range",
                     json_range(page_range(page, at->offset,
                                           at->offset + (size_t)at->length)));
}

/* The name at the place; NULL: there is none. */
static const struct word *word_at(struct request *request, size_t *token)
{
    const struct token_list *list =
        page_tokens(&request->server->library, request->page);
    if (!token_at(list, request->offset, token))
        return NULL;
    const struct token *found = &list->tokens[*token];
    bool name = found->kind == TOKEN_WORD && !found->word->reserved;
    return name ? found->word : NULL;
}

/* Where an #include leads. */
static json_t *definition_file(struct request *request)
{
    struct library *library = &request->server->library;
    const struct outline *outline = page_outline(library, request->page);
    const struct token *tokens = request->page->tokens->tokens;
    for (size_t i = 0; i < outline->includes.count; i++) {
        const struct token *name = &tokens[outline->includes.items[i].token];
        bool here = request->offset >= name->offset &&
                    request->offset <= name->offset + (size_t)name->length;
        const char *path =
            here ? library_find(library, request->arena, request->page,
                                outline->includes.items[i].name)
                 : NULL;
        struct page *page = path ? page_of_file(library, path) : NULL;
        if (page)
            return json_pack("{s:s,s:o}", "uri", page->uri, "range",
                             json_range(page_range(page, 0, 0)));
    }
    return NULL;
}

json_t *definition_answer(struct request *request)
{
    size_t token;
    struct page *where;
    const struct word *word = word_at(request, &token);
    if (!word)
        return definition_file(request);
    const struct name *name = describe_find(request->server, request->arena,
                                            request->page, word, token, &where);
    return name ? token_location(where, name->token) : NULL;
}

/* ---- all uses ---- */

/* A place where the name is used; `page` is where. */
typedef void use_visit(void *context, struct page *page, size_t token);

static bool name_is_inner(const struct name *name)
{
    return name && (name->kind == NAME_PARAMETER ||
                    (name->kind == NAME_LOCAL && name->unseen > 0));
}

/* Uses in one page of a name that is global (`inner` NULL), or of that one. */
static void page_uses(struct library *library, struct page *page,
                      const struct word *word, const struct name *inner,
                      use_visit *visit, void *context)
{
    const struct outline *outline = page_outline(library, page);
    const struct token_list *list = page->tokens;
    for (size_t at = 0; at + 1 < list->count; at++) {
        const struct token *token = &list->tokens[at];
        if (token->kind != TOKEN_WORD || token->word != word)
            continue;
        const struct name *meant = outline_name(outline, word, at);
        if (inner ? meant && meant->first == inner->first &&
                        meant->kind == inner->kind
                  : !name_is_inner(meant) || meant->unseen + 1 >= list->count)
            visit(context, page, at);
    }
}

static void name_uses(struct request *request, const struct word *word,
                      const struct name *name, struct page *where,
                      use_visit *visit, void *context)
{
    struct library *library = &request->server->library;
    struct page_list list = { 0 };
    if (name->kind == NAME_PARAMETER) {
        page_uses(library, where, word, name, visit, context);
        return;
    }
    pages_around(library, request->page, request->arena, &list);
    for (size_t i = 0; i < list.count; i++)
        page_uses(library, list.items[i], word, NULL, visit, context);
}

struct references {
    json_t *list;
    const struct name *name;
    struct page *where;
    bool declaration; /* it counts too */
};

static void reference_add(void *context, struct page *page, size_t token)
{
    struct references *r = context;
    if (r->declaration || page != r->where || token != r->name->token)
        json_array_append_new(r->list, token_location(page, token));
}

json_t *references_answer(struct request *request)
{
    size_t token;
    struct page *where;
    const struct word *word = word_at(request, &token);
    const struct name *name =
        word ? describe_find(request->server, request->arena, request->page,
                             word, token, &where)
             : NULL;
    if (!name)
        return NULL;
    const json_t *context = json_object_get(request->params, "context");
    struct references references = { json_array(), name, where,
                                     json_is_true(json_object_get(
                                         context, "includeDeclaration")) };
    name_uses(request, word, name, where, reference_add, &references);
    return references.list;
}

/* ---- renaming ---- */

struct renaming {
    json_t *changes;
    const char *name;
    const char *locked; /* a file that can't be written */
};

static void rename_add(void *context, struct page *page, size_t token)
{
    struct renaming *r = context;
    const struct token *at = &page->tokens->tokens[token];
    json_t *list = json_object_get(r->changes, page->uri);
    if (!page->open && access(page->path, W_OK) != 0)
        r->locked = page->path;
    if (!list) {
        list = json_array();
        json_object_set_new(r->changes, page->uri, list);
    }
    json_array_append_new(
        list, json_pack("{s:o,s:s}", "range",
                        json_range(page_range(page, at->offset,
                                              at->offset + (size_t)at->length)),
                        "newText", r->name));
}

static json_t *request_fail(struct request *request, int code,
                            const char *words)
{
    request->error = code;
    request->words = words;
    return NULL;
}

static bool name_can_be(const char *name)
{
    bool begins = isalpha((unsigned char)*name) || *name == '_';
    while (isalnum((unsigned char)*name) || *name == '_')
        name++;
    return begins && !*name;
}

json_t *rename_answer(struct request *request)
{
    size_t token;
    struct page *where;
    struct arena *arena = request->arena;
    const char *name = json_text(request->params, "newName");
    const struct word *word = word_at(request, &token);
    const struct name *declared =
        word ? describe_find(request->server, arena, request->page, word, token,
                             &where)
             : NULL;
    if (!declared)
        return request_fail(request, RPC_FAILED,
                            "this is no name that the scene declares");
    if (!name || !name_can_be(name))
        return request_fail(request, RPC_INVALID_PARAMS,
                            "a name is made of letters, digits and '_', and "
                            "begins with no digit");
    if (word_intern(request->server->library.words, name, strlen(name))
            ->reserved)
        return request_fail(
            request, RPC_INVALID_PARAMS,
            arena_printf(arena, "'%s' is a reserved word", name));
    struct page *other;
    if (describe_find(
            request->server, arena, request->page,
            word_intern(request->server->library.words, name, strlen(name)),
            token, &other))
        return request_fail(
            request, RPC_FAILED,
            arena_printf(arena, "'%s' is declared already", name));
    struct renaming renaming = { json_object(), name, NULL };
    name_uses(request, word, declared, where, rename_add, &renaming);
    if (!renaming.locked)
        return json_pack("{s:o}", "changes", renaming.changes);
    json_decref(renaming.changes);
    return request_fail(request, RPC_FAILED,
                        arena_printf(arena,
                                     "it is used in '%s', which can't be "
                                     "written",
                                     renaming.locked));
}
