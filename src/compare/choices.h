/* The command line of glim-compare. */
#ifndef COMPARE_CHOICES_H
#define COMPARE_CHOICES_H

#include "base/arena.h"
#include "compare/pair.h"
#include "text/diag.h"

/* What a figure must not pass; NAN: not said. */
struct limits {
    double mean, relative, rmse, psnr, over, flip, ssim;
};

enum shown {
    SHOW_FLIP,
    SHOW_DIFFERENCE,
    SHOW_RELATIVE,
};

/* Arguments for one or both of the programs that draw a scene. */
struct words {
    char **items;
    size_t count, capacity;
};

struct choices {
    const char *names[2]; /* A and B; of a scene the first alone */
    int name_count;
    bool scene; /* the first is a .pov file */
    bool linear, raw, csv, names_first, quiet, help, version;
    double threshold;
    double pixels_per_degree;
    struct limits limits;
    const char *heat, *strip; /* files; NULL: none */
    const char *show;
    double top;                /* NAN: not said */
    struct words povray, glim; /* what each gets besides */
};

/* Reads the arguments. False after an error was printed. Strings live in
 * `arena` or in argv. */
bool choices_parse(struct choices *choices, int argc, char **argv,
                   struct arena *arena, struct diag *diag);

/* The pair's space, and what heat maps show. */
enum pair_space choices_space(const struct choices *choices);
enum shown choices_shown(const struct choices *choices);

/* The value that gets the heat map's last colour. */
double choices_top(const struct choices *choices);

/* Whether any limit was given. */
bool limits_any(const struct limits *limits);

/* --help to standard output. */
void choices_help(void);

#endif
