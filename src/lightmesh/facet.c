/* Flat pieces of surface, and which triangles stand alone: see facet.h. */
#include "lightmesh/facet.h"

#include <string.h>

#include "base/memory.h"
#include "base/random.h"
#include "lightmesh/tuning.h"
#include "scene/mesh.h"
#include "scene/primitive.h"

/* How many triangles have a corner at a place, by half of a hash of it: that
 * two places have the same takes a chance in thousands, and a leaf then has
 * the lattice's light. */
struct corner {
    uint32_t key; /* 0: free */
    uint32_t count;
};

struct facets {
    const struct leaf **leaves; /* in the order in which they are visited */
    size_t leaf_count;
    uint32_t *first; /* number of a leaf's first piece, from 1, by leaf->number;
                      * 0: it has none */
    uint8_t *alone;  /* a bit for each piece */
    size_t piece_count;
    struct corner *corners;
    size_t mask;
};

static size_t leaf_pieces(const struct leaf *leaf)
{
    return leaf->object->kind == OBJECT_MESH
               ? leaf->object->mesh->triangle_count
               : PATCHES_MAX;
}

/* Calls visit for every shape of a tree that nothing cuts off. */
struct visitor {
    void (*visit)(struct facets *facets, const struct leaf *leaf);
    struct facets *facets;
};

static void visit_mesh(void *context, const struct leaf *leaf)
{
    const struct visitor *visitor = context;
    visitor->visit(visitor->facets, leaf);
}

static void visit_solid(void *context, const struct solid *solid)
{
    const struct visitor *visitor = context;
    if (solid->more->clip_count > 0)
        return;
    if (solid->kind == OBJECT_UNION)
        for (size_t i = 0; i < solid->child_count; i++)
            visit_solid(context, solid->children[i]);
    if (solid->kind == OBJECT_SHAPE && solid->leaf->object->primitive->patches)
        visitor->visit(visitor->facets, solid->leaf);
}

static void visit_leaves(struct facets *facets, const struct world *world,
                         void (*visit)(struct facets *facets,
                                       const struct leaf *leaf))
{
    struct visitor visitor = { visit, facets };
    facets->leaf_count = facets->piece_count = 0;
    world_visit(world, visit_solid, visit_mesh, &visitor);
}

static void count_leaf(struct facets *facets, const struct leaf *leaf)
{
    facets->piece_count += leaf_pieces(leaf);
    facets->leaf_count++;
}

static uint64_t corner_key(vec3 place)
{
    const double axis[3] = { place.x, place.y, place.z };
    uint64_t key = 0;
    for (int i = 0; i < 3; i++) {
        /* The same corner may be computed in several ways. */
        float rounded = (float)axis[i] + 0.0f;
        uint32_t bits;
        memcpy(&bits, &rounded, sizeof bits);
        key = random_mix(key ^ bits);
    }
    return key | 1;
}

static struct corner *corner_find(const struct facets *facets, uint64_t key)
{
    size_t i = key >> 32 & facets->mask;
    while (facets->corners[i].key && facets->corners[i].key != (uint32_t)key)
        i = (i + 1) & facets->mask;
    return &facets->corners[i];
}

static void take_leaf(struct facets *facets, const struct leaf *leaf)
{
    size_t count = leaf_pieces(leaf);
    facets->leaves[facets->leaf_count++] = leaf;
    facets->first[leaf->number] = (uint32_t)facets->piece_count + 1;
    facets->piece_count += count;
    if (!facets->corners || leaf->object->kind != OBJECT_MESH)
        return;
    for (size_t i = 0; i < 3 * count; i++) {
        uint64_t key = corner_key(leaf_corner(leaf, i / 3, (int)(i % 3)));
        struct corner *corner = corner_find(facets, key);
        corner->key = (uint32_t)key;
        corner->count++;
    }
}

static void mark_leaf(struct facets *facets, const struct leaf *leaf)
{
    size_t first = facets->first[leaf->number] - 1;
    if (leaf->object->kind != OBJECT_MESH)
        return;
    for (size_t i = 0; i < leaf_pieces(leaf); i++) {
        bool alone = true;
        for (int k = 0; alone && k < 3; k++) {
            uint64_t key = corner_key(leaf_corner(leaf, i, k));
            alone = corner_find(facets, key)->count == 1;
        }
        if (alone)
            facets->alone[(first + i) / 8] |= (uint8_t)(1 << (first + i) % 8);
    }
}

struct facets *facets_new(const struct world *world)
{
    struct facets *facets = memory_new(sizeof *facets);
    size_t leaves = world_leaf_count(world), places = 64;
    visit_leaves(facets, world, count_leaf);
    facets->leaves = memory_new((facets->leaf_count + 1) * sizeof(void *));
    facets->first = memory_new((leaves + 1) * sizeof *facets->first);
    facets->alone = memory_new(facets->piece_count / 8 + 1);
    while (places < 4 * world_triangle_count(world))
        places *= 2;
    facets->mask = places - 1;
    if (world_triangle_count(world) <= FACETS_MOST)
        facets->corners = memory_new(places * sizeof *facets->corners);
    visit_leaves(facets, world, take_leaf);
    for (size_t i = 0; facets->corners && i < facets->leaf_count; i++)
        mark_leaf(facets, facets->leaves[i]);
    memory_free(facets->corners);
    facets->corners = NULL;
    return facets;
}

