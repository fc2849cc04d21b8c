/* Rays that are on their way together: see packet.h. */
#include "world/packet.h"

#include <string.h>

#include "scene/primitive.h"
#include "world/packet_tree.h"

/* Which rays there are: those whose six numbers are finite, for 0 times a
 * finite one is 0, and that have a direction and a length. */
CLONES static void find_rays(const struct rays *restrict rays,
                             const struct rays_span *restrict span,
                             lane_flag *restrict good)
{
    for (int i = 0; i < RAY_LANES; i++) {
        vec3 o = rays_origin(rays, i), d = rays_direction(rays, i);
        double zero = (o.x + o.y + o.z) * 0 + (d.x + d.y + d.z) * 0;
        bool is =
            (zero == 0) & (vec3_dot(d, d) > 0) & (span->near[i] < span->far[i]);
        good[i] = is ? -1 : 0;
    }
}

/* The span is there. */
static void packet_start(struct packet *packet, const struct rays *rays,
                         unsigned lanes, bool boxed)
{
    LANE_LINES lane_flag good[RAY_LANES];
    find_rays(rays, &packet->span, good);
    packet->query[0].packet = packet;
    packet->rays = rays;
    packet->open = rays_bits(good) & lanes;
    packet->begun = packet->panes = 0;
    if (boxed)
        rays_inverse(rays, lane_run_all(), packet->inverse);
}

static void packet_span(struct packet *packet, const struct rays_span *span,
                        double limit)
{
    for (int i = 0; i < RAY_LANES; i++) {
        packet->span.near[i] = span->near[i];
        packet->span.far[i] = lesser(span->far[i], limit);
    }
}

void packet_to_lamp(struct packet *packet, const struct occlusions *asked,
                    unsigned lanes, double limit, bool boxed)
{
    packet->occlusion = true;
    packet->light = asked->light;
    packet->filter = asked->filter;
    packet->context = asked->context;
    packet->kind = RAY_PHOTON;
    packet_span(packet, &asked->span, limit);
    packet_start(packet, &asked->rays, lanes, boxed);
}

void packet_to_nearest(struct packet *packet, const struct nearest *asked,
                       double limit, bool boxed)
{
    packet->occlusion = false;
    packet->opaque = true;
    packet->light = -1;
    packet->kind = asked->kind;
    packet->found = asked->found;
    for (unsigned lanes = asked->lanes; lanes; lanes &= lanes - 1)
        packet->found[__builtin_ctz(lanes)].leaf = NULL;
    packet_span(packet, asked->span, limit);
    packet_start(packet, asked->rays, asked->lanes, boxed);
}

/* For the filter of a query, whose context it is. */
static bool meet_pane(void *context, const struct ray *ray,
                      const struct world_hit *hit)
{
    const struct query *query = context;
    struct packet *packet = query->packet;
    const unsigned lane = (unsigned)(query - packet->query);
    (void)ray;
    if (packet->filter)
        return packet->filter(packet->context, lane, hit);
    packet->panes |= 1u << lane;
    return true;
}

/* What is known already of a ray whose query is begun. */
static void query_take_over(struct query *query, const struct world_hit *found)
{
    if (found->leaf)
        query_keep(query, found->leaf, found->hit);
}

struct query *packet_query(struct packet *packet, unsigned i)
{
    struct query *query = &packet->query[i];
    if (packet->begun >> i & 1)
        return query;
    packet->begun |= 1u << i;
    query->ray = rays_at(packet->rays, (int)i);
    query->slabs.origin = query->ray.origin;
    query->slabs.inverse = lane_get(packet->inverse, i);
    query->spread = 0;
    query->tmin = packet->span.near[i];
    query->tmax = packet->span.far[i];
    query->shift = packet->shift[i];
    query->doubt = packet->doubt;
    query->occlusion = packet->occlusion;
    query->kind = packet->kind;
    query->leaf = NULL;
    query->rough = false;
    query->light = packet->light;
    query->packet = packet;
    query->filter = packet->opaque ? NULL : meet_pane;
    query->context = query;
    query->blocked = false;
    query->recent_count = 0;
    if (!packet->occlusion)
        query_take_over(query, &packet->found[i]);
    return query;
}

void packet_offer_query(struct packet *packet, unsigned i,
                        const struct leaf *leaf, struct hit hit)
{
    struct query *query = packet_query(packet, i);
    if (!query_wants(query, leaf, hit.t))
        return;
    query_keep(query, leaf, hit);
    packet_met(packet, i);
}

