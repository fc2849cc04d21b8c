/* INI files, as POV-Ray reads them (measured): one Key=value a line, or any
 * number of +switches, scenes and INI files; ';' and '#' begin comments; what
 * stands before the first [section] always counts. */
#include "cli/option.h"

#include <stdlib.h>
#include <unistd.h>

#include "base/directory.h"
#include "base/text.h"

enum { INI_NESTING_LIMIT = 8, INI_FILES_LIMIT = 1000 };

/* Where a reader of one file is. */
struct ini {
    struct option_reader *reader;
    const struct source *source;
    size_t next;         /* to read; offset into the source */
    const char *section; /* asked for, or NULL */
    bool found;          /* that section was there */
    const char *names;   /* "[small], [large]": the sections that are there */
    bool active;         /* what is read now counts */
    bool good;
};

static struct span ini_span(const struct ini *ini, size_t start, size_t end)
{
    return (struct span){ ini->source, (uint32_t)start,
                          (uint32_t)(end - start) };
}

static char ini_char(const struct ini *ini)
{
    return ini->next < ini->source->length ? ini->source->text[ini->next]
                                           : '\n';
}

static bool ini_is_end(char c)
{
    return c == '\n' || c == '\r';
}

static void ini_skip_blanks(struct ini *ini)
{
    while (ini_char(ini) == ' ' || ini_char(ini) == '\t')
        ini->next++;
}

static void ini_skip_line(struct ini *ini)
{
    while (!ini_is_end(ini_char(ini)))
        ini->next++;
}

static const char *ini_text(const struct ini *ini, size_t start, size_t end)
{
    return arena_copy_text(ini->reader->arena, ini->source->text + start,
                           end - start);
}

static void ini_fail(struct ini *ini, size_t start, size_t end,
                     const char *message)
{
    diag_print(ini->reader->diag, DIAG_ERROR, ini_span(ini, start, end), NULL,
               "%s", message);
    ini->good = false;
    ini_skip_line(ini);
}

static size_t ini_trim(const struct ini *ini, size_t start, size_t end)
{
    while (end > start && strchr(" \t", ini->source->text[end - 1]))
        end--;
    return end;
}

/* [name] */
static void ini_read_section(struct ini *ini)
{
    size_t open = ini->next++;
    ini_skip_blanks(ini);
    size_t start = ini->next;
    while (!ini_is_end(ini_char(ini)) && ini_char(ini) != ']')
        ini->next++;
    if (ini_char(ini) != ']') {
        ini_fail(ini, open, ini->next,
                 "this '[' needs a ']' after the "
                 "section's name");
        return;
    }
    const char *name = ini_text(ini, start, ini_trim(ini, start, ini->next));
    bool wanted = ini->section && text_equal_nocase(name, ini->section);
    ini->found = ini->found || wanted;
    ini->names = ini->names ? arena_printf(ini->reader->arena, "%s, [%s]",
                                           ini->names, name)
                            : arena_printf(ini->reader->arena, "[%s]", name);
    ini->active = wanted || text_equal_nocase(name, "Glim");
    ini->next++;
}

static void ini_apply(struct ini *ini, const struct setting *setting)
{
    if (ini->active && !option_read(ini->reader, setting))
        ini->good = false;
}

/* +switch or a file: up to a blank; quotes keep blanks and go away. */
static void ini_read_word(struct ini *ini)
{
    size_t start = ini->next, length = 0;
    char quote = '\0';
    char *word = NULL;
    if (strncmp(ini->source->text + start, "//", 2) == 0) {
        ini_fail(ini, start, start + 2,
                 "a comment in an INI file begins with ';'");
        return;
    }
    for (; !ini_is_end(ini_char(ini)); ini->next++) {
        char c = ini_char(ini);
        if (!quote && strchr(" \t;", c))
            break;
        if (c == quote)
            quote = '\0';
        else if (!quote && (c == '"' || c == '\''))
            quote = c;
        else
            length++;
    }
    if (quote) {
        ini_fail(ini, start, ini->next, "this quote is not closed");
        return;
    }
    word = arena_alloc(ini->reader->arena, length + 1);
    length = 0;
    for (size_t i = start; i < ini->next; i++) {
        char c = ini->source->text[i];
        if (c == quote)
            quote = '\0';
        else if (!quote && (c == '"' || c == '\''))
            quote = c;
        else
            word[length++] = c;
    }
    struct span span = ini_span(ini, start, ini->next);
    ini_apply(ini, &(struct setting){ .shown = word, .span = span });
}

/* The end of a value that is not in quotes: a comment or the line's end. */
static size_t ini_value_end(struct ini *ini)
{
    size_t start = ini->next;
    bool quoted = false;
    for (; !ini_is_end(ini_char(ini)); ini->next++) {
        if (ini_char(ini) == '"')
            quoted = !quoted;
        if (!quoted && (ini_char(ini) == ';' || ini_char(ini) == '#'))
            break;
    }
    return ini_trim(ini, start, ini->next);
}

