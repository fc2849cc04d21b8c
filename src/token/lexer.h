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

#endif
