/* Shafts against a tree of boxes: see shaft.h. */
#include "world/shaft.h"

#include <float.h>

#include "base/lesser.h"
#include "world/shaft_tree.h"
#include "scene/primitive.h"

/* A half space that holds all rays of a shaft: normal . p <= limit. */
struct shaft_side {
    vec3 normal;
    double limit;
};

enum { SHAFT_SIDES = 5 };

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

/* The largest of three, without their signs. */
static double most_of(vec3 v)
{
    return greater(fabs(v.x), greater(fabs(v.y), fabs(v.z)));
}

/* How far they begin from `from` in a direction of any length, times that: all
 * of a disc, and what its bending adds. */
static double rays_reach(const struct shaft_rays *rays, vec3 direction)
{
    double square = vec3_dot(direction, direction);
    double rise = vec3_dot(direction, rays->normal);
    return rays->radius *
           (sqrt(greater(square - rise * rise, 0)) + rays->bend * sqrt(square));
}

static vec3 rays_reach_box(const struct shaft_rays *rays)
{
    return vec3_make(rays_reach(rays, vec3_make(1, 0, 0)),
                     rays_reach(rays, vec3_make(0, 1, 0)),
                     rays_reach(rays, vec3_make(0, 0, 1)));
}

/* Adds the side through the point the rays begin at, across a normal of any
 * length, on which `inner`, an offset, is. None if that is too near to say. */
static void bounds_add(struct shaft_bounds *bounds,
                       const struct shaft_rays *rays, vec3 normal, vec3 inner)
{
    double depth = vec3_dot(inner, normal);
    double doubt = bounds->doubt * most_of(normal);
    if (!(fabs(depth) > doubt))
        return;
    vec3 out = depth > 0 ? vec3_negate(normal) : normal;
    double limit = vec3_dot(out, rays->from) + doubt;
    if (rays->radius > 0)
        limit += rays_reach(rays, normal);
    bounds->sides[bounds->count++] = (struct shaft_side){ out, limit };
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
    low = vec3_make(lesser(low.x, edges.low.x), lesser(low.y, edges.low.y),
                    lesser(low.z, edges.low.z));
    high =
        vec3_make(greater(high.x, edges.high.x), greater(high.y, edges.high.y),
                  greater(high.z, edges.high.z));
    bounds->box.low = vec3_add(rays->from, low);
    bounds->box.high = vec3_add(rays->from, high);
    if (rays->radius > 0) {
        vec3 reach = rays_reach_box(rays);
        bounds->box.low = vec3_sub(bounds->box.low, reach);
        bounds->box.high = vec3_add(bounds->box.high, reach);
    }
}

static struct box3 box_hold(struct box3 box, vec3 p)
{
    return (struct box3){
        { lesser(box.low.x, p.x), lesser(box.low.y, p.y),
          lesser(box.low.z, p.z) },
        { greater(box.high.x, p.x), greater(box.high.y, p.y),
          greater(box.high.z, p.z) },
    };
}

/* How steeply all rays leave the plane that touches what they begin on, at
 * least, to the side that `sign` says: the sine; not positive if some don't. */
static double rays_rise(const struct shaft_rays *rays, double sign)
{
    vec3 way = vec3_sub(rays->middle, rays->from);
    double rise = sign * vec3_dot(rays->normal, way) -
                  fabs(vec3_dot(rays->normal, rays->half[0])) -
                  fabs(vec3_dot(rays->normal, rays->half[1]));
    double longest = vec3_length(way) + vec3_length(rays->half[0]) +
                     vec3_length(rays->half[1]);
    return rise / longest - rays->bend;
}

/* Adds that plane, as high as where they begin to see: what ends in it, beside
 * what they begin on, is not met. */
static void bounds_rise(struct shaft_bounds *bounds,
                        const struct shaft_rays *rays)
{
    vec3 way = vec3_sub(rays->middle, rays->from);
    double sign = vec3_dot(rays->normal, way) > 0 ? 1 : -1;
    double rise = rays_rise(rays, sign);
    if (!rays->leaf || !(rise > least_rise))
        return;
    vec3 out = vec3_scale(rays->normal, -sign);
    double limit = vec3_dot(out, rays->from) + bounds->doubt -
                   rise * rays->tmin + rays_reach(rays, out);
    bounds->sides[bounds->count++] = (struct shaft_side){ out, limit };
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
        square = greater(square, vec3_dot(edge[i], edge[i]));
    }
    bounds_near(&bounds, rays, edges, square);
    bounds.doubt =
        1e-9 * greater(most_of(bounds.box.low), most_of(bounds.box.high));
    bounds.count = 0;
    for (int i = 0; i < 4; i++)
        bounds_add(&bounds, rays, vec3_cross(edge[i], edge[(i + 1) % 4]), way);
    bounds_rise(&bounds, rays);
    return bounds;
}

