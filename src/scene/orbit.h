/* Orbits of z -> z^n + c in the complex plane: what mandel and julia are; and
 * of the two maps of magnetism: magnet. */
#ifndef SCENE_ORBIT_H
#define SCENE_ORBIT_H

#include <stdbool.h>

#include "base/field.h"

/* The members are read by the field tables of both patterns. */
struct orbit {
    double constant[2]; /* julia's c; of mandel it is the point itself */
    int iterations;
    int exponent;
    double exterior[2], interior[2]; /* how what is where is coloured: which
                                      * way, and a factor */
    int magnet;                      /* 1 or 2; magnet alone has it */
    bool julia;                      /* magnet: which set */
};

/* The value for the orbit that begins at x + iy, with c = u + iv. */
double orbit_value(const struct orbit *orbit, double x, double y, double u,
                   double v);

/* The same of magnet's maps. */
double orbit_magnet(const struct orbit *orbit, double x, double y, double u,
                    double v);

#define ORBIT_DEFAULTS                                                         \
    .iterations = 1, .exponent = 2, .exterior = { 1, 1 }, .interior = { 0, 1 }

#define ORBIT_ITERATIONS                                                       \
    {                                                                          \
        "iterations", FIELD_INTEGER, offsetof(struct orbit, iterations), 1,    \
            100000, "steps after which a point counts as interior", false      \
    }

#define ORBIT_COLOURS                                                          \
    { "exterior", FIELD_PAIR, offsetof(struct orbit, exterior),                \
      0,          0,          "0 to 8, and a factor: 1, 1",                    \
      false },                                                                 \
    {                                                                          \
        "interior", FIELD_PAIR, offsetof(struct orbit, interior), 0, 0,        \
            "0 to 6, and a factor: 0, 1", false                                \
    }

#define ORBIT_ITEMS                                                            \
    {                                                                          \
        "exponent",                                                            \
        FIELD_INTEGER,                                                         \
        offsetof(struct orbit, exponent),                                      \
        2,                                                                     \
        33,                                                                    \
        "n of z^n + c, 2",                                                     \
        false                                                                  \
    },                                                                         \
        ORBIT_COLOURS

#endif
