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

bool option_unknown(struct option_reader *reader, const struct setting *setting,
                    const char *name)
{
    struct arena *arena = reader->arena;
    size_t start = strspn(name, "+-"), length = strcspn(name + start, "= \t");
    const char *plain = arena_copy_text(arena, name + start, length);
    const char *rest = name + start + length;
    bool word = strncmp(name, "--", 2) == 0;
    const char *hint = guess_spelling(arena, plain, rest, word);
    const struct option *letters =
        start == 1 ? option_find_letters(name + 1) : NULL;
    const struct option *assigned =
        start == 0 && (*rest == '=' || setting->span.source)
            ? option_find_letters(plain)
            : NULL;
    if (assigned && strlen(assigned->letters) != length)
        assigned = NULL;
    /* +Wabc is no word mistyped. */
    if (letters && letters->argument && length <= 4 && !*rest)
        hint = NULL;
    const char *synonym =
        setting->span.source ? guess_key(plain) : guess_synonym(plain);
    bool output = synonym && strcmp(synonym, "+Oname") == 0 && setting->next &&
                  !strpbrk(setting->next, "+-=");
    if (synonym && setting->span.source) {
        hint = synonym;
    } else if (output) {
        hint = arena_printf(arena, "type +O%s", setting->next);
        reader->took_next = true;
    } else if (synonym) {
        hint = arena_printf(arena, "type %s", synonym);
        reader->took_next = setting->next && !strpbrk(setting->next, "+-=./");
    } else if (hint && !setting->span.source) {
        hint = arena_printf(arena, "did you mean '%s'?", hint);
    } else if (!hint && assigned) {
        hint = setting->span.source
                   ? assigned->key
                   : arena_printf(arena, "type +%s%s", plain, rest + 1);
    } else if (!hint && letters && letters->argument) {
        hint = arena_printf(arena,
                            "+%s wants a number; glim --help lists the options",
                            letters->letters);
    } else if (!hint && start == 0 && !setting->span.source && *rest == '=') {
        hint = arena_printf(arena,
                            "type Declare=%s to give the scene a value; glim "
                            "--help lists the options",
                            name);
    } else if (!hint && !setting->span.source) {
        hint = "glim --help lists the options";
    }
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
