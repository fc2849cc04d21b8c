/* --help, --version, --list and the manual page's table, all from the tables
 * that are used: nothing can be forgotten. */
#include "cli/build.h"
#include "cli/option.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "base/text.h"
#include "cli/language.h"
#include "cli/output_name.h"
#include "lightmesh/interpolation.h"
#include "scene/pattern.h"
#include "scene/camera.h"
#include "scene/primitive.h"
#include "skeleton/heuristic.h"
#include "token/word.h"
#include "tracer/integrator.h"

enum { HELP_COLUMN = 34, HELP_WIDTH = 79 };

/* "+An", "+W n": a value follows its letters at once. */
static int help_letters(const struct option *option, char *text, size_t size)
{
    bool flag = option->argument && strcmp(option->argument, "bool") == 0;
    return snprintf(text, size, "+%s%s", option->letters,
                    option->argument && !flag ? option->argument : "");
}

/* "+Wn  Width=n", at most 64 bytes. */
static void help_names(const struct option *option, char text[128])
{
    int length = 0;
    text[0] = '\0';
    if (option->letters)
        length = help_letters(option, text, 128);
    else if (option->key)
        length = snprintf(text, 128, "      ");
    const char *argument = option->argument ? option->argument : "";
    if (option->also)
        argument = "bool";
    if (option->key)
        length +=
            snprintf(text + length, 128 - (size_t)length, "%*s%s=%s",
                     length < 8 ? 8 - length : 1, "", option->key, argument);
    if (option->word)
        snprintf(text + length, 128 - (size_t)length, "%s--%s%s%s",
                 length ? "  " : "", option->word, *argument ? " " : "",
                 argument);
}

/* `text` broken between words, every line but the first indented. */
static void help_wrap(const char *text, int column)
{
    while (*text) {
        int length = (int)strcspn(text, " ");
        if (column + length + 1 > HELP_WIDTH) {
            printf("\n%*s", HELP_COLUMN, "");
            column = HELP_COLUMN;
        }
        printf(" %.*s", length, text);
        column += length + 1;
        text += length;
        text += strspn(text, " ");
    }
    printf("\n");
}

static void help_print_option(const struct option *option)
{
    char names[128];
    help_names(option, names);
    printf("  %-*s", HELP_COLUMN - 2, names);
    int column = (int)strlen(names) + 2;
    if (column > HELP_COLUMN) {
        printf("\n%*s", HELP_COLUMN, "");
        column = HELP_COLUMN;
    }
    if (column < HELP_COLUMN)
        column = HELP_COLUMN;
    help_wrap(option->help, column);
}

static void help_print_options(void)
{
    for (size_t i = 0; option_at(i); i++) {
        const struct option *option = option_at(i);
        if (!option->set)
            printf("\n%s:\n", option->help);
        else
            help_print_option(option);
    }
}

static void help_print(void)
{
    printf("usage: glim [option | file.ini[[section]]] ... scene.pov\n"
           "Renders a POV-Ray scene. Options are those of POV-Ray: +X or -X, "
           "Key=value or\n--word, read from left to right, the last wins. "
           "Only for switches does - mean\noff. See glim(1); the scene "
           "language is glim(5).\n");
    help_print_options();
}

enum { MAN_COLUMNS = 72 }; /* of a line, not counting what is escaped */

/* A cell of an mdoc list in lines, with what roff would take for markup
 * escaped. */
static void help_man_text(const char *text)
{
    size_t column = 0;
    for (; *text; text++, column++) {
        bool ends =
            *text == ' ' && column + strcspn(text + 1, " ") >= MAN_COLUMNS;
        if (ends)
            column = 0;
        if (*text == '\\' || *text == '-')
            printf("\\%c", *text == '-' ? '-' : 'e');
        else
            putchar(ends ? '\n' : *text);
    }
}

static void help_man_option(const struct option *option)
{
    const char *argument = option->argument ? option->argument : "";
    bool flag = strcmp(argument, "bool") == 0;
    const char *separator = "";
    printf(".It ");
    if (option->letters) {
        printf("Ic +%s", option->letters);
        if (*argument == '[')
            printf(" Ns Oo Ar %.*s Oc", (int)strlen(argument) - 2,
                   argument + 1);
        else if (*argument && !flag)
            printf(" Ns Ar %s", argument);
        separator = " , ";
    }
    if (option->key) {
        printf("%sIc %s Ns = Ns Ar %s", separator, option->key,
               option->also || !*argument ? "bool" : argument);
        separator = " , ";
    }
    if (option->word)
        printf("%sFl \\-%s", separator, option->word);
    if (option->word && *argument == '[')
        printf(" Oo Ar %.*s Oc", (int)strlen(argument) - 2, argument + 1);
    else if (option->word && *argument)
        printf(" Ar %s", argument);
    printf("\n");
    help_man_text(option->help);
    printf("\n");
}

