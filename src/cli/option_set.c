/* Setters: each checks one kind of value and puts it in its place. They
 * return false after an error was reported. See option.h. */
#include "cli/option.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>

#include "base/directory.h"
#include "base/text.h"
#include "cli/output_name.h"
#include "tracer/integrator.h"

/* An INI file may be long: a list that nobody means is not searched. */
enum { LIBRARY_LIMIT = 1000 };

static void *option_place(struct option_reader *reader,
                          const struct option *option)
{
    return (char *)reader->options + option->offset;
}

bool option_number(const char *text, double *number)
{
    size_t length = strspn(text, "0123456789+-.eE");
    char *end;
    *number = strtod(text, &end);
    return length > 0 && text[length] == '\0' && *end == '\0' &&
           isfinite(*number);
}

/* The option as it was typed, ready for its value. */
static const char *option_typed(struct option_reader *reader,
                                const struct option *option,
                                const struct setting *setting)
{
    bool word = setting->shown && strncmp(setting->shown, "--", 2) == 0;
    if (option->word && (word || !option->key))
        return arena_printf(reader->arena, "--%s ", option->word);
    if (option->letters && !setting->by_key)
        return arena_printf(reader->arena, "+%s", option->letters);
    return arena_printf(reader->arena, "%s=", option->key);
}

/* "Include_Header=" says nothing, as in POV-Ray: programs that write INI files
 * name every key. */
static bool option_is_void(const struct setting *setting)
{
    return setting->by_key && setting->value && !*setting->value;
}

bool option_wants(struct option_reader *reader, const struct option *option,
                  const struct setting *setting, const char *example)
{
    if (setting->value && *setting->value)
        return true;
    const char *next = setting->next;
    bool scene = next && text_equal_nocase(next + strcspn(next, "."), ".pov");
    if (next && *next && (!strchr("+-", *next) || strcmp(next, "-") == 0) &&
        (!scene || strstr(example, ".pov"))) {
        reader->took_next = true;
        example = next;
    }
    return option_fail(reader, setting, "%s needs a value: type %s%s",
                       option->key ? option->key : option->word,
                       option_typed(reader, option, setting), example);
}

/* The same of a file's name. Shells replace a '~' that begins a word, and INI
 * files none. */
static bool option_wants_name(struct option_reader *reader,
                              const struct option *option,
                              const struct setting *setting,
                              const char *example)
{
    const char *name = setting->value, *home = getenv("HOME");
    if (!option_wants(reader, option, setting, example))
        return false;
    if (strncmp(name, "~/", 2) != 0 || path_is_directory("~"))
        return true;
    return option_fail(reader, setting, "a '~' means nothing here: type %s%s%s",
                       option_typed(reader, option, setting),
                       home ? home : "/home/me", name + 1);
}

bool option_read_number(struct option_reader *reader,
                        const struct option *option,
                        const struct setting *setting, double *number)
{
    if (!option_wants(reader, option, setting, "5"))
        return false;
    if (option_number(setting->value, number))
        return true;
    if (!setting->by_key && !isdigit((unsigned char)*setting->value) &&
        !strchr("+-.", *setting->value))
        return option_unknown(reader, setting, setting->shown);
    size_t first = strspn(setting->value, "0123456789.");
    if (!setting->by_key && first && strchr("+- ", setting->value[first]))
        return option_fail(reader, setting,
                           "options are apart from each other: type +%s%.*s %s",
                           option->letters, (int)first, setting->value,
                           setting->value + first +
                               (setting->value[first] == ' '));
    return option_fail(reader, setting, "%s wants a number, not '%s'%s",
                       option->key, setting->value,
                       setting->span.source && strchr(setting->value, '=')
                           ? "; one Key=value on each line"
                           : "");
}

static bool option_in_range(struct option_reader *reader,
                            const struct option *option,
                            const struct setting *setting, double number)
{
    if (number >= option->minimum && number <= option->maximum)
        return true;
    if (option->minimum <= -1e300)
        return option_fail(reader, setting, "%s is too large", option->key);
    return option_fail(reader, setting, "%s must be from %s to %s", option->key,
                       NUMBER_TEXT(option->minimum),
                       NUMBER_TEXT(option->maximum));
}

