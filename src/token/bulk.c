/* See bulk.h. */
#include "token/bulk.h"

/* vertex_vectors { ... } and the other lists of a mesh2. */
static bool word_begins_numbers(const struct word *word)
{
    return word->keyword == KEYWORD_VERTEX_VECTORS ||
           word->keyword == KEYWORD_NORMAL_VECTORS ||
           word->keyword == KEYWORD_FACE_INDICES ||
           word->keyword == KEYWORD_NORMAL_INDICES;
}

/* mesh { and then triangles, or more of them. */
static bool triangles_follow(const struct token *end, size_t count)
{
    if (end[-1].kind == TOKEN_TRIANGLES)
        return true;
    return count > 1 && end[-1].kind == TOKEN_LBRACE &&
           end[-2].kind == TOKEN_WORD && end[-2].word->keyword == KEYWORD_MESH;
}

bool bulk_cut(struct bulk *bulk, const struct token *tokens, size_t count,
              const char *text, struct token *token, size_t *length)
{
    if (count == 0)
        return false;
    const struct token *end = tokens + count;
    if (*text == '{' && end[-1].kind == TOKEN_WORD &&
        word_begins_numbers(end[-1].word)) {
        token->kind = TOKEN_NUMBERS;
        token->numbers =
            numbers_cut(bulk->arena, text, (size_t)(bulk->end - text), length);
        return token->numbers != NULL;
    }
    if ((*text == 't' || *text == 's') && triangles_follow(end, count)) {
        token->kind = TOKEN_TRIANGLES;
        token->triangles =
            triangles_cut(bulk->arena, bulk->words, &bulk->bench, text, length);
        return token->triangles != NULL;
    }
    return false;
}
