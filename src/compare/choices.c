/* The command line of glim-compare: see choices.h. One table is what is read
 * and what --help prints. */
#include "compare/choices.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/text.h"
#include "compare/flip.h"

#define UNSAID ((double)NAN)

enum choice_kind { KIND_FLAG, KIND_NUMBER, KIND_TEXT, KIND_WORDS };

struct choice_row {
    const char *word; /* without "--"; NULL: `help` is a title */
    enum choice_kind kind;
    size_t offset; /* into struct choices */
    double minimum, maximum;
    const char *argument;
    const char *help;
};

#define AT(field) offsetof(struct choices, field)
#define TITLE(title)                                                           \
    {                                                                          \
        .help = title                                                          \
    }
#define FLAG(word, field, help)                                                \
    {                                                                          \
        word, KIND_FLAG, AT(field), 0, 0, NULL, help                           \
    }
#define NUMBER(word, field, low, high, help)                                   \
    {                                                                          \
        word, KIND_NUMBER, AT(field), low, high, "N", help                     \
    }
#define TEXT(word, field, argument, help)                                      \
    {                                                                          \
        word, KIND_TEXT, AT(field), 0, 0, argument, help                       \
    }
#define WORDS(word, field, help)                                               \
    {                                                                          \
        word, KIND_WORDS, AT(field), 0, 0, "ARG", help                         \
    }

/* clang-format off */
static const struct choice_row table[] = {
    TITLE("How"),
    FLAG("linear", linear, "compare light, not what a monitor gets"),
    FLAG("raw", raw, "compare the numbers as they stand in the files"),
    NUMBER("threshold", threshold, 0, 1e9,
           "pixels that differ by more are over it (3.5/255)"),
    NUMBER("pixels-per-degree", pixels_per_degree, 1, FLIP_PIXELS_LIMIT,
           "of the viewer's eye, for FLIP (67)"),
    TITLE("Limits; N may be a fraction such as 3/255"),
    NUMBER("max-mean", limits.mean, 0, 1e9, "of the mean difference"),
    NUMBER("max-relative", limits.relative, 0, 1e9,
           "of the mean relative difference"),
    NUMBER("max-rmse", limits.rmse, 0, 1e9, "of the root mean square"),
    NUMBER("min-psnr", limits.psnr, -1e9, 1e9,
           "of the peak signal-to-noise ratio, dB"),
    NUMBER("max-over", limits.over, 0, 1,
           "of the share of pixels over the threshold"),
    NUMBER("max-flip", limits.flip, 0, 1, "of the mean FLIP"),
    NUMBER("min-ssim", limits.ssim, -1, 1, "of the mean SSIM"),
    TITLE("What is written"),
    TEXT("heat", heat, "FILE", "a heat map of the differences"),
    TEXT("strip", strip, "FILE", "A, B and the heat map side by side"),
    TEXT("show", show, "WHAT",
         "in the heat map: flip, difference or relative (flip)"),
    NUMBER("top", top, 1e-9, 1e9,
           "value of its brightest colour (1; of difference 0.25)"),
    FLAG("csv", csv, "the figures on one line, with commas"),
    FLAG("names", names_first, "as --csv, after a line with their names"),
    FLAG("quiet", quiet, "no figures, only errors and the exit status"),
    TITLE("A scene"),
    WORDS("povray", povray, "an argument for POV-Ray alone"),
    WORDS("glim", glim, "an argument for glim alone: --glim --lighting=path"),
    TITLE("Other"),
    FLAG("help", help, "this list"),
    FLAG("version", version, "the version"),
};
/* clang-format on */

enum { ROW_COUNT = sizeof table / sizeof *table };

struct choices_reader {
    struct choices *choices;
    struct arena *arena;
    struct diag *diag;
    struct words plain; /* names, and what a scene's programs get */
};

__attribute__((format(printf, 2, 3))) static bool
choices_fail(struct choices_reader *reader, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    diag_vprint(reader->diag, DIAG_ERROR, span_none(), NULL, format, arguments);
    va_end(arguments);
    return false;
}

static const struct choice_row *choices_find(const char *word)
{
    for (size_t i = 0; i < ROW_COUNT; i++)
        if (table[i].word && strcmp(table[i].word, word) == 0)
            return &table[i];
    return NULL;
}

static bool choices_unknown(struct choices_reader *reader, const char *typed,
                            const char *word)
{
    struct text_nearest nearest = text_nearest_start(word);
    for (size_t i = 0; i < ROW_COUNT; i++)
        if (table[i].word)
            text_nearest_try(&nearest, table[i].word);
    if (nearest.best)
        return choices_fail(reader,
                            "unknown option '%s' (did you mean '--%s'?)", typed,
                            nearest.best);
    return choices_fail(reader,
                        "unknown option '%s' (glim-compare --help lists the "
                        "options)",
                        typed);
}

