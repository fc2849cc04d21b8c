/* The surface's own coordinates where a ray meets it: what uv_mapping maps. */
#include "world/world.h"
#include "scene/mesh.h"
#include "scene/primitive.h"

vec3 world_uv(const struct intersection *at)
{
    const struct leaf *leaf = at->leaf;
    const struct object *object = leaf->object;
    bool mesh = object->kind == OBJECT_MESH;
    double uv[2] = { at->point.x, at->point.y };
    vec3 point = leaf_is_moved(leaf)
                     ? affine_point(leaf->pose->inward, at->point)
                     : at->point;
    if (mesh && object->mesh->mapped)
        mesh_uv(object->mesh, (size_t)at->part, point, uv);
    else if (!mesh && object->primitive->uv)
        object->primitive->uv(leaf->shape, point, uv);
    vec3 place = { uv[0], uv[1], 0 };
    return vec3_finite(place) ? place : (vec3){ 0, 0, 0 };
}
