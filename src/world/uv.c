/* The surface's own coordinates where a ray meets it: what uv_mapping maps. */
#include "world/world.h"
#include "scene/mesh.h"
#include "scene/primitive.h"

static vec3 leaf_uv(const struct leaf *leaf, vec3 there, int part)
{
    const struct object *object = leaf->object;
    bool mesh = object->kind == OBJECT_MESH;
    double uv[2] = { there.x, there.y };
    vec3 point =
        leaf_is_moved(leaf) ? affine_point(leaf->pose->inward, there) : there;
    if (mesh && object->mesh->mapped)
        mesh_uv(object->mesh, (size_t)part, point, uv);
    else if (!mesh && object->primitive->uv)
        object->primitive->uv(leaf->shape, point, uv);
    vec3 place = { uv[0], uv[1], 0 };
    return vec3_finite(place) ? place : (vec3){ 0, 0, 0 };
}

vec3 world_uv(const struct intersection *at)
{
    return leaf_uv(at->leaf, at->point, at->part);
}

vec3 world_face_uv(const struct leaf *leaf, const struct world_faces *faces,
                   unsigned i)
{
    return leaf_uv(leaf, lane_get(faces->point, i), faces->hit[i].part);
}
