/* What glim.5 says of a word. The page's own source is a part of the program:
 * there is no other text to keep. */
#ifndef LANGUAGE_MANUAL_H
#define LANGUAGE_MANUAL_H

#include "base/arena.h"

/* Markdown, in the arena: what the manual says of a word where it stands in
 * `block` (NULL: outside of all); or NULL. */
const char *manual_text(struct arena *arena, const char *word,
                        const char *block);

/* How a function is called, "pow(a, b)", and what it does; or NULL. */
const char *manual_function(struct arena *arena, const char *word,
                            const char **help);

#endif
