/* Boxes over the triangles of a mesh: see mesh_tree.h. */
#include "world/mesh_tree.h"

#include "scene/slab.h"

enum {
    TREE_LEAF = 4,   /* triangles */
    TREE_DEPTH = 64, /* more than log2 of any number of triangles */
};

/* Inner nodes have count 0; their children are the next node and `first`. */
struct tree_node {
    struct box3 box;
    uint32_t first, count;
};

struct mesh_tree {
    const struct mesh *mesh;
    uint32_t *order; /* triangles, those of a leaf together */
    struct tree_node *nodes;
    uint32_t node_count;
};

static vec3 corner(const struct mesh *mesh, uint32_t triangle, int k)
{
    return mesh->vertices[mesh->triangles[triangle].vertex[k]];
}

/* Three times the centroid along an axis. */
static double triangle_key(const struct mesh *mesh, uint32_t triangle, int axis)
{
    return vec3_component(corner(mesh, triangle, 0), axis) +
           vec3_component(corner(mesh, triangle, 1), axis) +
           vec3_component(corner(mesh, triangle, 2), axis);
}

/* Hoare's selection: the smaller half of `order` first. */
static void split_at_median(const struct mesh *mesh, uint32_t *order,
                            uint32_t count, uint32_t middle, int axis)
{
    uint32_t low = 0, high = count - 1;
    while (low < high) {
        double pivot = triangle_key(mesh, order[low + (high - low) / 2], axis);
        uint32_t i = low, j = high;
        while (i <= j) {
            while (triangle_key(mesh, order[i], axis) < pivot)
                i++;
            while (triangle_key(mesh, order[j], axis) > pivot)
                j--;
            if (i <= j) {
                uint32_t swap = order[i];
                order[i++] = order[j];
                order[j] = swap;
                if (j == 0)
                    break;
                j--;
            }
        }
        if (middle <= j)
            high = j;
        else if (middle >= i)
            low = i;
        else
            return;
    }
}

static int longest_axis(struct box3 box)
{
    vec3 size = vec3_sub(box.high, box.low);
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

/* Builds the node over order[first .. first + count - 1]. */
static void build(struct mesh_tree *tree, uint32_t first, uint32_t count)
{
    struct tree_node *node = &tree->nodes[tree->node_count++];
    struct box3 box = box3_empty(), centres = box3_empty();
    for (uint32_t i = first; i < first + count; i++) {
        struct box3 one = mesh_triangle_box(tree->mesh, tree->order[i]);
        box = box3_union(box, one);
        centres = box3_add(centres, vec3_add(one.low, one.high));
    }
    *node = (struct tree_node){ box, first, count };
    if (count <= TREE_LEAF)
        return;
    uint32_t half = count / 2;
    split_at_median(tree->mesh, tree->order + first, count, half,
                    longest_axis(centres));
    build(tree, first, half);
    node->first = tree->node_count;
    node->count = 0;
    build(tree, first + half, count - half);
}

const struct mesh_tree *mesh_tree_new(struct arena *arena,
                                      const struct mesh *mesh)
{
    struct mesh_tree *tree = ARENA_NEW(arena, struct mesh_tree);
    uint32_t count = (uint32_t)mesh->triangle_count;
    tree->mesh = mesh;
    if (count == 0)
        return tree;
    tree->order = ARENA_ARRAY(arena, uint32_t, count);
    tree->nodes = ARENA_ARRAY(arena, struct tree_node, (size_t)count * 2);
    for (uint32_t i = 0; i < count; i++)
        tree->order[i] = i;
    build(tree, 0, count);
    return tree;
}

/* Who asks for crossings. */
struct tree_asker {
    const struct ray *ray;
    double tmin, tmax;
    hit_visit *visit;
    void *context;
};

static bool visit_leaf(const struct mesh_tree *tree,
                       const struct tree_node *node,
                       const struct tree_asker *asker)
{
    for (uint32_t i = 0; i < node->count; i++) {
        struct hit hit;
        if (mesh_intersect(tree->mesh, tree->order[node->first + i], asker->ray,
                           &hit) &&
            hit.t > asker->tmin && hit.t < asker->tmax &&
            asker->visit(asker->context, &hit))
            return true;
    }
    return false;
}

void mesh_tree_crossings(const struct mesh_tree *tree, const struct ray *ray,
                         double tmin, double tmax, hit_visit *visit,
                         void *context)
{
    const struct tree_asker asker = { ray, tmin, tmax, visit, context };
    uint32_t stack[TREE_DEPTH];
    int depth = 0;
    if (tree->node_count == 0)
        return;
    struct slabs slabs = slabs_of(ray);
    stack[depth++] = 0;
    while (depth > 0) {
        uint32_t number = stack[--depth];
        const struct tree_node *node = &tree->nodes[number];
        if (!slabs_hit(&slabs, &node->box, tmin, tmax))
            continue;
        if (node->count > 0) {
            if (visit_leaf(tree, node, &asker))
                return;
        } else if (depth + 2 <= TREE_DEPTH) {
            stack[depth++] = node->first;
            stack[depth++] = number + 1;
        }
    }
}

static bool leaf_meets(const struct mesh_tree *tree,
                       const struct tree_node *node, const struct cell *cell)
{
    for (uint32_t i = 0; i < node->count; i++) {
        uint32_t triangle = tree->order[node->first + i];
        if (cell_meets_triangle(cell, corner(tree->mesh, triangle, 0),
                                corner(tree->mesh, triangle, 1),
                                corner(tree->mesh, triangle, 2)))
            return true;
    }
    return false;
}

bool mesh_tree_meets(const struct mesh_tree *tree, const struct cell *cell)
{
    uint32_t stack[TREE_DEPTH];
    struct box3 box = cell_box(cell);
    int depth = 0;
    if (tree->node_count == 0)
        return false;
    stack[depth++] = 0;
    while (depth > 0) {
        uint32_t number = stack[--depth];
        const struct tree_node *node = &tree->nodes[number];
        if (box3_is_empty(box3_intersection(box, node->box)))
            continue;
        if (node->count > 0) {
            if (leaf_meets(tree, node, cell))
                return true;
        } else if (depth + 2 <= TREE_DEPTH) {
            stack[depth++] = node->first;
            stack[depth++] = number + 1;
        }
    }
    return false;
}

static bool count_crossing(void *context, const struct hit *hit)
{
    (void)hit;
    ++*(unsigned *)context;
    return false;
}

bool mesh_tree_inside(const struct mesh_tree *tree, vec3 point)
{
    unsigned count = 0;
    const struct mesh *mesh = tree->mesh;
    if (!mesh->solid || !box3_contains(mesh->bounds, point))
        return false;
    struct ray ray = { point, mesh->inside_vector };
    mesh_tree_crossings(tree, &ray, 0, HUGE_VAL, count_crossing, &count);
    return count % 2 == 1;
}
