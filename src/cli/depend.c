/* Rules for make: see depend.h. */
#include "cli/depend.h"

#include "base/writer.h"
#include "cli/output_name.h"
#include "cli/picture.h"

/* What means something to make in a rule's names. */
static const char special[] = " \t#%:*?[]~";

static void depend_name(struct writer *text, const char *name)
{
    for (; *name; name++) {
        if (*name == '$')
            writer_add(text, "$", 1);
        else if (strchr(special, *name) ||
                 (*name == '\\' && name[1] && strchr(special, name[1])))
            writer_add(text, "\\", 1);
        writer_add(text, name, 1);
    }
}

/* A name that make can't hold in a rule, however it is written. */
static bool depend_can(const char *name)
{
    return *name && !strpbrk(name, "\n\r");
}

/* What is made: the light mesh alone, or each picture. NULL: it is called
 * nothing, as on standard output. */
static const char *depend_made(const struct options *options)
{
    const struct light_mesh_settings *mesh = &options->light.light_mesh;
    const char *name = mesh->only ? mesh->save_file : options->named;
    return name && strcmp(name, "-") != 0 ? name : NULL;
}

static void depend_targets(struct writer *text, const struct options *options,
                           const struct targets *targets)
{
    const char *said = options->depend.target;
    bool mesh = options->light.light_mesh.only;
    if (said)
        writer_add(text, said, strlen(said));
    else if (mesh)
        depend_name(text, depend_made(options));
    for (size_t i = 0; !said && !mesh && i < targets->count; i++) {
        if (i)
            writer_add(text, " \\\n  ", 5);
        depend_name(text, targets->items[i]);
    }
    writer_add(text, ":", 1);
}

static void depend_file(struct writer *text, const char *path, bool there)
{
    if (!depend_can(path) || (!there && strpbrk(path, " \t#%:*?[]~\\$,()")))
        return;
    writer_add(text, " \\\n  ", 5);
    if (there)
        depend_name(text, path);
    else
        writer_print(text, "$(wildcard %s)", path);
}

/* The name of the file itself: as said, or beside what is made. NULL: none. */
static const char *depend_path(const struct options *options,
                               struct arena *arena)
{
    const struct depend *depend = &options->depend;
    const char *made = depend_made(options);
    if (depend->file || !depend->on || !made)
        return depend->file;
    return arena_printf(arena, "%.*s.d", (int)output_stem(made), made);
}

bool depend_can_be(const struct options *options, struct arena *arena,
                   struct diag *diag)
{
    const struct depend *depend = &options->depend;
    if ((depend->file || depend->on) && !depend->target &&
        !depend_made(options)) {
        diag_print(diag, DIAG_ERROR, span_none(), NULL,
                   "a rule for make needs a target, and standard output is "
                   "none: add -MT NAME");
        return false;
    }
    return picture_can_be(depend_path(options, arena), diag);
}

static bool depend_counts(const struct file_list *files, size_t i)
{
    return strcmp(file_list_path(files, i), "-") != 0;
}

bool depend_write(const struct options *options, const struct targets *targets,
                  const struct file_list *files, struct diag *diag)
{
    struct writer text = writer_new();
    char why[256];
    bool done = true;
    const char *path = depend_path(options, text.arena);
    if (path && (options->depend.target || options->light.light_mesh.only ||
                 targets->count > 0)) {
        depend_targets(&text, options, targets);
        for (size_t i = 0; i < files->count; i++)
            if (depend_counts(files, i))
                depend_file(&text, file_list_path(files, i),
                            file_list_there(files, i));
        writer_add(&text, "\n", 1);
        for (size_t i = 0; options->depend.phony && i < files->count; i++) {
            const char *name = file_list_path(files, i);
            if (!depend_counts(files, i) || !file_list_there(files, i) ||
                !depend_can(name) || strcmp(name, options->path) == 0)
                continue;
            writer_add(&text, "\n", 1);
            depend_name(&text, name);
            writer_add(&text, ":\n", 2);
        }
        done = writer_save(&text, path, why, sizeof why);
        if (!done)
            diag_print(diag, DIAG_ERROR, span_none(), NULL,
                       "can't write '%s': %s", path, why);
    }
    writer_free(&text);
    return done;
}
