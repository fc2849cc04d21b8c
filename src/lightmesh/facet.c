/* Which triangles stand alone: see facet.h. */
#include "lightmesh/facet.h"

#include <string.h>

#include "base/memory.h"
#include "base/random.h"
#include "scene/mesh.h"

/* Of more triangles none are found to be alone: most are too small to be of
 * use, and sorting them takes memory. */
enum { FACETS_MAX = 250000 };

/* How many triangles have a corner at a place, by a hash of it. */
struct corner {
    uint64_t key; /* 0: free */
    uint32_t count;
};

struct facets {
    const struct leaf **leaves; /* in the order in which they are visited */
    size_t leaf_count;
    uint32_t *first; /* number of a leaf's first triangle, by leaf->number */
    bool *mesh;      /* whether it is one of them, likewise */
    uint8_t *alone;  /* a bit for each triangle */
    size_t triangle_count;
    struct corner *corners;
    size_t mask;
};

static void count_leaf(void *context, const struct leaf *leaf)
{
    struct facets *facets = context;
    facets->triangle_count += leaf->object->mesh->triangle_count;
    facets->leaf_count++;
}

static void ignore_solid(void *context, const struct solid *solid)
{
    (void)context;
    (void)solid;
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
    size_t i = key >> 1 & facets->mask;
    while (facets->corners[i].key && facets->corners[i].key != key)
        i = (i + 1) & facets->mask;
    return &facets->corners[i];
}

static vec3 leaf_corner(const struct leaf *leaf, size_t triangle, int k)
{
    const struct mesh *mesh = leaf->object->mesh;
    vec3 v = mesh->vertices[mesh->triangles[triangle].vertex[k]];
    return leaf->moved ? affine_point(&leaf->to_world, v) : v;
}

static void take_leaf(void *context, const struct leaf *leaf)
{
    struct facets *facets = context;
    size_t count = leaf->object->mesh->triangle_count;
    facets->leaves[facets->leaf_count++] = leaf;
    facets->first[leaf->number] = (uint32_t)facets->triangle_count;
    facets->mesh[leaf->number] = true;
    facets->triangle_count += count;
    for (size_t i = 0; facets->corners && i < 3 * count; i++) {
        uint64_t key = corner_key(leaf_corner(leaf, i / 3, (int)(i % 3)));
        struct corner *corner = corner_find(facets, key);
        corner->key = key;
        corner->count++;
    }
}

static void mark_leaf(struct facets *facets, const struct leaf *leaf)
{
    size_t first = facets->first[leaf->number];
    for (size_t i = 0; i < leaf->object->mesh->triangle_count; i++) {
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
    world_visit(world, ignore_solid, count_leaf, facets);
    facets->leaves = memory_new((facets->leaf_count + 1) * sizeof(void *));
    facets->first = memory_new((leaves + 1) * sizeof *facets->first);
    facets->mesh = memory_new((leaves + 1) * sizeof *facets->mesh);
    facets->alone = memory_new(facets->triangle_count / 8 + 1);
    while (places < 4 * facets->triangle_count)
        places *= 2;
    facets->mask = places - 1;
    if (facets->triangle_count <= FACETS_MAX)
        facets->corners = memory_new(places * sizeof *facets->corners);
    facets->leaf_count = facets->triangle_count = 0;
    world_visit(world, ignore_solid, take_leaf, facets);
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
    memory_free(facets->mesh);
    memory_free(facets->alone);
    memory_free(facets);
}

static bool facet_fill(const struct facets *facets, const struct leaf *leaf,
                       size_t triangle, struct facet *facet)
{
    if (leaf->object->mesh->triangles[triangle].normal[0] != MESH_NONE)
        return false;
    for (int k = 0; k < 3; k++)
        facet->corner[k] = leaf_corner(leaf, triangle, k);
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
    facet->number = facets->first[leaf->number] + (uint32_t)triangle;
    facet->alone = facets->alone[facet->number / 8] >> (facet->number % 8) & 1;
    return true;
}

bool facets_find(const struct facets *facets, const struct intersection *at,
                 struct facet *facet)
{
    return facets->mesh[at->leaf->number] &&
           facet_fill(facets, at->leaf, (size_t)at->part, facet);
}

bool facets_at(const struct facets *facets, uint32_t number,
               struct facet *facet)
{
    size_t low = 0, high = facets->leaf_count;
    if (number >= facets->triangle_count)
        return false;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (facets->first[facets->leaves[middle]->number] <= number)
            low = middle;
        else
            high = middle;
    }
    const struct leaf *leaf = facets->leaves[low];
    return facet_fill(facets, leaf, number - facets->first[leaf->number],
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
    *u = fmin(fmax(*u, 0), 1);
    *v = fmin(fmax(*v, 0), 1 - *u);
}
