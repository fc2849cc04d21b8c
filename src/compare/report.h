/* What is told about two pictures, and whether they are alike. */
#ifndef COMPARE_REPORT_H
#define COMPARE_REPORT_H

#include "compare/figures.h"
#include "compare/choices.h"

/* Seconds a program took for its picture; processor: user and system. */
struct times {
    double processor, wall;
};

struct report {
    const char *names[2];
    const struct pair *pair;
    struct figures figures;
    double flip, ssim;         /* means */
    const struct times *times; /* of A and B, or NULL */
};

/* The table, or the line of --csv, to standard output. */
void report_print(const struct report *report, const struct choices *choices);

/* Whether the pictures are alike: identical if no limit was given, else within
 * every limit, and with no broken pixel. Otherwise says why on diag->out,
 * unless --quiet. */
bool report_alike(const struct report *report, const struct choices *choices,
                  struct diag *diag);

#endif
