/* A ray meets leaves and solids: see query.h. */
#include "world/query.h"

#include "world/mesh_tree.h"
#include "scene/mesh.h"
#include "scene/primitive.h"

bool query_block(struct query *query, const struct leaf *leaf,
                 const struct hit *hit)
{
    const struct world_hit crossing = { leaf, *hit };
    query->blocked = leaf->look->opaque || !query->filter ||
                     query->filter(query->context, &query->ray, &crossing);
    return query->blocked;
}

/* The tree the leaf is a part of; those at the top are taken apart if they are
 * unions. */
static const struct solid *leaf_root(const struct leaf *leaf)
{
    const struct solid *solid = leaf->solid;
    while (solid && solid->parent)
        solid = solid->parent;
    return solid;
}

/* Whether both are of one tree, or of unions taken apart that have a clip in
 * common. */
static bool leaves_are_cut_together(const struct leaf *a, const struct leaf *b)
{
    const struct solid *one = leaf_root(a), *other = leaf_root(b);
    if (!one || !other || one == other)
        return one && one == other;
    for (size_t i = 0; i < one->more->clip_count; i++)
        for (size_t k = 0; k < other->more->clip_count; k++)
            if (one->more->clips[i] == other->more->clips[k])
                return true;
    return false;
}

static bool leaf_is_endless(const struct leaf *leaf)
{
    const struct solid *root = leaf_root(leaf);
    return root && !solid_is_bounded(root);
}

/* Of two crossings at the same place that of a plane is seen, or of another
 * thing without end; else that of the earlier leaf, but in an intersection, a
 * merge or a clipped union that of the later (measured), whatever the order
 * they are found in. */
static bool tie_is_won(const struct leaf *leaf, const struct leaf *other)
{
    if (leaves_are_cut_together(leaf, other))
        return leaf->number > other->number;
    bool endless = leaf_is_endless(leaf);
    return endless == leaf_is_endless(other) ? leaf->number < other->number
                                             : endless;
}

bool query_wants(const struct query *query, const struct leaf *leaf, double t)
{
    if (!(t > query->tmin))
        return false;
    return t < query->tmax ||
           (t == query->tmax && query->leaf && tie_is_won(leaf, query->leaf));
}

static bool query_counts(const struct query *query, const struct solid *solid,
                         const struct ray *ray, const struct hit *hit)
{
    return query_wants(query, solid->leaf, hit->t) &&
           (solid->simple || solid_counts(solid, ray_point(ray, hit->t),
                                          ray_point(&query->ray, hit->t)));
}

static bool take_if_counts(struct query *query, const struct solid *solid,
                           const struct ray *ray, const struct hit *hit)
{
    return query_counts(query, solid, ray, hit) &&
           query_take(query, solid->leaf, hit);
}

/* Whether any crossing blocks the ray, so that it need not be known which. */
static bool query_is_plain(const struct query *query, const struct solid *solid)
{
    return query->occlusion && solid->simple &&
           (solid->leaf->look->opaque || !query->filter);
}

static bool query_is_rough(const struct query *query,
                           const struct primitive *primitive)
{
    return query->spread > 0 && primitive->first_roughly;
}

/* The first crossing of a simple shape. */
static bool query_first(const struct query *query, const struct solid *solid,
                        struct hit *hit)
{
    const struct primitive *primitive = solid->leaf->object->primitive;
    const void *shape = solid->leaf->shape;
    const struct ray *ray = &query->ray;
    struct ray local;
    if (solid->moved) {
        local = ray_into(solid->to_shape, ray);
        ray = &local;
    }
    return query_is_rough(query, primitive)
               ? primitive->first_roughly(shape, ray, query->tmin,
                                          query_reach(query), query->spread,
                                          hit)
               : primitive->first(shape, ray, query->tmin, query_reach(query),
                                  hit);
}

/* Whether there is any. */
static bool query_crosses(const struct query *query, const struct solid *solid)
{
    return query_is_rough(query, solid->leaf->object->primitive)
               ? query_first(query, solid, NULL)
               : solid_crosses(solid, &query->ray, query->tmin, query->tmax);
}

struct crossing_query {
    struct query *query;
    const struct solid *solid;
    const struct ray *ray;
};

static bool take_crossing(void *context, const struct hit *hit)
{
    struct crossing_query *crossing = context;
    return take_if_counts(crossing->query, crossing->solid, crossing->ray, hit);
}

