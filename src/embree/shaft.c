/* Shafts against a tree of boxes: see shaft.h. */
#include "embree/shaft.h"

#include <stdlib.h>

#include "embree/slab.h"
#include "scene/mesh.h"
#include "scene/primitive.h"

/* Something with a box; without a solid it is a mesh. */
struct shaft_item {
    struct box3 box;
    const struct solid *solid;
    double key; /* they are sorted by it */
};

/* So many items are parted by trying all places, unless there are very many,
 * for that takes its time; of too many there is no tree. */
enum { SWEEP_MOST = 128, SWEEP_WORTH = 4000, TREE_MOST = 20000 };

/* In the order in which they are visited: the first child follows. */
struct shaft_node {
    struct box3 box;
    size_t next; /* node to go on with if the box is missed */
    bool leaf;
    const struct solid *solid; /* of a leaf */
};

struct shaft_tree {
    struct shaft_item *items; /* bounded ones, by code */
    struct shaft_node *nodes;
    size_t item_count, node_count;
    struct shaft_item *endless; /* boxes that are not bounded */
    size_t endless_count;
};

/* A half space that holds all rays of a shaft: normal . p <= limit. */
struct shaft_side {
    vec3 normal;
    double limit;
};

enum { SHAFT_SIDES = 4 };

struct shaft_bounds {
    struct box3 box;
    struct shaft_side sides[SHAFT_SIDES];
    int count;
    double doubt; /* how far rounding may have moved them */
};

/* What of a point, times a vector from where the rays begin, gives its depth,
 * 1 in the plane of the parallelogram, and, times depth, its coordinates
 * there. */
struct shaft_view {
    vec3 from, depth, across[2];
    double shift[2];
    bool flat; /* the rays are all in one plane */
};

/* Nearer things are taken to be everywhere. */
static const double least_depth = 1e-4;

/* Rays that leave a surface at less of an angle may meet it again. */
static const double least_rise = 1e-3;

/* For what rounding may do to coordinates. */
static const double place_margin = 1e-7;

static uint32_t spread_bits(uint32_t x)
{
    x = (x | x << 16) & 0x030000ff;
    x = (x | x << 8) & 0x0300f00f;
    x = (x | x << 4) & 0x030c30c3;
    return (x | x << 2) & 0x09249249;
}

/* Of the place of a value between two others, ten bits apart from each other.
 */
static uint32_t place_bits(double low, double high, double value)
{
    double place = high > low ? (value - low) / (high - low) : 0;
    return spread_bits((uint32_t)(fmin(fmax(place, 0), 1) * 1023));
}

static vec3 item_middle(const struct shaft_item *item)
{
    return vec3_scale(vec3_add(item->box.low, item->box.high), 0.5);
}

static int item_order(const void *a, const void *b)
{
    const struct shaft_item *x = a, *y = b;
    return (x->key > y->key) - (x->key < y->key);
}

static void items_sort(struct shaft_item *items, size_t count)
{
    qsort(items, count, sizeof *items, item_order);
}

/* Along a space-filling curve (Lauterbach et al. 2009). */
static void items_sort_along_curve(struct shaft_tree *tree)
{
    struct box3 all = box3_empty();
    for (size_t i = 0; i < tree->item_count; i++)
        all = box3_union(all, tree->items[i].box);
    for (size_t i = 0; i < tree->item_count; i++) {
        vec3 middle = item_middle(&tree->items[i]);
        tree->items[i].key = place_bits(all.low.x, all.high.x, middle.x) |
                             place_bits(all.low.y, all.high.y, middle.y) << 1 |
                             place_bits(all.low.z, all.high.z, middle.z) << 2;
    }
    items_sort(tree->items, tree->item_count);
}

static void items_sort_along_axis(struct shaft_item *items, size_t count,
                                  int axis)
{
    for (size_t i = 0; i < count; i++)
        items[i].key = vec3_component(item_middle(&items[i]), axis);
    items_sort(items, count);
}

/* Sorts them along the axis, and returns how many of the first make the best
 * first half: boxes are met the more often the larger they are (surface area
 * heuristic). *cost is what that is worth, the less the better. */
