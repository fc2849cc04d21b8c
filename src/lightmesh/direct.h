/* The direct light mesh (DLM of the light-mesh paper), in the reading that
 * agrees with shadow rays: a mesh point keeps what it sees of the lamps, a
 * surface adds the cosines. With few lamps that is each one's visible share,
 * interpolated and multiplied into the exact light; with many it is their
 * light as spherical harmonics, so that no surface point asks every lamp. */
#ifndef LIGHTMESH_DIRECT_H
#define LIGHTMESH_DIRECT_H

#include "lightmesh/harmonics.h"
#include "lightmesh/point_mesh.h"
#include "shade/lamps.h"

struct facet_light;
struct facet_mesh;
struct light_tree;

enum {
    FEW_MAX = 1024, /* lamps known one by one, at most */
    FEW_WORDS = FEW_MAX / 64,
};

static inline bool few_has(const uint64_t set[FEW_WORDS], int number)
{
    return set[number / 64] >> (number % 64) & 1;
}

struct direct_mesh {
    const struct lamps *lamps;
    struct point_mesh points;
    bool many;                 /* lamps: harmonics instead of shares */
    int budget;                /* lamps that a mesh point asks, if many */
    struct light_tree *tree;   /* if many */
    struct facet_mesh *facets; /* points on surfaces; or NULL */
};

struct direct_options {
    struct lattice lattice;
    struct lattice_view view; /* of the frame */
    const struct interpolation *interpolation;
    double radius; /* of interpolation, in spacings; 0: its own */
    struct refinement refinement;
    bool many;     /* lamps: the light of all is summed; or at most FEW_MAX */
    bool surfaces; /* many lamps: surfaces have points of their own, too */
    int budget;    /* many lamps: that a point asks */
    vec3 centre;   /* of what is seen */
    double size;
    size_t bytes; /* of memory */
};

/* Frees with direct_mesh_free. The lamps must outlive it. */
struct direct_mesh *direct_mesh_new(const struct lamps *lamps,
                                    const struct direct_options *options);
void direct_mesh_free(struct direct_mesh *mesh);

/* Few lamps: the share of lamp `number` that a blend sees. */
rgb direct_mesh_share(const struct direct_mesh *mesh,
                      const struct mesh_blend *blend, int number);

/* What a blend knows of few lamps: sets of their numbers, as bits. */
struct direct_verdict {
    uint64_t lit[FEW_WORDS];  /* all points see all of the lamp */
    uint64_t dark[FEW_WORDS]; /* no point sees any of it */
    /* All points find its light so faint beside that of the others that the
     * interpolated share will do where a shadow's edge is to be sharp. */
    uint64_t faint[FEW_WORDS];
};

void direct_mesh_judge(const struct direct_mesh *mesh,
                       const struct mesh_blend *blend,
                       struct direct_verdict *verdict);

/* Whether enough points were asked to believe in sharp shadows what they agree
 * on. */
bool direct_mesh_agrees(const struct mesh_blend *blend);

/* Many lamps: their light around a blend. */
struct harmonics direct_mesh_light(const struct mesh_blend *blend);

/* All light of lamps that reaches a mesh point, without cosines. */
rgb direct_mesh_arriving(const struct direct_mesh *mesh, vec3 place,
                         const void *payload);

/* Direct light on any surface point, the lamps' colours times their cosines. */
rgb direct_mesh_irradiance(const struct direct_mesh *mesh,
                           struct worker *worker,
                           const struct receiver *receiver);

/* The same by one mesh point, see point_mesh_nearest. */
rgb direct_mesh_nearest(const struct direct_mesh *mesh, struct worker *worker,
                        const struct receiver *receiver, vec3 jitter);

#endif
