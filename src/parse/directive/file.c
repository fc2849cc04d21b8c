/* #include: another file is read here. */
#include "parse/data_file.h"
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
    const struct parse_listener *listener = p->options->listener;
    const struct source *source =
        listener ? listener->text(listener->context, p->sources, path, at)
                 : NULL;
    if (!source)
        source = source_read(p->sources, path, at, &problem);
    if (!source) {
        error_at(p, at, NULL, "can't read '%s': %s", path, problem);
        stream_abort(p);
        return NULL;
    }
    known = lexer_run(p->arena, p->words, source);
    *ARRAY_PUSH(p->arena, &p->files) = known;
    return known;
}

/* What the scene itself wrote under that name, or NULL; it may write it again.
 */
static bool include_written(struct parser *p, const char *name, struct span at,
                            const struct token_list **list)
{
    const char *problem;
    const struct source *source = data_file_written(p, name, at, &problem);
    if (problem) {
        error_at(p, at, NULL, "can't read '%s': %s", name, problem);
        stream_abort(p);
        return false;
    }
    *list = source ? lexer_run(p->arena, p->words, source) : NULL;
    return true;
}

/* include_directive = "#include" string . */
static bool include_run(struct parser *p, struct span at)
{
    const char *name;
    if (!directive_string(p, &name))
        return false;
    struct span where = span_join(at, p->last_span);
    const struct token_list *list;
    const char *path = NULL;
    if (!include_written(p, name, where, &list))
        return false;
    if (!list)
        path = file_need(p, where, "include file", name, ".inc");
    if (!list && !path) {
        stream_abort(p);
        return false;
    }
    if (!list)
        list = include_load(p, path, where);
    if (!list || !stream_round(p, INCLUDE_COST, where))
        return false;
    return stream_push_file(p, list);
}

const struct directive include_directive = { include_run,
                                             "read another file here" };
