/* CSG for rays side by side: see packet_tree.h. As for one ray (query.c): the
 * crossings of each leaf that are near enough are asked whether they count.
 * What a shape can't tell of several rays at a time is asked ray by ray. */
#include "world/packet_tree.h"

#include "scene/primitive.h"
#include "world/mesh_tree.h"

/* Parts of a tree that last kept crossings of their siblings from counting:
 * they are asked first, since they are likely to do so again. */
struct refusers {
    const struct solid *of[4];
};

/* On the way through one tree. */
struct tree_look {
    struct packet *packet;
    const struct solid *root;
    const struct rays *rays; /* in the root's frame, as is the inverse */
    const double (*inverse)[RAY_LANES];
    struct refusers *refusers;
};

CLONES static void find_inside_box(const struct box3 *box, struct lane_run run,
                                   const struct lane_points *restrict points,
                                   lane_flag *restrict inside)
{
    const struct box3 here = *box;
    EACH_LANE(i, run)
        inside[i] = box3_contains(here, lane_get(points->at, i)) ? -1 : 0;
}

static unsigned inside_box(const struct box3 *box, struct lane_run run,
                           const struct lane_points *points)
{
    LANE_LINES lane_flag inside[RAY_LANES];
    if (box == &solid_nothing)
        return 0;
    if (box == &solid_everything)
        return (1u << RAY_LANES) - 1;
    find_inside_box(box, run, points, inside);
    return rays_bits(inside);
}

/* One after the other. */
static unsigned leaf_inside_each(const struct solid *solid,
                                 const struct lane_points *points,
                                 unsigned lanes)
{
    const struct object *object = solid->leaf->object;
    unsigned inside = 0;
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        vec3 p = lane_get(points->at, i);
        if (solid->kind == OBJECT_SHAPE
                ? object->primitive->inside(solid->leaf->shape, p)
                : mesh_tree_inside(solid->more->tree, p))
            inside |= 1u << i;
    }
    return inside;
}

static unsigned leaf_inside(const struct solid *solid,
                            const struct lane_points *points, unsigned lanes)
{
    const struct object *object = solid->leaf->object;
    struct lane_points local;
    LANE_LINES lane_flag flags[RAY_LANES];
    const struct lane_run run = lane_run_of(lanes);
    unsigned inside;
    if (solid->moved) {
        lane_points_into(solid->to_shape, run, points, &local);
        points = &local;
    }
    if (solid->kind == OBJECT_SHAPE && object->primitive->inside_many) {
        object->primitive->inside_many(solid->leaf->shape, run, points, flags);
        inside = rays_bits(flags);
    } else {
        inside = leaf_inside_each(solid, points, lanes);
    }
    return lanes & (solid->leaf->look->inverse ? ~inside : inside);
}

static unsigned lanes_inside(const struct solid *solid,
                             const struct lane_points *points, unsigned lanes);

static unsigned inside_all(const struct solid *const *solids, size_t count,
                           const struct lane_points *points, unsigned lanes)
{
    for (size_t i = 0; i < count && lanes; i++)
        lanes = lanes_inside(solids[i], points, lanes);
    return lanes;
}

static unsigned inside_any(const struct solid *solid,
                           const struct lane_points *points, unsigned lanes)
{
    unsigned inside = 0;
    for (size_t i = 0; i < solid->child_count && lanes & ~inside; i++)
        inside |= lanes_inside(solid->children[i], points, lanes & ~inside);
    return inside;
}

static unsigned inside_content(const struct solid *solid,
                               const struct lane_points *points, unsigned lanes)
{
    struct lane_points local;
    if (solid->more->frame) {
        lane_points_into(solid->more->frame->inward, lane_run_of(lanes), points,
                         &local);
        points = &local;
    }
    if (solid->leaf)
        return leaf_inside(solid, points, lanes);
    if (solid->kind == OBJECT_INTERSECTION)
        return inside_all((const struct solid *const *)solid->children,
                          solid->child_count, points, lanes);
    return inside_any(solid, points, lanes);
}

