/* What was meant by what is no option: for the words of errors. */
#include "cli/option.h"

#include <dirent.h>
#include <sys/stat.h>

#include "base/text.h"

/* Keys are written with '_', words with '-': --output-alpha is near to
 * Output_Alpha. */
static const char *guess_dashes(struct arena *arena, const char *name,
                                char from, char to)
{
    char *text = arena_copy_text(arena, name, strlen(name));
    for (char *c = text; *c; c++)
        if (*c == from)
            *c = to;
    return text;
}

/* The row whose key, or whose word, is nearest. NULL: none is near. */
static const struct option *guess_row(struct arena *arena, const char *name,
                                      bool word)
{
    const struct option *best = NULL;
    struct text_nearest nearest =
        text_nearest_start(word ? guess_dashes(arena, name, '_', '-')
                                : guess_dashes(arena, name, '-', '_'));
    for (size_t i = 0; option_at(i); i++) {
        const struct option *option = option_at(i);
        const char *known = word ? option->word : option->key;
        const char *before = nearest.best;
        if (known)
            text_nearest_try(&nearest, known);
        if (nearest.best != before)
            best = option;
    }
    return best;
}

/* The option as it should have been typed; `rest` is the value, with its '='
 * if it had one, or "". */
static const char *guess_spelling(struct arena *arena, const char *name,
                                  const char *rest, bool word)
{
    const struct option *option = guess_row(arena, name, word);
    bool other = !option;
    if (other)
        option = guess_row(arena, name, !word);
    if (!option)
        return NULL;
    bool by_word = word != other;
    if (*rest || !other)
        return arena_printf(arena, "%s%s%s", by_word ? "--" : "",
                            by_word ? option->word : option->key, rest);
    return option_spelling(option, by_word, arena);
}

/* What other programs call it. */
struct synonym {
    const char *name, *meant;
};

static const char *synonym_find(const struct synonym *synonyms, size_t count,
                                const char *name)
{
    for (size_t i = 0; i < count; i++)
        if (text_equal_nocase(name, synonyms[i].name))
            return synonyms[i].meant;
    return NULL;
}

/* On the command line, */
static const char *guess_synonym(const char *name)
{
    static const struct synonym synonyms[] = {
        { "output", "+Oname" },
        { "out", "+Oname" },
        { "input", "+Iscene.pov" },
        { "size", "+W320 +H240" },
        { "s", "+W320 +H240" },
        { "resolution", "+W320 +H240" },
        { "frames", "+KFF10" },
        { "width", "+W320" },
        { "height", "+H240" },
        { "quality", "+Q9" },
        { "clock", "+K0" },
        { "continue", "+C" },
        { "resume", "+C" },
        { "jobs", "--threads 4" },
        { "t", "--threads 4" },
        { "n", "--threads 4" },
        { "antialias", "+A0.3" },
        { "antialiasing", "+A0.3" },
        { "aa", "+A0.3" },
        { "include", "+Ldirectory" },
        { "format", "+FN" },
        { "method", "--lighting rays" },
        { "define", "Declare=Name=1" },
        { "gamma", "File_Gamma=sRGB" },
        { "preview", "--lighting rays" },
        { "fast", "--lighting rays" },
        { "nt", "--threads 4" },
        { "cores", "--threads 4" },
        { "cpus", "--threads 4" },
    };
    return synonym_find(synonyms, sizeof synonyms / sizeof *synonyms, name);
}

bool option_is_word(struct arena *arena, const char *text)
{
    size_t length = strcspn(text, "=");
    const char *name = arena_copy_text(arena, text, length);
    const struct option *letters = option_find_letters(name);
    bool all = letters && strlen(letters->letters) == length;
    return !all && (option_find_word(name) || guess_synonym(name));
}

