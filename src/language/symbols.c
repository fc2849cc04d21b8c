/* The outline of a text, and what of it can be folded. */
#include "language/describe.h"

enum { SYMBOL_FUNCTION = 12, SYMBOL_VARIABLE = 13, SYMBOL_OBJECT = 19 };

static size_t token_end(const struct page *page, size_t token)
{
    const struct token *at = &page->tokens->tokens[token];
    return at->offset + (size_t)at->length;
}

static json_t *symbol_json(const struct page *page, const char *name, int kind,
                           const char *detail, const size_t tokens[3])
{
    const struct token *list = page->tokens->tokens;
    size_t start = list[tokens[0]].offset, end = token_end(page, tokens[2]);
    size_t selected = list[tokens[1]].offset;
    return json_pack(
        "{s:s,s:i,s:o,s:o,s:o}", "name", name, "kind", kind, "detail",
        json_words(detail, strlen(detail)), "range",
        json_range(page_range(page, start, end)), "selectionRange",
        json_range(page_range(page, selected, token_end(page, tokens[1]))));
}

/* Blocks of the scene that have no name: `sphere {`. */
static void symbols_blocks(const struct page *page,
                           const struct outline *outline, json_t *list)
{
    const struct token *tokens = page->tokens->tokens;
    size_t name = 0;
    for (size_t i = 0; i < outline->folds.count; i++) {
        const struct fold *fold = &outline->folds.items[i];
        if (!fold->outermost || fold->first == 0 ||
            tokens[fold->first - 1].kind != TOKEN_WORD)
            continue;
        while (name < outline->names.count &&
               outline->names.items[name].last < fold->first)
            name++;
        if (name < outline->names.count &&
            outline->names.items[name].first < fold->first)
            continue;
        size_t places[] = { fold->first - 1, fold->first - 1, fold->last };
        json_array_append_new(
            list, symbol_json(page, tokens[fold->first - 1].word->text,
                              SYMBOL_OBJECT, "", places));
    }
}

json_t *symbols_answer(struct request *request)
{
    struct page *page = request->page;
    const struct outline *outline =
        page_outline(&request->server->library, page);
    json_t *list = json_array();
    for (size_t i = 0; i < outline->names.count; i++) {
        const struct name *name = &outline->names.items[i];
        bool macro = name->kind == NAME_MACRO;
        if (name->kind == NAME_PARAMETER || name->kind == NAME_LOOP)
            continue;
        size_t places[] = { name->first, name->token,
                            name->last < name->token ? name->token
                                                     : name->last };
        json_array_append_new(
            list, symbol_json(page, name->word->text,
                              macro ? SYMBOL_FUNCTION : SYMBOL_VARIABLE,
                              macro ? describe_macro(request->arena, name)
                                    : describe_value(request->server,
                                                     request->arena, name),
                              places));
    }
    symbols_blocks(page, outline, list);
    return list;
}

json_t *folds_answer(struct request *request)
{
    struct page *page = request->page;
    const struct outline *outline =
        page_outline(&request->server->library, page);
    const struct token *tokens = page->tokens->tokens;
    json_t *list = json_array();
    for (size_t i = 0; i < outline->folds.count; i++) {
        const struct fold *fold = &outline->folds.items[i];
        struct place first = page_place(page, tokens[fold->first].offset);
        struct place last = page_place(page, tokens[fold->last].offset);
        if (last.line > first.line)
            json_array_append_new(list,
                                  json_pack("{s:I,s:I}", "startLine",
                                            (json_int_t)first.line, "endLine",
                                            (json_int_t)(last.line - 1)));
    }
    return list;
}
