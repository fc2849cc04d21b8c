/* The energy balance between zones: pieces of wall that each send out their
 * light evenly (radiosity). Zone i with the area S_i, the mean albedo rho_i and
 * the own light Q_i (direct light that it reflects at first, and emission) gets
 *
 *   S_i E_i = sum_j A_ij B_j + A_i,sky E_sky,    B_j = rho_j E_j + Q_j / S_j
 *
 * where A_ij = A_ji is the area of i times the share of j in what it sees, and
 * A_ii what is left of S_i. What glows may light walls by itself, by better
 * ways than those between zones: what it gives them is part of Q, and added to
 * E in the end, as to B what it sends. One zone alone is an integrating sphere
 * (Sumpner 1892: E = rho Phi / (S (1 - rho))). E is the indirect irradiance.
 * Units are POV-Ray's, without pi: a wall sends out albedo * irradiance, and E
 * is also the mean radiance that comes in. */
#ifndef SKELETON_ENCLOSURE_H
#define SKELETON_ENCLOSURE_H

#include <stdint.h>

#include "base/arena.h"
#include "base/rgb.h"

struct zone {
    double area;
    rgb reflecting; /* sum of area * albedo */
    rgb source;     /* Q */
    rgb glowing;    /* sum of area * emission */
    rgb shone;      /* sum of area * irradiance straight from what glows */
    double sky;     /* of the area, what sees the sky */
    rgb sky_light;  /* sum of that area * radiance of the sky there */
    rgb light;      /* E, by enclosure_solve */
    rgb sent;       /* B, by enclosure_solve */
    double whole;   /* the area, or more if others see more of it */
    double self;    /* A_ii */
};

/* A_ij; each pair of zones once or more. */
struct opening {
    uint32_t a, b;
    double area;
};

struct enclosure {
    struct arena *arena;
    struct zone *zones;
    size_t count;
    struct {
        struct opening *items;
        size_t count, capacity;
    } openings;
};

/* Zones without walls, in the arena. */
struct enclosure *enclosure_new(struct arena *arena, size_t count);

/* A piece of wall: `direct` is the irradiance it gets from lamps, `emission`
 * what it sends out by itself, which lights none but by enclosure_shine. */
void enclosure_wall(struct enclosure *enclosure, uint32_t zone, double area,
                    rgb albedo, rgb direct, rgb emission);

/* Walls of the zone get light straight from what glows: sums of area *
 * irradiance, and of what they send back of that. */
void enclosure_shine(struct enclosure *enclosure, uint32_t zone, rgb shone,
                     rgb returned);

void enclosure_open(struct enclosure *enclosure, uint32_t a, uint32_t b,
                    double area);

/* Part of the zone's area that sees the sky, of this mean radiance. */
void enclosure_sky(struct enclosure *enclosure, uint32_t zone, double area,
                   rgb radiance);

/* For openings and sky that were measured, those of zones to themselves among
 * them: scales them until each zone sees as much as its area is, what i sees of
 * j still being what j sees of i (Sinkhorn and Knopp 1967). */
void enclosure_even_out(struct enclosure *enclosure);

/* Merges openings of the same pair, and solves by Gauss-Seidel until no light
 * changes by more than 1e-6 of itself. Returns the number of rounds. */
int enclosure_solve(struct enclosure *enclosure);

#endif
