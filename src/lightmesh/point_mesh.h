/* A light mesh: points in space that know something about the light, each
 * unknown until a surface near it is shaded, then computed and kept (section
 * 1.6 of the light-mesh paper). What they know is the business of `fill`:
 * direct.h keeps direct light.
 *
 * A mesh point lights a place only if it is in front of the surface there and
 * nothing stands between. If no point is of use, the place is a mesh point of
 * its own, not kept. */
#ifndef LIGHTMESH_POINT_MESH_H
#define LIGHTMESH_POINT_MESH_H

#include <stdatomic.h>

#include "base/worker.h"
#include "world/world.h"
#include "lightmesh/interpolation.h"
#include "lightmesh/distinct.h"
#include "lightmesh/receiver.h"
#include "lightmesh/refine.h"

struct obstacles;
struct table;

/* A mesh point to be filled. */
struct mesh_site {
    vec3 place;
    uint64_t key;  /* of what may look random */
    double dither; /* in [0,1): the points of any cell have different eighths */
    /* A place on a surface that is its own mesh point, and not kept; its
     * normal. */
    bool lone;
    vec3 normal;
    double worth; /* likewise, of what it gets: how much the picture shows */
    /* The unit direction into the only surface that may ask for it: what comes
     * from there lights nothing. Zero: there are several, or nobody looked. */
    vec3 wall;
};

/* Must depend on the site alone. `payload` is zeroed. */
typedef void mesh_fill(const void *context, struct worker *worker,
                       const struct mesh_site *site, void *payload);

/* How much light a payload knows of. */
typedef double mesh_amount(const void *payload);

/* The light on a surface if all mesh points around were like this one. */
typedef rgb mesh_alone(const void *context, vec3 place, vec3 normal,
                       const void *payload);

/* What was done for a mesh. */
struct point_mesh_work {
    atomic_ullong rays;        /* without those that ask other meshes */
    atomic_ullong nanoseconds; /* of all threads together, likewise */
    atomic_ullong lone;        /* places that were their own mesh points */
};

struct point_mesh {
    const struct world *world;
    struct lattice lattice;
    const struct interpolation *interpolation;
    double radius;        /* of interpolation, in spacings */
    double least;         /* share of a place's points that isn't asked, unless
                           * there are no others; more where the place is worth
                           * less (seek_worth) */
    struct table *table;  /* payloads; and beside them, by the same keys, */
    struct table *around; /* obstacles */
    struct point_mesh_work *work;
    size_t payload_size;
    mesh_fill *fill;
    bool walled;                  /* whether that wants to know about walls */
    mesh_amount *amount;          /* NULL: points are never taken for alike */
    struct refinement refinement; /* from what lattice_level says */
    mesh_alone *light;            /* NULL: there must be none */
    /* The place of the point of this key, false if there is none; NULL: they
     * are the lattice's. */
    bool (*place)(const void *context, uint64_t key, vec3 *place);
    const void *context;
};

/* Counts what is done for a point of a mesh, without what other meshes did for
 * it: that they have counted. */
struct mesh_watch {
    unsigned long long rays, others;
    double seconds, start;
};

struct mesh_watch mesh_watch_start(const struct worker *worker);
void mesh_watch_stop(const struct mesh_watch *watch,
                     const struct point_mesh *mesh, struct worker *worker);

enum { BLEND_POINTS = 4 * INTERPOLATION_POINTS };

/* What a place takes from mesh points. */
struct mesh_blend {
    int count; /* at least 1 */
    bool here; /* no point is of use: the one there is was made for the place */
    rgb through; /* of their light, what panes let pass to the place */
    struct {
        const void *payload; /* valid until the worker's scratch is reset */
        double weight;       /* they sum to 1 */
    } at[BLEND_POINTS];
};

/* The tables of a mesh whose other members are set: `bytes` of memory at
 * most; what finds no room there is worked out each time that it is asked for,
 * which changes time and no picture. Freed with point_mesh_free. */
void point_mesh_start(struct point_mesh *mesh, size_t bytes);
void point_mesh_free(struct point_mesh *mesh);

/* The bytes in use. */
size_t point_mesh_bytes(const struct point_mesh *mesh);

/* Takes a mesh point that is known: its place and payload. */
typedef void mesh_visit(void *context, vec3 place, const void *payload);

/* Calls visit for each of them, in no order, while no thread asks the mesh.
 * Which they are doesn't depend on threads. */
void point_mesh_each(const struct point_mesh *mesh, mesh_visit *visit,
                     void *context);

/* About how many known points are there only because others differed, as `view`
 * asks. */
size_t point_mesh_refined(const struct point_mesh *mesh,
                          const struct lattice_view *view);

/* What a point knows, what stands around it, and the name under which the first
 * is kept: that of all levels if they are mixed. The worker's scratch holds
 * what has no room in the tables. */
const void *point_mesh_payload(const struct point_mesh *mesh,
                               struct worker *worker,
                               const struct lattice_point *point);
const struct obstacles *point_mesh_around(const struct point_mesh *mesh,
                                          struct worker *worker,
                                          const struct lattice_point *point);
struct lattice_point point_mesh_shared(const struct point_mesh *mesh,
                                       const struct lattice_point *point);

/* Fills the payload of a site, and counts what it took. */
void point_mesh_fill(const struct point_mesh *mesh, struct worker *worker,
                     const struct mesh_site *site, void *payload);

/* By how many levels the points are coarser that a receiver of this weight asks
 * for, 0 to POINT_MESH_WORTHS - 1, and a weight for which they are so many. */
enum { POINT_MESH_WORTHS = 4 };
int point_mesh_worth(double weight);
double point_mesh_typical_worth(int levels);

/* The mesh points that light the receiver. What is worth little has coarser
 * ones. */
void point_mesh_blend(const struct point_mesh *mesh, struct worker *worker,
                      const struct receiver *receiver,
                      struct mesh_blend *blend);

/* The payload of the nearest mesh point that sees the receiver, or NULL. Cheap,
 * for places of which many are looked at together: with `jitter` uniform in
 * [-0.5,0.5)^3 the mean of many is the trilinear interpolation, where all of a
 * cell's corners are of use. Unless `through` is NULL one that sees it through
 * panes is as good, which let that of its light pass. */
const void *point_mesh_nearest(const struct point_mesh *mesh,
                               struct worker *worker,
                               const struct receiver *receiver, vec3 jitter,
                               rgb *through);

/* Adds the names of the points that a blend for the receiver would ask for, of
 * no level finer than usual. */
void point_mesh_want(const struct point_mesh *mesh,
                     const struct receiver *receiver, struct distinct *wanted);

#endif
