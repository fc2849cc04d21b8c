/* crackle: cells around random points, one point in each unit cube
 * (S. Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996). The value
 * is made of the distances to the nearest, second and third nearest point. */
#include <stdlib.h>

#include "scene/crackle.h"
#include "scene/cubes.h"
#include "scene/noise.h"

struct crackle {
    vec3 form; /* weights of the three distances */
    double metric, offset;
    bool solid; /* one value for each cell instead */
};

static const struct crackle crackle_defaults = { { -1, 1, 0 }, 2, 0, false };

static const struct field crackle_items[] = {
    { "form", FIELD_VECTOR, offsetof(struct crackle, form), 0, 0,
      "weights of the distances to the nearest three points, <-1, 1, 0>",
      false },
    { "metric", FIELD_FLOAT, offsetof(struct crackle, metric), 0, 0,
      "exponent of the distance: 2 round, 1 city blocks, default 2", false },
    { "offset", FIELD_FLOAT, offsetof(struct crackle, offset), 0, 0,
      "distance from the points in a fourth dimension, default 0", false },
    { "solid", FIELD_FLAG, offsetof(struct crackle, solid), 0, 0,
      "one random value for each cell", false },
    { .name = NULL },
};

/* The three smallest sums of powers so far, and the cube of the first. */
struct nearest {
    double sum[3];
    vec3 cell;
};

static double crackle_power(const struct crackle *crackle, double distance)
{
    return crackle->metric == 2   ? distance * distance
           : crackle->metric == 1 ? fabs(distance)
                                  : pow(fabs(distance), crackle->metric);
}

static double crackle_sum(const struct crackle *crackle, vec3 distance)
{
    return crackle_power(crackle, distance.x) +
           crackle_power(crackle, distance.y) +
           crackle_power(crackle, distance.z);
}

static void nearest_add(struct nearest *nearest, double sum, vec3 cell)
{
    double *s = nearest->sum;
    if (sum < s[0]) {
        s[2] = s[1], s[1] = s[0], s[0] = sum;
        nearest->cell = cell;
    } else if (sum < s[1]) {
        s[2] = s[1], s[1] = sum;
    } else if (sum < s[2]) {
        s[2] = sum;
    }
}

/* How far a coordinate in [0,1) is from the cube `step` cubes away. */
static double crackle_gap(double place, int step)
{
    return step > 0 ? step - place : step < 0 ? place - step - 1 : 0;
}

enum { CRACKLE_FAR = 2 }; /* cubes away, at most */

/* A point's cube, its place in it, and the powers of how far it is from the
 * cubes up to CRACKLE_FAR away, by axis. */
struct crackle_place {
    const struct crackle *crackle;
    vec3 base, place;
    double power[3][2 * CRACKLE_FAR + 1];
};

static void place_measure(struct crackle_place *p, int ring)
{
    for (int axis = 0; axis < 3; axis++)
        for (int step = -ring; step <= ring; step++)
            if (step == -ring || step == ring)
                p->power[axis][step + CRACKLE_FAR] = crackle_power(
                    p->crackle,
                    crackle_gap(vec3_component(p->place, axis), step));
}

/* Adds the point of the cube so many steps away. */
static void crackle_visit(const struct crackle_place *p, vec3 step, bool near,
                          struct nearest *nearest)
{
    vec3 cell = vec3_add(p->base, step);
    vec3 point = near
                     ? cubes_point(p->base, step)
                     : vec3_add(step, noise_cell_point(cell.x, cell.y, cell.z));
    vec3 offset = vec3_sub(point, p->place);
    nearest_add(nearest, crackle_sum(p->crackle, offset), cell);
}

/* The cubes that are so many steps away along some axis, but for those that are
 * farther than what is known. */
static void crackle_ring(const struct crackle_place *p, int ring, int keep,
                         struct nearest *nearest)
{
    const double *px = p->power[0] + CRACKLE_FAR;
    const double *py = p->power[1] + CRACKLE_FAR;
    const double *pz = p->power[2] + CRACKLE_FAR;
    bool far = p->crackle->metric > 0; /* what is far is not near */
    for (int z = -ring; z <= ring; z++) {
        for (int y = -ring; y <= ring; y++) {
            bool side = abs(y) == ring || abs(z) == ring;
            if (far && py[y] + pz[z] > nearest->sum[keep])
                continue;
            for (int x = -ring; x <= ring; x += side || !ring ? 1 : 2 * ring)
                if (!far || px[x] + py[y] + pz[z] <= nearest->sum[keep])
                    crackle_visit(p, vec3_make(x, y, z), ring < 2, nearest);
        }
    }
}

/* Which of the sums is the last that matters. */
static int crackle_kept(const struct crackle *crackle)
{
    return crackle->solid ? 0 : crackle->form.z != 0 ? 2 : 1;
}

/* The cubes at most two away, nearer ones first. Outside of the inner 27 all
 * is more than 1 away, and so is the sum of powers. */
static struct nearest crackle_search(const struct crackle *crackle, vec3 point)
{
    const vec3 base = vec3_make(floor(point.x), floor(point.y), floor(point.z));
    const vec3 place = vec3_sub(point, base);
    struct nearest nearest = { { HUGE_VAL, HUGE_VAL, HUGE_VAL }, base };
    struct crackle_place p = { crackle, base, place, { { 0 } } };
    int keep = crackle_kept(crackle), from = 0;
    if (crackle->metric == 2) {
        if (crackle->solid)
            nearest.cell =
                vec3_add(base, cubes_first(base, place, &nearest.sum[0]));
        else
            cubes_nearest(base, place, nearest.sum);
        if (nearest.sum[keep] <= 1)
            return nearest;
        from = CRACKLE_FAR;
    }
    for (int ring = 0; ring <= CRACKLE_FAR; ring++) {
        if (ring == 2 && nearest.sum[keep] <= 1)
            break;
        place_measure(&p, ring);
        if (ring >= from)
            crackle_ring(&p, ring, keep, &nearest);
    }
    return nearest;
}

static vec3 centre_of(const struct crackle *crackle, vec3 point)
{
    vec3 cell = crackle_search(crackle, point).cell;
    return vec3_add(cell, noise_cell_point(cell.x, cell.y, cell.z));
}

vec3 crackle_centre(vec3 point)
{
    static const struct crackle cells = { { -1, 1, 0 }, 2, 0, true };
    return centre_of(&cells, point);
}

static double crackle_value(const struct pattern *pattern, vec3 point)
{
    const struct crackle *crackle = pattern->parameters;
    if (crackle->solid)
        return noise_value(pattern_generator(pattern),
                           centre_of(crackle, point));
    struct nearest nearest = crackle_search(crackle, point);
    double deep = crackle_power(crackle, crackle->offset);
    double root = 1 / crackle->metric;
    double d[3];
    for (int i = 0; i < 3; i++) {
        double sum = nearest.sum[i] + (crackle->offset == 0 ? 0 : deep);
        d[i] = crackle->metric == 2 ? sqrt(sum) : pow(sum, root);
    }
    double value = crackle->form.x * d[0] + crackle->form.y * d[1];
    if (crackle->form.z != 0)
        value += crackle->form.z * d[2];
    return fmin(fmax(value, 0), 1);
}

const struct pattern_kind crackle_pattern = {
    .name = "crackle",
    .help = "cells with random centres",
    .size = sizeof(struct crackle),
    .defaults = &crackle_defaults,
    .items = crackle_items,
    .value = crackle_value,
};