static size_t items_halve(struct shaft_item *items, size_t count, int axis,
                          double *cost)
{
    double before[SWEEP_MOST];
    struct box3 box = box3_empty();
    size_t best = count / 2;
    items_sort_along_axis(items, count, axis);
    for (size_t i = 0; i < count; i++) {
        before[i] = box3_half_area(box) * (double)i;
        box = box3_union(box, items[i].box);
    }
    *cost = HUGE_VAL;
    box = box3_empty();
    for (size_t i = count - 1; i > 0; i--) {
        box = box3_union(box, items[i].box);
        double sum = before[i] + box3_half_area(box) * (double)(count - i);
        if (sum < *cost) {
            *cost = sum;
            best = i;
        }
    }
    return best;
}

static size_t items_split(const struct shaft_tree *tree,
                          struct shaft_item *items, size_t count)
{
    double cost, least = HUGE_VAL;
    int best = 0;
    if (count > SWEEP_MOST || tree->item_count > SWEEP_WORTH)
        return count / 2;
    for (int axis = 0; axis < 3; axis++) {
        items_halve(items, count, axis, &cost);
        best = cost < least ? axis : best;
        least = fmin(cost, least);
    }
    return items_halve(items, count, best, &cost);
}

static struct box3 build_nodes(struct shaft_tree *tree, size_t first,
                               size_t count)
{
    struct shaft_node *node = &tree->nodes[tree->node_count++];
    if (count == 1) {
        node->leaf = true;
        node->solid = tree->items[first].solid;
        node->box = tree->items[first].box;
    } else {
        size_t half = items_split(tree, &tree->items[first], count);
        struct box3 a = build_nodes(tree, first, half);
        struct box3 b = build_nodes(tree, first + half, count - half);
        node->box = box3_union(a, b);
    }
    node->next = tree->node_count;
    return node->box;
}

static void tree_add(struct shaft_tree *tree, struct box3 box,
                     const struct solid *solid)
{
    struct shaft_item item = { .box = box, .solid = solid };
    if (box3_is_empty(box) || (solid && solid->leaf && solid->leaf->no_shadow))
        return;
    if (box3_is_finite(box))
        tree->items[tree->item_count++] = item;
    else
        tree->endless[tree->endless_count++] = item;
}

static void tree_add_solids(struct shaft_tree *tree,
                            const struct solid_list *list)
{
    for (size_t i = 0; i < list->count; i++)
        tree_add(tree, list->items[i]->surface, list->items[i]);
}

struct shaft_tree *shaft_tree_new(struct flat *flat,
                                  const struct solid_list *bounded)
{
    struct arena *arena = flat->arena;
    size_t room = flat->solids.count + bounded->count + flat->meshes.count;
    if (room > TREE_MOST)
        return NULL;
    struct shaft_tree *tree = ARENA_NEW(arena, struct shaft_tree);
    tree->items = ARENA_ARRAY(arena, struct shaft_item, room);
    tree->endless = ARENA_ARRAY(arena, struct shaft_item, room);
    tree->nodes = ARENA_ARRAY(arena, struct shaft_node, 2 * room);
    tree_add_solids(tree, &flat->solids);
    tree_add_solids(tree, bounded);
    for (size_t i = 0; i < flat->meshes.count; i++) {
        const struct leaf *leaf = flat->meshes.items[i];
        if (!leaf->no_shadow)
            tree_add(tree,
                     solid_padded(affine_box(&leaf->to_world,
                                             leaf->object->mesh->bounds)),
                     NULL);
    }
    items_sort_along_curve(tree);
    if (tree->item_count > 0)
        build_nodes(tree, 0, tree->item_count);
    return tree;
}

/* The largest of three, without their signs. */
static double most_of(vec3 v)
{
    return slab_max(fabs(v.x), slab_max(fabs(v.y), fabs(v.z)));
}

/* Adds the side through the point the rays begin at, across a normal of any
 * length, on which `inner`, an offset, is. None if that is too near to say. */
static void bounds_add(struct shaft_bounds *bounds, vec3 from, vec3 normal,
                       vec3 inner)
{
    double depth = vec3_dot(inner, normal);
    double doubt = bounds->doubt * most_of(normal);
    if (!(fabs(depth) > doubt))
        return;
    vec3 out = depth > 0 ? vec3_negate(normal) : normal;
    bounds->sides[bounds->count++] =
        (struct shaft_side){ out, vec3_dot(out, from) + doubt };
}

