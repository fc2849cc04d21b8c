/* Tokens: see token.h. */
#include "token/token.h"

struct span token_span(const struct token_list *list, size_t index)
{
    const struct token *token = &list->tokens[index];
    return (struct span){ list->source, token->offset, token->length };
}

const char *token_kind_name(enum token_kind kind)
{
    switch (kind) {
    case TOKEN_END:
        return "the end of the file";
    case TOKEN_NUMBER:
        return "a number";
    case TOKEN_STRING:
        return "a string";
    case TOKEN_WORD:
        return "a word";
    case TOKEN_DIRECTIVE:
        return "a directive";
    case TOKEN_NUMBERS:
        return "a list of vectors";
    case TOKEN_TRIANGLES:
        return "triangles";
    case TOKEN_BAD:
        return "an illegal character";
#define X(name, spelling)                                                      \
    case TOKEN_##name:                                                         \
        return "'" spelling "'";
        TOKEN_PUNCTUATION(X)
#undef X
    }
    return "a token";
}
