/* See near_glow.h. */
#include "lightmesh/near_glow.h"

#include "base/array.h"
#include "base/draw.h"
#include "base/smooth.h"
#include "base/warp.h"
#include "lightmesh/gather_glow.h"
#include "lightmesh/gather_rays.h"
#include "lightmesh/lattice.h"
#include "lightmesh/near_field.h"
#include "lightmesh/tuning.h"
#include "scene/box_tree.h"
#include "scene/mesh.h"
#include "scene/primitive.h"
#include "world/solid.h"

/* A leaf that glows. */
struct near_leaf {
    const struct emitter_share *share;
    struct box3 box; /* in the world */
    double reach;    /* up to where places find it */
};

struct near_glow {
    struct arena *arena;
    const struct emitters *emitters;
    size_t count;
    struct near_leaf *leaves;
    const struct box_tree *tree; /* of all from where they are in reach */
    uint32_t *number;            /* by that of the leaf, from 1 on; 0: none */
    struct near_ways ways;
};

/* A place that looks for it. */
struct asking {
    const struct near_glow *near;
    const struct gather *gather;
    struct worker *worker;
    vec3 place, side;
    struct near_list {
        const struct near_leaf **items;
        size_t count, capacity;
    } leaves; /* in reach, in the worker's scratch, */
    struct near_sums {
        double *items;
        size_t count, capacity;
    } sums;       /* and of how often each and those before are picked */
    double sum;   /* of all */
    double reach; /* the longest */
    bool around;  /* whether rays go all around as well */
    struct indirect_light *light;
    rgb *arriving;
};

static struct box3 leaf_box(const struct leaf *leaf)
{
    const struct object *object = leaf->object;
    struct box3 box = object->kind == OBJECT_MESH
                          ? object->mesh->bounds
                          : object->primitive->bounds(leaf->shape);
    return affine_box(leaf->pose->outward, box);
}

/* What is much larger than that both ways, as a lava field or a ceiling that
 * glows, gives neighbours nearly the same: points know it. */
static bool box_is_near(struct box3 box, double reach)
{
    const vec3 size = vec3_sub(box.high, box.low);
    const double wide = near_glow_wide * reach;
    return (size.x > wide) + (size.y > wide) + (size.z > wide) < 2;
}

/* Fills `boxes` with those in which the leaves are in reach. */
static void near_glow_fill(struct near_glow *near,
                           const struct lattice *lattice,
                           const struct lattice_view *view, struct box3 *boxes)
{
    const struct emitter_share *shares;
    const size_t count = emitters_shares(near->emitters, &shares);
    for (size_t i = 0; i < count; i++) {
        struct box3 box = leaf_box(shares[i].leaf);
        if (!box3_is_finite(box) || box3_is_empty(box) ||
            near_is_dear(shares[i].leaf))
            continue;
        vec3 middle = vec3_scale(vec3_add(box.low, box.high), 0.5);
        double reach =
            near_glow_reach * lattice_spacing_at(lattice, view, middle);
        if (!box_is_near(box, reach))
            continue;
        boxes[near->count] = box3_grown(box, reach);
        near->leaves[near->count++] =
            (struct near_leaf){ &shares[i], box, reach };
        near->number[shares[i].leaf->number] = (uint32_t)near->count;
    }
}

struct near_glow *near_glow_new(const struct world *world,
                                const struct emitters *emitters,
                                const struct lattice *lattice,
                                const struct lattice_view *view)
{
    const struct emitter_share *shares;
    const size_t count = emitters ? emitters_shares(emitters, &shares) : 0;
    if (count == 0)
        return NULL;
    struct arena *arena = arena_new(0);
    struct near_glow *near = ARENA_NEW(arena, struct near_glow);
    near->arena = arena;
    near->emitters = emitters;
    near->leaves = ARENA_ARRAY(arena, struct near_leaf, count);
    near->number = ARENA_ARRAY(arena, uint32_t, world_leaf_count(world) + 1);
    struct box3 *boxes = ARENA_ARRAY(arena, struct box3, count);
    near_glow_fill(near, lattice, view, boxes);
    near->tree = box_tree_new(arena, boxes, near->count);
    near->ways = near_ways_new(NEAR_GLOW_RAYS);
    return near;
}