bool set_number(struct option_reader *reader, const struct option *option,
                const struct setting *setting)
{
    double number;
    if (!option_read_number(reader, option, setting, &number) ||
        !option_in_range(reader, option, setting, number))
        return false;
    *(double *)option_place(reader, option) = number;
    return true;
}

bool set_whole(struct option_reader *reader, const struct option *option,
               const struct setting *setting)
{
    double number;
    if (!option_read_number(reader, option, setting, &number) ||
        !option_in_range(reader, option, setting, number))
        return false;
    *(double *)option_place(reader, option) = trunc(number);
    return true;
}

/* 0 is 1, as in POV-Ray. */
bool set_step(struct option_reader *reader, const struct option *option,
              const struct setting *setting)
{
    double *step = option_place(reader, option);
    if (!set_whole(reader, option, setting))
        return false;
    if (*step == 0) {
        option_warn(reader, setting, "%s 0 counts as 1: every frame",
                    option->key);
        *step = 1;
    }
    return true;
}

/* Where POV-Ray takes any number and uses the nearest it can, so does this. */
static bool option_is_lenient(const struct option *option)
{
    static const char *const keys[] = {
        "Antialias_Depth", "Sampling_Method",   "Quality",     "Bits_Per_Color",
        "Warning_Level",   "Render_Block_Size", "Compression", "Work_Threads",
    };
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        if (strcmp(option->key, keys[i]) == 0)
            return true;
    return false;
}

bool set_integer(struct option_reader *reader, const struct option *option,
                 const struct setting *setting)
{
    double number;
    if (!option_read_number(reader, option, setting, &number))
        return false;
    number = trunc(number);
    if (option_is_lenient(option)) {
        double nearest = fmin(fmax(number, option->minimum), option->maximum);
        if (nearest != number)
            option_warn(reader, setting,
                        "%s goes from %.0f to %.0f; %.0f is used", option->key,
                        option->minimum, option->maximum, nearest);
        number = nearest;
    }
    if (!option_in_range(reader, option, setting, number))
        return false;
    *(int *)option_place(reader, option) = (int)number;
    return true;
}

/* POV-Ray's: everything else is off. */
static bool option_is_true(const char *value)
{
    static const char *const words[] = { "true", "yes", "on", "1" };
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (text_equal_nocase(value, words[i]))
            return true;
    return false;
}

static bool option_is_false(const char *value)
{
    static const char *const words[] = { "false", "no", "off", "0", "" };
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (text_equal_nocase(value, words[i]))
            return true;
    return false;
}

bool option_truth(const char *value, bool *state)
{
    *state = option_is_true(value);
    return *state || option_is_false(value);
}

/* The state that a switch or a key asks for. */
static bool option_state(struct option_reader *reader,
                         const struct option *option,
                         const struct setting *setting)
{
    bool state;
    if (!setting->by_key)
        return setting->on;
    const char *value = setting->value ? setting->value : "";
    if (!option_truth(value, &state))
        option_warn(reader, setting,
                    "%s is on or off; '%s' counts as off, as in POV-Ray",
                    option->key, value);
    return state;
}

/* Whether something stands behind a switch's letters. */
static bool option_has_more(const struct setting *setting)
{
    return !setting->by_key && setting->value && *setting->value;
}

bool set_switch(struct option_reader *reader, const struct option *option,
                const struct setting *setting)
{
    bool has_value = option_has_more(setting);
    if (has_value && !option->also)
        return option_unknown(reader, setting, setting->shown);
    *(bool *)option_place(reader, option) =
        option_state(reader, option, setting);
    if (!has_value)
        return true;
    const struct option *also = option_find_key(option->also);
    return also->set(reader, also, setting);
}

bool set_flag(struct option_reader *reader, const struct option *option,
              const struct setting *setting)
{
    if (option_has_more(setting))
        return option_unknown(reader, setting, setting->shown);
    *(bool *)option_place(reader, option) = true;
    return true;
}

bool set_verbose(struct option_reader *reader, const struct option *option,
                 const struct setting *setting)
{
    if (option_has_more(setting))
        return option_unknown(reader, setting, setting->shown);
    /* Debian's povray.ini says Verbose=On. */
    if (!reader->startup)
        reader->options->progress = option_state(reader, option, setting)
                                        ? PROGRESS_ALWAYS
                                        : PROGRESS_NEVER;
    return true;
}