/* Key = value; ini->next is at the '='. */
static void ini_read_value(struct ini *ini, size_t key)
{
    size_t key_end = ini_trim(ini, key, ini->next++);
    ini_skip_blanks(ini);
    size_t start = ini->next, end;
    char quote = ini_char(ini);
    if (quote == '"' || quote == '\'') {
        ini->next = ++start;
        while (!ini_is_end(ini_char(ini)) && ini_char(ini) != quote)
            ini->next++;
        end = ini->next;
        if (ini_char(ini) != quote) {
            ini_fail(ini, start - 1, end, "this quote is not closed");
            return;
        }
        ini->next++;
        ini_skip_blanks(ini);
        if (!ini_is_end(ini_char(ini)) && !strchr(";#", ini_char(ini))) {
            size_t rest = ini->next;
            ini_skip_line(ini);
            ini_fail(ini, rest, ini->next,
                     "one Key=value on each line: begin a new line here");
            return;
        }
    } else
        end = ini_value_end(ini);
    struct setting setting = {
        .shown = ini_text(ini, key, end),
        .value = ini_text(ini, start, end),
        .span = ini_span(ini, key, key_end),
        .value_span = ini_span(ini, start, end),
    };
    ini_apply(ini, &setting);
    ini_skip_line(ini);
}

static void ini_read_item(struct ini *ini)
{
    size_t start = ini->next;
    if (strchr("+-", ini_char(ini))) {
        ini_read_word(ini);
        return;
    }
    while (!ini_is_end(ini_char(ini)) && !strchr("=;", ini_char(ini)))
        ini->next++;
    if (ini_char(ini) == '=') {
        ini_read_value(ini, start);
        return;
    }
    ini->next = start;
    ini_read_word(ini);
}

static void ini_read_all(struct ini *ini)
{
    const struct diag *diag = ini->reader->diag;
    while (ini->next < ini->source->length && diag->errors < DIAG_ERROR_LIMIT) {
        ini_skip_blanks(ini);
        char c = ini_char(ini);
        if (c == ';' || c == '#')
            ini_skip_line(ini);
        else if (ini_is_end(c) || c == '\0')
            ini->next++;
        else if (c == '[')
            ini_read_section(ini);
        else
            ini_read_item(ini);
    }
}

static bool ini_read_file(struct option_reader *reader, const char *path,
                          const char *section, const struct setting *setting)
{
    const char *problem = NULL;
    struct ini ini = {
        .reader = reader, .section = section, .active = true, .good = true
    };
    file_list_add(reader->options->parse.asked, path);
    ini.source = source_read(reader->arena, path, setting->span, &problem);
    if (!ini.source)
        return option_fail(reader, setting, "can't read %s: %s", path, problem);
    if (memchr(ini.source->text, '\0', ini.source->length))
        return option_fail(reader, setting,
                           "%s is not a text: it has a NUL byte", path);
    if (reader->depth >= INI_NESTING_LIMIT)
        return option_fail(reader, setting,
                           "INI files %d deep within each other are too many",
                           INI_NESTING_LIMIT);
    if (++reader->ini_files > INI_FILES_LIMIT)
        return option_fail(reader, setting,
                           "INI files named %d times are "
                           "too many",
                           INI_FILES_LIMIT + 1);
    reader->depth++;
    ini_read_all(&ini);
    reader->depth--;
    if (section && !ini.found)
        return option_fail(reader, setting, "%s has no section [%s]; it has %s",
                           path, section, ini.names ? ini.names : "none");
    return ini.good;
}

static bool ini_is_named(const char *name)
{
    size_t length = strlen(name);
    return length > 4 && text_equal_nocase(name + length - 4, ".ini");
}

/* A name as it is written: see option_search. */
static const char *const exact[] = { "", NULL };

/* Whether a shell has made two words of the name of a file that there is. */
static bool ini_is_split(struct option_reader *reader, const char *name,
                         const char *next)
{
    return next && option_search(
                       reader, arena_printf(reader->arena, "%s %s", name, next),
                       exact) != NULL;
}

