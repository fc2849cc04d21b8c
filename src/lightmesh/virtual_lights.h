/* What lamps light in a chamber, as virtual lights (Keller, Instant Radiosity,
 * 1997): the walls around a lamp, or the floor before a window, are looked at
 * once, by many rays, and mesh points get their light from places of them, each
 * by a shadow ray. Cells have as many of these as they bring; and a mesh point
 * asks those that would give it most, each as often as it would (resampled
 * importance sampling: Talbot, Cline and Egbert 2005). What is so near to it
 * that these would be seen apart stays with its gather rays, and fades over. */
#ifndef LIGHTMESH_VIRTUAL_LIGHTS_H
#define LIGHTMESH_VIRTUAL_LIGHTS_H

#include "base/worker.h"
#include "lightmesh/bright.h"
#include "shade/lamps.h"

struct virtual_light {
    vec3 point, normal; /* of the surface, unit */
    rgb light;          /* that it sends on, all around alike */
    double area;        /* for which it stands */
    double near;        /* of its cell */
};

enum {
    VIRTUAL_SLOTS = 1024,
    VIRTUAL_LANES = 2048,     /* lights of a part, at most */
    VIRTUAL_PICKS_MOST = 256, /* of which a place asks */
};

/* Those of a part, side by side. */
struct virtual_lanes {
    double place[3][VIRTUAL_LANES];
    double normal[3][VIRTUAL_LANES];
    double power[VIRTUAL_LANES]; /* of the strongest colour */
    double near[VIRTUAL_LANES];
};

/* Each part (gather_ways.h) has others, in all of which there is as much light.
 */
struct virtual_lights {
    int count;                /* of a part; 0: there are none */
    struct virtual_light *at; /* of part p numbers p, p + GATHER_PARTS, ... */
    struct virtual_lanes *lanes; /* of each part */
    double side;                 /* of cells, */
    struct virtual_cell {
        uint64_t key; /* cell_key; 0: none */
        vec3 middle;
        int facing;     /* side.h */
        double worth;   /* how much of its light is theirs, up to 1 */
        double brought; /* share of all light that is brought, about, */
        double seen_at; /* and from how far */
        double near; /* units: gather rays have what is nearer, virtual lights
                      * what is twice as far */
    } cell[VIRTUAL_SLOTS]; /* a hash table, never full */
};

/* Of the surfaces in these places and in the cells beside them; `times` as many
 * as a picture needs. Freed with virtual_lights_free. */
struct virtual_lights *virtual_lights_new(const struct bright *lit,
                                          const struct lamps *lamps, int times,
                                          struct worker *worker);
void virtual_lights_free(struct virtual_lights *lights);

/* How much of the lamps' light on a surface there, whose normal (unit) that is,
 * they bring to what is so far from it: 0 to 1. */
double virtual_lights_share(const struct virtual_lights *lights, vec3 place,
                            vec3 normal, double distance);

/* How much of a virtual light's they do. */
double virtual_light_fade(double near, double distance);

/* One that a place asks: it is picked so often, in the mean. */
struct virtual_pick {
    int number;
    double often;
};

/* Picks `wanted` of a part, up to VIRTUAL_PICKS_MOST; returns how many are not
 * the same. */
int virtual_lights_pick(const struct virtual_lights *lights, vec3 place,
                        unsigned part, int wanted, struct virtual_pick *picks);

#endif
