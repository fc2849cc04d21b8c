/* Bright places that lamps light, as virtual lights (Keller, Instant Radiosity,
 * 1997): the patch of sun under a window is looked at once, by many rays, and
 * all mesh points get its light from few places of it, each by a shadow ray.
 * What is so near to a mesh point that these would be seen apart stays with its
 * gather rays, and fades over. */
#ifndef LIGHTMESH_VIRTUAL_LIGHTS_H
#define LIGHTMESH_VIRTUAL_LIGHTS_H

#include "base/worker.h"
#include "lightmesh/bright.h"
#include "shade/lamps.h"

struct virtual_light {
    vec3 point, normal; /* of the surface, unit */
    rgb light;          /* that it sends on, all around alike */
    double area;        /* for which it stands */
};

enum { VIRTUAL_CELLS = 9 * BRIGHT_MOST, VIRTUAL_SLOTS = 1024 };

/* Each part (gather_ways.h) has others, in all of which there is as much light.
 */
struct virtual_lights {
    int count;                /* of a part; 0: there are none */
    struct virtual_light *at; /* of part p numbers p, p + GATHER_PARTS, ... */
    double near, far; /* units: gather rays have what is nearer, these what is
                       * farther */
    double side;      /* of cells, */
    struct virtual_cell {
        uint64_t key; /* bright_key; 0: none */
        vec3 middle;
        int facing;        /* side.h */
        double worth;      /* how much of its light is theirs, up to 1 */
    } cell[VIRTUAL_SLOTS]; /* a hash table */
};

/* Of the surfaces in these places and in the cells beside them; `times` as many
 * as a picture needs. Frees with virtual_lights_free. */
struct virtual_lights *virtual_lights_new(const struct bright *lit,
                                          const struct lamps *lamps, int times,
                                          struct worker *worker);
void virtual_lights_free(struct virtual_lights *lights);

/* How much of the lamps' light on a surface there, whose normal (unit) that is,
 * they bring to what is so far from it: 0 to 1. */
double virtual_lights_share(const struct virtual_lights *lights, vec3 place,
                            vec3 normal, double distance);

/* How much of a virtual light's they do. */
double virtual_lights_fade(const struct virtual_lights *lights,
                           double distance);

#endif
