/* Command line and INI files, resolved. */
#ifndef CLI_OPTIONS_H
#define CLI_OPTIONS_H

#include "parse/parse.h"
#include "render/render.h"

enum options_action {
    ACTION_RENDER,
    ACTION_CHECK, /* --check: parse only */
    ACTION_HELP,
    ACTION_VERSION,
    ACTION_LIST, /* --list [WHAT]: what the language knows, from its tables */
    ACTION_MAN,  /* --man-options: the option table as mdoc, for glim.1 */
};

struct options {
    enum options_action action;
    const char *list_what;
    const char *input;  /* scene; "-" is standard input */
    const char *output; /* final file name; "-" standard output; NULL: none */
    char file_type;     /* +F letter, 'N' by default */
    int bits;           /* per channel, 8 */
    bool grey, alpha;
    int compression; /* JPEG quality */
    bool file_gamma_said;
    double file_gamma;   /* 0: sRGB */
    bool continue_trace; /* +C */
    bool verbose, stats;
    bool messages, warnings, fatal; /* +GD, +GW, +GF consoles */
    int warning_level;
    const char *lighting;
    int quality;
    unsigned threads;
    struct parse_options parse;
    struct render_options render;
    /* Animation (+KFF): frames first..last by step, clock from .. to. */
    bool animation;
    int first_frame, last_frame, frame_step;
    double initial_clock, final_clock;
    bool cyclic;
    int subset_start, subset_end;
};

/* Reads the start-up INI, then the arguments from left to right. Returns false
 * after an error was printed. Strings live in `arena`. */
bool options_parse(struct options *options, int argc, char **argv,
                   struct arena *arena, struct diag *diag);

#endif
