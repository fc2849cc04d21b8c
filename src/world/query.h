/* A ray on its way through the world, with the exact ray and the best crossing
 * so far. Embree hands it to the callbacks as the extended context of a
 * traversal, so that its own float ray decides nothing but where to look. Of
 * rays that are traced together it hands on the first of an array: the id of
 * Embree's ray says which is meant. */
#ifndef WORLD_QUERY_H
#define WORLD_QUERY_H

#include "world/rtcore.h"
#include "scene/slab.h"
#include "world/world.h"

enum { QUERY_RECENT = 16 };

struct packet;

struct query {
    embree_context embree; /* first: Embree gives this pointer */
    struct packet *packet; /* that it is the first of (packet.h), or NULL */
    struct ray ray;
    struct slabs slabs;
    double tmin, tmax; /* tmax: the best crossing so far */
    double shift;      /* Embree's t minus ours */
    double doubt;      /* how far Embree's t may be off */
    double spread;     /* of a cone, see primitive.h; 0: it is a line */
    bool occlusion;    /* any crossing, not the nearest */

    enum ray_kind kind; /* nearest: */
    const struct leaf *leaf;
    struct hit hit;
    bool rough; /* the hit's u and v are still to be found */

    int light; /* occlusion: */
    world_filter *filter;
    void *context;
    bool blocked;
    struct {
        const struct leaf *leaf;
        double t;
    } recent[QUERY_RECENT]; /* triangles told, against telling them twice */
    unsigned recent_count;
};

/* Embree's packets of N rays and their hits are arrays of N of each of these
 * words, one array after the other; those of a single ray are plain structs,
 * which is the same for N = 1. */
enum { LANE_TFAR = 8, LANE_ID = 10, LANE_HIT = 12 }; /* of a ray */
enum { LANE_PRIMITIVE = 5, LANE_GEOMETRY = 6, LANE_INSTANCE = 7 }; /* a hit */

/* That of ray i of the packet, filled in. */
struct query *packet_query(struct packet *packet, unsigned i);

/* The query of ray i of N. */
static inline struct query *query_lane(embree_context *context,
                                       const void *rays, unsigned n, unsigned i)
{
    struct query *first = (struct query *)context;
    unsigned id = ((const unsigned *)rays)[LANE_ID * n + i];
    return first->packet ? packet_query(first->packet, id) : first + id;
}

/* Whether a leaf stands in the way of the light of lamp number `light`. */
static inline bool leaf_casts(const struct leaf *leaf, int light)
{
    return !leaf->look->no_shadow &&
           (leaf->look->looks_like < 0 || leaf->look->looks_like != light);
}

/* Whether a ray of that kind that looks for the nearest sees it. */
static inline bool leaf_is_seen(const struct leaf *leaf, enum ray_kind kind)
{
    const struct leaf_look *look = leaf->look;
    switch (kind) {
    case RAY_CAMERA:
        return !look->no_image;
    case RAY_REFLECTION:
        return !look->no_reflection;
    case RAY_SIGHT:
        return !look->no_image && !look->clear;
    case RAY_GATHER:
        return !look->no_reflection && !look->clear;
    case RAY_PHOTON:
        return !look->no_shadow;
    case RAY_OBSTACLE:
        break;
    }
    return !look->no_shadow && !look->clear;
}

/* Whether the ray sees the leaf at all. */
static inline bool query_sees(const struct query *query,
                              const struct leaf *leaf)
{
    if (!query->occlusion)
        return leaf_is_seen(leaf, query->kind);
    return leaf_casts(leaf, query->light) &&
           (query->filter || !leaf->look->clear);
}

/* Up to where a crossing may win, be it in a tie, of a best one so far. */
static inline double reach_of(double best)
{
    return best * (1 + 0x1p-52);
}

static inline double query_reach(const struct query *query)
{
    return reach_of(query->tmax);
}

/* Whether a crossing at t counts. */
bool query_wants(const struct query *query, const struct leaf *leaf, double t);

/* For query_take: of a ray to a lamp. */
bool query_block(struct query *query, const struct leaf *leaf,
                 const struct hit *hit);

/* Takes a crossing that counts, within tmin and tmax, of a ray that looks for
 * what is nearest. By value, so that nobody writes it down before it is in its
 * place: reading two numbers at a time that were only just written one by one
 * waits for the memory. */
static inline void query_keep(struct query *query, const struct leaf *leaf,
                              struct hit hit)
{
    query->tmax = hit.t;
    query->leaf = leaf;
    query->hit = hit;
    query->rough = false;
}

/* Of any ray. Returns true when the search is over. */
static inline bool query_take(struct query *query, const struct leaf *leaf,
                              const struct hit *hit)
{
    if (query->occlusion)
        return query_block(query, leaf, hit);
    query_keep(query, leaf, *hit);
    return false;
}

/* Looks at everything in a solid that is simple, or is not. */
bool query_simple(struct query *query, const struct solid *solid);
bool query_tree(struct query *query, const struct solid *solid);

/* The ray in the space of the tree at hand; its t is the same everywhere. Of
 * the tree no crossing before `enter` or after `leave` counts. */
struct space {
    struct ray ray;
    struct slabs slabs;
    double enter, leave;
};

/* The same in a leaf of a tree; `ray` is that of the space. NULL: the leaf is
 * simple, and the ray the world's. */
bool query_leaf(struct query *query, const struct solid *solid,
                const struct ray *ray, const struct space *space);

/* Whether the ray meets the gate or starts in it. */
bool query_gate_opens(const struct solid *gate, const struct ray *ray,
                      const struct slabs *slabs);

/* Looks at everything in the solid; returns true when the search is over. */
static inline bool query_solid(struct query *query, const struct solid *solid)
{
    return solid->simple ? query_simple(query, solid)
                         : query_tree(query, solid);
}

/* The exact crossing of a triangle that Embree says is hit: its plane decides
 * t. False if it is not within tmin and tmax. */
bool query_triangle(const struct query *query, const struct leaf *leaf,
                    uint32_t triangle, double *t);

/* As query_take for a triangle, which Embree may offer more than once or, where
 * two share an edge, both of them. */
bool query_take_triangle(struct query *query, const struct leaf *leaf,
                         uint32_t triangle, double t);

/* Fills in what is left out of the hit of a triangle, u and v. */
void query_refine(const struct ray *ray, const struct leaf *leaf,
                  struct hit *hit);

/* The same for query->hit, if it is left out. */
void query_finish(struct query *query);

#endif
