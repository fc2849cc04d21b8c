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
                struct permit permit)
{
    char real[PATH_MAX];
    if (!realpath(permit.directory, real))
        return;
    permit.directory = arena_copy_text(arena, real, strlen(real));
    *ARRAY_PUSH(arena, list) = permit;
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

/* Where a file is: the directory it is named in, and that of what a link
 * leads to. */
struct whereabouts {
    char named[PATH_MAX], real[PATH_MAX];
};

static const struct permit_list *denier(const struct permits *permits,
                                        const struct whereabouts *at)
{
    for (size_t i = 0; i < permits->count; i++) {
        const struct permit_list *list = &permits->items[i];
        size_t k = 0;
        while (k < list->count &&
               !permit_covers(&list->items[k],
                              list->items[k].links ? at->named : at->real))
            k++;
        if (k == list->count)
            return list;
    }
    return NULL;
}

/* "/a/b" to "/a", "b" to "." */
static void cut_last(char *path)
{
    char *slash = strrchr(path, '/');
    if (slash)
        slash[slash == path] = '\0';
    else
        strcpy(path, ".");
}

const struct permit_list *permits_denier_of(const struct permits *permits,
                                            const char *directory)
{
    struct whereabouts at;
    if (!permits || permits->count == 0)
        return NULL;
    if (!realpath(directory, at.real))
        return &permits->items[0];
    strcpy(at.named, at.real);
    return denier(permits, &at);
}

const struct permit_list *permits_denier(const struct permits *permits,
                                         const char *path)
{
    struct whereabouts at;
    char folder[PATH_MAX];
    if (!permits || permits->count == 0)
        return NULL;
    if (strlen(path) >= sizeof folder || !realpath(path, at.real))
        return &permits->items[0];
    cut_last(at.real);
    strcpy(folder, path);
    cut_last(folder);
    return realpath(folder, at.named) ? denier(permits, &at)
                                      : &permits->items[0];
}

/* NULL: all users' homes are there, or everything. */
static const char *folder_above(const char *folder, struct arena *arena)
{
    char real[PATH_MAX];
    if (!realpath(folder, real))
        return NULL;
    char *slash = strrchr(real, '/');
    *slash = '\0';
    return strrchr(real, '/') > real
               ? arena_copy_text(arena, real, strlen(real))
               : NULL;
}

void permit_beside(struct permit_list *list, struct arena *arena,
                   const char *folder)
{
    const char *above = list->above ? folder_above(folder, arena) : NULL;
    permit_add(list, arena,
               (struct permit){ above ? above : folder, true, false });
}
