/* Lists of directories: see permit.h. */
#define _XOPEN_SOURCE 700
#include "text/permit.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"

struct permit_list *permits_begin(struct permits *permits, struct arena *arena,
                                  const char *where)
{
    struct permit_list *list = ARRAY_PUSH(arena, permits);
    *list = (struct permit_list){ .where = where };
    return list;
}

void permit_add(struct permit_list *list, struct arena *arena,
                const char *directory, bool below)
{
    char real[PATH_MAX];
    if (!realpath(directory, real))
        return;
    *ARRAY_PUSH(arena, list) =
        (struct permit){ arena_copy_text(arena, real, strlen(real)), below };
}

/* Both without links; the root alone ends in a slash. */
static bool permit_covers(const struct permit *permit, const char *directory)
{
    size_t length = strlen(permit->directory);
    if (length == 1)
        length = 0;
    if (strncmp(directory, permit->directory, length) != 0)
        return false;
    return directory[length] == '\0' ||
           (directory[length] == '/' &&
            (permit->below || directory[length + 1] == '\0'));
}

static const struct permit_list *denier(const struct permits *permits,
                                        const char *directory)
{
    for (size_t i = 0; i < permits->count; i++) {
        const struct permit_list *list = &permits->items[i];
        size_t k = 0;
        while (k < list->count && !permit_covers(&list->items[k], directory))
            k++;
        if (k == list->count)
            return list;
    }
    return NULL;
}

const struct permit_list *permits_denier_of(const struct permits *permits,
                                            const char *directory)
{
    char real[PATH_MAX];
    if (!permits || permits->count == 0)
        return NULL;
    return realpath(directory, real) ? denier(permits, real)
                                     : &permits->items[0];
}

const struct permit_list *permits_denier(const struct permits *permits,
                                         const char *path)
{
    char real[PATH_MAX];
    if (!permits || permits->count == 0)
        return NULL;
    if (!realpath(path, real))
        return &permits->items[0];
    char *slash = strrchr(real, '/');
    slash[slash == real] = '\0';
    return denier(permits, real);
}
