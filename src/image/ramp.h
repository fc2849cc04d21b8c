/* Colours that stand for numbers. */
#ifndef IMAGE_RAMP_H
#define IMAGE_RAMP_H

#include <stdbool.h>

enum ramp {
    RAMP_MAGMA,    /* black, violet, red, orange, pale yellow */
    RAMP_SPECTRUM, /* blue, cyan, green, yellow, red: seen over a picture */
};

/* The colour of a value from 0 to 1, sRGB-encoded. */
void ramp_colour(enum ramp ramp, double value, float colour[3]);

/* The numbers that a ramp's ends stand for. */
struct ramp_range {
    bool logarithmic; /* numbers that are not above 0 are at the low end */
    bool known;       /* there was a number */
    double low, high;
};

void ramp_range_add(struct ramp_range *range, double number);

/* Where a number is on the ramp, 0..1. */
double ramp_range_place(const struct ramp_range *range, double number);

#endif
