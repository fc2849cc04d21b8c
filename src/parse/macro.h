/* Macros: text with parameters. */
#ifndef PARSE_MACRO_H
#define PARSE_MACRO_H

#include "parse/parser.h"

/* Whether the word is a macro's name now. */
bool macro_is_call(struct parser *p, const struct word *word);

/* Reads the arguments of a call, whose name was taken, and puts the body on
 * the stream. False after an error. */
bool macro_call(struct parser *p, const struct word *word, struct span at);

#endif
