/* Embree's triangle geometries and the filters that make their hits exact: see
 * triangles.h. */
#include "world/triangles.h"

#include "scene/mesh.h"
#include "world/packet.h"

/* What ray i of the packet hits. */
static struct triangle_ref locate(const struct RTCFilterFunctionNArguments *a,
                                  unsigned i)
{
    const struct triangle_set *set = a->geometryUserPtr;
    const unsigned *hit = (const unsigned *)a->hit;
    unsigned primitive = hit[LANE_PRIMITIVE * a->N + i];
    if (set->refs)
        return set->refs[primitive];
    return (struct triangle_ref){ set->leaves[hit[LANE_INSTANCE * a->N + i]],
                                  primitive };
}

static void nearest_filter(const struct RTCFilterFunctionNArguments *a)
{
    unsigned asked = flags_bits(a->valid, a->N);
    for (; asked; asked &= asked - 1) {
        unsigned i = (unsigned)__builtin_ctz(asked);
        struct query *query = query_lane(a->context, a->ray, a->N, i);
        struct triangle_ref ref = locate(a, i);
        double t;
        if (!query_sees(query, ref.leaf) ||
            !query_triangle(query, ref.leaf, ref.triangle, &t)) {
            a->valid[i] = 0;
            continue;
        }
        query_take_triangle(query, ref.leaf, ref.triangle, t);
        packet_met_lane(a->context, query);
    }
}

/* Whether Embree's t of ray i is clear of both ends of the ray. */
static bool surely_between(const struct query *query,
                           const struct RTCFilterFunctionNArguments *a,
                           unsigned i)
{
    const float *tfar = (const float *)a->ray + LANE_TFAR * a->N;
    double t = (double)tfar[i] - query->shift;
    return t > query->tmin + query->doubt && t < query->tmax - query->doubt;
}

static bool blocks_plainly(struct query *query,
                           const struct RTCFilterFunctionNArguments *a,
                           unsigned i)
{
    double t;
    if (surely_between(query, a, i))
        return true;
    struct triangle_ref ref = locate(a, i);
    return query_triangle(query, ref.leaf, ref.triangle, &t);
}

static void plain_shadow_filter(const struct RTCFilterFunctionNArguments *a)
{
    unsigned asked = flags_bits(a->valid, a->N);
    for (; asked; asked &= asked - 1) {
        unsigned i = (unsigned)__builtin_ctz(asked);
        struct query *query = query_lane(a->context, a->ray, a->N, i);
        query->blocked = blocks_plainly(query, a, i);
        if (!query->blocked)
            a->valid[i] = 0;
    }
}

static bool blocks(struct query *query, struct triangle_ref ref)
{
    double t;
    return query_sees(query, ref.leaf) &&
           query_triangle(query, ref.leaf, ref.triangle, &t) &&
           query_take_triangle(query, ref.leaf, ref.triangle, t);
}

static void shadow_filter(const struct RTCFilterFunctionNArguments *a)
{
    unsigned asked = flags_bits(a->valid, a->N);
    for (; asked; asked &= asked - 1) {
        unsigned i = (unsigned)__builtin_ctz(asked);
        struct query *query = query_lane(a->context, a->ray, a->N, i);
        if (!blocks(query, locate(a, i)))
            a->valid[i] = 0;
    }
}

/* Meshes that go into one geometry. */
struct copies {
    const struct leaf **items;
    size_t count, capacity;
    size_t vertices, triangles;
};

static void copies_add(struct arena *arena, struct copies *copies,
                       const struct leaf *leaf)
{
    *ARRAY_PUSH(arena, copies) = leaf;
    copies->vertices += leaf->object->mesh->vertex_count;
    copies->triangles += leaf->object->mesh->triangle_count;
}

static void write_vertices(float *out, const struct mesh *mesh,
                           const affine *transform)
{
    for (size_t i = 0; i < mesh->vertex_count; i++) {
        vec3 p = affine_point(transform, mesh->vertices[i]);
        *out++ = triangles_float(p.x);
        *out++ = triangles_float(p.y);
        *out++ = triangles_float(p.z);
    }
}

static void write_indices(unsigned *out, const struct mesh *mesh, size_t base)
{
    for (size_t i = 0; i < mesh->triangle_count; i++)
        for (int k = 0; k < 3; k++)
            *out++ = (unsigned)base + mesh->triangles[i].vertex[k];
}

/* A geometry with room for so much; its buffers into the pointers. NULL when
 * there is no memory, which Embree has reported. */
static RTCGeometry geometry_new(RTCDevice device, size_t vertex_count,
                                size_t triangle_count, float **vertices,
                                unsigned **indices)
{
    RTCGeometry geometry =
        embree.NewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    if (!geometry)
        return NULL;
    *vertices = embree.SetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                                            RTC_FORMAT_FLOAT3,
                                            3 * sizeof(float), vertex_count);
    *indices = embree.SetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
        3 * sizeof(unsigned), triangle_count);
    if (*vertices && *indices)
        return geometry;
    embree.ReleaseGeometry(geometry);
    return NULL;
}

static unsigned geometry_attach(RTCScene scene, RTCGeometry geometry,
                                struct triangle_set *set,
                                RTCFilterFunctionN shadow)
{
    embree.SetGeometryUserData(geometry, set);
    embree.SetGeometryIntersectFilterFunction(geometry, nearest_filter);
    embree.SetGeometryOccludedFilterFunction(geometry, shadow);
    embree.CommitGeometry(geometry);
    unsigned number = embree.AttachGeometry(scene, geometry);
    embree.ReleaseGeometry(geometry);
    return number;
}

/* Into an Embree scene around that centre. */
struct triangles_place {
    RTCDevice device;
    RTCScene scene;
    vec3 centre;
};