/* Which of these points are inside: as solid_inside. */
static unsigned lanes_inside(const struct solid *solid,
                             const struct lane_points *points, unsigned lanes)
{
    const struct lane_run run = lane_run_of(lanes);
    lanes &= inside_box(solid->region, run, points);
    unsigned sure = lanes ? lanes & ~inside_box(solid->holes, run, points) : 0;
    lanes &= ~sure;
    if (lanes)
        lanes = inside_content(solid, points, lanes);
    return sure | inside_all(solid->more->clips, solid->more->clip_count,
                             points, lanes);
}

enum { REFUSERS = sizeof(struct refusers) / sizeof(struct solid *) };

static bool refusers_have(const struct refusers *refusers,
                          const struct solid *solid)
{
    for (int k = 0; k < REFUSERS; k++)
        if (refusers->of[k] == solid)
            return true;
    return false;
}

/* In front of the others, of which one is forgotten. */
static void refusers_add(struct refusers *refusers, const struct solid *solid)
{
    for (int k = REFUSERS - 1; k > 0; k--)
        refusers->of[k] = refusers->of[k - 1];
    refusers->of[0] = solid;
}

/* Where the sibling lets crossings count. */
static unsigned sibling_agrees(const struct solid *sibling,
                               const struct lane_points *points, unsigned lanes)
{
    unsigned inside = lanes_inside(sibling, points, lanes);
    bool wanted = sibling->parent->kind == OBJECT_INTERSECTION;
    return wanted ? inside : lanes & ~inside;
}

/* Where the siblings of `node` let crossings of it count; in which order they
 * are asked doesn't matter. */
static unsigned siblings_agree(const struct solid *node,
                               struct refusers *refusers,
                               const struct lane_points *points, unsigned lanes)
{
    const struct solid *parent = node->parent;
    struct refusers asked = *refusers;
    if (parent->kind == OBJECT_UNION)
        return lanes;
    for (int k = 0; k < REFUSERS && lanes; k++) {
        const struct solid *sibling = asked.of[k];
        if (sibling && sibling->parent == parent && sibling != node)
            lanes = sibling_agrees(sibling, points, lanes);
    }
    for (size_t i = 0; i < parent->child_count && lanes; i++) {
        const struct solid *sibling = parent->children[i];
        if (sibling == node || refusers_have(&asked, sibling))
            continue;
        unsigned agreed = sibling_agrees(sibling, points, lanes);
        if (agreed != lanes)
            refusers_add(refusers, sibling);
        lanes = agreed;
    }
    return lanes;
}

CLONES static void find_points(const struct rays *restrict rays,
                               struct lane_run run, const double *restrict t,
                               struct lane_points *restrict points)
{
    EACH_LANE(i, run)
        lane_put(
            points->at, (unsigned)i,
            vec3_along(rays_origin(rays, i), rays_direction(rays, i), t[i]));
}

/* Which of these crossings of the leaf count: as solid_counts. */
static unsigned crossings_count(const struct tree_look *look,
                                const struct solid *leaf, const double *t,
                                unsigned lanes)
{
    const struct lane_run run = lane_run_of(lanes);
    struct lane_points inner, outer;
    find_points(look->rays, run, t, &inner);
    if (look->root->more->frame && look->root->more->clip_count)
        find_points(look->packet->rays, run, t, &outer);
    for (const struct solid *node = leaf; node && lanes; node = node->parent) {
        const struct lane_points *points =
            node->parent || !look->root->more->frame ? &inner : &outer;
        lanes = inside_all(node->more->clips, node->more->clip_count, points,
                           lanes);
        if (node->parent)
            lanes = siblings_agree(node, look->refusers, &inner, lanes);
    }
    return lanes;
}