void packet_tell(const struct packet *packet)
{
    for (unsigned begun = packet->begun; begun; begun &= begun - 1) {
        unsigned i = (unsigned)__builtin_ctz(begun);
        packet->found[i].leaf = packet->query[i].leaf;
        packet->found[i].hit = packet->query[i].hit;
    }
}

void packet_set_out(struct packet *packet, const double shift[RAY_LANES],
                    double doubt)
{
    memcpy(packet->shift, shift, sizeof packet->shift);
    packet->doubt = doubt;
    for (unsigned begun = packet->begun; begun; begun &= begun - 1) {
        unsigned i = (unsigned)__builtin_ctz(begun);
        packet->query[i].shift = shift[i];
        packet->query[i].doubt = doubt;
    }
}

/* Takes the nearest crossings of the shape. */
static void packet_first(struct packet *packet, const struct solid *solid,
                         const struct rays *rays, unsigned lanes)
{
    const struct object *object = solid->leaf->object;
    struct rays_met met;
    struct rays_span asked;
    struct rays_crossings all;
    const struct lane_run run = lane_run_of(lanes);
    const struct rays_span *span = rays_span_asked(
        &packet->span, lanes, object->primitive->lane_by_lane, &asked);
    memset(met.u, 0, sizeof met.u);
    if (object->primitive->first_many) {
        object->primitive->first_many(solid->leaf->shape, run, rays, span,
                                      &met);
    } else {
        object->primitive->all_many(solid->leaf->shape, run, rays, &all);
        rays_first_of(&all, run, span, &met);
    }
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        if (!(met.t[i] <= packet->span.far[i]))
            continue;
        packet_offer(packet, i, solid->leaf,
                     (struct hit){ met.t[i], (int)met.part[i], met.u[i], 0 });
    }
}

/* One after the other. */
static unsigned packet_each(struct packet *packet, const struct solid *solid,
                            unsigned lanes)
{
    unsigned over = 0;
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        if (query_solid(packet_query(packet, i), solid))
            over |= 1u << i;
        if (!packet->occlusion)
            packet_met(packet, i);
    }
    return over;
}

/* Those to a lamp that the shape is in the way of. */
static unsigned packet_crosses(struct packet *packet, const struct solid *solid,
                               unsigned lanes)
{
    const struct leaf *leaf = solid->leaf;
    bool asked = !leaf->look->opaque && packet->filter;
    if (asked && solid->all_many)
        return packet_shape(packet, solid, lanes);
    lanes = solid_crosses_many(solid, packet->rays, &packet->span, lanes);
    if (asked)
        return packet_each(packet, solid, lanes);
    if (!leaf->look->opaque && !packet->opaque)
        packet->panes |= lanes;
    return lanes;
}

/* All rays at once. Returns those that need not look any more. */
static unsigned packet_together(struct packet *packet,
                                const struct solid *solid, unsigned lanes)
{
    const struct rays *rays = packet->rays;
    struct rays local;
    if (!packet_sees(packet, solid->leaf))
        return 0;
    if (packet->occlusion)
        return packet_crosses(packet, solid, lanes);
    if (solid->moved) {
        rays_into(solid->to_shape, lane_run_of(lanes), rays, &local);
        rays = &local;
    }
    packet_first(packet, solid, rays, lanes);
    return 0;
}

/* A single ray is no worse off alone in a tree. */
static unsigned packet_meet(struct packet *packet, const struct solid *solid,
                            unsigned lanes)
{
    bool routine = packet->occlusion ? solid->crosses_many : solid->first_many;
    bool together =
        solid->simple ? routine : solid->together && lanes & (lanes - 1);
    return !together       ? packet_each(packet, solid, lanes)
           : solid->simple ? packet_together(packet, solid, lanes)
                           : packet_tree(packet, solid, lanes);
}

/* They have found what they look for: no shape needs to look at them. */
static void packet_close(struct packet *packet, unsigned lanes)
{
    packet->open &= ~lanes;
    for (; lanes; lanes &= lanes - 1)
        packet->span.far[__builtin_ctz(lanes)] = -(double)INFINITY;
}

bool packet_look(struct packet *packet, const struct solid *solid,
                 unsigned lanes)
{
    lanes &= packet->open;
    if (!lanes)
        return packet->open == 0;
    packet_close(packet, packet_meet(packet, solid, lanes));
    return packet->open == 0;
}

unsigned packet_meets(const struct packet *packet, const struct box3 *box)
{
    const struct rays_boxed rays = { packet->rays, packet->inverse,
                                     &packet->span };
    LANE_LINES lane_flag met[RAY_LANES];
    rays_meet_box(&rays, box, lane_run_of(packet->open), met);
    return rays_bits(met) & packet->open;
}
