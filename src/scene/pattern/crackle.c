/* crackle: cells around random points, one point in each unit cube
 * (S. Worley, "A Cellular Texture Basis Function", SIGGRAPH 1996). The value
 * is made of the distances to the nearest, second and third nearest point. */
#include "scene/noise.h"

#include <stdlib.h>

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

/* The three smallest sums of powers so far, and whose is the first. */
struct nearest {
    double sum[3];
    vec3 point;
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

static void nearest_add(struct nearest *nearest, double sum, vec3 point)
{
    double *s = nearest->sum;
    if (sum < s[0]) {
        s[2] = s[1], s[1] = s[0], s[0] = sum;
        nearest->point = point;
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

/* Adds the point of the cube `step` away from the one at `base`, unless the
 * whole cube is farther than what is known. */
static void crackle_visit(const struct crackle *crackle, vec3 base, vec3 place,
                          const int step[3], struct nearest *nearest)
{
    vec3 gap = { crackle_gap(place.x, step[0]), crackle_gap(place.y, step[1]),
                 crackle_gap(place.z, step[2]) };
    double known = nearest->sum[crackle->form.z != 0 ? 2 : 1];
    if (crackle->metric > 0 && crackle_sum(crackle, gap) > known)
        return;
    vec3 cell = vec3_add(base, vec3_make(step[0], step[1], step[2]));
    vec3 inner = noise_cell_point(cell.x, cell.y, cell.z);
    vec3 offset =
        vec3_sub(vec3_add(vec3_make(step[0], step[1], step[2]), inner), place);
    nearest_add(nearest, crackle_sum(crackle, offset), vec3_add(cell, inner));
}

/* The cubes at most two away, nearer ones first. Outside of the inner 27 all
 * is more than 1 away, and so is the sum of powers. */
static struct nearest crackle_search(const struct crackle *crackle, vec3 point)
{
    struct nearest nearest = { { HUGE_VAL, HUGE_VAL, HUGE_VAL }, point };
    vec3 base = { floor(point.x), floor(point.y), floor(point.z) };
    vec3 place = vec3_sub(point, base);
    int keep = crackle->form.z != 0 ? 2 : 1;
    for (int ring = 0; ring <= 2; ring++) {
        if (ring == 2 && nearest.sum[keep] <= 1)
            break;
        int side = 2 * ring + 1;
        for (int i = 0; i < side * side * side; i++) {
            int step[3] = { i % side - ring, i / side % side - ring,
                            i / side / side - ring };
            if (abs(step[0]) == ring || abs(step[1]) == ring ||
                abs(step[2]) == ring)
                crackle_visit(crackle, base, place, step, &nearest);
        }
    }
    return nearest;
}

static double crackle_value(const struct pattern *pattern, vec3 point)
{
    const struct crackle *crackle = pattern->parameters;
    struct nearest nearest = crackle_search(crackle, point);
    if (crackle->solid)
        return noise_value(pattern_generator(pattern), nearest.point);
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