/* Which lanes' crossings may be wanted: see query_wants. */
CLONES static void find_near(const struct rays_span *restrict span,
                             struct lane_run run, const double *restrict t,
                             bool ties, lane_flag *restrict near)
{
    EACH_LANE(i, run) {
        double far = span->far[i];
        bool before = (t[i] < far) | (ties & (t[i] == far));
        near[i] = ((t[i] > span->near[i]) & before) ? -1 : 0;
    }
}

/* Crossings of a leaf: of which part is not told of those that are 0. */
struct leaf_met {
    const struct leaf *leaf;
    const double *t, *part;
};

static struct hit met_hit(const struct leaf_met *met, unsigned i)
{
    int part = met->part ? (int)met->part[i] : 0;
    return (struct hit){ met->t[i], part, 0, 0 };
}

static void take_nearest(struct packet *packet, const struct leaf_met *met,
                         unsigned lanes)
{
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        packet_offer(packet, i, met->leaf, met_hit(met, i));
    }
}

/* What lets light pass. Returns the rays for which it does not. */
static unsigned take_panes(struct packet *packet, const struct leaf_met *met,
                           unsigned lanes)
{
    unsigned over = 0;
    if (!packet->filter) {
        packet->panes |= packet->opaque ? 0 : lanes;
        return lanes;
    }
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        const struct world_hit hit = { met->leaf, met_hit(met, i) };
        over |= (unsigned)packet->filter(packet->context, i, &hit) << i;
    }
    return over;
}

/* Those of `lanes`, of a leaf. Returns the rays that need not look any more. */
static unsigned take_met(const struct tree_look *look, const struct solid *leaf,
                         const struct leaf_met *met, unsigned lanes)
{
    struct packet *packet = look->packet;
    if (lanes && !leaf->simple)
        lanes = crossings_count(look, leaf, met->t, lanes);
    if (packet->occlusion)
        return met->leaf->look->opaque ? lanes : take_panes(packet, met, lanes);
    take_nearest(packet, met, lanes);
    return 0;
}

/* Of a shape that tells all crossings at once. */
static unsigned look_at_shape(const struct tree_look *look,
                              const struct solid *solid, unsigned lanes)
{
    struct packet *packet = look->packet;
    const struct object *object = solid->leaf->object;
    const struct rays *rays = look->rays;
    struct rays local;
    struct rays_crossings all;
    const struct lane_run run = lane_run_of(lanes);
    unsigned over = 0;
    if (solid->moved) {
        rays_into(solid->to_shape, run, rays, &local);
        rays = &local;
    }
    object->primitive->all_many(solid->leaf->shape, run, rays, &all);
    for (int k = 0; k < all.count; k++) {
        LANE_LINES lane_flag near[RAY_LANES];
        find_near(&packet->span, run, all.t[k], !packet->occlusion, near);
        const struct leaf_met met = { solid->leaf, all.t[k], all.part[k] };
        over |= take_met(look, solid, &met, lanes & ~over & rays_bits(near));
    }
    return over;
}

struct crossings_look {
    const struct tree_look *look;
    const struct solid *solid;
    unsigned over;
};

/* Beyond the nearest that counts there is nothing to see. */
static unsigned take_round(void *context, unsigned met,
                           const double t[RAY_LANES])
{
    struct crossings_look *crossings = context;
    const struct packet *packet = crossings->look->packet;
    const struct leaf_met at = { crossings->solid->leaf, t, NULL };
    unsigned over = take_met(crossings->look, crossings->solid, &at, met);
    crossings->over |= over;
    for (unsigned each = packet->occlusion ? 0 : met; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        over |= (unsigned)(packet->span.far[i] == reach_of(t[i])) << i;
    }
    return over;
}

static struct space space_of(const struct tree_look *look,
                             const struct query *query, unsigned i)
{
    struct space space = { rays_at(look->rays, (int)i), .enter = query->tmin,
                           .leave = query->tmax };
    space.slabs.origin = space.ray.origin;
    space.slabs.inverse = lane_get(look->inverse, i);
    if (!look->root->boxed)
        slabs_clip(&query->slabs, &look->root->surface, &space.enter,
                   &space.leave);
    return space;
}

