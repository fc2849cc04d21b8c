/* Points on lenses, as POV-Ray 3.7 spreads them (measured by pinhole pictures
 * of a lens: outline and variance): 4 in a square, 7, 19 and 37 in hexagons,
 * each anywhere in its cell; other numbers on a disc. Their order here lets any
 * first few of them be spread as well as all. */
#include "scene/lens.h"

#include <math.h>
#include <string.h>

#include "base/clones.h"
#include "base/draw.h"
#include "base/octet_math.h"
#include "base/random.h"
#include "scene/material.h"
#include "scene/rays.h"

static const double lens_radius = 0.25;
enum { SHAPE_TRIES = 1000 }; /* for a point of a shape that lets light pass */

static const double pi = 3.14159265358979323846;

void lens_sample(const double u[2], double point[2])
{
    double r = lens_radius * sqrt(u[0]), turn = 2 * pi * u[1];
    point[0] = r * lone_cos(turn);
    point[1] = r * lone_sin(turn);
}

/* Rings of a hexagon of so many cells, or 0. */
static int hexagon_rings(int count)
{
    return count == 7 ? 1 : count == 19 ? 2 : count == 37 ? 3 : 0;
}

/* Cell i, from the middle outwards, in distances of cells. */
static void hexagon_cell(int i, double cell[2])
{
    int ring = 0, first = 0;
    cell[0] = cell[1] = 0;
    while (i >= first + (ring ? 6 * ring : 1)) {
        first += ring ? 6 * ring : 1;
        ring++;
    }
    if (ring == 0)
        return;
    int side = (i - first) / ring, step = (i - first) % ring;
    double from = pi / 3 * side, along = from + 2 * pi / 3;
    cell[0] = ring * cos(from) + step * cos(along);
    cell[1] = ring * sin(from) + step * sin(along);
}

void lens_begin(uint64_t key, double begin[2])
{
    begin[0] = random_unit(key);
    begin[1] = random_unit(random_mix(key));
}

static void lens_place(uint64_t key, int i, double place[2])
{
    lens_begin(key, place);
    draw_further(i, &place[0], &place[1]);
}

bool lens_is_disc(int count)
{
    return count != 4 && !hexagon_rings(count);
}

CLONES static void lens_steps(const double *restrict number, double *restrict x,
                              double *restrict y)
{
    for (int i = 0; i < RAY_LANES; i++)
        draw_further(number[i], &x[i], &y[i]);
}

CLONES static void octet_spread(octet *radius, octet *turn)
{
    octet_sqrt(radius);
    *radius *= lens_radius;
    *turn *= 2 * pi;
}

CLONES static void octet_around(const octet *radius, octet *sine, octet *cosine)
{
    *sine *= *radius;
    *cosine *= *radius;
}

void lens_disc_points(const double *number, double *x, double *y)
{
    lens_steps(number, x, y);
    for (int i = 0; i < RAY_LANES; i += OCTET) {
        octet radius, sine, cosine;
        memcpy(&radius, x + i, sizeof radius);
        memcpy(&sine, y + i, sizeof sine);
        octet_spread(&radius, &sine);
        cosine = sine;
        octet_sin(&sine);
        octet_cos(&cosine);
        octet_around(&radius, &sine, &cosine);
        memcpy(x + i, &cosine, sizeof cosine);
        memcpy(y + i, &sine, sizeof sine);
    }
}

void lens_point(int count, int i, uint64_t key, double point[2])
{
    uint64_t own = random_key(key, (uint64_t)i);
    double u = random_unit(own) - 0.5, v = random_unit(random_mix(own)) - 0.5;
    int rings = hexagon_rings(count);
    if (count == 4) {
        point[0] = lens_radius * ((i % 2) - 0.5 + u);
        point[1] = lens_radius * ((i / 2) - 0.5 + v);
        return;
    }
    if (rings) {
        double cell = 2 * lens_radius / (sqrt(3) * (rings + 1));
        hexagon_cell(i, point);
        point[0] = cell * (point[0] + u);
        point[1] = cell * (point[1] + v);
        return;
    }
    double place[2];
    lens_place(key, i, place);
    lens_sample(place, point);
}

/* Points of the square, each taken as likely as it is bright there. */
void lens_shaped_point(const struct pigment *shape, int i, uint64_t key,
                       double point[2])
{
    double place[2] = { 0.5, 0.5 };
    uint64_t own = random_key(key, (uint64_t)i);
    for (int try = 0; try < SHAPE_TRIES; try++) {
        /* The first tries of all are spread evenly. */
        if (try == 0)
            lens_place(key, i, place);
        else
            lens_place(own, try, place);
        colour c = pigment_colour(shape, vec3_make(place[0], place[1], 0));
        double light = grey_of(c.r, c.g, c.b);
        if (random_unit(random_key(own, (uint64_t)try)) < light)
            break;
    }
    point[0] = 2 * lens_radius * (place[0] - 0.5);
    point[1] = 2 * lens_radius * (0.5 - place[1]);
}