/* "0.01" or "3/255". */
static bool choices_read_number(const char *text, double *number)
{
    static const char *const digits = "0123456789+-.eE";
    char *end;
    size_t length = strspn(text, digits);
    *number = strtod(text, &end);
    if (length == 0 || end != text + length)
        return false;
    if (*end == '/') {
        const char *rest = end + 1;
        length = strspn(rest, digits);
        *number /= strtod(rest, &end);
        if (length == 0 || end != rest + length)
            return false;
    }
    return *end == '\0' && isfinite(*number);
}

static bool choices_set_number(struct choices_reader *reader,
                               const struct choice_row *row, const char *value)
{
    double number;
    if (!choices_read_number(value, &number))
        return choices_fail(reader, "--%s wants a number, not '%s'", row->word,
                            value);
    if (!(number >= row->minimum && number <= row->maximum))
        return choices_fail(reader, "--%s must be from %s to %s, not %s",
                            row->word, NUMBER_TEXT(row->minimum),
                            NUMBER_TEXT(row->maximum), value);
    *(double *)((char *)reader->choices + row->offset) = number;
    return true;
}

static bool choices_set(struct choices_reader *reader,
                        const struct choice_row *row, char *value)
{
    void *place = (char *)reader->choices + row->offset;
    if (row->kind == KIND_NUMBER)
        return choices_set_number(reader, row, value);
    if (row->kind == KIND_WORDS)
        *ARRAY_PUSH(reader->arena, (struct words *)place) = value;
    else if (row->kind == KIND_TEXT)
        *(const char **)place = value;
    else
        *(bool *)place = true;
    return true;
}

/* One `--word`, `--word=value` or `--word value`; *used: how many of the
 * arguments that was. `next` is NULL after the last. */
static bool choices_read_word(struct choices_reader *reader, char *typed,
                              char *next, int *used)
{
    size_t length = strcspn(typed + 2, "=");
    char *value = typed[2 + length] == '=' ? typed + 3 + length : NULL;
    const char *word = arena_copy_text(reader->arena, typed + 2, length);
    const struct choice_row *row = choices_find(word);
    *used = 1;
    if (!row)
        return choices_unknown(reader, typed, word);
    if (row->kind == KIND_FLAG && value)
        return choices_fail(reader, "--%s takes no value", word);
    if (row->kind != KIND_FLAG && !value) {
        value = next;
        *used = 2;
    }
    if (row->kind != KIND_FLAG && (!value || !*value))
        return choices_fail(reader, "--%s needs a value: type --%s %s", word,
                            word,
                            row->kind == KIND_NUMBER  ? "0.01"
                            : row->offset == AT(show) ? "flip"
                            : row->kind == KIND_TEXT  ? "name.png"
                                                      : "ARG");
    return choices_set(reader, row, value);
}

static bool choices_is_scene(const char *word)
{
    size_t length = strlen(word);
    return length > 4 && !strchr("+-", word[0]) && !strchr(word, '=') &&
           text_equal_nocase(word + length - 4, ".pov");
}

static bool choices_take_scene(struct choices_reader *reader, size_t scene)
{
    struct choices *choices = reader->choices;
    choices->scene = true;
    for (size_t i = 0; i < reader->plain.count; i++) {
        char *word = reader->plain.items[i];
        if (i == scene)
            choices->names[choices->name_count++] = word;
        else if (choices_is_scene(word))
            return choices_fail(reader, "one scene at a time: '%s' and '%s'",
                                choices->names[0], word);
        else if (!strchr("+-", *word) && !strchr(word, '='))
            return choices_fail(reader,
                                "'%s' is no scene and no option of a renderer: "
                                "a scene or two pictures are compared",
                                word);
        else {
            *ARRAY_PUSH(reader->arena, &choices->povray) = word;
            *ARRAY_PUSH(reader->arena, &choices->glim) = word;
        }
    }
    return true;
}

static bool choices_take_pictures(struct choices_reader *reader,
                                  size_t names_only)
{
    struct choices *choices = reader->choices;
    const struct words *plain = &reader->plain;
    for (size_t i = 0; i < plain->count && i < names_only; i++)
        if (plain->items[i][0] == '+' || plain->items[i][0] == '-')
            return choices_unknown(reader, plain->items[i],
                                   plain->items[i] + 1);
    if (plain->count != 2)
        return choices_fail(reader,
                            "two pictures or a scene wanted, not %zu names: "
                            "type glim-compare A.png B.png, or glim-compare "
                            "scene.pov",
                            plain->count);
    choices->names[0] = plain->items[0];
    choices->names[1] = plain->items[1];
    choices->name_count = 2;
    return true;
}