/* The parts of the rays in which crossings of a part of the tree can count. */
static void crossings_span(const struct tree_look *look,
                           const struct solid *solid, unsigned lanes,
                           struct rays_span *span)
{
    for (int i = 0; i < RAY_LANES; i++)
        span->near[i] = span->far[i] = 0;
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        const struct query *query = packet_query(look->packet, i);
        double enter = query->tmin, leave = query->tmax;
        if (!solid->simple) {
            const struct space space = space_of(look, query, i);
            enter = greater(enter, space.enter);
            leave = lesser(leave, space.leave);
            if (!solid->boxed)
                slabs_clip(&space.slabs, &solid->surface, &enter, &leave);
        }
        span->near[i] = enter;
        span->far[i] = leave;
    }
}

/* Of one that tells them in rounds. */
static unsigned look_at_crossings(const struct tree_look *look,
                                  const struct solid *solid, unsigned lanes)
{
    const struct leaf *leaf = solid->leaf;
    const struct lane_run run = lane_run_of(lanes);
    struct crossings_look crossings = { look, solid, 0 };
    const struct rays *rays = look->rays;
    struct rays local;
    struct rays_span span;
    crossings_span(look, solid, lanes, &span);
    if (solid->moved) {
        rays_into(solid->to_shape, run, rays, &local);
        rays = &local;
    }
    leaf->object->primitive->crossings_many(leaf->shape, run, rays, &span,
                                            take_round, &crossings);
    return crossings.over;
}

/* One ray after the other. */
static unsigned look_each(const struct tree_look *look,
                          const struct solid *solid, unsigned lanes)
{
    unsigned over = 0;
    for (; lanes; lanes &= lanes - 1) {
        unsigned i = (unsigned)__builtin_ctz(lanes);
        struct query *query = packet_query(look->packet, i);
        struct space space = space_of(look, query, i);
        if (query_leaf(query, solid, &space.ray, &space))
            over |= 1u << i;
        if (!look->packet->occlusion)
            packet_met(look->packet, i);
    }
    return over;
}

/* Of one that tells the nearest of each ray; where that doesn't count, the ray
 * looks by itself. */
static unsigned look_at_first(const struct tree_look *look,
                              const struct solid *solid, unsigned lanes)
{
    struct packet *packet = look->packet;
    const struct primitive *primitive = solid->leaf->object->primitive;
    const struct lane_run run = lane_run_of(lanes);
    const struct rays *rays = look->rays;
    struct rays local;
    struct rays_span span;
    struct rays_met met;
    unsigned found = 0, wanted = 0;
    crossings_span(look, solid, lanes, &span);
    if (solid->moved) {
        rays_into(solid->to_shape, run, rays, &local);
        rays = &local;
    }
    memset(met.u, 0, sizeof met.u);
    (primitive->told_many ? primitive->told_many : primitive->first_many)(
        solid->leaf->shape, run, rays, &span, &met);
    for (unsigned each = lanes; each; each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        found |= (unsigned)(met.t[i] <= span.far[i]) << i;
        wanted |= (unsigned)(met.t[i] > span.near[i]) << i;
    }
    unsigned counted = crossings_count(look, solid, met.t, found & wanted);
    for (unsigned each = packet->occlusion ? 0 : counted; each;
         each &= each - 1) {
        unsigned i = (unsigned)__builtin_ctz(each);
        packet_offer(packet, i, solid->leaf,
                     (struct hit){ met.t[i], (int)met.part[i], met.u[i], 0 });
    }
    return (packet->occlusion ? counted : 0) |
           look_each(look, solid, found & ~counted);
}