/* By increasing t: beyond the nearest that counts there is nothing to see. */
static bool take_next(void *context, const struct hit *hit)
{
    struct crossing_query *crossing = context;
    struct query *query = crossing->query;
    return take_crossing(context, hit) ||
           (!query->occlusion && query->tmax == hit->t);
}

/* Of a shape that tells them one by one; `inner` is the ray in its space. Of a
 * part, crossings outside its box and the tree's don't count, if these are
 * boxes of the surface. */
static bool query_crossings(struct query *query, const struct solid *solid,
                            const struct ray *ray, const struct ray *inner,
                            const struct space *space)
{
    const struct object *object = solid->leaf->object;
    struct crossing_query context = { query, solid, ray };
    double enter = query->tmin, leave = query->tmax;
    if (space) {
        enter = greater(enter, space->enter);
        leave = lesser(leave, space->leave);
        if (!solid->boxed)
            slabs_clip(&space->slabs, &solid->surface, &enter, &leave);
    }
    object->primitive->crossings(solid->leaf->shape, inner, enter, leave,
                                 take_next, &context);
    return query->blocked;
}

/* So often at most, lest by rounding a ray sets out from one place for ever. */
enum { ANEW_MOST = 1000 };

/* Light through panes that tell some of their crossings only: as in POV-Ray the
 * ray sets out anew from each that counts (measured). */
static bool query_anew(struct query *query, const struct solid *solid,
                       const struct ray *ray, const struct ray *inner)
{
    struct ray onward = *inner;
    double gone = 0;
    for (int round = 0; round < ANEW_MOST; round++) {
        struct hits hits;
        int i = 0;
        hits.count = 0;
        solid->leaf->object->primitive->intersect(solid->leaf->shape, &onward,
                                                  &hits);
        for (; i < hits.count; i++) {
            hits.at[i].t += gone;
            if (query_counts(query, solid, ray, &hits.at[i]))
                break;
        }
        if (i == hits.count)
            return false;
        gone = hits.at[i].t;
        if (query_take(query, solid->leaf, &hits.at[i]))
            return true;
        onward.origin = ray_point(inner, gone);
    }
    return false;
}

static bool query_shape(struct query *query, const struct solid *solid,
                        const struct ray *ray, const struct space *space)
{
    const struct object *object = solid->leaf->object;
    const struct primitive *primitive = object->primitive;
    const struct ray *inner = ray;
    struct ray local;
    struct hits hits;
    hits.count = 0;
    if (solid->moved) {
        local = ray_into(solid->to_shape, ray);
        inner = &local;
    }
    if (primitive->crossings)
        return query_crossings(query, solid, ray, inner, space);
    if (primitive->some && query->occlusion && query->filter &&
        !solid->leaf->look->opaque)
        return query_anew(query, solid, ray, inner);
    primitive->intersect(solid->leaf->shape, inner, &hits);
    for (int i = 0; i < hits.count; i++)
        if (take_if_counts(query, solid, ray, &hits.at[i]))
            return true;
    return false;
}

static bool query_mesh(struct query *query, const struct solid *solid,
                       const struct ray *ray)
{
    struct crossing_query context = { query, solid, ray };
    struct ray local = ray_into(solid->to_shape, ray);
    mesh_tree_crossings(solid->more->tree, &local, query->tmin, query->tmax,
                        take_crossing, &context);
    return query->blocked;
}

bool query_leaf(struct query *query, const struct solid *solid,
                const struct ray *ray, const struct space *space)
{
    return query_sees(query, solid->leaf) &&
           (solid->kind == OBJECT_SHAPE ? query_shape(query, solid, ray, space)
                                        : query_mesh(query, solid, ray));
}

bool query_gate_opens(const struct solid *gate, const struct ray *ray,
                      const struct slabs *slabs)
{
    struct query probe;
    probe.ray = *ray;
    probe.slabs = *slabs;
    probe.tmin = 0;
    probe.tmax = HUGE_VAL;
    probe.occlusion = true;
    probe.spread = 0;
    probe.light = -1;
    probe.filter = NULL;
    probe.leaf = NULL;
    probe.blocked = false;
    return query_solid(&probe, gate) || solid_inside(gate, ray->origin);
}

static bool query_gates_open(const struct solid *solid, const struct ray *ray,
                             const struct slabs *slabs)
{
    for (size_t i = 0; i < solid->more->gate_count; i++)
        if (!query_gate_opens(solid->more->gates[i], ray, slabs))
            return false;
    return true;
}

