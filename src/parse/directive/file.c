/* #include, and the directives that read and write data files, which glim
 * refuses: a scene may come from a stranger. */
#include "parse/directive.h"

/* In rounds of a loop: a file is looked for in several places. */
enum { INCLUDE_COST = 20 };

static const struct token_list *include_known(struct parser *p,
                                              const char *path)
{
    for (size_t i = 0; i < p->files.count; i++)
        if (strcmp(p->files.items[i]->source->name, path) == 0)
            return p->files.items[i];
    return NULL;
}

/* Reads and cuts a file the first time it is included. */
static const struct token_list *include_load(struct parser *p, const char *path,
                                             struct span at)
{
    const struct token_list *known = include_known(p, path);
    if (known)
        return known;
    const char *problem;
    const struct source *source = source_read(p->sources, path, at, &problem);
    if (!source) {
        error_at(p, at, NULL, "can't read '%s': %s", path, problem);
        stream_abort(p);
        return NULL;
    }
    known = lexer_run(p->arena, p->words, source);
    *ARRAY_PUSH(p->arena, &p->files) = known;
    return known;
}

/* include_directive = "#include" string . */
static bool include_run(struct parser *p, struct span at)
{
    const char *name;
    if (!directive_string(p, &name))
        return false;
    struct span where = span_join(at, p->last_span);
    const char *path = file_find(p, name, ".inc");
    if (!path) {
        error_at(p, where, file_hint(p, name),
                 "can't find the include file '%s'", name);
        stream_abort(p);
        return false;
    }
    const struct token_list *list = include_load(p, path, where);
    if (!list || !stream_round(p, INCLUDE_COST, where))
        return false;
    return stream_push_file(p, list);
}

static bool file_refuse(struct parser *p, struct span at)
{
    error_at(p, at, NULL,
             "'%.*s' is refused: a scene may not read or write data files",
             (int)at.length, at.source->text + at.offset);
    stream_abort(p);
    return false;
}

const struct directive include_directive = { include_run,
                                             "read another file here" };
const struct directive fopen_directive = { file_refuse, "refused" };
const struct directive fclose_directive = { file_refuse, "refused" };
const struct directive read_directive = { file_refuse, "refused" };
const struct directive write_directive = { file_refuse, "refused" };
