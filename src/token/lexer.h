/* Text to tokens. */
#ifndef TOKEN_LEXER_H
#define TOKEN_LEXER_H

#include "token/token.h"
#include "token/word.h"

/* Never fails: bad bytes and unclosed strings become TOKEN_BAD, which is an
 * error only when something reads it (skipped branches may hold garbage).
 * Stops where the arena is over its limit: the caller asks that. */
const struct token_list *lexer_run(struct arena *arena,
                                   struct word_table *words,
                                   const struct source *source);

/* Only the text from `start` to `end`, which cuts no token. */
const struct token_list *lexer_run_part(struct arena *arena,
                                        struct word_table *words,
                                        const struct source *source,
                                        size_t start, size_t end);

#endif
