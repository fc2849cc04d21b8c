/* Characters that word processors and web pages put where others are meant:
 * curly quotes, long dashes, blanks that don't break. */
#ifndef TOKEN_LOOKALIKE_H
#define TOKEN_LOOKALIKE_H

#include <stdbool.h>
#include <stddef.h>

#include "token/token.h"

struct lookalike {
    const char *bytes;    /* in UTF-8 */
    const char *meant;    /* what the keyboard has */
    enum token_kind kind; /* TOKEN_END: a blank; TOKEN_STRING: a quote */
};

/* The one that the text begins with, or NULL. */
const struct lookalike *lookalike_find(const char *text);

/* Bytes of the string in curly quotes that begins here, quotes included: they
 * are *open and *close long. 0: it does not end in this line. */
size_t lookalike_string(const char *text, size_t *open, size_t *close);

#endif