/* and in an INI file. */
static const char *guess_key(const char *name)
{
    static const struct synonym synonyms[] = {
        { "antialias_method", "Sampling_Method=2" },
        { "antialiasing_method", "Sampling_Method=2" },
        { "antialias_level", "Antialias_Depth=3" },
        { "resolution", "Width=320, and Height=240 in a line of its own" },
        { "size", "Width=320, and Height=240 in a line of its own" },
        { "image_width", "Width=320" },
        { "image_height", "Height=240" },
        { "input", "Input_File_Name=scene.pov" },
        { "scene", "Input_File_Name=scene.pov" },
        { "output", "Output_File_Name=picture" },
        { "frames", "Final_Frame=10" },
        { "first_frame", "Initial_Frame=1" },
        { "last_frame", "Final_Frame=10" },
        { "start_frame", "Initial_Frame=1" },
        { "end_frame", "Final_Frame=10" },
        { "threads", "Work_Threads=4" },
        { "max_threads", "Work_Threads=4" },
        { "include_path", "Library_Path=folder" },
        { "format", "Output_File_Type=N" },
        { "file_type", "Output_File_Type=N" },
        { "gamma", "File_Gamma=sRGB" },
    };
    return synonym_find(synonyms, sizeof synonyms / sizeof *synonyms, name);
}

const char *option_scene_near(struct arena *arena, const char *name)
{
    const char *last = text_last_part(name);
    int folder = (int)(last - name);
    struct text_nearest nearest = text_nearest_start(last);
    DIR *directory =
        opendir(folder ? arena_printf(arena, "%.*s", folder, name) : ".");
    struct dirent *entry;
    while (directory && (entry = readdir(directory)) != NULL) {
        size_t length = strlen(entry->d_name);
        if (length > 4 && text_equal_nocase(entry->d_name + length - 4, ".pov"))
            text_nearest_try(&nearest,
                             arena_printf(arena, "%s", entry->d_name));
    }
    if (directory)
        closedir(directory);
    return nearest.best
               ? arena_printf(arena, "%.*s%s", folder, name, nearest.best)
               : NULL;
}

bool option_scene_missing(struct option_reader *reader, const char *name)
{
    struct stat status;
    if (stat(name, &status) == 0) {
        diag_print(reader->diag, DIAG_ERROR, span_none(), NULL,
                   "'%s' is a directory, not a scene", name);
        return false;
    }
    const char *near = option_scene_near(reader->arena, name);
    const char *hint =
        near ? arena_printf(reader->arena, "did you mean '%s'?", near) : NULL;
    diag_print(
        reader->diag, DIAG_ERROR, span_none(), hint,
        "there is no scene '%s', neither here nor along the library path",
        name);
    return false;
}

/* What was typed, in parts: "--wdith=3" is 2 signs, "wdith" and "=3". */
struct guess {
    const char *name, *plain, *rest;
    size_t signs;
    const struct option *letters; /* the name begins with them, or NULL */
};

static struct guess guess_parts(struct arena *arena, const char *name)
{
    size_t signs = strspn(name, "+-");
    size_t length = strcspn(name + signs, "= \t");
    return (struct guess){
        .name = name,
        .plain = arena_copy_text(arena, name + signs, length),
        .rest = name + signs + length,
        .signs = signs,
        .letters = signs == 1 ? option_find_letters(name + 1) : NULL,
    };
}

/* The option with the nearest name. */
static const char *guess_near(struct arena *arena, const struct guess *guess)
{
    /* +Wabc is no word mistyped. */
    if (guess->letters && guess->letters->argument &&
        strlen(guess->plain) <= 4 && !*guess->rest)
        return NULL;
    return guess_spelling(arena, guess->plain, guess->rest, guess->signs == 2);
}

/* W=320: the row whose letters are all of the name, or NULL. */
static const struct option *guess_assigned(const struct guess *guess)
{
    const struct option *option =
        guess->signs ? NULL : option_find_letters(guess->plain);
    return option && strlen(option->letters) == strlen(guess->plain) ? option
                                                                     : NULL;
}

static bool guess_is_switch(const struct option *option)
{
    if (option->set == set_ignored)
        return option->offset == IGNORED_SWITCH;
    return !option->argument ||
           (strcmp(option->argument, "bool") == 0 && !option->also);
}

