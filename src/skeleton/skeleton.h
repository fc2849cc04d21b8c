/* Coarse irradiance along the curvilinear skeleton of the void (Noel, Chaussard
 * and Biri, "Coarse Irradiance Estimation using Curvilinear Skeleton", SIGGRAPH
 * 2012 posters): how much light reaches a point, and from where, for every
 * point of the void. Built once; then const, any number of threads may ask. */
#ifndef SKELETON_SKELETON_H
#define SKELETON_SKELETON_H

#include "base/worker.h"
#include "world/world.h"
#include "shade/ambience.h"
#include "shade/lamp.h"
#include "skeleton/graph.h"
#include "skeleton/paths.h"

struct heuristic;
struct pieces_kept;

/* How the light of one lamp comes into the void. */
struct skeleton_lamp {
    const struct lamp *lamp;
    /* Shared by lamps that enter at the same node, or, of many, close by. NULL:
     * it never comes, or the heuristic asks for no ways. */
    const struct paths *paths;
    /* It stands in the void, by the source of the paths. Else it shines in from
     * outside, and the sources are the nodes that see it. */
    bool within;
};

/* What a lamp is about, to choose among many. */
struct lamp_gist {
    float x, y, z;
    float brightness;
    float fading; /* 1/D^2: it has half of it left at the distance D; or 0 */
};

struct skeleton {
    struct arena *arena;
    const struct world *world;
    const struct scene *scene;
    struct ambience ambience;
    const struct voxels *voxels;
    struct graph *graph;
    uint32_t *nearest;    /* node of each voxel, GRAPH_NONE: none */
    const uint8_t *marks; /* of what is matter, skeleton/matter.h */
    struct lamp *plain_lamps;
    struct skeleton_lamp *lamps;
    struct lamp_gist *gists;
    size_t lamp_count;
    const struct heuristic *heuristic;
    void *state; /* of the heuristic */
    uint64_t seed;
    size_t rays; /* that heuristics may send to get started, about */
    const struct pieces_kept *root; /* while it is begun; or NULL */
    unsigned threads;
    const atomic_int *stop;
    int rounds; /* of the collapse */
};

static inline bool skeleton_stopped(const struct skeleton *skeleton)
{
    return skeleton->stop &&
           atomic_load_explicit(skeleton->stop, memory_order_relaxed);
}

struct skeleton_options {
    const struct heuristic *heuristic; /* NULL: the default */
    uint64_t seed;
    unsigned threads;
    const atomic_int *stop; /* non-zero: leave off; NULL: never */
    size_t rays; /* that the heuristic may send to get started, about; 0: as
                  * many as answers need that are shown as they are */
    /* How another picture's void was cut that this one's may be cut like
     * (skeleton/pieces.h); or NULL. */
    const struct pieces_kept *root;
};

/* From the voxels of the scene, which must outlive it, as must the world. NULL
 * if it was stopped. */
struct skeleton *skeleton_new(const struct world *world,
                              const struct scene *scene,
                              const struct voxels *voxels,
                              const struct skeleton_options *options);
void skeleton_free(struct skeleton *skeleton);

/* How its heuristic has cut the void, as a root for others; NULL: it doesn't.
 * Freed with memory_free. */
struct pieces_kept *skeleton_keep(const struct skeleton *skeleton);

/* A point, and where the skeleton knows it. */
struct skeleton_point {
    vec3 position;
    vec3 normal;   /* unit, into the void; zero: of no surface */
    vec3 around;   /* a place in the void before it */
    size_t voxel;  /* that this is in; VOXEL_NONE: there is no void */
    bool faces;    /* whether that is straight before the point */
    uint32_t node; /* the closest to that; GRAPH_NONE: there is no void */
};

/* In POV-Ray's units: irradiance without pi. */
struct skeleton_light {
    rgb arriving; /* of all lamps, on a surface that faces the stream */
    vec3 stream;  /* where light comes from: the sum of unit directions, each
                   * times the brightness of its light */
    rgb indirect; /* irradiance of the surface but for the direct light of lamps
                   * that are seen from it */
};

/* The closest voxel with a node, `reach` voxels around a place; of those the
 * one most in the direction of the normal. Sets around, voxel and node; false
 * if there is none. */
bool skeleton_search(const struct skeleton *skeleton, int reach,
                     struct skeleton_point *point);

/* Finds the void before a point, or else beside it, within two voxels, but not
 * behind a wall. `from` is a place that sees the point, if one is known, so
 * that the void may be looked for on the way there; else the point itself. */
struct skeleton_point skeleton_find(const struct skeleton *skeleton,
                                    vec3 position, vec3 normal, vec3 from);

/* Whether a point there would face void, and isn't in a gap that is narrower
 * than voxels: as of skeleton_find. */
bool skeleton_faces(const struct skeleton *skeleton, vec3 position,
                    vec3 normal);

/* What the heuristic says. Where the skeleton doesn't reach it is black, and
 * outside of the grid what the sky gives. */
struct skeleton_light skeleton_light(const struct skeleton *skeleton,
                                     struct worker *worker, vec3 position,
                                     vec3 normal);

/* Its `indirect` alone, which may be much cheaper. */
rgb skeleton_indirect(const struct skeleton *skeleton, struct worker *worker,
                      vec3 position, vec3 normal);

/* The same for many rays whose light is mixed anyway: taken to be even within a
 * voxel. `from` as in skeleton_find. False where no void is near, as behind
 * bars closer to each other than voxels are wide, or outside of the grid, if
 * there is no sky that gives light. */
bool skeleton_close(const struct skeleton *skeleton, struct worker *worker,
                    vec3 position, vec3 normal, vec3 from, rgb *light);

#endif
