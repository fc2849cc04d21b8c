/* Orbits of z -> z^n + c in the complex plane: what mandel and julia are; and
 * of the two maps of magnetism: magnet. */
#ifndef SCENE_ORBIT_H
#define SCENE_ORBIT_H

#include <stdbool.h>

#include "base/field.h"
#include "scene/spots.h"

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

/* Some that are followed side by side: they begin at x + iy, and c is u + iv.
 */
struct orbit_starts {
    int count; /* 1 to SPOTS_MAX */
    double x[SPOTS_MAX], y[SPOTS_MAX], u[SPOTS_MAX], v[SPOTS_MAX];
};

/* The value for each. */
void orbit_values(const struct orbit *orbit, const struct orbit_starts *starts,
                  double *values);

/* The same of magnet's maps. */
void orbit_magnets(const struct orbit *orbit, const struct orbit_starts *starts,
                   double *values);

/* Starts at the spots' x and y, with the constant as c. */
void orbit_starts_at(const struct orbit *orbit, const struct spots *spots,
                     struct orbit_starts *starts);

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