void facets_free(struct facets *facets)
{
    if (!facets)
        return;
    memory_free(facets->leaves);
    memory_free(facets->first);
    memory_free(facets->alone);
    memory_free(facets);
}

/* What follows from the corners. */
static bool facet_finish(const struct facets *facets, uint32_t number,
                         struct facet *facet)
{
    vec3 e = vec3_sub(facet->corner[1], facet->corner[0]);
    vec3 g = vec3_sub(facet->corner[2], facet->corner[0]);
    vec3 h = vec3_sub(g, e), cross = vec3_cross(e, g);
    double ee = vec3_dot(e, e), gg = vec3_dot(g, g), hh = vec3_dot(h, h);
    double area = vec3_length(cross);
    if (!(area > 0) || !isfinite(area))
        return false;
    facet->normal = vec3_scale(cross, 1 / area);
    facet->size = sqrt(area / 2);
    facet->longest = sqrt(fmax(ee, fmax(gg, hh)));
    facet->apex = hh <= ee && hh <= gg ? 0 : gg <= ee ? 1 : 2;
    facet->number = number;
    facet->alone = facets->alone[number / 8] >> (number % 8) & 1;
    return true;
}

static bool triangle_fill(const struct leaf *leaf, size_t triangle,
                          struct facet *facet)
{
    facet->square = false;
    if (leaf->object->mesh->triangles[triangle].normal[0] != MESH_NONE)
        return false;
    for (int k = 0; k < 3; k++)
        facet->corner[k] = leaf_corner(leaf, triangle, k);
    return true;
}

static bool square_fill(const struct leaf *leaf, size_t part,
                        struct facet *facet)
{
    const struct object *object = leaf->object;
    struct patch patches[PATCHES_MAX];
    facet->square = true;
    if ((int)part >= object->primitive->patches(leaf->shape, patches) ||
        patches[part].kind != PATCH_PARALLELOGRAM)
        return false;
    struct patch patch = patch_moved(&patches[part], leaf->pose->outward);
    facet->corner[0] = patch.at;
    facet->corner[1] = vec3_along(patch.at, patch.a, 2);
    facet->corner[2] = vec3_along(patch.at, patch.b, 2);
    return true;
}

static bool facet_fill(const struct facets *facets, const struct leaf *leaf,
                       size_t part, struct facet *facet)
{
    size_t number = facets->first[leaf->number] - 1 + part;
    bool flat = leaf->object->kind == OBJECT_MESH
                    ? triangle_fill(leaf, part, facet)
                    : square_fill(leaf, part, facet);
    return flat && facet_finish(facets, (uint32_t)number, facet);
}

/* Whether the piece is where the ray met it: shapes number their parts as they
 * like. */
static bool facet_holds(const struct facet *facet, vec3 place)
{
    vec3 offset = vec3_sub(place, facet->corner[0]);
    return fabs(vec3_dot(offset, facet->normal)) < 1e-4 * facet->longest;
}

bool facets_find(const struct facets *facets, const struct intersection *at,
                 struct facet *facet)
{
    const struct leaf *leaf = at->leaf;
    if (!facets->first[leaf->number] || at->part < 0 ||
        (size_t)at->part >= leaf_pieces(leaf))
        return false;
    return facet_fill(facets, leaf, (size_t)at->part, facet) &&
           facet_holds(facet, at->point);
}

bool facets_at(const struct facets *facets, uint32_t number,
               struct facet *facet)
{
    size_t low = 0, high = facets->leaf_count;
    if (number >= facets->piece_count)
        return false;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (facets->first[facets->leaves[middle]->number] - 1 <= number)
            low = middle;
        else
            high = middle;
    }
    const struct leaf *leaf = facets->leaves[low];
    return facet_fill(facets, leaf, number + 1 - facets->first[leaf->number],
                      facet);
}

vec3 facet_place(const struct facet *facet, double u, double v)
{
    vec3 e = vec3_sub(facet->corner[1], facet->corner[0]);
    vec3 g = vec3_sub(facet->corner[2], facet->corner[0]);
    return vec3_along(vec3_along(facet->corner[0], e, u), g, v);
}

void facet_locate(const struct facet *facet, vec3 place, double *u, double *v)
{
    vec3 e = vec3_sub(facet->corner[1], facet->corner[0]);
    vec3 g = vec3_sub(facet->corner[2], facet->corner[0]);
    vec3 d = vec3_sub(place, facet->corner[0]);
    double twice = 2 * facet->size * facet->size;
    *u = vec3_dot(vec3_cross(d, g), facet->normal) / twice;
    *v = vec3_dot(vec3_cross(e, d), facet->normal) / twice;
    *u = fmin(fmax(*u, 0), facet->square ? 0.5 : 1);
    *v = fmin(fmax(*v, 0), facet->square ? 0.5 : 1 - *u);
}
