/* Triangles to voxels: the conservative test of Schwarz and Seidel, Fast
 * Parallel Surface and Solid Voxelization on GPUs, 2010, section 3, in columns
 * along the axis that the triangle faces most, of which its plane leaves few
 * voxels each. */
#include "skeleton/voxelise.h"

#include "base/array.h"
#include "base/parallel.h"
#include "scene/cell.h"
#include "scene/mesh.h"
#include "skeleton/matter.h"

enum { CHUNK = 1024 }; /* triangles that a thread does at once */

/* The voxels' half side; see voxelise.c. */
static const double voxel_half = 0.5 + 1e-6;

struct mesh_item {
    const struct leaf *leaf;
    size_t first;           /* number of its first chunk */
    const uint8_t *texture; /* marks by texture of the mesh; NULL: none */
};

struct mesh_work {
    struct arena *arena;
    const struct voxels *grid;
    const uint8_t *marks;
    struct box3 space;
    uint8_t *out;
    size_t chunks;
    struct {
        struct mesh_item *items;
        size_t count, capacity;
    } meshes;
};

static void take_no_solid(void *context, const struct solid *solid)
{
    (void)context;
    (void)solid;
}

static void take_mesh(void *context, const struct leaf *leaf)
{
    struct mesh_work *work = context;
    const struct mesh *mesh = leaf->object->mesh;
    struct box3 box = affine_box(leaf->pose->outward, mesh->bounds);
    struct mesh_item item = { leaf, work->chunks, NULL };
    box = box3_intersection(box, work->space);
    if (leaf->look->no_shadow || box3_is_empty(box))
        return;
    if (mesh->texture_count > 0) {
        uint8_t *marks = ARENA_ARRAY(work->arena, uint8_t, mesh->texture_count);
        for (size_t i = 0; i < mesh->texture_count; i++)
            marks[i] = mesh->textures[i]
                           ? matter_of_texture(mesh->textures[i],
                                               leaf->pose->inward, box)
                           : work->marks[leaf->number];
        item.texture = marks;
    }
    work->chunks += (mesh->triangle_count + CHUNK - 1) / CHUNK;
    *ARRAY_PUSH(work->arena, &work->meshes) = item;
}

/* A triangle in voxel units. */
struct voxel_triangle {
    vec3 corner[3], normal;
    int low[3], high[3];
    int axis; /* that the normal is closest to */
    uint8_t marks;
};

static void mark(const struct mesh_work *work, const struct voxel_triangle *t,
                 const int *at)
{
    uint8_t *out = &work->out[voxels_index(work->grid, at[0], at[1], at[2])];
    vec3 centre = { at[0] + 0.5, at[1] + 0.5, at[2] + 0.5 };
    vec3 half = { voxel_half, voxel_half, voxel_half };
    if ((__atomic_load_n(out, __ATOMIC_RELAXED) & t->marks) == t->marks)
        return;
    struct cell cell = { .centre = centre, .half = half };
    if (cell_meets_triangle(&cell, t->corner[0], t->corner[1], t->corner[2]))
        __atomic_fetch_or(out, t->marks, __ATOMIC_RELAXED);
}

/* The voxels of a column that the triangle's plane meets. */
static void mark_column(const struct mesh_work *work,
                        const struct voxel_triangle *t, int *at)
{
    int axis = t->axis, u = (axis + 1) % 3, v = (axis + 2) % 3;
    double across = vec3_component(t->normal, axis);
    double first = t->low[axis], last = t->high[axis];
    if (across != 0) {
        double nu = vec3_component(t->normal, u) / across;
        double nv = vec3_component(t->normal, v) / across;
        double height = vec3_component(t->corner[0], axis) -
                        nu * (at[u] + 0.5 - vec3_component(t->corner[0], u)) -
                        nv * (at[v] + 0.5 - vec3_component(t->corner[0], v));
        double reach = (fabs(nu) + fabs(nv)) * voxel_half + 1e-3;
        first = fmax(first, floor(height - reach));
        last = fmin(last, floor(height + reach));
    }
    for (at[axis] = (int)first; at[axis] <= last; at[axis]++)
        mark(work, t, at);
}

static void mark_triangle(const struct mesh_work *work,
                          const struct voxel_triangle *t)
{
    int u = (t->axis + 1) % 3, v = (t->axis + 2) % 3, at[3];
    for (at[u] = t->low[u]; at[u] <= t->high[u]; at[u]++)
        for (at[v] = t->low[v]; at[v] <= t->high[v]; at[v]++)
            mark_column(work, t, at);
}

static bool triangle_load(const struct mesh_work *work,
                          const struct mesh_item *item, size_t index,
                          struct voxel_triangle *t)
{
    const struct mesh *mesh = item->leaf->object->mesh;
    const struct mesh_triangle *source = &mesh->triangles[index];
    struct box3 box = box3_empty();
    t->marks = item->texture && source->texture < mesh->texture_count
                   ? item->texture[source->texture]
                   : work->marks[item->leaf->number];
    for (int k = 0; k < 3; k++) {
        vec3 p = affine_point(item->leaf->pose->outward,
                              mesh->vertices[source->vertex[k]]);
        box = box3_add(box, p);
        p = vec3_sub(p, work->grid->origin);
        t->corner[k] = vec3_scale(p, 1 / work->grid->edge);
    }
    vec3 n = vec3_cross(vec3_sub(t->corner[1], t->corner[0]),
                        vec3_sub(t->corner[2], t->corner[0]));
    t->normal = n;
    n = vec3_make(fabs(n.x), fabs(n.y), fabs(n.z));
    t->axis = n.x > n.y && n.x > n.z ? 0 : n.y > n.z ? 1 : 2;
    return t->marks && voxels_touched(work->grid, box, t->low, t->high);
}

/* The mesh that chunk `number` is of. */
static const struct mesh_item *find_item(const struct mesh_work *work,
                                         size_t number)
{
    size_t low = 0, high = work->meshes.count;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (work->meshes.items[middle].first <= number)
            low = middle;
        else
            high = middle;
    }
    return &work->meshes.items[low];
}

/* Several threads may write to a voxel, but only add to it. */
static void mark_chunk(void *context, size_t number, unsigned thread)
{
    const struct mesh_work *work = context;
    const struct mesh_item *item = find_item(work, number);
    size_t first = (number - item->first) * CHUNK;
    size_t end = item->leaf->object->mesh->triangle_count;
    (void)thread;
    end = end < first + CHUNK ? end : first + CHUNK;
    for (size_t i = first; i < end; i++) {
        struct voxel_triangle triangle;
        if (triangle_load(work, item, i, &triangle))
            mark_triangle(work, &triangle);
    }
}

void voxelise_meshes(const struct world *world, const struct voxels *grid,
                     const uint8_t *marks, unsigned threads,
                     const atomic_int *stop, uint8_t *out)
{
    struct mesh_work work = { .arena = arena_new(0),
                              .grid = grid,
                              .marks = marks,
                              .space = voxels_box(grid),
                              .out = out };
    world_visit(world, take_no_solid, take_mesh, &work);
    parallel_run(threads, work.chunks, stop, mark_chunk, &work);
    arena_free(work.arena);
}
