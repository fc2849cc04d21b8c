/* --language-server: see language.h. */
#include "cli/language.h"

#include <errno.h>
#include <limits.h>
#include <string.h>
#include <unistd.h>

#define PROGRAM "glim-language-server"

/* What scenes may read: +R begins a list, of whom it is from, +A one that
 * permits the directory above a scene's, and +D, +B and +T
 * are its directories: alone, with what is below, with what links there lead
 * to. Into words, unless that is NULL; returns how many. */
static size_t language_permits(const struct permits *permits, char **words,
                               struct arena *arena)
{
    size_t count = 0;
    for (size_t i = 0; permits && i < permits->count; i++) {
        const struct permit_list *list = &permits->items[i];
        if (words)
            words[count] = arena_printf(arena, "+%c%s", list->above ? 'A' : 'R',
                                        list->where);
        count++;
        for (size_t k = 0; k < list->count; k++, count++)
            if (words)
                words[count] = arena_printf(arena, "+%c%s",
                                            list->items[k].links   ? 'T'
                                            : list->items[k].below ? 'B'
                                                                   : 'D',
                                            list->items[k].directory);
    }
    return count;
}

void language_server(const struct options *options, struct diag *diag)
{
    char name[PATH_MAX + sizeof PROGRAM];
    ssize_t length = readlink("/proc/self/exe", name, PATH_MAX);
    name[length > 0 ? length : 0] = '\0';
    char *slash = strrchr(name, '/');
    strcpy(slash ? slash + 1 : name, PROGRAM);

    struct arena *arena = arena_new(0);
    const struct parse_options *parse = &options->parse;
    size_t standard = 0;
    while (parse->standard_paths[standard])
        standard++;
    size_t permits = language_permits(parse->permits, NULL, arena);
    char **arguments = ARENA_ARRAY(
        arena, char *, parse->include_path_count + standard + permits + 2);
    size_t count = 0;
    arguments[count++] = name;
    for (size_t i = 0; i < parse->include_path_count; i++)
        arguments[count++] =
            arena_printf(arena, "+L%s", parse->include_paths[i]);
    for (size_t i = 0; i < standard; i++)
        arguments[count++] =
            arena_printf(arena, "+S%s", parse->standard_paths[i]);
    language_permits(parse->permits, arguments + count, arena);
    execv(name, arguments);
    if (errno == ENOENT)
        diag_print(diag, DIAG_ERROR, span_none(),
                   "install libjansson-dev and type make",
                   "glim was built without its language server, which needs "
                   "Jansson");
    else
        diag_print(diag, DIAG_ERROR, span_none(), NULL, "can't run '%s': %s",
                   name, strerror(errno));
    arena_free(arena);
}
