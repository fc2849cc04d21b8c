/* Triangles as Embree's own: all small meshes together in world space, big
 * ones that several objects share once, as instances. */
#ifndef WORLD_TRIANGLES_H
#define WORLD_TRIANGLES_H

#include "world/flatten.h"
#include "world/query.h"
#include "world/rtcore.h"

enum {
    TRIANGLES_SHARED = 1000,     /* a mesh larger than this is not copied */
    TRIANGLES_LIMIT = 200000000, /* in all, those of instances once */
};

struct triangle_ref {
    const struct leaf *leaf;
    uint32_t triangle;
};

/* One geometry of Embree; its user pointer. */
struct triangle_set {
    struct triangle_ref *refs;        /* by primitive, or NULL: */
    const struct leaf *const *leaves; /* by instance */
};

struct triangles {
    vec3 centre;                 /* Embree's origin, in the world */
    struct triangle_set plain;   /* opaque, seen by all shadow rays */
    struct triangle_set special; /* the others */
    struct triangle_set shared;
    const struct leaf **leaves; /* by Embree's number of the instance */
    size_t leaf_room;
};

/* Whether a mesh of flat->meshes will be shared by instances. */
bool triangles_any_shared(const struct flat *flat);

/* Adds flat->meshes to `scene`, which is at `centre`. False after an error was
 * printed. */
bool triangles_add(struct triangles *triangles, struct flat *flat,
                   RTCDevice device, RTCScene scene, vec3 centre);

/* Releases the scenes of shared meshes. */
void triangles_free(struct flat *flat);

/* Saturating: Embree ignores what is beyond 1.8e18. */
static inline double embree_number(double value)
{
    value = 1e30 < value ? 1e30 : value;
    return -1e30 > value ? -1e30 : value;
}

static inline float triangles_float(double value)
{
    return (float)embree_number(value);
}

#endif
