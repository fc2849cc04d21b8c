/* Errors inside POV-Ray's own include files, which nobody means to mend: they
 * are shown at the user's line that led there. */
#include "parse/stream.h"

static bool source_is_library(const struct parser *p,
                              const struct source *source)
{
    const char *const *path = p->options->standard_paths;
    for (; path && *path; path++) {
        size_t length = strlen(*path);
        if (strncmp(source->name, *path, length) == 0 &&
            source->name[length] == '/')
            return true;
    }
    return false;
}

struct span library_user(struct parser *p, struct span span)
{
    if (!span.source || !source_is_library(p, span.source))
        return span;
    for (const struct cursor *c = p->cursor; c; c = c->below)
        if (c->called_at.source && !source_is_library(p, c->called_at.source))
            return c->called_at;
    return span;
}
