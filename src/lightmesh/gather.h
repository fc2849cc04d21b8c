/* What comes to a mesh point from one direction: the gather ray of equation
 * (4) of the light-mesh paper, whose surface is lit by the direct mesh and by
 * the indirect one of the bounce before, so that the two meshes feed each
 * other. */
#ifndef LIGHTMESH_GATHER_H
#define LIGHTMESH_GATHER_H

#include "base/draw.h"
#include "lightmesh/direct.h"
#include "lightmesh/indirect_light.h"
#include "shade/ambience.h"
#include "shade/emitters.h"

struct indirect_mesh;
struct onwards;
struct virtual_lights;

/* The irradiance of light from everywhere that ends a row of bounces, and
 * stands in where a place sees no mesh point; false where it isn't known.
 * Nothing is between the place and `from`, where its light goes; only the mean
 * of many answers need be right. */
typedef bool gather_close(const void *context, struct worker *worker,
                          vec3 place, vec3 normal, vec3 from, rgb *light);

/* A crevice that rays set out from. What they meet close to where they come
 * from is in it as well: nothing that ends the bounces is asked about that, but
 * further rays. */
struct gather_crevice {
    const struct indirect_light *known; /* of the place that they set out from:
                                         * usual in it; NULL: it is in none */
    double near;                        /* units: so close */
    double least; /* chance, at least, that a ray goes on from there */
};

struct gather {
    const struct lamps *lamps;
    const struct direct_mesh *direct;
    const struct indirect_mesh *indirect; /* of one bounce less, or NULL */
    const struct indirect_light *here;    /* around what rays meet first; NULL:
                                           * `indirect` is asked */
    const struct virtual_lights *virtual_lights; /* what these bring to mesh
                                                  * points gather rays don't;
                                                  * NULL: there are none */
    int picks;                                   /* of which one asks so many */
    struct lattice_view view;                    /* of what its rays meet */
    const struct emitters *emitters;
    const struct ambience *ambience;
    struct bounce_tone tone; /* of what `indirect` says */
    struct gather_crevice crevice;
    gather_close *close; /* or NULL */
    const void *close_context;
    bool together; /* most rays meet something that few lamps light: shadow rays
                    * of several are quicker */
    bool onward;   /* where that knows nothing further rays end it, and stand in
                    * likewise */
    const struct onwards *onwards; /* what is drawn for these; may be NULL */
    double
        wide; /* radius of what a ray stands for, of its length; 0: a point */
    struct indirect_share around; /* what ends the bounces where nothing else
                                   * does */
};

/* What `close` says of a receiver; false where nothing is known. */
bool gather_closes(const struct gather *gather, struct worker *worker,
                   const struct receiver *receiver,
                   struct indirect_share *share);

/* What is drawn for a gather ray. */
enum gather_slot {
    GATHER_DIRECTION,
    GATHER_WHICH, /* of what glows */
    GATHER_WHERE,
    GATHER_LAMP,       /* which lamp, */
    GATHER_LAMP_PLACE, /* and where on an area light */
    GATHER_NEAR,       /* which mesh points near by */
    GATHER_HIGH,
    GATHER_MIRROR, /* whether one is followed; so many numbers as there may be
                    * mirrors */
    GATHER_MEETING = GATHER_MIRROR + 8, /* whether a surface that is met is lit;
                                         * likewise */
    GATHER_CHANCE = GATHER_MEETING + 128, /* whether a ray goes on */
    GATHER_ONWARD,                        /* what is drawn for that one */
};

/* What comes along a ray. */
struct gathered_ray {
    rgb light;
    double open;            /* to the ambient light outside, 0 to 1 */
    rgb glow;               /* of the light, what its first surface has of its
                             * own */
    rgb lamps;              /* likewise, what it has of lamps */
    struct intersection at; /* where; at.leaf NULL: nowhere */
};

/* The ray is sample `draws`. Mirrors and panes are followed. */
void gather_radiance(const struct gather *gather, struct worker *worker,
                     const struct ray *ray, const struct draws *draws,
                     struct gathered_ray *gathered);

/* The same of a ray of which is known where it ends, in gathered->at, whose
 * leaf is NULL where that is nowhere; and what lamps give the side of that
 * surface that it comes to, without what virtual lights bring, unless
 * `lamplight` is NULL. */
void gather_met(const struct gather *gather, struct worker *worker,
                const struct ray *ray, const struct draws *draws,
                const rgb *lamplight, struct gathered_ray *gathered);

#endif
