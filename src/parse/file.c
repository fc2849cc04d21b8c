/* Where a scene's files are found: POV-Ray's rule, which does not look beside
 * the file that includes. */
#include <sys/stat.h>

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

const char *file_find(struct parser *p, const char *name, const char *extension)
{
    const char *path = *name ? file_search(p, name) : NULL;
    if (path || !extension || file_has_extension(name))
        return path;
    return file_search(p, arena_printf(p->arena, "%s%s", name, extension));
}

const char *file_hint(struct parser *p)
{
    const struct parse_options *options = p->options;
    char *list = arena_printf(p->arena, "looked in .");
    for (size_t i = 0; i < options->include_path_count; i++)
        list =
            arena_printf(p->arena, "%s, %s", list, options->include_paths[i]);
    return arena_printf(p->arena, "%s; +LDIR adds others", list);
}