bool set_all_consoles(struct option_reader *reader, const struct option *option,
                      const struct setting *setting)
{
    reader->options->messages = reader->options->warnings =
        option_state(reader, option, setting);
    return !option_has_more(setting) ||
           set_message_file(reader, option, setting);
}

bool set_quiet(struct option_reader *reader, const struct option *option,
               const struct setting *setting)
{
    (void)option;
    (void)setting;
    reader->options->messages = reader->options->warnings = false;
    reader->options->progress = PROGRESS_NEVER;
    return true;
}

void option_add_library(struct option_reader *reader, const char *directory)
{
    for (size_t i = 0; i < reader->library.count; i++)
        if (strcmp(reader->library.items[i], directory) == 0)
            return;
    *ARRAY_PUSH(reader->arena, &reader->library) = directory;
}

bool set_library(struct option_reader *reader, const struct option *option,
                 const struct setting *setting)
{
    if (option_is_void(setting))
        return true;
    if (!option_wants_name(reader, option, setting, "dir"))
        return false;
    if (reader->library.count >= LIBRARY_LIMIT)
        return option_fail(reader, setting,
                           "the library path has %d directories at most",
                           LIBRARY_LIMIT);
    option_add_library(reader, setting->value);
    return true;
}

bool set_header(struct option_reader *reader, const struct option *option,
                const struct setting *setting)
{
    if (option_is_void(setting))
        return true;
    if (!option_wants_name(reader, option, setting, "file.inc"))
        return false;
    *ARRAY_PUSH(reader->arena, &reader->headers) = setting->value;
    return true;
}

bool set_input(struct option_reader *reader, const struct option *option,
               const struct setting *setting)
{
    if (option_is_void(setting))
        return true;
    if (!option_wants_name(reader, option, setting, "scene.pov"))
        return false;
    reader->options->input = setting->value;
    return true;
}

bool set_text(struct option_reader *reader, const struct option *option,
              const struct setting *setting)
{
    if (!option_wants(reader, option, setting, option->argument))
        return false;
    *(const char **)option_place(reader, option) = setting->value;
    return true;
}

bool set_output(struct option_reader *reader, const struct option *option,
                const struct setting *setting)
{
    if (option_is_void(setting))
        return true;
    if (!option_wants_name(reader, option, setting, "picture"))
        return false;
    reader->output = setting->value;
    return true;
}

bool set_file_type(struct option_reader *reader, const struct option *option,
                   const struct setting *setting)
{
    if (!option_wants(reader, option, setting, "N"))
        return false;
    const char *value = setting->value;
    const struct output_type *type = output_type_find(value[0]);
    if (!type)
        return option_fail(reader, setting,
                           "there is no file type '%s': type +FN for PNG, "
                           "+FE for OpenEXR, +FJ for JPEG; --list formats "
                           "shows all",
                           value);
    bool grey = false;
    double bits = 0;
    size_t digits = 0;
    for (const char *c = value + 1; *c; c++) {
        if (*c == 'g' || *c == 'G')
            grey = true;
        else if (isdigit((unsigned char)*c) && digits++ < 3)
            bits = bits * 10 + (*c - '0');
        else
            return option_fail(reader, setting,
                               "'%s' is no file type: type a letter (N is PNG, "
                               "E OpenEXR, J JPEG), and behind it a number of "
                               "bits and g for grey if you like, as in N16g",
                               value);
    }
    reader->options->file_type = type->letter;
    reader->options->grey = grey;
    reader->options->bits = 0;
    if (!digits || type->letter == 'J') /* POV-Ray ignores +FJ90's number */
        return true;
    const struct option *also = option_find_key("Bits_Per_Color");
    struct setting depth = *setting;
    depth.value = arena_printf(reader->arena, "%.0f", bits);
    return also->set(reader, also, &depth);
}

bool set_gamma(struct option_reader *reader, const struct option *option,
               const struct setting *setting)
{
    if (!option_wants(reader, option, setting, "sRGB"))
        return false;
    double gamma = 0;
    if (!text_equal_nocase(setting->value, "srgb") &&
        (!option_number(setting->value, &gamma) || gamma < 0.01 || gamma > 100))
        return option_fail(reader, setting,
                           "%s is sRGB or a number from 0.01 to 100, not '%s'",
                           option->key, setting->value);
    *(double *)option_place(reader, option) = gamma;
    return true;
}

