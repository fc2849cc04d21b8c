/* The words of the language, for who lists or explains them: tables of the
 * parser that nobody else may keep a copy of. */
#ifndef PARSE_WORDS_H
#define PARSE_WORDS_H

#include <stddef.h>

/* The built-in function number `index`, in order of the alphabet, or NULL. */
const char *parse_function_at(size_t index);

/* The word behind the '#' of directive number `index`, and its help; NULL past
 * the last. */
const char *parse_directive_word(size_t index, const char **help);

/* What the field table of a block says of one of its words; NULL: it has no
 * table, or not that word. `block` NULL: outside of all. */
const char *parse_field_help(const char *block, const char *word);

#endif
