/* What lamps light in a chamber, as virtual lights (Keller, Instant Radiosity,
 * 1997): the walls around a lamp, or the floor before a window, are looked at
 * once, by many rays, and mesh points get their light from places of them, each
 * by a shadow ray. Cells that bring more are looked at more closely; and a mesh
 * point asks those that would give it most, others by chance, as often as they
 * would (resampled importance sampling: Talbot, Cline and Egbert 2005). Nothing
 * of them but its light changes with what moves elsewhere. What is so near to
 * it that these would be seen apart stays with its gather rays, and fades over.
 */
#ifndef LIGHTMESH_VIRTUAL_LIGHTS_H
#define LIGHTMESH_VIRTUAL_LIGHTS_H

#include "base/worker.h"
#include "lightmesh/bright.h"
#include "lightmesh/gather_ways.h"
#include "shade/lamps.h"

struct virtual_light {
    vec3 point, normal; /* of the surface, unit */
    rgb light;          /* that it sends on, all around alike */
    double area;        /* for which it stands */
    double near;        /* of its cell */
    double chance;      /* in [0,1): what gives less of one pick isn't asked */
    uint32_t number;    /* of the ray that found it, in its cell */
};

enum {
    VIRTUAL_SLOTS = 1024,
    VIRTUAL_LANES = 2048,      /* lights that are looked at together */
    VIRTUAL_PICKS_USUAL = 512, /* of which a place wants so many at most, */
    VIRTUAL_PICKS_MOST = 2 * VIRTUAL_PICKS_USUAL, /* and may get more */
};

/* Rows of lanes: coordinates, and the power of the strongest colour. */
enum {
    VIRTUAL_PLACE,
    VIRTUAL_NORMAL = 3,
    VIRTUAL_POWER = 6,
    VIRTUAL_NEAR,
    VIRTUAL_ROWS,
};

/* Those of a part, side by side. */
struct virtual_lanes {
    int count;
    double *row[VIRTUAL_ROWS];
    const struct virtual_light **light;
};

/* Each part (gather_ways.h) has others, in all of which there is as much light,
 * about. */
struct virtual_lights {
    size_t count; /* of all parts */
    int times;    /* more than 1: those that a place picks are to stay */
    struct virtual_light *at;
    struct virtual_lanes lanes[GATHER_PARTS];
    double side; /* of cells, */
    struct virtual_cell {
        uint64_t key; /* cell_key; 0: none */
        vec3 middle;
        int facing;     /* side.h */
        double worth;   /* how much of its light is theirs, up to 1 */
        double brought; /* share of all light that is brought, about */
        double near; /* units: gather rays have what is nearer, virtual lights
                      * what is twice as far */
    } cell[VIRTUAL_SLOTS]; /* a hash table, never full */
};

/* Of the surfaces in these places and in the cells beside them; `times` as many
 * as a picture by itself needs, for one of an animation's. Freed with
 * virtual_lights_free. */
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
    const struct virtual_light *light;
    double often;
};

/* Picks about `wanted` of a part, up to VIRTUAL_PICKS_USUAL, into
 * picks[VIRTUAL_PICKS_MOST]; returns how many. */
int virtual_lights_pick(const struct virtual_lights *lights, vec3 place,
                        unsigned part, int wanted, struct virtual_pick *picks);

#endif
