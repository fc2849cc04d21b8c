/* Which pixels of a picture are points of it: a lattice of one in so many, and
 * where that leaves a small surface without a point, denser ones. A staggered
 * lattice has no rows or columns that an edge could run along unseen. */
#ifndef LIGHTMESH_STAGGER_H
#define LIGHTMESH_STAGGER_H

enum { STAGGER_DEPTH = 4, STAGGER_REACH = 3, STAGGER_SERVERS = 16 };

/* A pixel's class says where it is in the lattice, whose points have class 0.
 * Half as many more are on the lattice that is twice as dense, and so on. */
struct stagger {
    int apart; /* of so many pixels one is on the lattice: a power of 2 */
    int skew;  /* the class of (x, y): x + skew y, modulo `apart` */
    int depth; /* so many denser lattices until all pixels are on one, at most
                * STAGGER_DEPTH */
    int reach; /* how far from a pixel points may be that serve it, across and
                * down, at most STAGGER_REACH */
    struct servers *servers; /* by class */
};

/* Points of the lattice near a pixel: first the corners of a triangle that it
 * is in, at most one farther than reach, then those within reach. */
struct servers {
    int count;
    struct server {
        int across, down; /* from the pixel */
    } at[STAGGER_SERVERS];
};

/* The nearest number that `apart` can be, 1 to 16. */
int stagger_apart(double wanted);

/* `apart` as stagger_apart has it. Frees with stagger_free. */
struct stagger *stagger_new(int apart);
void stagger_free(struct stagger *stagger);

/* The first lattice that has the pixel, 0 to depth; coordinates may be
 * negative. */
int stagger_level(const struct stagger *stagger, int x, int y);

/* The first x from `from` on with that level in row y, and how far apart they
 * are. */
int stagger_first(const struct stagger *stagger, int level, int from, int y);
int stagger_step(const struct stagger *stagger, int level);

const struct servers *stagger_servers(const struct stagger *stagger, int x,
                                      int y);

#endif
