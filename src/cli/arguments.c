/* Arguments of the command line: which belong together. See option.h. */
#include "cli/option.h"

#include "base/text.h"

/* The compiler's -MF FILE and -MT TARGET. */
static bool argument_is_compilers(const char *argument)
{
    return strcmp(argument, "-MF") == 0 || strcmp(argument, "-MT") == 0;
}

/* What is to be read, and so no picture. */
static bool argument_is_input(const char *argument)
{
    size_t length = strlen(argument);
    const char *end = argument + (length > 4 ? length - 4 : 0);
    return text_equal_nocase(end, ".pov") || text_equal_nocase(end, ".ini") ||
           strchr(argument, '=');
}

/* --threads 4 is --threads=4: the value of a word may be the next argument. */
static bool argument_takes_next(const char *argument, const char *next)
{
    if (strncmp(argument, "--", 2) != 0 || !next || strchr(argument, '='))
        return false;
    const struct option *option = option_find_word(argument + 2);
    if (!option || !option->argument)
        return false;
    if (strcmp(option->argument, "[json]") == 0)
        return strcmp(next, "json") == 0 || strcmp(next, "text") == 0;
    if (strcmp(option->argument, "[file]") == 0 && argument_is_input(next))
        return false;
    return option->argument[0] != '[' || !strchr("+-", next[0]);
}

/* --wdith 10: no word about the value of what is no option. */
static bool argument_wastes_next(const char *argument, const char *next)
{
    return strncmp(argument, "--", 2) == 0 && next && !strchr(argument, '=') &&
           !option_find_word(argument + 2) && !strpbrk(next, "+-=./");
}

/* How many arguments make one setting, which is put into *token. */
static int argument_take(struct option_reader *reader, char **argv,
                         const char *next, struct setting *token)
{
    *token = (struct setting){ .shown = argv[0], .next = next };
    bool compilers = next && argument_is_compilers(argv[0]);
    if (!compilers && !argument_takes_next(argv[0], next))
        return 1;
    token->shown = arena_printf(reader->arena, "%s%s%s", argv[0],
                                compilers ? "" : "=", next);
    return 2;
}

bool arguments_read(struct option_reader *reader, int argc, char **argv)
{
    bool good = true, ended = false;
    for (int i = 1; i < argc; i++) {
        if (ended) { /* after --: a scene, whatever its name */
            reader->options->input = argv[i];
            continue;
        }
        if (strcmp(argv[i], "--") == 0) {
            ended = true;
            continue;
        }
        struct setting token;
        const char *next = i + 1 < argc ? argv[i + 1] : NULL;
        bool two = argument_take(reader, argv + i, next, &token) == 2;
        bool known = option_read(reader, &token);
        i += two || (!known && (reader->took_next ||
                                argument_wastes_next(argv[i], next)));
        reader->took_next = false;
        good = known && good;
    }
    return good;
}