/* Says what to type instead when there is no such INI file. */
static bool ini_missing(struct option_reader *reader, const char *name,
                        const struct setting *setting)
{
    static const char *const scenes[] = { ".pov", ".POV", NULL };
    const char *scene = option_search(reader, name, scenes);
    const char *file = option_search(reader, name, exact);
    struct setting plain = { .span = setting->span };
    if (ini_is_split(reader, name, setting->next))
        return option_fail(reader, &plain,
                           "a name with blanks stands in quotes: type '%s %s'",
                           name, setting->next);
    if (file)
        return option_fail(reader, &plain,
                           "'%s' is not a scene by its name and not an INI "
                           "file: type +I%s to render it",
                           name, name);
    if (scene)
        return option_fail(reader, &plain,
                           "there is no INI file '%s.ini': to render the "
                           "scene type %s",
                           name, scene);
    if (ini_is_named(name))
        return option_fail(reader, &plain,
                           "there is no INI file '%s', neither here nor along "
                           "the library path",
                           name);
    if (path_is_directory(name))
        return option_fail(reader, &plain,
                           "'%s' is a directory, neither a scene nor an INI "
                           "file",
                           name);
    if (name[0] == '[')
        return option_fail(reader, &plain,
                           "a section stands right behind its file: type "
                           "FILE.ini%s",
                           name);
    const char *meant = option_meant(reader->arena, name);
    double number, height;
    size_t across = strcspn(name, "x");
    if (name[across] == 'x' && option_number(name + across + 1, &height) &&
        option_number(arena_copy_text(reader->arena, name, across), &number))
        return reader->diag->errors > 0 ||
               option_fail(reader, &plain,
                           "'%s' is no option like this: type +W%.*s +H%s",
                           name, (int)across, name, name + across + 1);
    if (reader->diag->errors > 0 && option_number(name, &number))
        return false; /* a value of what was reported */
    if (option_number(name, &number))
        return option_fail(reader, &plain,
                           "'%s' alone means nothing: the value of an option "
                           "stands right behind it, as in +W320",
                           name);
    if (meant)
        return option_fail(reader, &plain,
                           "'%s' is no option like this: type %s", name, meant);
    static const char dash[] = "\xe2\x80\x93", long_dash[] = "\xe2\x80\x94";
    if (strncmp(name, dash, 3) == 0 || strncmp(name, long_dash, 3) == 0)
        return option_fail(reader, &plain,
                           "'%s' begins with a dash that is longer than the "
                           "'-' of options: type -%s",
                           name, name + 3);
    const char *near = option_scene_near(reader->arena, name);
    if (near && strchr(name, '.'))
        return option_fail(reader, &plain,
                           "there is no scene or INI file '%s': did you mean "
                           "'%s'?",
                           name, near);
    size_t key = strcspn(name, ":");
    if (name[key] && option_find_key(arena_copy_text(reader->arena, name, key)))
        return option_fail(reader, &plain,
                           "'%s' is no option like this: type %.*s=%s", name,
                           (int)key, name, name + key + 1);
    return option_fail(reader, &plain,
                       "there is no INI file '%s' or '%s.ini', and a scene's "
                       "name ends in .pov",
                       name, name);
}

bool ini_read(struct option_reader *reader, const char *name,
              const struct setting *setting)
{
    static const char *const extensions[] = { ".ini", ".INI", NULL };
    const char *section = NULL;
    size_t length = strlen(name), open = strcspn(name, "[");
    if (open && open < length && name[length - 1] == ']') {
        section =
            arena_copy_text(reader->arena, name + open + 1, length - open - 2);
        while (open > 1 && name[open - 1] == ' ')
            open--;
        name = arena_copy_text(reader->arena, name, open);
    } else if (open && open < length && !strchr(name, ']')) {
        return option_fail(reader, setting, "a ']' is missing at its end");
    }
    const char *path = NULL;
    if (ini_is_named(name))
        path = option_search(reader, name, exact);
    if (!path)
        path = option_search(reader, name, extensions);
    if (!path)
        return ini_missing(reader, name, setting);
    return ini_read_file(reader, path, section, setting);
}

/* The first of the files that there is, read. */
static bool ini_read_first(struct option_reader *reader,
                           const char *const *names, size_t count)
{
    struct setting setting = { 0 };
    for (size_t i = 0; i < count; i++)
        if (names[i] && access(names[i], R_OK) == 0)
            return ini_read_file(reader, names[i], NULL, &setting);
    return true;
}

/* Two files at most: POV-Ray's own settings, from the first there is of
 * $POVINI, ./povray.ini, ~/.povray/3.7/povray.ini and
 * /etc/povray/3.7/povray.ini; then glim's, from the first of ./glim.ini and
 * ~/.glim.ini. */
bool ini_startup(struct option_reader *reader)
{
    const char *home = getenv("HOME");
    const char *mine = NULL, *povray = NULL;
    if (home) {
        mine = arena_printf(reader->arena, "%s/.glim.ini", home);
        povray = arena_printf(reader->arena, "%s/.povray/3.7/povray.ini", home);
    }
    const char *const povrays[] = { getenv("POVINI"), "povray.ini", povray,
                                    "/etc/povray/3.7/povray.ini" };
    const char *const mines[] = { "glim.ini", mine };
    reader->startup = true;
    bool good = ini_read_first(reader, povrays, 4);
    reader->startup = false;
    return ini_read_first(reader, mines, 2) && good;
}
