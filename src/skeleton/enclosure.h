/* The energy balance between chambers. Each is taken for an integrating sphere
 * (Sumpner 1892: E = rho Phi / (S (1 - rho))), and what one sends another goes
 * through the opening between them:
 *
 *   (S_i (1 - rho_i) + sum_j A_ij + A_i,sky) E_i =
 *                                   Q_i + sum_j A_ij E_j + A_i,sky E_sky
 *
 * S: area of the walls, rho: their mean albedo, A: area of openings, Q: light
 * that the walls send out at first: direct light they reflect and their own.
 * E is the indirect irradiance. Units are POV-Ray's, without pi: a wall sends
 * out albedo * irradiance, and E is also the mean radiance that comes in. */
#ifndef SKELETON_ENCLOSURE_H
#define SKELETON_ENCLOSURE_H

#include <stdint.h>

#include "base/arena.h"
#include "base/rgb.h"

struct chamber {
    double area;   /* of the walls */
    rgb absorbing; /* sum of area * (1 - albedo) */
    rgb source;    /* Q */
    double sky;    /* area that is open to the sky */
    rgb sky_light; /* sum of area * mean radiance of the sky there */
    rgb light;     /* E, by enclosure_solve */
};

/* An opening; each pair of chambers once or more. */
struct opening {
    uint32_t a, b;
    double area;
};

struct enclosure {
    struct arena *arena;
    struct chamber *chambers;
    size_t count;
    struct {
        struct opening *items;
        size_t count, capacity;
    } openings;
};

/* Empty chambers, in the arena. */
struct enclosure *enclosure_new(struct arena *arena, size_t count);

/* A piece of wall: `direct` is the irradiance it gets from lamps, `emission`
 * what it sends out by itself. */
void enclosure_wall(struct enclosure *enclosure, uint32_t chamber, double area,
                    rgb albedo, rgb direct, rgb emission);

void enclosure_open(struct enclosure *enclosure, uint32_t a, uint32_t b,
                    double area);

/* An opening to a sky of this mean radiance. */
void enclosure_sky(struct enclosure *enclosure, uint32_t chamber, double area,
                   rgb radiance);

/* Merges openings of the same pair, and solves by Gauss-Seidel until no light
 * changes by more than 1e-6 of itself. Returns the number of rounds. */
int enclosure_solve(struct enclosure *enclosure);

#endif