static bool add_copies(struct arena *arena, const struct copies *copies,
                       struct triangle_set *set, RTCFilterFunctionN shadow,
                       const struct triangles_place *to)
{
    float *vertices;
    unsigned *indices;
    size_t vertex = 0, triangle = 0;
    affine shift = affine_translation(vec3_negate(to->centre));
    if (copies->count == 0)
        return true;
    RTCGeometry geometry = geometry_new(to->device, copies->vertices,
                                        copies->triangles, &vertices, &indices);
    if (!geometry)
        return false;
    set->refs = ARENA_ARRAY(arena, struct triangle_ref, copies->triangles);
    for (size_t i = 0; i < copies->count; i++) {
        const struct leaf *leaf = copies->items[i];
        const struct mesh *mesh = leaf->object->mesh;
        affine move = affine_compose(shift, *leaf->pose->outward);
        write_vertices(vertices + 3 * vertex, mesh, &move);
        write_indices(indices + 3 * triangle, mesh, vertex);
        for (size_t k = 0; k < mesh->triangle_count; k++)
            set->refs[triangle++] = (struct triangle_ref){ leaf, (uint32_t)k };
        vertex += mesh->vertex_count;
    }
    geometry_attach(to->scene, geometry, set, shadow);
    return true;
}

/* The mesh in a scene of its own, in its own space. */
static bool share_mesh(struct triangles *triangles, struct mesh_entry *entry,
                       RTCDevice device)
{
    const struct mesh *mesh = entry->mesh;
    affine identity = affine_identity();
    float *vertices;
    unsigned *indices;
    RTCGeometry geometry = geometry_new(
        device, mesh->vertex_count, mesh->triangle_count, &vertices, &indices);
    if (!geometry)
        return false;
    RTCScene scene = embree.NewScene(device);
    embree.SetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);
    write_vertices(vertices, mesh, &identity);
    write_indices(indices, mesh, 0);
    geometry_attach(scene, geometry, &triangles->shared,
                    entry->special ? shadow_filter : plain_shadow_filter);
    embree.CommitScene(scene);
    entry->instance = scene;
    return true;
}

static bool add_instance(struct triangles *triangles, struct mesh_entry *entry,
                         const struct leaf *leaf, RTCDevice device,
                         RTCScene scene)
{
    if (!entry->instance && !share_mesh(triangles, entry, device))
        return false;
    affine move =
        affine_compose(affine_translation(vec3_negate(triangles->centre)),
                       *leaf->pose->outward);
    float columns[12];
    for (int row = 0; row < 3; row++)
        for (int column = 0; column < 4; column++)
            columns[3 * column + row] = triangles_float(move.m[row][column]);
    RTCGeometry geometry =
        embree.NewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    embree.SetGeometryInstancedScene(geometry, entry->instance);
    embree.SetGeometryTransform(geometry, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR,
                                columns);
    embree.CommitGeometry(geometry);
    unsigned number = embree.AttachGeometry(scene, geometry);
    embree.ReleaseGeometry(geometry);
    if (number >= triangles->leaf_room)
        return false;
    triangles->leaves[number] = leaf;
    return true;
}

static bool check_limit(struct flat *flat, size_t triangles, size_t vertices)
{
    if (triangles <= TRIANGLES_LIMIT && vertices <= 3 * (size_t)TRIANGLES_LIMIT)
        return true;
    diag_print(flat->diag, DIAG_ERROR, span_none(), NULL,
               "the scene has %zu triangles with %zu vertices (limit is %d)",
               triangles, vertices, TRIANGLES_LIMIT);
    return false;
}

static bool mesh_is_shared(const struct mesh_entry *entry)
{
    return entry->uses > 1 && entry->mesh->triangle_count > TRIANGLES_SHARED;
}

bool triangles_any_shared(const struct flat *flat)
{
    const struct mesh_table *table = &flat->meshes_used;
    for (size_t i = 0; i < table->capacity; i++)
        if (table->entries[i].mesh && mesh_is_shared(&table->entries[i]))
            return true;
    return false;
}

bool triangles_add(struct triangles *triangles, struct flat *flat,
                   RTCDevice device, RTCScene scene, vec3 centre)
{
    struct copies plain = { NULL, 0, 0, 0, 0 }, special = plain;
    const struct triangles_place to = { device, scene, centre };
    triangles->centre = centre;
    triangles->leaf_room = flat->meshes.count + 16;
    triangles->leaves =
        ARENA_ARRAY(flat->arena, const struct leaf *, triangles->leaf_room);
    triangles->shared.leaves = triangles->leaves;
    for (size_t i = 0; i < flat->meshes.count; i++) {
        const struct leaf *leaf = flat->meshes.items[i];
        struct mesh_entry *entry = mesh_table_entry(
            flat->arena, &flat->meshes_used, leaf->object->mesh);
        if (mesh_is_shared(entry)) {
            if (!add_instance(triangles, entry, leaf, device, scene))
                return false;
        } else {
            copies_add(flat->arena,
                       look_is_plain(leaf->look) ? &plain : &special, leaf);
        }
    }
    return check_limit(flat, plain.triangles + special.triangles,
                       plain.vertices + special.vertices) &&
           add_copies(flat->arena, &plain, &triangles->plain,
                      plain_shadow_filter, &to) &&
           add_copies(flat->arena, &special, &triangles->special, shadow_filter,
                      &to);
}

void triangles_free(struct flat *flat)
{
    for (size_t i = 0; i < flat->meshes_used.capacity; i++)
        if (flat->meshes_used.entries[i].instance)
            embree.ReleaseScene(flat->meshes_used.entries[i].instance);
}