/* From where the rays begin to see, at least, and at most: where all corners
 * are on one side, all rays go that way, by no less than the least corner's
 * distance over the longest. */
static void bounds_near(struct shaft_bounds *bounds,
                        const struct shaft_rays *rays, struct box3 edges,
                        double square)
{
    double share = rays->tmin / sqrt(square);
    double t = rays->tmin;
    vec3 low = edges.low, high = edges.high;
    low = vec3_make(low.x > 0 ? low.x * share : -t,
                    low.y > 0 ? low.y * share : -t,
                    low.z > 0 ? low.z * share : -t);
    high = vec3_make(high.x < 0 ? high.x * share : t,
                     high.y < 0 ? high.y * share : t,
                     high.z < 0 ? high.z * share : t);
    low = vec3_make(slab_min(low.x, edges.low.x), slab_min(low.y, edges.low.y),
                    slab_min(low.z, edges.low.z));
    high = vec3_make(slab_max(high.x, edges.high.x),
                     slab_max(high.y, edges.high.y),
                     slab_max(high.z, edges.high.z));
    bounds->box.low = vec3_add(rays->from, low);
    bounds->box.high = vec3_add(rays->from, high);
}

static struct box3 box_hold(struct box3 box, vec3 p)
{
    return (struct box3){
        { slab_min(box.low.x, p.x), slab_min(box.low.y, p.y),
          slab_min(box.low.z, p.z) },
        { slab_max(box.high.x, p.x), slab_max(box.high.y, p.y),
          slab_max(box.high.z, p.z) },
    };
}

static struct shaft_bounds shaft_bounds(const struct shaft_rays *rays)
{
    struct shaft_bounds bounds;
    const vec3 *half = rays->half;
    vec3 way = vec3_sub(rays->middle, rays->from);
    vec3 sum = vec3_add(half[0], half[1]), odds = vec3_sub(half[0], half[1]);
    vec3 edge[4] = { vec3_sub(way, sum), vec3_add(way, odds),
                     vec3_add(way, sum), vec3_sub(way, odds) };
    struct box3 edges = { edge[0], edge[0] };
    double square = 0;
    for (int i = 0; i < 4; i++) {
        edges = box_hold(edges, edge[i]);
        square = slab_max(square, vec3_dot(edge[i], edge[i]));
    }
    bounds_near(&bounds, rays, edges, square);
    bounds.doubt =
        1e-9 * slab_max(most_of(bounds.box.low), most_of(bounds.box.high));
    bounds.count = 0;
    for (int i = 0; i < 4; i++)
        bounds_add(&bounds, rays->from, vec3_cross(edge[i], edge[(i + 1) % 4]),
                   way);
    return bounds;
}

static struct shaft_view shaft_view(const struct shaft_rays *rays)
{
    vec3 way = vec3_sub(rays->middle, rays->from);
    vec3 normal = vec3_cross(rays->half[0], rays->half[1]);
    double square = vec3_dot(normal, normal), depth = vec3_dot(normal, way);
    struct shaft_view view = { .from = rays->from, .flat = true };
    if (!(fabs(depth) > least_depth * sqrt(square) * vec3_length(way)))
        return view;
    view.flat = false;
    view.depth = vec3_scale(normal, 1 / depth);
    view.across[0] = vec3_scale(vec3_cross(rays->half[1], normal), 1 / square);
    view.across[1] = vec3_scale(vec3_cross(normal, rays->half[0]), 1 / square);
    for (int k = 0; k < 2; k++)
        view.shift[k] = vec3_dot(view.across[k], way);
    return view;
}

