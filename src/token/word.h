/* The table of words: interns spellings and knows the reserved ones. */
#ifndef TOKEN_WORD_H
#define TOKEN_WORD_H

#include "token/keyword.h"
#include "token/token.h"

struct word_table;

/* A table that holds every keyword, primitive and pattern name; in `arena`. */
struct word_table *word_table_new(struct arena *arena);

const struct word *word_intern(struct word_table *words, const char *text,
                               size_t length);

/* Calls visit for each reserved word, in alphabetical order ("did you
 * mean", --list). */
void word_table_visit(const struct word_table *words,
                      void (*visit)(void *context, const struct word *word),
                      void *context);

#endif
