/* The one table of options, and how a setting reaches its row; shared by the
 * files that read, explain and check options. */
#ifndef CLI_OPTION_H
#define CLI_OPTION_H

#include "base/array.h"
#include "cli/options.h"

/* Where Debian has what POV-Ray brings: its %INSTALLDIR%. */
#define OPTION_POVRAY_FOLDER "/usr/share/povray-3.7"

struct option_typed {
    const struct option *option;
    const char *shown;
};

/* What is known while options are read. */
struct option_reader {
    struct options *options;
    struct arena *arena;
    struct diag *diag;
    /* In a start-up povray.ini: what would make glim chatty doesn't count. */
    bool startup;
    unsigned depth, ini_files; /* INI files within each other, read in all */
    struct {
        const char **items;
        size_t count, capacity;
    } library, headers, below; /* below: --read-only-below */
    struct permits permits;
    struct {
        struct parse_declare *items;
        size_t count, capacity;
    } declares;
    bool took_next;     /* that argument belonged to what was reported */
    const char *output; /* as +O says */
    const char *scene;  /* named on the command line, or NULL */
    /* Settings of the command line that not every lighting uses. */
    struct {
        struct option_typed *items;
        size_t count, capacity;
    } typed;
};

/* One `+Xvalue`, `Key=value` or `--word=value`. */
struct setting {
    const char *shown; /* as typed; for messages of the command line */
    const char *value; /* NULL: none */
    bool on;           /* by +, not by - */
    bool by_key;
    struct span span;       /* all of it; nowhere on the command line */
    struct span value_span; /* the value alone */
    const char *next;       /* the argument after it, or NULL */
};

/* What may stand behind the letters of an option without effect. */
enum option_ignored { IGNORED_SWITCH, IGNORED_NUMBER, IGNORED_TEXT };

struct option;
typedef bool option_set(struct option_reader *reader,
                        const struct option *option,
                        const struct setting *setting);

/* A row. One without `set` is the title of a group. */
struct option {
    const char *letters; /* +W */
    const char *key;     /* Width= */
    const char *word;    /* --width */
    option_set *set;
    size_t offset; /* into struct options; set_action: the action;
                    * set_ignored: an enum option_ignored */
    double minimum, maximum;
    const struct field *fields; /* set_light: its row of this table */
    const char *field;
    const char *of;   /* the lightings that use it, with blanks; NULL: all */
    const char *also; /* a switch's value belongs to this key */
    const char *argument; /* what the value is called in lists; in brackets
                           * when it may be left out; NULL: takes none */
    const char *help;     /* with the default in parentheses */
};

/* Number `index` of the table, or NULL past its end. */
const struct option *option_at(size_t index);

/* The row of a key, of a long word, or of the longest letters that `text`
 * (without its sign) begins with; case ignored. NULL: none. */
const struct option *option_find_key(const char *key);
const struct option *option_find_word(const char *word);
const struct option *option_find_letters(const char *text);

/* How the option is typed by its key or its word, which it must have:
 * "Width=n", "--threads n"; in the arena. */
const char *option_spelling(const struct option *option, bool word,
                            struct arena *arena);

/* Reports a setting that is wrong; always returns false. The message should
 * make sense after "'+W0': ". */
__attribute__((format(printf, 3, 4))) bool
option_fail(struct option_reader *reader, const struct setting *setting,
            const char *format, ...);
__attribute__((format(printf, 3, 4))) void
option_warn(struct option_reader *reader, const struct setting *setting,
            const char *format, ...);

/* Reports that there is no option `name`, with the nearest one there is;
 * returns false. */
bool option_unknown(struct option_reader *reader, const struct setting *setting,
                    const char *name);

/* The scene in that folder whose name is nearest, or NULL. */
const char *option_scene_near(struct arena *arena, const char *name);

/* Reports that there is no such scene, with the name that may be meant;
 * returns false. */
bool option_scene_missing(struct option_reader *reader, const char *name);

/* Whether letters without their sign, up to an '=', are a long word or what
 * other programs call an option: -output=x.png is not +O of "utput=x.png". */
bool option_is_word(struct arena *arena, const char *text);

/* The option that a bare word may have been meant as: "Width", "H10"; in the
 * arena, or NULL. */
const char *option_meant(struct arena *arena, const char *text);

/* Applies one token of the command line or of an INI file: +X, -X, --word,
 * Key=value, a scene or an INI file. */
bool option_read(struct option_reader *reader, const struct setting *token);

/* Applies the arguments from left to right. */
bool arguments_read(struct option_reader *reader, int argc, char **argv);

/* Adds a directory at the end of the library path unless it is there. */
void option_add_library(struct option_reader *reader, const char *directory);

/* Whether the setting has a value; says what to type if not. */
bool option_wants(struct option_reader *reader, const struct option *option,
                  const struct setting *setting, const char *example);

/* The value as a number. */
bool option_read_number(struct option_reader *reader,
                        const struct option *option,
                        const struct setting *setting, double *number);

/* "on", "off" and their kin; false when it is neither. */
bool option_truth(const char *value, bool *state);

/* The setters: option_light.c, permitted.c, option_batch.c, and option_set.c
 * for all others. */
option_set set_light, set_below;
option_set set_check_picture, set_join, set_progress, set_stats;
option_set set_switch, set_integer, set_whole, set_step, set_number,
    set_library, set_header, set_input, set_output, set_file_type, set_gamma,
    set_declare, set_verbose, set_all_consoles, set_lighting, set_action,
    set_list, set_flag, set_quiet, set_ignored, set_no_command,
    set_message_file, set_text;

/* A whole text as a number; false when it is anything else. */
bool option_number(const char *text, double *number);

/* Reads the INI file `name`, "file[section]" for one of its sections. Sections
 * called [Glim] are always read. */
bool ini_read(struct option_reader *reader, const char *name,
              const struct setting *setting);

/* What scenes may read, by --read-only-below and povray.conf, once all options
 * are known. Returns false after an error was printed. */
bool permits_resolve(struct option_reader *reader);

/* What --part says, once all options are known. Returns false after an error
 * was printed. */
bool part_resolve(struct option_reader *reader);

/* Whether there is a way to draw so large a picture; the same. */
bool large_resolve(struct option_reader *reader);

/* The same of --frames, once it is known how many there are. */
bool frames_said_resolve(struct option_reader *reader);

/* Reads the start-up files; see ini_startup in ini.c for which. */
bool ini_startup(struct option_reader *reader);

/* `name` in the current directory or along the library path, with one of the
 * extensions (NULL-terminated, the first may be "") added; NULL: nowhere. */
const char *option_search(const struct option_reader *reader, const char *name,
                          const char *const *extensions);

#endif