/* Where the rays go that meet the box, within the shaft's own. */
static void view_place(const struct shaft_view *view, const struct box3 *own,
                       const struct box3 *box, struct shaft_solid *out)
{
    vec3 side[2] = {
        vec3_sub(vec3_max(own->low, box->low), view->from),
        vec3_sub(vec3_min(own->high, box->high), view->from),
    };
    for (int k = 0; k < 2; k++) {
        out->low[k] = HUGE_VAL;
        out->high[k] = -HUGE_VAL;
    }
    bool near = view->flat;
    for (int i = 0; i < 8 && !near; i++) {
        vec3 p = { side[i & 1].x, side[i >> 1 & 1].y, side[i >> 2].z };
        double depth = vec3_dot(view->depth, p);
        near = !(depth > least_depth);
        for (int k = 0; k < 2; k++) {
            double at = vec3_dot(view->across[k], p) / depth - view->shift[k];
            out->low[k] = slab_min(out->low[k], at - place_margin);
            out->high[k] = slab_max(out->high[k], at + place_margin);
        }
    }
    for (int k = 0; k < 2 && near; k++) {
        out->low[k] = -HUGE_VAL;
        out->high[k] = HUGE_VAL;
    }
}

/* Written so that nothing is left out by the products of zeros and infinities.
 */
static bool bounds_miss(const struct shaft_bounds *bounds,
                        const struct box3 *box)
{
    const struct box3 *own = &bounds->box;
    if (box->low.x > own->high.x || box->high.x < own->low.x ||
        box->low.y > own->high.y || box->high.y < own->low.y ||
        box->low.z > own->high.z || box->high.z < own->low.z)
        return true;
    for (int i = 0; i < bounds->count; i++) {
        vec3 n = bounds->sides[i].normal;
        double nearest = n.x * (n.x > 0 ? box->low.x : box->high.x) +
                         n.y * (n.y > 0 ? box->low.y : box->high.y) +
                         n.z * (n.z > 0 ? box->low.z : box->high.z);
        if (nearest > bounds->sides[i].limit)
            return true;
    }
    return false;
}

/* A search of a tree. */
struct shaft_search {
    struct shaft_bounds bounds;
    const struct shaft_rays *rays;
    struct shaft *shaft;
    bool viewed; /* the rest is known */
    struct shaft_view view;
    const struct leaf *left; /* is not met again; or NULL */
};

/* What the rays begin on, if they leave it for good: a convex shape is all
 * behind the plane that touches it. */
static const struct leaf *shaft_left(const struct shaft_rays *rays)
{
    const struct leaf *leaf = rays->leaf;
    vec3 way = vec3_sub(rays->middle, rays->from);
    double rise = vec3_dot(rays->normal, way) -
                  fabs(vec3_dot(rays->normal, rays->half[0])) -
                  fabs(vec3_dot(rays->normal, rays->half[1]));
    double longest = vec3_length(way) + vec3_length(rays->half[0]) +
                     vec3_length(rays->half[1]);
    bool convex = leaf && leaf->solid && leaf->solid->simple &&
                  leaf->object->kind == OBJECT_SHAPE && !leaf->inverse &&
                  leaf->object->primitive->convex;
    return convex && rise > least_rise * longest ? leaf : NULL;
}

static void search_take(struct shaft_search *search, const struct solid *solid)
{
    struct shaft *shaft = search->shaft;
    if (!search->viewed) {
        search->viewed = true;
        search->view = shaft_view(search->rays);
        search->left = shaft_left(search->rays);
    }
    if (solid && search->left && solid->leaf == search->left)
        return;
    if (!solid || shaft->count == SHAFT_SOLIDS) {
        shaft->crowded = true;
        return;
    }
    struct shaft_solid *out = &shaft->at[shaft->count++];
    out->solid = solid;
    view_place(&search->view, &search->bounds.box, &solid->surface, out);
}

void shaft_find(const struct shaft_tree *tree, const struct shaft_rays *rays,
                struct shaft *shaft)
{
    struct shaft_search search;
    search.bounds = shaft_bounds(rays);
    search.rays = rays;
    search.shaft = shaft;
    search.viewed = false;
    shaft->count = 0;
    shaft->crowded = false;
    for (size_t i = 0; i < tree->endless_count && !shaft->crowded; i++)
        if (!bounds_miss(&search.bounds, &tree->endless[i].box))
            search_take(&search, tree->endless[i].solid);
    for (size_t i = 0; i < tree->node_count && !shaft->crowded;) {
        const struct shaft_node *node = &tree->nodes[i];
        bool missed = bounds_miss(&search.bounds, &node->box);
        if (!missed && node->leaf)
            search_take(&search, node->solid);
        i = missed ? node->next : i + 1;
    }
}