static size_t option_name_length(const char *text)
{
    size_t length = 0;
    while (isalnum((unsigned char)text[length]) || text[length] == '_')
        length++;
    return isdigit((unsigned char)text[0]) ? 0 : length;
}

bool set_declare(struct option_reader *reader, const struct option *option,
                 const struct setting *setting)
{
    if (option_is_void(setting))
        return true;
    if (!option_wants(reader, option, setting, "Name=1"))
        return false;
    size_t length = option_name_length(setting->value);
    const char *rest = setting->value + length;
    rest += strspn(rest, " \t");
    const char *value = rest + 1;
    if (length == 0 || *rest != '=' || value[strspn(value, " \t")] == '\0')
        return option_fail(reader, setting,
                           "Declare wants a name and a value, not '%s': type "
                           "Declare=Name=1",
                           setting->value);
    const char *name = arena_copy_text(reader->arena, setting->value, length);
    for (size_t i = 0; i < reader->declares.count; i++)
        if (strcmp(reader->declares.items[i].name, name) == 0)
            return true; /* as in POV-Ray, the first counts */
    *ARRAY_PUSH(reader->arena, &reader->declares) =
        (struct parse_declare){ name, value, setting->value_span };
    return true;
}

bool set_lighting(struct option_reader *reader, const struct option *option,
                  const struct setting *setting)
{
    if (!option_wants(reader, option, setting, "rays"))
        return false;
    struct options *options = reader->options;
    if (strcmp(setting->value, "help") == 0) {
        options->action = ACTION_LIST;
        options->list_what = "lightings";
        return true;
    }
    options->lighting = integrator_lighting_find(setting->value);
    if (options->lighting)
        return true;
    struct text_nearest nearest = text_nearest_start(setting->value);
    for (size_t i = 0; integrator_lighting_at(i); i++)
        text_nearest_try(&nearest, integrator_lighting_at(i)->name);
    const char *all = integrator_lighting_at(0)->name;
    for (size_t i = 1; !nearest.best && integrator_lighting_at(i); i++)
        all = arena_printf(reader->arena, "%s%s%s", all,
                           integrator_lighting_at(i + 1) ? ", " : " or ",
                           integrator_lighting_at(i)->name);
    return option_fail(reader, setting, "there is no lighting '%s': type %s",
                       setting->value, nearest.best ? nearest.best : all);
}

bool set_action(struct option_reader *reader, const struct option *option,
                const struct setting *setting)
{
    (void)setting;
    reader->options->action = (enum options_action)option->offset;
    return true;
}

bool set_list(struct option_reader *reader, const struct option *option,
              const struct setting *setting)
{
    (void)option;
    reader->options->action = ACTION_LIST;
    reader->options->list_what = setting->value;
    return true;
}

/* What has no effect may still be a slip of the pen: -Xa, -version. */
bool set_ignored(struct option_reader *reader, const struct option *option,
                 const struct setting *setting)
{
    double number;
    if (!option_has_more(setting))
        return true;
    if (strcmp(option->key, "Display") == 0 && strchr(setting->value, '='))
        return option_fail(reader, setting,
                           "-D is POV-Ray's preview window: type Declare=%s",
                           setting->value);
    if (option->offset == IGNORED_TEXT)
        return true;
    return option->offset == IGNORED_NUMBER
               ? option_read_number(reader, option, setting, &number)
               : option_unknown(reader, setting, setting->shown);
}

bool set_no_command(struct option_reader *reader, const struct option *option,
                    const struct setting *setting)
{
    if (setting->value && *setting->value)
        option_warn(reader, setting,
                    "%s is not run: glim starts no other programs; call them "
                    "from your script or Makefile",
                    option->key);
    return true;
}

bool set_message_file(struct option_reader *reader, const struct option *option,
                      const struct setting *setting)
{
    (void)option;
    if (!setting->value || !*setting->value)
        return true;
    option_warn(reader, setting,
                "messages go to standard error only; to keep them type "
                "2> %s",
                setting->value);
    return true;
}
