/* Long plain data of meshes as one token each, where the tokens before say that
 * it may follow: cut one by one they would be most of the time and memory of
 * reading. What these are is said here; the lexer only asks. */
#ifndef TOKEN_BULK_H
#define TOKEN_BULK_H

#include "token/token.h"
#include "token/triangles.h"

/* Where a file is cut: kept from piece to piece. */
struct bulk {
    struct arena *arena;
    struct word_table *words;
    const char *end; /* of the text, a NUL */
    struct triangle_bench bench;
};

/* The data at `text`, which is no space, after the last of `count` tokens: in
 * *token its kind and value, in *length how far it reaches. False: it is to be
 * cut into ordinary tokens. */
bool bulk_cut(struct bulk *bulk, const struct token *tokens, size_t count,
              const char *text, struct token *token, size_t *length);

#endif
