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

/* How many words there are: ids are below it. */
unsigned word_count(const struct word_table *words);

/* The main spelling of a keyword. */
const char *keyword_spelling(enum keyword keyword);

/* Calls visit for each reserved word, in order of their ids ("did you
 * mean", --list). */
void word_table_visit(const struct word_table *words,
                      void (*visit)(void *context, const struct word *word),
                      void *context);

#endif
