/* Where in the language a place of a text is, told from the tokens before it.
 */
#ifndef LANGUAGE_CONTEXT_H
#define LANGUAGE_CONTEXT_H

#include "language/page.h"

enum context_kind {
    CONTEXT_NOTHING,   /* a comment, a string, a number */
    CONTEXT_DIRECTIVE, /* the word behind a '#' */
    CONTEXT_FILE,      /* a string that names a file */
    CONTEXT_VALUE,     /* a number, vector, colour is wanted */
    CONTEXT_ITEM,      /* something new may begin */
    CONTEXT_NAME,      /* a name that is being given */
};

enum file_kind { FILE_INCLUDE, FILE_IMAGE, FILE_FONT };

/* A call or a block whose arguments the place is among. */
struct call {
    const struct word *name; /* NULL: none */
    bool block;              /* name { ... */
    unsigned argument;       /* which, from 0 */
};

struct context {
    enum context_kind kind;
    enum file_kind file;
    const char *block;          /* its keyword; NULL: outside of all */
    bool in_macro;              /* of which nobody knows where it is called */
    const struct word *keyword; /* reserved, right before; or NULL */
    bool declaring;             /* right behind a '=' of #declare */
    size_t prefix;              /* where the word begins that is written */
    size_t token;               /* the first at or behind the prefix */
    struct call call;
};

struct context context_at(struct library *library, struct page *page,
                          size_t offset);

/* The token that covers the offset, or ends there; false: none does. */
bool token_at(const struct token_list *list, size_t offset, size_t *token);

#endif
