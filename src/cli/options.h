/* Command line and INI files, resolved: what is to be done. */
#ifndef CLI_OPTIONS_H
#define CLI_OPTIONS_H

#include "cli/frames.h"
#include "image/file.h"
#include "parse/parse.h"
#include "render/render.h"

enum options_action {
    ACTION_RENDER,
    ACTION_CHECK, /* --check: parse only */
    ACTION_HELP,
    ACTION_VERSION,
    ACTION_LIST, /* --list [WHAT]: what the language knows, from its tables */
    ACTION_MAN,  /* --man-options: the option table as mdoc, for glim.1 */
    ACTION_LANGUAGE_SERVER,
    ACTION_CHECK_PICTURE, /* --check-picture FILE */
    ACTION_JOIN,          /* --join FILE */
};

/* --depend, and as compilers say it: -MD -MF FILE -MT TARGET -MP. */
struct depend {
    bool on;            /* wanted, beside the picture if no file is said */
    const char *file;   /* where to; NULL: not said */
    const char *target; /* for make, as it stands; NULL: the pictures */
    bool phony;         /* what is read is a target, too */
};

enum { OPTIONS_THREAD_LIMIT = 512, OPTIONS_SAMPLE_LIMIT = 16777216 };

struct options {
    enum options_action action;
    const char *list_what;
    const char *input;  /* as typed; "-" is standard input; NULL: none */
    const char *path;   /* the same, found along the library path */
    const char *output; /* the picture's name, without a frame's number; "-"
                         * standard output; NULL: none */
    const char *named;  /* the same, and of --check and -F what it would be */
    const char *probe;  /* --probe: the points' file; NULL: a picture */
    char file_type;     /* +F letter, 'N' by default */
    int bits;           /* per channel; 0: not said */
    bool grey, alpha;
    int compression;   /* JPEG quality */
    double file_gamma; /* 0: sRGB */
    bool to_file, continue_trace;
    struct depend depend;
    const char *picture; /* of --check-picture and --join */
    const char *part; /* --part: "3/16", "array", "array/16" or "strip"; NULL:
                       * all of it */
    const char *frames_said; /* --frames: likewise */
    bool join; /* --join without a file: the picture of the scene */
    enum { PROGRESS_TERMINAL, PROGRESS_NEVER, PROGRESS_ALWAYS } progress;
    const char *progress_form, *stats_form; /* "json" or "text"; NULL: text */
    bool stats;
    bool watch;              /* --watch: again and again */
    bool messages, warnings; /* +GD and +GW: #debug, #warning and ours */
    int warning_level;
    const struct lighting *lighting;
    const char *debug_pixel; /* --debug-pixel: "x,y"; NULL: a picture */
    const char *show;        /* --show: a view of the lighting; NULL: none */
    int quality, threads;
    struct settings light; /* of it only what is in light_said is said */
    struct light_said light_said;
    double clock; /* +K; NAN: not said */
    struct frames frames;
    bool jitter;
    int samples;                /* 0: not said */
    double columns[2], rows[2]; /* start and end as said; NAN: not */
    struct parse_options parse;
    struct render_options render;
};

/* Files that are read for it are put into options->parse.asked, which may be
 * NULL and is all of *options that must be set before.
 * Reads the start-up INI files, then the arguments from left to right, and
 * works out names, sizes and frames. Returns false after an error was printed.
 * Strings live in `arena`. */
bool options_parse(struct options *options, int argc, char **argv,
                   struct arena *arena, struct diag *diag);

/* How image files of the chosen type are written. */
struct image_format options_format(const struct options *options);

/* Whether there is nothing to read or render, but a list to print. */
bool options_answers(const struct options *options);

/* Prints to standard output what ACTION_HELP, _VERSION, _LIST or _MAN ask
 * for. Returns false after an error was printed. */
bool options_answer(const struct options *options, struct diag *diag);

#endif
