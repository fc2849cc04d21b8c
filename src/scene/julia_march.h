/* Rays through Julia sets of which distances are known (julia_fate.h), eight
 * side by side: each goes on by steps in which nothing can change, but no
 * shorter than a limit; where something has, the place is found by regula falsi
 * (bracket.h). */
#ifndef SCENE_JULIA_MARCH_H
#define SCENE_JULIA_MARCH_H

#include "base/octet.h"
#include "scene/julia_fractal.h"

struct julia_march {
    octet origin[3], direction[3];
    octet tmin, tmax; /* the part of each that counts */
    octet speed;      /* lengths of the directions */
    octet t;          /* so far they are */
    octet step;       /* and so far the next goes at least, of t */
    octet_bits stays; /* what is there */
    octet_bits open;  /* they go on */
    int steps;
};

/* A ray to be gone along, in the lane of that number. Those of other lanes must
 * be finite. */
void julia_march_put(struct julia_march *march, int lane, const struct ray *ray,
                     double tmin, double tmax);

/* One alone, in lane 0. Then, and of several once `open` is set, only the part
 * in the ball around the set is left, or none. */
void julia_march_alone(const struct julia_fractal *fractal,
                       const struct ray *ray, double tmin, double tmax,
                       struct julia_march *march);
void julia_march_enter(const struct julia_fractal *fractal,
                       struct julia_march *march);

/* Points of the rays, those at `t` of each. */
struct julia_points;
void julia_march_points(const struct julia_march *march, const octet *t,
                        struct julia_points *points);

/* What is at t, where `open` is set, and how far all is like it. */
struct julia_fates;
void julia_march_look(const struct julia_fractal *fractal,
                      const struct julia_march *march, const octet *t,
                      const octet_bits *open, struct julia_fates *fates);

/* Looks at where they begin. */
void julia_march_start(const struct julia_fractal *fractal,
                       struct julia_march *march);

/* Goes on to where each that is open goes in or out next: `at`, where `met` is
 * set. Others are no longer open if they won't. `rough`: between which steps
 * is near enough. */
void julia_march_next(const struct julia_fractal *fractal,
                      struct julia_march *march, bool rough, octet *at,
                      octet_bits *met);

#endif