/* `names_only`: how many of the plain words stood before "--". */
static bool choices_take_names(struct choices_reader *reader, size_t names_only)
{
    for (size_t i = 0; i < reader->plain.count; i++)
        if (choices_is_scene(reader->plain.items[i]))
            return choices_take_scene(reader, i);
    struct choices *choices = reader->choices;
    if (choices->povray.count || choices->glim.count)
        return choices_fail(reader, "--povray and --glim are for a scene: type "
                                    "glim-compare scene.pov");
    return choices_take_pictures(reader, names_only);
}

static bool choices_check(struct choices_reader *reader)
{
    struct choices *choices = reader->choices;
    static const char *const shown[] = { "flip", "difference", "relative" };
    bool known = false;
    for (size_t i = 0; i < sizeof shown / sizeof *shown; i++)
        known = known || strcmp(choices->show, shown[i]) == 0;
    if (!known)
        return choices_fail(reader,
                            "--show wants flip, difference or relative, not "
                            "'%s'",
                            choices->show);
    if (choices->linear && choices->raw)
        return choices_fail(reader, "--linear and --raw exclude each other");
    choices->csv = choices->csv || choices->names_first;
    return true;
}

bool choices_parse(struct choices *choices, int argc, char **argv,
                   struct arena *arena, struct diag *diag)
{
    *choices = (struct choices){
        .threshold = 3.5 / 255,
        .pixels_per_degree = FLIP_PIXELS_PER_DEGREE,
        .limits = { UNSAID, UNSAID, UNSAID, UNSAID, UNSAID, UNSAID, UNSAID },
        .show = "flip",
        .top = UNSAID,
    };
    struct choices_reader reader = { .choices = choices,
                                     .arena = arena,
                                     .diag = diag };
    size_t names_only = SIZE_MAX;
    for (int i = 1, used; i < argc; i += used) {
        used = 1;
        if (names_only == SIZE_MAX && strcmp(argv[i], "--") == 0)
            names_only = reader.plain.count;
        else if (strcmp(argv[i], "-h") == 0 || strcmp(argv[i], "-?") == 0)
            choices->help = true;
        else if (names_only == SIZE_MAX && strncmp(argv[i], "--", 2) == 0) {
            if (!choices_read_word(&reader, argv[i], argv[i + 1], &used))
                return false;
        } else
            *ARRAY_PUSH(arena, &reader.plain) = argv[i];
    }
    if (choices->help || choices->version)
        return true;
    return choices_check(&reader) && choices_take_names(&reader, names_only);
}

enum pair_space choices_space(const struct choices *choices)
{
    if (choices->raw)
        return SPACE_RAW;
    return choices->linear ? SPACE_LINEAR : SPACE_DISPLAY;
}

enum shown choices_shown(const struct choices *choices)
{
    return choices->show[0] == 'f'   ? SHOW_FLIP
           : choices->show[0] == 'd' ? SHOW_DIFFERENCE
                                     : SHOW_RELATIVE;
}

double choices_top(const struct choices *choices)
{
    if (!isnan(choices->top))
        return choices->top;
    return choices_shown(choices) == SHOW_DIFFERENCE ? 0.25 : 1;
}

bool limits_any(const struct limits *limits)
{
    return !(isnan(limits->mean) && isnan(limits->relative) &&
             isnan(limits->rmse) && isnan(limits->psnr) &&
             isnan(limits->over) && isnan(limits->flip) && isnan(limits->ssim));
}

void choices_help(void)
{
    printf("usage: glim-compare [option ...] A B\n"
           "       glim-compare [option ...] scene.pov [option for both "
           "programs ...]\n"
           "Compares two pictures, or what POV-Ray and glim make of a scene. "
           "Exit status: 0\nalike, 1 different, 2 trouble. See "
           "glim-compare(1).\n");
    for (size_t i = 0; i < ROW_COUNT; i++) {
        char name[64];
        if (!table[i].word) {
            printf("\n%s:\n", table[i].help);
            continue;
        }
        snprintf(name, sizeof name, "--%s%s%s", table[i].word,
                 table[i].argument ? " " : "",
                 table[i].argument ? table[i].argument : "");
        printf("  %-22s %s\n", name, table[i].help);
    }
}
