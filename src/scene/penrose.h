/* Penrose's tilings of the plane, which never repeat: what tiling 25 to 27 look
 * up. All three have a fivefold centre at the origin, and an edge length of 1.
 * R. Penrose, "Pentaplexity", Mathematical Intelligencer 2 (1979); how they are
 * found: R. Robinson's triangles, in B. Gruenbaum and G. Shephard, "Tilings and
 * Patterns" (1987), 10.3. */
#ifndef SCENE_PENROSE_H
#define SCENE_PENROSE_H

/* In [0,1]: of n kinds of tiles, kind k has k / n inside, and rises to
 * (k + 1) / n towards its border. 0 where doubles can't tell the tiles of a
 * place so far away. */

/* Pentagons of three kinds, stars, boats and thin rhombs. */
double penrose_pentagons(double x, double z);

/* Kites and darts: the longer sides are 1. */
double penrose_kites(double x, double z);

/* Thick and thin rhombs. */
double penrose_rhombs(double x, double z);

#endif