static bool query_part(struct query *query, const struct solid *solid,
                       const struct space *space)
{
    if (!slabs_hit(&space->slabs, &solid->surface, query->tmin, query->tmax))
        return false;
    if (solid->more->gate_count &&
        !query_gates_open(solid, &space->ray, &space->slabs))
        return false;
    if (solid->leaf)
        return query_leaf(query, solid, &space->ray, space);
    for (size_t i = 0; i < solid->child_count; i++)
        if (query_part(query, solid->children[i], space))
            return true;
    return false;
}

/* Of most rays at most shapes: the first crossing, or whether there is any. One
 * as far as what is known by now may win the tie. */
bool query_simple(struct query *query, const struct solid *solid)
{
    const struct object *object = solid->leaf->object;
    const struct primitive *primitive = object->primitive;
    struct hit hit;
    if (!query_sees(query, solid->leaf))
        return false;
    if (solid->kind == OBJECT_SHAPE && query_is_plain(query, solid))
        return query->blocked = query_crosses(query, solid);
    if (solid->kind != OBJECT_SHAPE || query->occlusion || !primitive->first)
        return query_leaf(query, solid, &query->ray, NULL);
    return query_first(query, solid, &hit) &&
           query_wants(query, solid->leaf, hit.t) &&
           query_take(query, solid->leaf, &hit);
}

bool query_tree(struct query *query, const struct solid *solid)
{
    double enter = query->tmin, leave = query->tmax;
    slabs_clip(&query->slabs, &solid->surface, &enter, &leave);
    if (!slabs_overlap(enter, leave))
        return false;
    if (solid->more->gate_count &&
        !query_gates_open(solid, &query->ray, &query->slabs))
        return false;
    struct space space = { query->ray, query->slabs, enter, leave };
    if (solid->boxed) {
        space.enter = query->tmin;
        space.leave = query->tmax;
    }
    if (solid->more->frame) {
        space.ray = ray_into(solid->more->frame->inward, &query->ray);
        space.slabs = slabs_of(&space.ray);
        if (!slabs_hit(&space.slabs, solid->more->inner, query->tmin,
                       query->tmax))
            return false;
    }
    if (solid->leaf)
        return query_leaf(query, solid, &space.ray, &space);
    for (size_t i = 0; i < solid->child_count; i++)
        if (query_part(query, solid->children[i], &space))
            return true;
    return false;
}

bool query_triangle(const struct query *query, const struct leaf *leaf,
                    uint32_t triangle, double *t)
{
    const struct mesh *mesh = leaf->object->mesh;
    if (leaf_is_moved(leaf)) {
        struct ray ray = ray_into(leaf->pose->inward, &query->ray);
        *t = mesh_distance(mesh, triangle, &ray);
    } else {
        *t = mesh_distance(mesh, triangle, &query->ray);
    }
    return query_wants(query, leaf, *t);
}

/* Only smooth triangles need more than t. */
void query_refine(const struct ray *ray, const struct leaf *leaf,
                  struct hit *hit)
{
    const struct mesh *mesh = leaf->object->mesh;
    if (leaf->object->kind != OBJECT_MESH ||
        mesh->triangles[hit->part].normal[0] == MESH_NONE)
        return;
    struct ray there =
        leaf_is_moved(leaf) ? ray_into(leaf->pose->inward, ray) : *ray;
    mesh_refine(mesh, (size_t)hit->part, &there, hit);
}

void query_finish(struct query *query)
{
    if (query->rough)
        query_refine(&query->ray, query->leaf, &query->hit);
    query->rough = false;
}

bool query_take_triangle(struct query *query, const struct leaf *leaf,
                         uint32_t triangle, double t)
{
    struct hit hit = { t, (int)triangle, 0, 0 };
    if (query->occlusion && !leaf->look->opaque) {
        for (unsigned i = 0; i < query->recent_count && i < QUERY_RECENT; i++)
            if (query->recent[i].leaf == leaf &&
                fabs(query->recent[i].t - t) <= 1e-9 * (1 + t))
                return false;
        query->recent[query->recent_count % QUERY_RECENT].leaf = leaf;
        query->recent[query->recent_count++ % QUERY_RECENT].t = t;
    }
    bool over = query_take(query, leaf, &hit);
    query->rough = true;
    return over;
}