void near_glow_free(struct near_glow *near)
{
    if (!near)
        return;
    near_ways_free(&near->ways);
    arena_free(near->arena);
}

double near_glow_share(const struct near_glow *near, const struct leaf *leaf,
                       double distance)
{
    if (!near || !near->number[leaf->number])
        return 0;
    const double reach = near->leaves[near->number[leaf->number] - 1].reach;
    return fade_out(distance / reach, near_glow_whole);
}

/* How often a leaf is picked that is so far off, squared: by what it may give.
 */
static double leaf_odds(const struct near_leaf *leaf, double apart2)
{
    double least = near_glow_whole * leaf->reach;
    return leaf->share->share / fmax(apart2, least * least);
}

static bool asking_take(void *context, size_t item)
{
    struct asking *asking = context;
    const struct near_leaf *leaf = &asking->near->leaves[item];
    const double apart2 = box3_distance2(leaf->box, asking->place);
    if (apart2 >= leaf->reach * leaf->reach)
        return false;
    asking->sum += leaf_odds(leaf, apart2);
    asking->reach = fmax(asking->reach, leaf->reach);
    *ARRAY_PUSH(asking->worker->scratch, &asking->leaves) = leaf;
    *ARRAY_PUSH(asking->worker->scratch, &asking->sums) = asking->sum;
    return false;
}

/* How densely one ray all around, if there is one, and one to a point picked
 * look there. */
static double asking_density(const struct asking *asking, vec3 way,
                             const struct intersection *at)
{
    const struct near_glow *near = asking->near;
    const struct near_leaf *leaf =
        &near->leaves[near->number[at->leaf->number] - 1];
    double density = asking->around ? vec3_dot(way, asking->side) / WARP_PI : 0;
    double odds = leaf_odds(leaf, box3_distance2(leaf->box, asking->place));
    return density +
           odds / asking->sum / leaf->share->share *
               emitters_density(near->emitters, asking->place, way, at);
}

/* What is met, if it glows within its reach. */
static void asking_add(struct asking *asking, const struct ray *ray,
                       const struct intersection *at)
{
    double cosine = vec3_dot(ray->direction, asking->side);
    double share = near_glow_share(asking->near, at->leaf, at->t);
    if (!(cosine > 0) || share == 0)
        return;
    double density = asking_density(asking, ray->direction, at);
    rgb glow = rgb_scale(gather_glow_at(asking->gather, ray, at), share);
    if (!(density > 0) || !isfinite(density) || rgb_peak(glow) == 0)
        return;
    indirect_light_add(asking->light, ray->direction, glow, 0, density);
    *asking->arriving =
        rgb_add_scaled(*asking->arriving, glow, cosine / (WARP_PI * density));
}

/* A packet of rays all around. Returns whether any finds something. */
static bool asking_look_around(struct asking *asking, int first)
{
    _Static_assert(NEAR_GLOW_RAYS % RAY_LANES == 0, "whole packets");
    const struct draws none = { 0, 0 };
    struct gather_rays sent;
    sent.count = 0;
    for (int i = first; i < first + RAY_LANES; i++)
        gather_rays_add(&sent, &none, asking->place,
                        warp_turned(asking->near->ways.ways[i], asking->side));
    gather_rays_meet(asking->gather, asking->worker, asking->reach, &sent);
    const rgb before = *asking->arriving;
    for (unsigned i = 0; i < sent.count; i++) {
        const struct ray ray = rays_at(&sent.rays, (int)i);
        if (sent.found[i].at.leaf)
            asking_add(asking, &ray, &sent.found[i].at);
    }
    return rgb_peak(rgb_sub(*asking->arriving, before)) > 0;
}

