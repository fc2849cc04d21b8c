/* Which files a scene may have read: --read-only-below, and povray.conf of the
 * system and of the user as POV-Ray documents it. Each is a list, and all must
 * permit a file. What the user names, the scene's own directory and those of
 * the library path, every list permits. The system's file, which Debian ships
 * as strict as can be and POV-Ray doesn't heed (measured), also permits the
 * directory above the scene's: "../textures" is where many have them. */
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/directory.h"
#include "base/text.h"
#include "cli/option.h"

static const char system_conf[] = "/etc/povray/3.7/povray.conf";

/* One povray.conf while it is read. */
struct conf {
    struct option_reader *reader;
    const struct source *source;
    enum { CONF_OTHER, CONF_SECURITY, CONF_PATHS } section;
    bool restricted;
    struct permit_list *list;
};

struct text_piece {
    const char *start, *end;
};

static struct text_piece piece_trim(struct text_piece piece)
{
    while (piece.start < piece.end && strchr(" \t\r", *piece.start))
        piece.start++;
    while (piece.start < piece.end && strchr(" \t\r", piece.end[-1]))
        piece.end--;
    return piece;
}

static bool piece_is(struct text_piece piece, const char *text)
{
    size_t length = (size_t)(piece.end - piece.start);
    return length == strlen(text) && strncmp(piece.start, text, length) == 0;
}

static struct span conf_span(const struct conf *conf, struct text_piece piece)
{
    return (struct span){ conf->source,
                          (uint32_t)(piece.start - conf->source->text),
                          (uint32_t)(piece.end - piece.start) };
}

/* "[File I/O Security]" */
static void conf_section(struct conf *conf, struct text_piece line)
{
    conf->section = piece_is(line, "[File I/O Security]") ? CONF_SECURITY
                    : piece_is(line, "[Permitted Paths]") ? CONF_PATHS
                                                          : CONF_OTHER;
}

/* What isn't understood is as strict as can be. */
static void conf_security(struct conf *conf, struct text_piece line)
{
    conf->restricted = !piece_is(line, "none") && !piece_is(line, "read-only");
    if (conf->restricted && !piece_is(line, "restricted"))
        diag_print(conf->reader->diag, DIAG_WARNING, conf_span(conf, line),
                   "none, read-only or restricted",
                   "not understood, and taken as 'restricted'");
}

/* The path with %HOME% and %INSTALLDIR% replaced, which begin it; NULL: there
 * is no such place. */
static const char *conf_path(const struct conf *conf, struct text_piece path)
{
    static const char home[] = "%HOME%", install[] = "%INSTALLDIR%";
    struct arena *arena = conf->reader->arena;
    const char *text =
        arena_copy_text(arena, path.start, (size_t)(path.end - path.start));
    if (strncmp(text, home, sizeof home - 1) == 0)
        return getenv("HOME") ? arena_printf(arena, "%s%s", getenv("HOME"),
                                             text + sizeof home - 1)
                              : NULL;
    if (strncmp(text, install, sizeof install - 1) == 0)
        return arena_printf(arena, "%s%s", OPTION_POVRAY_FOLDER,
                            text + sizeof install - 1);
    return text;
}

/* read = DIR, read* = DIR, read+write = DIR, read+write* = DIR */
static void conf_permit(struct conf *conf, struct text_piece line)
{
    const char *equal =
        memchr(line.start, '=', (size_t)(line.end - line.start));
    struct text_piece word =
        piece_trim((struct text_piece){ line.start, equal ? equal : line.end });
    bool below = word.end > word.start && word.end[-1] == '*';
    word.end -= below;
    if (!equal || (!piece_is(word, "read") && !piece_is(word, "read+write"))) {
        diag_print(conf->reader->diag, DIAG_WARNING, conf_span(conf, line),
                   "read* = DIRECTORY", "not understood");
        return;
    }
    struct text_piece path =
        piece_trim((struct text_piece){ equal + 1, line.end });
    bool quoted = path.end - path.start >= 2 && strchr("'\"", *path.start) &&
                  path.end[-1] == *path.start;
    path.start += quoted;
    path.end -= quoted;
    const char *name = conf_path(conf, path);
    if (name)
        permit_add(conf->list, conf->reader->arena,
                   (struct permit){ name, below, false });
}