/* Options that have no effect are one paragraph, not a list. */
static void help_man_ignored(size_t i)
{
    const char *separator = "";
    for (; option_at(i); i++) {
        printf("%s", separator);
        if (option_at(i)->letters)
            printf(".Ic +%s ", option_at(i)->letters);
        if (option_at(i)->key)
            printf("%s%s", option_at(i)->letters ? "Pq " : ".Ic ",
                   option_at(i)->key);
        separator = " ,\n";
    }
    printf(" .\n");
}

static void help_print_man(void)
{
    bool open = false;
    for (size_t i = 0; option_at(i); i++) {
        const struct option *option = option_at(i);
        if (option->set) {
            help_man_option(option);
            continue;
        }
        if (open)
            printf(".El\n");
        printf(".Ss %s\n", option->help);
        open = option_at(i + 1) && option_at(i + 1)->help;
        if (!option_at(i + 2) || !*option_at(i + 2)->help) {
            help_man_ignored(i + 1);
            return;
        }
        printf(".Bl -tag -width Ds\n");
    }
}

/* Names and help of all plug-ins of a kind. */
#define LIST(kind, at)                                                         \
    static void help_list_##kind(void)                                         \
    {                                                                          \
        for (size_t i = 0; at(i); i++)                                         \
            printf("%-20s %s\n", at(i)->name, at(i)->help);                    \
    }

LIST(primitive, primitive_at)
LIST(pattern, pattern_at)
LIST(camera, camera_kind_at)
LIST(lighting, integrator_lighting_at)
LIST(interpolation, interpolation_at)
LIST(heuristic, heuristic_at)

static void help_list_formats(void)
{
    for (size_t i = 0; output_type_at(i); i++)
        printf("+F%c %s  %s\n", output_type_at(i)->letter,
               output_type_at(i)->extension, output_type_at(i)->help);
}

static void help_print_word(void *context, const struct word *word)
{
    (void)context;
    printf("%s\n", word->text);
}

static void help_list_keywords(void)
{
    struct arena *arena = arena_new(0);
    word_table_visit(word_table_new(arena), help_print_word, NULL);
    arena_free(arena);
}

static const struct list {
    const char *name;
    void (*print)(void);
} lists[] = {
    { "primitives", help_list_primitive },
    { "patterns", help_list_pattern },
    { "cameras", help_list_camera },
    { "keywords", help_list_keywords },
    { "lightings", help_list_lighting },
    { "interpolations", help_list_interpolation },
    { "heuristics", help_list_heuristic },
    { "formats", help_list_formats },
    { "options", help_print_options },
};

enum { LIST_COUNT = sizeof lists / sizeof *lists };

static bool help_list(const char *what, struct diag *diag)
{
    if (!what || !*what) {
        for (size_t i = 0; i < LIST_COUNT; i++)
            printf("glim --list %s\n", lists[i].name);
        return true;
    }
    struct text_nearest nearest = text_nearest_start(what);
    for (size_t i = 0; i < LIST_COUNT; i++) {
        if (text_equal_nocase(what, lists[i].name)) {
            lists[i].print();
            return true;
        }
        text_nearest_try(&nearest, lists[i].name);
    }
    diag_print(diag, DIAG_ERROR, span_none(), NULL,
               "there is no list of '%s': type --list %s", what,
               nearest.best ? nearest.best : "to see which there are");
    return false;
}

bool options_answers(const struct options *options)
{
    return options->action != ACTION_RENDER && options->action != ACTION_CHECK;
}

bool options_answer(const struct options *options, struct diag *diag)
{
    if (options->action == ACTION_HELP)
        help_print();
    else if (options->action == ACTION_VERSION)
        printf("glim %s\nbuild %s\n", GLIM_VERSION, build_id);
    else if (options->action == ACTION_MAN)
        help_print_man();
    else if (options->action == ACTION_LANGUAGE_SERVER) {
        language_server(options, diag);
        return false;
    } else if (!help_list(options->list_what, diag))
        return false;
    if (fflush(stdout) == 0)
        return true;
    diag_print(diag, DIAG_ERROR, span_none(), NULL,
               "can't write standard output: %s", strerror(errno));
    return false;
}
