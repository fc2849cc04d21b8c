/* What is told of a word: for hovering, and beside a completion. */
#ifndef LANGUAGE_DESCRIBE_H
#define LANGUAGE_DESCRIBE_H

#include "language/server.h"

/* Of a reserved word, in Markdown; never NULL. */
const char *describe_keyword(struct server *server, struct arena *arena,
                             const struct word *word, const char *block);

/* "a colour, rgb <1, 0.5, 0>"; what the text alone tells, if it was not
 * evaluated. */
const char *describe_value(struct server *server, struct arena *arena,
                           const struct name *name);

/* "M(a, b)" */
const char *describe_macro(struct arena *arena, const struct name *macro);

/* The comment right above a declaration, its signs left out; or NULL. */
const char *describe_comment(struct arena *arena, struct page *page,
                             const struct name *name);

/* The declaration that a word at a token means, in the page or in what is
 * around it; or NULL. */
const struct name *describe_find(struct server *server, struct arena *arena,
                                 struct page *page, const struct word *word,
                                 size_t token, struct page **where);

#endif