static void conf_line(struct conf *conf, struct text_piece line)
{
    const char *comment =
        memchr(line.start, ';', (size_t)(line.end - line.start));
    if (comment)
        line.end = comment;
    line = piece_trim(line);
    if (line.start == line.end)
        return;
    if (*line.start == '[')
        conf_section(conf, line);
    else if (conf->section == CONF_SECURITY)
        conf_security(conf, line);
    else if (conf->section == CONF_PATHS)
        conf_permit(conf, line);
}

/* A file that isn't there restricts nothing; one that can't be read would, if
 * that were known. */
static bool conf_read(struct option_reader *reader, const char *path)
{
    const char *problem = NULL;
    struct permit_list list = { .where = path,
                                .above = strcmp(path, system_conf) == 0 };
    struct conf conf = { .reader = reader, .list = &list };
    if (access(path, F_OK) != 0)
        return true;
    conf.source = source_read(reader->arena, path, span_none(), &problem);
    if (!conf.source) {
        diag_print(reader->diag, DIAG_ERROR, span_none(), NULL,
                   "can't read '%s', which says what scenes may read: %s", path,
                   problem);
        return false;
    }
    const char *next = conf.source->text, *end = next + conf.source->length;
    while (next < end) {
        const char *line_end = memchr(next, '\n', (size_t)(end - next));
        line_end = line_end ? line_end : end;
        conf_line(&conf, (struct text_piece){ next, line_end });
        next = line_end + (line_end < end);
    }
    if (conf.restricted)
        *ARRAY_PUSH(reader->arena, &reader->permits) = list;
    return true;
}

/* What was named by who called the program is not the scene's to choose. */
static void permits_add_named(struct option_reader *reader)
{
    const char *scene = reader->options->path;
    const char *slash = scene ? strrchr(scene, '/') : NULL;
    const char *folder = slash ? arena_copy_text(reader->arena, scene,
                                                 (size_t)(slash - scene) + 1)
                               : ".";
    for (size_t i = 0; i < reader->permits.count; i++) {
        struct permit_list *list = &reader->permits.items[i];
        if (scene && strcmp(scene, "-") != 0)
            permit_beside(list, reader->arena, folder);
        for (size_t k = 0; k < reader->library.count; k++)
            permit_add(
                list, reader->arena,
                (struct permit){ reader->library.items[k], true, false });
        permit_add(list, reader->arena,
                   (struct permit){ OPTION_POVRAY_FOLDER, true, true });
    }
}

bool permits_resolve(struct option_reader *reader)
{
    const char *home = getenv("HOME");
    struct permit_list *below = NULL;
    for (size_t i = 0; i < reader->below.count; i++) {
        if (!below)
            below = permits_begin(&reader->permits, reader->arena,
                                  "--read-only-below");
        permit_add(below, reader->arena,
                   (struct permit){ reader->below.items[i], true, false });
    }
    if (!conf_read(reader, system_conf) ||
        (home &&
         !conf_read(reader, arena_printf(reader->arena,
                                         "%s/.povray/3.7/povray.conf", home))))
        return false;
    permits_add_named(reader);
    struct permits *permits = ARENA_NEW(reader->arena, struct permits);
    *permits = reader->permits;
    reader->options->parse.permits = permits;
    return true;
}

bool set_below(struct option_reader *reader, const struct option *option,
               const struct setting *setting)
{
    if (!option_wants(reader, option, setting, "dir"))
        return false;
    if (!path_is_directory(setting->value))
        return option_fail(reader, setting, "there is no directory '%s'",
                           setting->value);
    *ARRAY_PUSH(reader->arena, &reader->below) =
        arena_copy_text(reader->arena, setting->value, strlen(setting->value));
    return true;
}
