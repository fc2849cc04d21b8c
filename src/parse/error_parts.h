/* What the files that word the errors of a scene share. */
#ifndef PARSE_ERROR_PARTS_H
#define PARSE_ERROR_PARTS_H

#include "base/text.h"
#include "parse/parser.h"

/* Longer words are not told of. */
enum { ERROR_WORD_MAX = 40 };

/* Whether an error at the next token would not be printed: asked before its
 * words are looked for, since that is slow and a loop can come by often. */
bool error_is_silent(struct parser *p);

/* Whether the rule that was reported last has not read on since: what is
 * missing now is missing because of that. */
bool error_follows(struct parser *p);

/* The text of the next token as written, cut to a readable length. */
const char *error_found(struct parser *p);

/* Tries the names of fields; NULL: there are none. */
void error_try_fields(struct text_nearest *nearest, const struct field *fields);

/* What the next token names, "a texture"; NULL: nothing. */
const char *error_kind(struct parser *p);

/* If the next word, which isn't declared, is so further on in the file: reports
 * it. */
bool error_below(struct parser *p, const struct word *name);

/* The word read last, and how long it is; NULL: it was none. */
const char *error_last_word(const struct parser *p, int *length);

/* The same if it names a value of that kind. */
const char *error_last_value(struct parser *p, enum value_kind kind,
                             int *length);

#endif
