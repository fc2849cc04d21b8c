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
#include "embree/world.h"
#include "lightmesh/interpolation.h"
#include "lightmesh/lattice.h"
#include "lightmesh/refine.h"

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
    struct table *table;  /* payloads */
    struct table *around; /* obstacles */
    struct point_mesh_work *work;
    atomic_bool *full; /* shared with other meshes; see point_mesh_crowding */
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
    struct {
        const void *payload; /* valid until the worker's scratch is reset */
        double weight;       /* they sum to 1 */
    } at[BLEND_POINTS];
};

/* The tables of a mesh whose other members are set: `bytes` of memory at
 * most. Freed with point_mesh_free. */
void point_mesh_start(struct point_mesh *mesh, size_t bytes);
void point_mesh_free(struct point_mesh *mesh);

/* How many times more points were asked for than there is room for; above 1
 * the mesh can't be used: from the moment it is full, *mesh->full, the light
 * is black, and points are only counted, lest they be computed again and
 * again. Whether that happens depends on no order. */
double point_mesh_crowding(const struct point_mesh *mesh);

/* The bytes in use. */
size_t point_mesh_bytes(const struct point_mesh *mesh);

/* Takes a mesh point that is known: its place and payload. */
typedef void mesh_visit(void *context, vec3 place, const void *payload);

/* Calls visit for each of them, in no order, while no thread asks the mesh.
 * Which they are doesn't depend on threads. */
void point_mesh_each(const struct point_mesh *mesh, mesh_visit *visit,
                     void *context);

/* About how many known points are there only because others differed. */
size_t point_mesh_refined(const struct point_mesh *mesh);

/* The mesh points that light `place`, on a surface whose true normal, turned
 * to the lit side, is `normal`. What is worth little has coarser ones. */
void point_mesh_blend(const struct point_mesh *mesh, struct worker *worker,
                      vec3 place, vec3 normal, double worth,
                      struct mesh_blend *blend);

/* The payload of the nearest mesh point that sees the place, or NULL. Cheap,
 * for places of which many are looked at together: with `jitter` uniform in
 * [-0.5,0.5)^3 the mean of many is the trilinear interpolation, where all of a
 * cell's corners are of use. */
const void *point_mesh_nearest(const struct point_mesh *mesh,
                               struct worker *worker, vec3 place, vec3 normal,
                               vec3 jitter);

#endif
