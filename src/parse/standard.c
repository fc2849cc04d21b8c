/* POV-Ray's standard include files: which of them declares a name, for the
 * error of a scene that forgot to include it. */
#include <ctype.h>

#include "parse/parser.h"
#include "parse/stream.h"

/* Those a scene would include by itself. */
static const char *const standard_files[] = {
    "colors.inc",  "textures.inc",  "finish.inc",     "glass.inc",
    "golds.inc",   "metals.inc",    "stones.inc",     "stones1.inc",
    "stones2.inc", "woods.inc",     "skies.inc",      "stars.inc",
    "shapes.inc",  "shapes2.inc",   "shapes3.inc",    "shapesq.inc",
    "rand.inc",    "math.inc",      "transforms.inc", "strings.inc",
    "consts.inc",  "functions.inc", "ior.inc",        "arrays.inc",
    "sunpos.inc",  "screen.inc",    "rad_def.inc",
};

/* Those that one of these includes. */
static const char *const standard_parts[][2] = {
    { "shapes_old.inc", "shapes.inc" },
    { "glass_old.inc", "glass.inc" },
    { "woodmaps.inc", "woods.inc" },
};

static bool standard_is_name(char c)
{
    return isalnum((unsigned char)c) || c == '_';
}

/* Whether the text from `at` on is the word, and nothing more. */
static bool standard_is_word(const char *at, const char *word)
{
    size_t length = strlen(word);
    return strncmp(at, word, length) == 0 && !standard_is_name(at[length]);
}

/* Whether `= function` or, of a macro, '(' follows. */
static bool standard_is_called(const char *text, bool macro)
{
    text += strspn(text, " \t");
    if (macro || *text != '=')
        return macro;
    text += 1 + strspn(text + 1, " \t\r\n");
    return standard_is_word(text, "function");
}

static bool standard_declares(const char *text, const char *name, bool called)
{
    while ((text = strchr(text, '#')) != NULL) {
        text += 1 + strspn(text + 1, " \t");
        bool macro = standard_is_word(text, "macro");
        if (!standard_is_word(text, "declare") && !macro)
            continue;
        text += strcspn(text, " \t\n");
        text += strspn(text, " \t");
        if (standard_is_word(text, name) &&
            (!called || standard_is_called(text + strlen(name), macro)))
            return true;
    }
    return false;
}

static bool standard_file_declares(struct parser *p, const char *file,
                                   const char *name, bool called)
{
    const char *problem, *path = file_find(p, file, NULL);
    const struct source *source =
        path ? source_read(p->arena, path, span_none(), &problem) : NULL;
    return source && standard_declares(source->text, name, called);
}

const char *standard_include(struct parser *p, const char *name)
{
    size_t files = sizeof standard_files / sizeof *standard_files;
    size_t parts = sizeof standard_parts / sizeof *standard_parts;
    const char *found = NULL;
    size_t left;
    const struct token *next = stream_raw(p, &left);
    bool called = left > 0 && next->kind == TOKEN_LPAREN;
    /* One letter is what an include counts with, and never what is meant. */
    if (strlen(name) < 2)
        return NULL;
    for (size_t i = 0; i < files && !found; i++)
        if (standard_file_declares(p, standard_files[i], name, called))
            found = standard_files[i];
    for (size_t i = 0; i < parts && !found; i++)
        if (standard_file_declares(p, standard_parts[i][0], name, called))
            found = standard_parts[i][1];
    return found ? arena_printf(p->arena, "#include \"%s\"", found) : NULL;
}