/* What to type for letters with something wrong behind them. */
static const char *guess_letters(struct arena *arena, const struct guess *guess)
{
    const struct option *letters = guess->letters;
    if (!letters)
        return NULL;
    return guess_is_switch(letters)
               ? arena_printf(arena, "type %c%s, and nothing behind it",
                              guess->name[0], letters->letters)
               : arena_printf(
                     arena, "+%s wants a number; glim --help lists the options",
                     letters->letters);
}

static const char *guess_in_file(struct arena *arena, const struct guess *guess)
{
    const char *hint = guess_key(guess->plain);
    const struct option *assigned = guess_assigned(guess);
    if (!hint)
        hint = guess_near(arena, guess);
    if (!hint && assigned)
        return assigned->key;
    return hint ? hint : guess_letters(arena, guess);
}

/* "type +W320", with the number that was typed if there is one. */
static const char *guess_numbered(struct arena *arena, const char *synonym,
                                  const char *said)
{
    double number;
    int letters = (int)strcspn(synonym, "0123456789. ");
    bool one = synonym[0] == '+' && synonym[letters] && !strchr(synonym, ' ');
    return one && said && option_number(said, &number)
               ? arena_printf(arena, "type %.*s%s", letters, synonym, said)
               : arena_printf(arena, "type %s", synonym);
}

/* -output x.png, -threads 4; NULL: neither another program's nor a word. */
static const char *guess_other(struct option_reader *reader, const char *next,
                               const struct guess *guess)
{
    struct arena *arena = reader->arena;
    const char *synonym = guess_synonym(guess->plain);
    const struct option *word =
        guess->signs == 1 ? option_find_word(guess->plain) : NULL;
    bool output = synonym && strcmp(synonym, "+Oname") == 0;
    if (output && guess->rest[0] == '=' && guess->rest[1])
        return arena_printf(arena, "type +O%s", guess->rest + 1);
    if (output && next && !strpbrk(next, "+-=")) {
        reader->took_next = true;
        return arena_printf(arena, "type +O%s", next);
    }
    if (synonym || (word && word->argument))
        reader->took_next = next && !strpbrk(next, "+-=./");
    if (synonym)
        return guess_numbered(arena, synonym,
                              *guess->rest == '=' ? guess->rest + 1 : next);
    return word ? arena_printf(arena, "type --%s%s%s%s", guess->plain,
                               guess->rest, reader->took_next ? " " : "",
                               reader->took_next ? next : "")
                : NULL;
}

static const char *guess_typed(struct option_reader *reader, const char *next,
                               const struct guess *guess)
{
    struct arena *arena = reader->arena;
    const struct option *assigned =
        *guess->rest == '=' ? guess_assigned(guess) : NULL;
    const char *hint = guess_other(reader, next, guess);
    const char *near = hint ? NULL : guess_near(arena, guess);
    if (near)
        return arena_printf(arena, "did you mean '%s'?", near);
    if (!hint && assigned)
        return arena_printf(arena, "type +%s%s", guess->plain, guess->rest + 1);
    if (!hint)
        hint = guess_letters(arena, guess);
    if (!hint && !guess->signs && *guess->rest == '=')
        return arena_printf(arena,
                            "type Declare=%s to give the scene a value; glim "
                            "--help lists the options",
                            guess->name);
    return hint ? hint : "glim --help lists the options";
}

bool option_unknown(struct option_reader *reader, const struct setting *setting,
                    const char *name)
{
    struct guess guess = guess_parts(reader->arena, name);
    const char *hint = setting->span.source
                           ? guess_in_file(reader->arena, &guess)
                           : guess_typed(reader, setting->next, &guess);
    diag_print(reader->diag, DIAG_ERROR, setting->span, hint,
               "unknown option '%s'", name);
    return false;
}

const char *option_meant(struct arena *arena, const char *text)
{
    double number;
    const struct option *option = option_find_key(text);
    if (option)
        return option_spelling(option, false, arena);
    option = option_find_word(text);
    if (option)
        return option_spelling(option, true, arena);
    option = option_find_letters(text);
    if (option && option_number(text + strlen(option->letters), &number))
        return arena_printf(arena, "+%s", text);
    return NULL;
}
