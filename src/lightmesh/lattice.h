/* Where mesh points are: regular lattices in space, each level twice as coarse
 * as the one before. A lattice point is named by its level and three integers,
 * packed into a key; everything a mesh knows of it is a function of that name
 * alone, so any thread may find it out. Levels nest: each point of a level is
 * one of the level before too, and has the name of the coarsest that has it
 * wherever points of several levels are kept together.
 *
 * The level that a place uses grows with its distance from the camera, so that
 * a cell covers about the same number of pixels everywhere and a plane that
 * goes to the horizon has few. Regions move it: each level is a factor of two,
 * and around a region the levels follow each other a cell's width apart. */
#ifndef LIGHTMESH_LATTICE_H
#define LIGHTMESH_LATTICE_H

#include <stdint.h>

#include "scene/light_settings.h"

enum { LATTICE_LEVELS = 32 };

struct lattice {
    double spacing; /* of level 0, > 0 */
    double near;    /* up to this distance level `usual`; 0: everywhere */
    const struct mesh_region *regions;
    size_t region_count;
    int usual; /* level without regions: those finer are theirs, or unused */
};

/* How near to each other points are for who asks. Where points are doesn't
 * follow from it, so that all may share them. */
struct lattice_view {
    vec3 eye;      /* the camera */
    int coarser;   /* levels more */
    double finest; /* level of what is nearest, counted from the usual one:
                    * below 0 finer */
};

struct lattice_point {
    int level;
    int at[3];
};

/* Distance of neighbours on a level. */
static inline double lattice_spacing(const struct lattice *lattice, int level)
{
    return lattice->spacing * (double)(1ull << level);
}

/* Gives the lattice, whose level 0 is its usual one, regions of other
 * densities, factors of two, which must outlive it. */
void lattice_set_regions(struct lattice *lattice,
                         const struct mesh_region *regions, size_t count);

/* Makes room for so many levels below those that lattice_level gives. */
void lattice_make_finer(struct lattice *lattice, int levels);

/* The levels that a place uses: the returned one, and the next coarser one
 * with weight *blend, which is 0 but near the change from one to the other. */
int lattice_level(const struct lattice *lattice,
                  const struct lattice_view *view, vec3 place, double *blend);

/* Distance of neighbours around a place, between levels as the blend says. */
double lattice_spacing_at(const struct lattice *lattice,
                          const struct lattice_view *view, vec3 place);

/* A place in units of a level's spacing: lattice points are at integers. They
 * are moved by a fraction, lest they fall on the round numbers that scenes
 * are made of. Farther out than 2^18 units is pressed to the rim. */
vec3 lattice_units(const struct lattice *lattice, int level, vec3 place);

/* The place of a lattice point. */
vec3 lattice_place(const struct lattice *lattice,
                   const struct lattice_point *point);

/* The same point on the coarsest level that has it. */
struct lattice_point lattice_coarsest(const struct lattice *lattice,
                                      const struct lattice_point *point);

/* Its name as a number, never 0. Neighbours have names that are near each
 * other in lattice_hash. */
uint64_t lattice_key(const struct lattice_point *point);
uint64_t lattice_hash(uint64_t key);

/* The lattice point of a name. */
struct lattice_point lattice_named(uint64_t key);

#endif
