/* Many lamps stood for by few: a tree of clusters of lamps that are near each
 * other (Walter et al. 2005, Lightcuts), from which each mesh point takes a
 * cut of bounded size and one lamp of each cluster, drawn by intensity, so
 * that the sum is right on average (Yuksel 2019, Stochastic Lightcuts). What
 * is drawn depends on numbers given, not on chance. */
#ifndef LIGHTMESH_LIGHT_TREE_H
#define LIGHTMESH_LIGHT_TREE_H

#include "shade/lamps.h"

enum { PICKS_MAX = 512 };

struct light_tree;

/* A lamp that stands for a cluster. */
struct light_pick {
    const struct lamp *lamp;
    double weight; /* how many of it there seem to be, >= 1 */
};

/* `centre` and `size` tell where the scene is: lamps whose rays are parallel
 * are far away from there. Frees with light_tree_free. */
struct light_tree *light_tree_new(const struct lamps *lamps, vec3 centre,
                                  double size);
void light_tree_free(struct light_tree *tree);

/* The lamps that give light, in the tree's order: neighbours are near each
 * other. */
size_t light_tree_count(const struct light_tree *tree);
const struct lamp *light_tree_lamp(const struct light_tree *tree, size_t i);

/* At most `budget` picks (1..PICKS_MAX) for a point; returns how many. `dither`
 * in [0,1) chooses within the clusters; points near each other should have
 * numbers that are far apart. */
int light_tree_pick(const struct light_tree *tree, vec3 point, double dither,
                    int budget, struct light_pick picks[]);

#endif