/* Around the vectors to the parallelogram. */
static struct box3 rays_edges(const struct shaft_rays *rays)
{
    vec3 way = vec3_sub(rays->middle, rays->from);
    vec3 reach = { fabs(rays->half[0].x) + fabs(rays->half[1].x),
                   fabs(rays->half[0].y) + fabs(rays->half[1].y),
                   fabs(rays->half[0].z) + fabs(rays->half[1].z) };
    return (struct box3){ vec3_sub(way, reach), vec3_add(way, reach) };
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
            out->low[k] = lesser(out->low[k], at - place_margin);
            out->high[k] = greater(out->high[k], at + place_margin);
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
    bool convex = leaf && leaf->solid && leaf->solid->simple &&
                  leaf->object->kind == OBJECT_SHAPE && !leaf->look->inverse &&
                  leaf->object->primitive->convex;
    return convex && rays_rise(rays, 1) > least_rise ? leaf : NULL;
}

/* A search of a tree for penumbras. */
struct blur_search {
    struct shaft_bounds bounds;
    struct box3 start, ways; /* where rays begin, and all their vectors */
    const struct leaf *left;
    double width; /* of the light */
    double least; /* of what was found */
};

/* How wide the light is at least, seen from where the rays begin. */
static double rays_width(const struct shaft_rays *rays)
{
    vec3 way = vec3_normalise(vec3_sub(rays->middle, rays->from));
    vec3 a = vec3_cross(rays->half[0], way);
    vec3 b = vec3_cross(rays->half[1], way);
    double longer = greater(vec3_length(a), vec3_length(b));
    double area = vec3_length(vec3_cross(a, b));
    return longer > 0 ? 2 * area / longer : 0;
}

/* What part of the way rays go at least until they are between low and high
 * along an axis; above 1: they never are. */
static double part_before(double start_low, double start_high, double way_low,
                          double way_high, double low, double high)
{
    if (low > start_high)
        return way_high > 0 ? (low - start_high) / way_high : 2;
    if (high < start_low)
        return way_low < 0 ? (high - start_low) / way_low : 2;
    return 0;
}

/* The penumbra of what is in the box. */
static double blur_of(const struct blur_search *search, const struct box3 *box)
{
    const struct box3 *start = &search->start, *ways = &search->ways;
    double part = part_before(start->low.x, start->high.x, ways->low.x,
                              ways->high.x, box->low.x, box->high.x);
    part = greater(part, part_before(start->low.y, start->high.y, ways->low.y,
                                     ways->high.y, box->low.y, box->high.y));
    part = greater(part, part_before(start->low.z, start->high.z, ways->low.z,
                                     ways->high.z, box->low.z, box->high.z));
    return part < 1 ? search->width * part / (1 - part) : DBL_MAX;
}

static void blur_take(struct blur_search *search, const struct solid *solid,
                      const struct box3 *box)
{
    if (!solid || !search->left || solid->leaf != search->left)
        search->least = lesser(search->least, blur_of(search, box));
}

double shaft_blur(const struct shaft_tree *tree, const struct shaft_rays *rays,
                  double enough)
{
    vec3 reach = rays_reach_box(rays);
    struct blur_search search = {
        .bounds = shaft_bounds(rays),
        .start = { vec3_sub(rays->from, reach), vec3_add(rays->from, reach) },
        .ways = rays_edges(rays),
        .left = shaft_left(rays),
        .width = rays_width(rays),
        .least = HUGE_VAL,
    };
    for (size_t i = 0; i < tree->endless_count; i++)
        if (!bounds_miss(&search.bounds, &tree->endless[i].box))
            blur_take(&search, tree->endless[i].solid, &tree->endless[i].box);
    for (size_t i = 0; i < tree->node_count && search.least >= enough;) {
        const struct shaft_node *node = &tree->nodes[i];
        bool missed = bounds_miss(&search.bounds, &node->box) ||
                      blur_of(&search, &node->box) >= search.least;
        if (!missed && node->leaf)
            blur_take(&search, node->solid, &node->box);
        i = missed ? node->next : i + 1;
    }
    return search.least;
}

/* That it has one crossing or another is all there is to be known of it. */
static bool solid_is_plain(const struct solid *solid)
{
    return solid->simple && solid->kind == OBJECT_SHAPE &&
           solid->leaf->look->opaque && solid->leaf->look->looks_like < 0;
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
    shaft->plain = shaft->plain && solid_is_plain(solid);
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
    shaft->plain = true;
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