/* Which of `lanes` do not miss it: as query_gate_opens. */
static unsigned gate_open(const struct tree_look *look,
                          const struct solid *gate, unsigned lanes)
{
    bool told =
        gate->simple && gate->crosses_many && leaf_casts(gate->leaf, -1);
    unsigned open = 0;
    struct rays_span span;
    if (told) {
        for (int i = 0; i < RAY_LANES; i++) {
            span.near[i] = 0;
            span.far[i] = HUGE_VAL;
        }
        open = solid_crosses_many(gate, look->rays, &span, lanes);
    }
    for (unsigned rest = lanes & ~open; rest; rest &= rest - 1) {
        unsigned i = (unsigned)__builtin_ctz(rest);
        struct ray ray = rays_at(look->rays, (int)i);
        struct slabs slabs = { ray.origin, lane_get(look->inverse, i) };
        if (told ? solid_inside(gate, ray.origin)
                 : query_gate_opens(gate, &ray, &slabs))
            open |= 1u << i;
    }
    return open;
}

static unsigned gates_open(const struct tree_look *look,
                           const struct solid *solid, unsigned lanes)
{
    for (size_t i = 0; i < solid->more->gate_count && lanes; i++)
        lanes = gate_open(look, solid->more->gates[i], lanes);
    return lanes;
}

/* Those of `lanes` that may meet the box, which is in the look's space. */
static unsigned box_met(const struct tree_look *look, const struct box3 *box,
                        unsigned lanes)
{
    const struct rays_boxed rays = { look->rays, look->inverse,
                                     &look->packet->span };
    LANE_LINES lane_flag met[RAY_LANES];
    rays_meet_box(&rays, box, lane_run_of(lanes), met);
    return lanes & rays_bits(met);
}

static unsigned look_at_part(const struct tree_look *look,
                             const struct solid *solid, unsigned lanes);

static unsigned look_inside(const struct tree_look *look,
                            const struct solid *solid, unsigned lanes)
{
    unsigned over = 0;
    if (!solid->leaf) {
        for (size_t i = 0; i < solid->child_count && lanes & ~over; i++)
            over |= look_at_part(look, solid->children[i], lanes & ~over);
        return over;
    }
    if (!lanes || !packet_sees(look->packet, solid->leaf))
        return 0;
    if (!solid->together)
        return look_each(look, solid, lanes);
    if (solid->all_many)
        return solid->leaf->object->primitive->all_many
                   ? look_at_shape(look, solid, lanes)
                   : look_at_crossings(look, solid, lanes);
    /* Of panes all crossings are wanted. */
    return look->packet->occlusion && !solid->leaf->look->opaque
               ? look_each(look, solid, lanes)
               : look_at_first(look, solid, lanes);
}

static unsigned look_at_part(const struct tree_look *look,
                             const struct solid *solid, unsigned lanes)
{
    lanes = box_met(look, &solid->surface, lanes);
    if (lanes && solid->more->gate_count)
        lanes = gates_open(look, solid, lanes);
    return lanes ? look_inside(look, solid, lanes) : 0;
}

unsigned packet_tree(struct packet *packet, const struct solid *solid,
                     unsigned lanes)
{
    struct refusers refusers = { { NULL } };
    struct tree_look look = { packet, solid, packet->rays, packet->inverse,
                              &refusers };
    struct rays local;
    LANE_LINES double inverse[3][RAY_LANES];
    lanes = box_met(&look, &solid->surface, lanes);
    if (lanes && solid->more->gate_count)
        lanes = gates_open(&look, solid, lanes);
    if (!lanes)
        return 0;
    if (solid->more->frame) {
        const struct lane_run run = lane_run_of(lanes);
        rays_into(solid->more->frame->inward, run, packet->rays, &local);
        rays_inverse(&local, run, inverse);
        look.rays = &local;
        look.inverse = (const double(*)[RAY_LANES])inverse;
        lanes = box_met(&look, solid->more->inner, lanes);
    }
    return look_inside(&look, solid, lanes);
}

unsigned packet_shape(struct packet *packet, const struct solid *solid,
                      unsigned lanes)
{
    struct refusers none = { { NULL } };
    const struct tree_look look = { packet, solid, packet->rays, NULL, &none };
    return look_inside(&look, solid, lanes);
}