/* In base 2, of van der Corput. */
static double radical_inverse(unsigned i)
{
    double sum = 0;
    for (double part = 0.5; i > 0; i /= 2, part /= 2)
        sum += i % 2 ? part : 0;
    return sum;
}

/* However many there are they lie evenly from one end to the other of all in
 * reach, and on the surface. */
static bool asking_pick(const struct asking *asking, int i,
                        struct emitter_pick *pick)
{
    double u[2] = { 0, 0 };
    draw_further(i + 1, &u[0], &u[1]);
    double which = radical_inverse((unsigned)i), part;
    size_t number =
        draw_share(asking->sums.items, asking->sums.count, which, &part);
    const struct emitter_share *share = asking->leaves.items[number]->share;
    double before = number > 0 ? asking->sums.items[number - 1] : 0;
    double within = (which * asking->sum - before) / (part * asking->sum);
    which = share->from + within * share->share;
    return emitters_pick(asking->near->emitters, asking->place, which, u,
                         pick) &&
           pick->leaf == share->leaf &&
           vec3_dot(pick->direction, asking->side) > 0;
}

/* And of rays to points, up to a packet. */
static void asking_look_there(struct asking *asking, int first, int count)
{
    const struct draws none = { 0, 0 };
    struct emitter_pick picks[RAY_LANES];
    struct gather_rays sent;
    sent.count = 0;
    for (int i = first; i < first + count; i++)
        if (asking_pick(asking, i, &picks[sent.count]))
            gather_rays_add(&sent, &none, asking->place,
                            picks[sent.count].direction);
    if (sent.count == 0)
        return;
    gather_rays_meet(asking->gather, asking->worker, asking->reach, &sent);
    for (unsigned i = 0; i < sent.count; i++) {
        const struct ray ray = rays_at(&sent.rays, (int)i);
        if (emitter_is_met(&picks[i], &sent.found[i].at))
            asking_add(asking, &ray, &sent.found[i].at);
    }
}

static void asking_mean(struct asking *asking, int sent)
{
    indirect_light_scale(asking->light, 1 / (float)sent);
    *asking->arriving = rgb_scale(*asking->arriving, 1.0 / sent);
}

/* As many as it takes: most where it is most of the light. What is so small
 * that none of the first all around finds it is left to those that are picked.
 */
static void asking_look(struct asking *asking, double beside)
{
    int sent = 0;
    while (sent < NEAR_GLOW_RAYS) {
        bool found = asking->around && asking_look_around(asking, sent);
        asking_look_there(asking, sent, RAY_LANES);
        asking->around = found;
        sent += RAY_LANES;
        if (rgb_brightness(*asking->arriving) <=
            near_glow_little * beside * sent)
            break;
    }
    asking_mean(asking, sent);
}

/* Few, of what is worth little. The most that rays all around would find is
 * left out: that next to what glows. */
static void asking_glance(struct asking *asking, double worth)
{
    int few = (int)(RAY_LANES * worth / near_glow_worth);
    if (few < NEAR_GLOW_FEW)
        few = NEAR_GLOW_FEW;
    asking_look_there(asking, 0, few);
    asking_mean(asking, few);
}

bool near_glow_find(const struct near_glow *near, const struct gather *gather,
                    struct worker *worker, const struct near_place *place,
                    struct indirect_light *light, rgb *arriving)
{
    if (!near)
        return false;
    struct asking asking = { .near = near,
                             .gather = gather,
                             .worker = worker,
                             .place = place->point,
                             .side = place->side,
                             .around = true,
                             .light = light,
                             .arriving = arriving };
    const struct box3 here = { place->point, place->point };
    box_tree_box(near->tree, here, asking_take, &asking);
    if (asking.leaves.count == 0)
        return false;
    *light = indirect_light_none;
    *arriving = rgb_grey(0);
    if (place->worth < near_glow_worth)
        asking_glance(&asking, place->worth);
    else
        asking_look(&asking, rgb_brightness(place->beside));
    return true;
}
