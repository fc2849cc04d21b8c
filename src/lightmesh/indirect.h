/* The indirect light mesh (ILM of the light-mesh paper): a mesh point keeps
 * the light that surfaces send it, gathered from all directions by equation
 * (4), as spherical harmonics. One mesh for each bounce: the first is lit by
 * the direct mesh and the second, that by the third, the last by the direct
 * one alone. Each is made, point by point, only where the one before asks;
 * meshes of later bounces are coarser, since less depends on them. A gather
 * ray takes one point near by: many rays are an interpolation of their own.
 *
 * Light of surfaces that glow is found by gather rays and by picking points on
 * them, weighted by the balance heuristic (Veach 1997, section 9.2). */
#ifndef LIGHTMESH_INDIRECT_H
#define LIGHTMESH_INDIRECT_H

#include "lightmesh/bright.h"
#include "lightmesh/gather_ways.h"
#include "lightmesh/gather.h"
#include "lightmesh/indirect_light.h"
#include "lightmesh/near_field.h"
#include "lightmesh/onward.h"
#include "lightmesh/way_cells.h"

enum { BOUNCES_MAX = 20 };

struct indirect_options {
    struct lattice lattice;       /* of the first bounce */
    struct lattice_view view;     /* of gather rays */
    struct refinement refinement; /* likewise */
    const struct interpolation *interpolation;
    double radius; /* of interpolation, in spacings; 0: its own */
    int bounces;   /* 1..BOUNCES_MAX */
    int samples;   /* gather rays of a mesh point */
    double edge;   /* what two of them that are side by side bring may
                    * differ by so many times what one does in the mean
                    * before others look between them; 0: none do */
    int near, near_lone, near_more; /* rays to what is close to a corner of many
                                     * pixels, to a place that is seen alone,
                                     * and to more of these in a pixel; */
    int near_own;                   /* and of a place in a crevice, */
    double own_worth;               /* which count so much, 0 to 1 */
    const struct bright *bright;    /* where most light comes from; NULL: nobody
                                     * looked */
    const struct virtual_lights *virtual_lights; /* NULL: there are none */
    int picks;      /* of which a point asks so many, */
    int glow_picks; /* and at least so many places of what glows */
    size_t bytes;   /* of memory, all bounces together */
    struct bounce_tone tone;
    gather_close *close; /* what lights the last bounce; may be NULL */
    const void *close_context;
    bool closed; /* little light leaves the scene */
    bool onward; /* further rays do where that knows nothing, */
    struct indirect_share around; /* or this */
};

struct near_glow;
struct indirect_mesh;

/* Meshes like one, of moments around it, its own among them. */
enum { MOMENTS_MOST = 5 };
struct indirect_moments {
    int count; /* 0: it knows what it gathers by itself */
    int now;   /* which is its own */
    struct {
        const struct indirect_mesh *mesh;
        double weight;
    } at[MOMENTS_MOST];
};

struct indirect_mesh {
    struct gather gather;
    struct point_mesh points;
    struct indirect_mesh *next;  /* of the bounce before this, or NULL */
    const struct bright *bright; /* as of its options; NULL: none of its rays go
                                  * there */
    int samples, lone_samples;
    int glow_picks; /* as of its options */
    struct gather_ways ways;
    double edge; /* as of its options */
    struct way_cells cells;
    struct onwards onwards;                      /* of its gather rays */
    struct near_ways near, near_lone, near_more; /* of near rays, as of its
                                                  * options, */
    struct near_ways near_beside;                /* beside what glows, */
    struct near_ways near_own;                   /* and in a crevice, */
    double own_worth;                            /* which count so much */
    struct onwards near_onwards;                 /* likewise */
    struct near_glow *near_glow;     /* what mesh points leave out; or NULL */
    struct indirect_moments moments; /* by which what points know is smoothed */
};

/* Frees with indirect_mesh_free. All that is given must outlive it. */
struct indirect_mesh *indirect_mesh_new(const struct direct_mesh *direct,
                                        const struct emitters *emitters,
                                        const struct ambience *ambience,
                                        const struct indirect_options *options);
void indirect_mesh_free(struct indirect_mesh *mesh);

/* Smooths what its points will know by these: lightmesh/moments.c. */
void indirect_mesh_smooth(struct indirect_mesh *mesh,
                          const struct indirect_moments *moments);

/* Whether what the receiver gets is left to what ends the bounces: the picture
 * shows too little of it. */
bool indirect_mesh_leaves(const struct indirect_mesh *mesh,
                          const struct receiver *receiver);

/* What the mesh points around know together, before the receiver's cosines,
 * into *light. Returns false where there are none, and it is the receiver's own
 * place that knows: that sees by itself what is close. */
bool indirect_mesh_blend(const struct indirect_mesh *mesh,
                         struct worker *worker, const struct receiver *receiver,
                         struct indirect_light *light);

/* Mends what the points around know by what is close: by rays along `ways`
 * (near_field.h), and by what glows there (near_glow.h). Returns what the
 * receiver's side gets of it, without bumps. */
struct near_share indirect_mesh_mend(const struct indirect_mesh *mesh,
                                     struct worker *worker,
                                     const struct receiver *receiver,
                                     const struct near_ways *ways,
                                     struct indirect_light *light);

/* Both. */
struct near_share indirect_mesh_around(const struct indirect_mesh *mesh,
                                       struct worker *worker,
                                       const struct receiver *receiver,
                                       const struct near_ways *ways,
                                       struct indirect_light *light);

/* What is worth little is less exact. */
struct indirect_share indirect_mesh_light(const struct indirect_mesh *mesh,
                                          struct worker *worker,
                                          const struct receiver *receiver);

/* By mesh points alone: on what is worth little, and on what a ray from a place
 * met. Those who mend send rays themselves, and would be asked again by these
 * without end. */
struct indirect_share indirect_mesh_beyond(const struct indirect_mesh *mesh,
                                           struct worker *worker,
                                           const struct receiver *receiver);

/* Who answers that, in words. */
const char *indirect_mesh_source(const struct indirect_mesh *mesh,
                                 const struct receiver *receiver);

/* The same in *share by one mesh point, see point_mesh_nearest; false if none
 * sees the place. */
bool indirect_mesh_nearest(const struct indirect_mesh *mesh,
                           struct worker *worker,
                           const struct receiver *receiver, vec3 jitter,
                           struct indirect_share *share);

#endif
