/* Where a scene's files are found: POV-Ray's rule, which does not look beside
 * the file that includes. */
#include <dirent.h>
#include <sys/stat.h>

#include "base/text.h"
#include "parse/parser.h"

static bool file_exists(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0;
}

static const char *file_search(struct parser *p, const char *name)
{
    const struct parse_options *options = p->options;
    if (file_exists(name))
        return name;
    for (size_t i = 0; name[0] != '/' && i < options->include_path_count; i++) {
        const char *path =
            arena_printf(p->arena, "%s/%s", options->include_paths[i], name);
        if (file_exists(path))
            return path;
    }
    return NULL;
}

static bool file_has_extension(const char *name)
{
    const char *slash = strrchr(name, '/');
    return strchr(slash ? slash : name, '.') != NULL;
}

const char *file_locate(struct parser *p, const char *name,
                        const char *extension)
{
    const char *path = *name ? file_search(p, name) : NULL;
    if (path || !extension || file_has_extension(name))
        return path;
    return file_search(p, arena_printf(p->arena, "%s%s", name, extension));
}

const char *file_find(struct parser *p, const char *name, const char *extension)
{
    const char *path = file_locate(p, name, extension);
    return path && !permits_denier(p->options->permits, path) ? path : NULL;
}

const char *file_need(struct parser *p, struct span span, const char *what,
                      const char *name, const char *extension)
{
    const char *path = file_locate(p, name, extension);
    const struct permit_list *denier =
        path ? permits_denier(p->options->permits, path) : NULL;
    if (!path)
        error_at(p, span, file_hint(p, name), "can't find the %s '%s'", what,
                 name);
    else if (denier)
        error_at(p, span,
                 arena_printf(p->arena,
                              "%s forbids it; +LDIR permits what is "
                              "in DIR",
                              denier->where),
                 "this scene may not read '%s'", path);
    return denier ? NULL : path;
}

/* Tries the names in directory `place`, and those in its part `folder`. */
static void file_try_names(struct parser *p, const char *place,
                           const char *folder, struct text_nearest *nearest)
{
    const char *name = arena_printf(p->arena, "%s/%s", place, folder);
    DIR *directory =
        permits_denier_of(p->options->permits, name) ? NULL : opendir(name);
    struct dirent *entry;
    while (directory && (entry = readdir(directory)) != NULL)
        text_nearest_try(nearest, arena_printf(p->arena, "%s", entry->d_name));
    if (directory)
        closedir(directory);
}

const char *file_hint(struct parser *p, const char *name)
{
    const struct parse_options *options = p->options;
    const char *slash = strrchr(name, '/'), *last = slash ? slash + 1 : name;
    const char *folder =
        arena_printf(p->arena, "%.*s", (int)(last - name), name);
    struct text_nearest nearest = text_nearest_start(last);
    char *list = arena_printf(p->arena, "looked in .");
    if (*name != '/')
        file_try_names(p, ".", folder, &nearest);
    for (size_t i = 0; i < options->include_path_count; i++) {
        const char *path = options->include_paths[i];
        list = arena_printf(p->arena, "%s, %s", list, path);
        if (*name != '/')
            file_try_names(p, path, folder, &nearest);
    }
    if (nearest.best)
        return arena_printf(p->arena, "\"%s%s\"", folder, nearest.best);
    return arena_printf(p->arena, "%s; +LDIR adds others", list);
}
