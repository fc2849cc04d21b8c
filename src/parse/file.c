/* Where a scene's files are found: POV-Ray's rule, which does not look beside
 * the file that includes. */
#include <dirent.h>
#include <sys/stat.h>

#include "base/directory.h"
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
    file_list_add(options->asked, name);
    if (file_exists(name))
        return name;
    for (size_t i = 0; name[0] != '/' && i < options->include_path_count; i++) {
        const char *path =
            arena_printf(p->arena, "%s/%s", options->include_paths[i], name);
        file_list_add(options->asked, path);
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
    return file_checked(p, span, what, name, file_locate(p, name, extension));
}

/* A name in the span that has the '"' of another string at its end; reports. */
static bool file_unclosed(struct parser *p, struct span span, const char *what)
{
    const char *quote =
        memchr(span.source->text + span.offset, '"', span.length);
    size_t length = quote ? 1 + strcspn(quote + 1, "\"\r\n") : 0;
    if (!length || (quote[length] != '\n' && quote[length] != '\r'))
        return false;
    error_at(p, span, arena_printf(p->arena, "%.*s\"", (int)length, quote),
             "the name of the %s goes on in the next line; a '\"' is missing",
             what);
    return true;
}

const char *file_checked(struct parser *p, struct span span, const char *what,
                         const char *name, const char *path)
{
    const struct permit_list *denier =
        path ? permits_denier(p->options->permits, path) : NULL;
    if (!path && file_unclosed(p, span, what))
        return NULL;
    if (!path && !*name)
        error_at(p, span, NULL,
                 "the name of the %s is empty: write it between the quotes",
                 what);
    else if (!path)
        error_at(p, span, file_hint(p, what, name), "can't find the %s '%s'",
                 what, file_shown(p, name));
    else if (denier)
        error_at(p, span,
                 arena_printf(p->arena,
                              "%s forbids it; +LDIR permits what is "
                              "in DIR",
                              denier->where),
                 "this scene may not read '%s'", file_shown(p, path));
    return denier ? NULL : path;
}

/* Where its last dot is, or its end. */
static size_t file_stem(const char *name)
{
    const char *dot = strrchr(name, '.');
    return dot ? (size_t)(dot - name) : strlen(name);
}

/* For "did you mean" of file names: the nearest name that differs by its
 * extension alone, or by what is before it, or goes on where that ends, as
 * colors.inc does for col.inc. Both together are never compared: ior.inc would
 * be nearer. */
struct file_nearest {
    const char *extension;
    struct text_nearest names, stems;
    const char *best, *longer; /* of one stem or longer; whole names */
};

static const char *file_stem_of(struct parser *p, const char *name)
{
    return arena_copy_text(p->arena, name, file_stem(name));
}

static struct file_nearest file_nearest_start(struct parser *p,
                                              const char *name)
{
    const char *stem = file_stem_of(p, name);
    return (struct file_nearest){ .extension = name + strlen(stem),
                                  .names = text_nearest_start(name),
                                  .stems = text_nearest_start(stem) };
}

static void file_nearest_try(struct parser *p, struct file_nearest *nearest,
                             const char *name)
{
    enum { SHORTEST = 3 };
    const char *word = nearest->stems.word, *stem = file_stem_of(p, name);
    if (text_equal_nocase(word, stem))
        text_nearest_try(&nearest->names, name);
    if (*nearest->extension &&
        !text_equal_nocase(nearest->extension, name + strlen(stem)))
        return;
    const char *before = nearest->stems.best;
    text_nearest_try(&nearest->stems, stem);
    if (nearest->stems.best != before)
        nearest->best = name;
    size_t length = strlen(word);
    bool begins = length >= SHORTEST && strncmp(word, stem, length) == 0;
    if (begins && (!nearest->longer || strlen(name) < strlen(nearest->longer)))
        nearest->longer = name;
}

/* NULL: none is near. */
static const char *file_nearest_end(const struct file_nearest *nearest)
{
    if (nearest->names.best)
        return nearest->names.best;
    return nearest->best ? nearest->best : nearest->longer;
}

/* Tries the names in directory `place`, and those in its part `folder`. */
static void file_try_names(struct parser *p, const char *place,
                           const char *folder, struct file_nearest *nearest)
{
    const char *name = arena_printf(p->arena, "%s/%s", place, folder);
    DIR *directory =
        permits_denier_of(p->options->permits, name) ? NULL : opendir(name);
    struct dirent *entry;
    while (directory && (entry = readdir(directory)) != NULL)
        file_nearest_try(p, nearest,
                         arena_printf(p->arena, "%s", entry->d_name));
    if (directory)
        closedir(directory);
}

/* The +L that finds the file beside the text that names it, or NULL. */
static const char *file_beside(struct parser *p, const char *name)
{
    const struct source *source = p->last_span.source;
    const char *slash = source ? strrchr(source->name, '/') : NULL;
    if (!slash || *name == '/')
        return NULL;
    int length = (int)(slash - source->name);
    const char *path =
        arena_printf(p->arena, "%.*s/%s", length, source->name, name);
    if (!file_exists(path) &&
        !file_exists(arena_printf(p->arena, "%s.inc", path)))
        return NULL;
    return arena_printf(p->arena,
                        "it is beside the file that names it: +L%.*s finds it",
                        length, source->name);
}

/* The name with '/' where a '\' made something else of it: "C:\temp". */
static const char *file_without_escapes(struct parser *p, const char *name)
{
    const char *shown = file_shown(p, name);
    struct span span = p->last_span;
    if (shown == name || !span.source || span.length > 200 ||
        span.source->text[span.offset] != '"')
        return NULL;
    char *text =
        arena_copy_text(p->arena, span.source->text + span.offset, span.length);
    for (char *c = text; *c; c++)
        if (*c == '\\')
            *c = '/';
    return text;
}

const char *file_shown(struct parser *p, const char *name)
{
    char *shown = arena_copy_text(p->arena, name, strlen(name));
    bool changed = false;
    for (char *c = shown; *c; c++) {
        bool control = (unsigned char)*c < 32 || *c == 127;
        if (control)
            *c = '?';
        changed |= control;
    }
    return changed ? shown : name;
}

const char *file_hint(struct parser *p, const char *what, const char *name)
{
    const char *better = file_without_escapes(p, name);
    if (!better)
        better = file_beside(p, name);
    if (better)
        return better;
    const struct parse_options *options = p->options;
    const char *last = text_last_part(name);
    const char *folder =
        arena_printf(p->arena, "%.*s", (int)(last - name), name);
    struct file_nearest nearest = file_nearest_start(p, last);
    char *list = arena_printf(p->arena, "looked in .");
    if (*name != '/')
        file_try_names(p, ".", folder, &nearest);
    for (size_t i = 0; i < options->include_path_count; i++) {
        const char *path = options->include_paths[i];
        list = arena_printf(
            p->arena, "%s, %s%s", list, path,
            path_is_directory(path) ? "" : " (which is no directory)");
        if (*name != '/')
            file_try_names(p, path, folder, &nearest);
    }
    const char *near = file_nearest_end(&nearest);
    if (near)
        return arena_printf(p->arena, "\"%s%s\"", folder, near);
    if (strcmp(what, "font") == 0 && file_search(p, "timrom.ttf"))
        return "\"timrom.ttf\", \"cyrvetic.ttf\" and \"crystal.ttf\" come with "
               "POV-Ray";
    return arena_printf(p->arena, "%s; +LDIR adds others", list);
}
