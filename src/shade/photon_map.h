/* Photons where they landed, and how dense they are: Jensen, Realistic Image
 * Synthesis Using Photon Mapping (2001), chapters 6 and 7. A balanced k-d tree
 * (Bentley 1975) kept in the array itself: the middle of a range is its node.
 * Const once it is built; any number of threads may ask. */
#ifndef SHADE_PHOTON_MAP_H
#define SHADE_PHOTON_MAP_H

#include <stdint.h>

#include "base/rgb.h"
#include "base/vec.h"
#include "base/worker.h"

struct photon {
    float at[3];
    float flux[3];   /* in POV-Ray's units: flux / area is irradiance */
    int16_t from[2]; /* to where it came from, as photon_pack has it */
    unsigned lamp : 30;
    unsigned axis : 2; /* of the tree */
};

enum {
    PHOTONS_MOST = 12 * 1000 * 1000, /* kept: 384 MB, and as much again while
                                      * they are sorted */
};

/* A unit vector in 32 bits and back, by the octahedron (Cigolle et al., A
 * Survey of Efficient Representations for Independent Unit Vectors, JCGT 2014).
 */
void photon_pack(vec3 direction, int16_t packed[2]);
vec3 photon_unpack(const int16_t packed[2]);

/* How a place looks for photons. */
struct photon_gather {
    unsigned least; /* where fewer lie in the radius, up to twice as far */
    unsigned most;  /* photons, at least 1; of 1 the next one tells how much
                     * room it has, so that 2 are looked at */
    double radius;  /* of where they may lie; 0: by how dense they are */
    double share;   /* multiplies either */
};

struct photon_map;

/* Takes `photons` (memory_new), which may be NULL if there are none; freed with
 * photon_map_free. At most PHOTONS_MOST. */
struct photon_map *photon_map_new(struct photon *photons, size_t count,
                                  const struct photon_gather *gather,
                                  unsigned threads);
void photon_map_free(struct photon_map *map);

/* Those of media, whose flux is times the length that each stands for; freed
 * with the map, which takes them. NULL: none. */
void photon_map_add_within(struct photon_map *map, struct photon_map *within);
const struct photon_map *photon_map_within(const struct photon_map *map);

/* All of them, in the order of the tree. */
const struct photon *photon_map_all(const struct photon_map *map,
                                    size_t *count);

/* Called with the photon and the irradiance it stands for. */
typedef void photon_visit(void *context, const struct photon *photon,
                          rgb irradiance);

/* Visits the nearest photons around a point of a surface of this unit normal,
 * of those that came to that side. The weights are Epanechnikov's kernel, 2 (1
 * - d^2/r^2) / (pi r^2), with r the distance of the farthest of them; where the
 * largest radius holds fewer than it looks for, with that radius; where it does
 * not even hold the least, with as much more as these need, up to twice. */
void photon_map_visit(const struct photon_map *map, struct worker *worker,
                      vec3 point, vec3 normal, photon_visit *visit,
                      void *context);

/* The same in space, where they came from wherever: of photons of media. What
 * each stands for is the irradiance of what faces it. The kernel is 15 (1 -
 * d^2/r^2) / (8 pi r^3). */
void photon_map_visit_within(const struct photon_map *within,
                             struct worker *worker, vec3 point,
                             photon_visit *visit, void *context);

#endif
