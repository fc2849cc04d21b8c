/* Hovering: what the word under the pointer is. */
#include "language/context.h"
#include "language/describe.h"

static const char *hover_name(struct request *request, const struct word *word,
                              size_t token)
{
    struct page *where;
    struct arena *arena = request->arena;
    const struct name *name = describe_find(request->server, arena,
                                            request->page, word, token, &where);
    if (!name)
        return NULL;
    const char *comment = describe_comment(arena, where, name);
    const char *value =
        name->kind == NAME_MACRO
            ? arena_printf(arena, "```\n#macro %s\n```",
                           describe_macro(arena, name))
            : arena_printf(arena, "**%s**: %s", word->text,
                           describe_value(request->server, arena, name));
    return arena_printf(arena, "%s%s%s", value, comment ? "\n\n" : "",
                        comment ? comment : "");
}

json_t *hover_answer(struct request *request)
{
    struct library *library = &request->server->library;
    const struct token_list *list = page_tokens(library, request->page);
    size_t at;
    if (!token_at(list, request->offset, &at))
        return NULL;
    const struct token *token = &list->tokens[at];
    if (token->kind != TOKEN_WORD && token->kind != TOKEN_DIRECTIVE)
        return NULL;
    struct context context = context_at(library, request->page, token->offset);
    const char *text = token->word->reserved
                           ? describe_keyword(request->server, request->arena,
                                              token->word, context.block)
                           : hover_name(request, token->word, at);
    if (!text)
        return NULL;
    return json_pack(
        "{s:o,s:o}", "contents", json_markdown(text), "range",
        json_range(page_range(request->page, token->offset,
                              token->offset + (size_t)token->length)));
}
