/* Rays that are on their way together: where each first meets something or,
 * on the way to a lamp, whether it does. They begin and go close together, as
 * those of neighbouring pixels do, so that what one may meet the others may
 * meet too. */
#ifndef WORLD_PACKET_H
#define WORLD_PACKET_H

#include "scene/slab_rays.h"
#include "world/query.h"

/* Bits stand for rays. */
struct packet {
    struct query query[RAY_LANES]; /* first, for Embree; those that are begun */
    struct world_hit *found; /* of rays that look for what is nearest, until
                              * their queries are begun */
    const struct rays *rays;
    struct rays_span span; /* of nearest crossings a little more, for ties */
    LANE_LINES double
        inverse[3][RAY_LANES]; /* of the directions, if there are boxes */
    double shift[RAY_LANES];   /* as in a query, and doubt */
    double doubt;
    bool occlusion;            /* to a lamp: */
    int light;                 /* number of the lamp */
    bool opaque;               /* nothing lets light pass */
    world_lane_filter *filter; /* or NULL */
    void *context;             /* of the filter */
    unsigned panes;     /* that have met what may, without a filter, and look no
                         * further */
    enum ray_kind kind; /* else */
    unsigned open;      /* rays that look for something still */
    unsigned begun;     /* whose queries are filled in */
};

/* Rays that look for what is nearest. */
struct nearest {
    const struct rays *rays;
    const struct rays_span *span;
    enum ray_kind kind;
    unsigned lanes;
    struct world_hit *found; /* of the lanes; leaf NULL: nothing */
};

/* Begins with those of `lanes` that are rays at all and have any length, up to
 * `limit`. `boxed`: they will be clipped by boxes. */
void packet_to_lamp(struct packet *packet, const struct occlusions *asked,
                    unsigned lanes, double limit, bool boxed);
void packet_to_nearest(struct packet *packet, const struct nearest *asked,
                       double limit, bool boxed);

/* Looks at the solid with the open ones of `lanes`. Rays to a lamp that meet it
 * are no longer open. Returns whether none is left open of all. */
bool packet_look(struct packet *packet, const struct solid *solid,
                 unsigned lanes);

/* What the rays that look for what is nearest have found in the end, where they
 * were asked. */
void packet_tell(const struct packet *packet);

/* For packet_offer: to a query. */
void packet_offer_query(struct packet *packet, unsigned i,
                        const struct leaf *leaf, struct hit hit);

/* Tells the queries that are begun how Embree's rays differ from theirs. */
void packet_set_out(struct packet *packet, const double shift[RAY_LANES],
                    double doubt);

/* To be called once a ray's query has met something nearer. */
static inline void packet_met(struct packet *packet, unsigned i)
{
    packet->span.far[i] = query_reach(&packet->query[i]);
}

/* A crossing of a ray that looks for what is nearest. As long as nobody else
 * asks about the ray it has no query: to fill one in takes longer. */
static inline void packet_offer(struct packet *packet, unsigned i,
                                const struct leaf *leaf, struct hit hit)
{
    struct world_hit *found = &packet->found[i];
    const double far = found->leaf ? found->hit.t : packet->span.far[i];
    if (packet->begun >> i & 1 || (found->leaf && hit.t == far)) {
        packet_offer_query(packet, i, leaf, hit);
    } else if (hit.t > packet->span.near[i] && hit.t < far) {
        *found = (struct world_hit){ leaf, hit };
        packet->span.far[i] = reach_of(hit.t);
    }
}

/* packet_met of a query that may be no packet's; Embree's context says. */
static inline void packet_met_lane(embree_context *context,
                                   const struct query *query)
{
    const struct query *first = (const struct query *)context;
    if (first->packet)
        packet_met(first->packet, (unsigned)(query - first));
}

/* Whether the packet's rays see the leaf at all. */
static inline bool packet_sees(const struct packet *packet,
                               const struct leaf *leaf)
{
    return packet->occlusion ? leaf_casts(leaf, packet->light)
                             : leaf_is_seen(leaf, packet->kind);
}

/* Which open rays may meet the box. */
unsigned packet_meets(const struct packet *packet, const struct box3 *box);

#endif
