/* mesh_camera{} of a camera. */
#include "scene/camera_mesh.h"

#include "parse/rules.h"
#include "scene/box_tree.h"
#include "scene/camera.h"
#include "scene/object.h"

struct camera_mesh_parts {
    struct camera_mesh_part *items;
    size_t count, capacity;
};

static bool parse_camera_part(struct parser *p, struct camera_mesh_parts *parts)
{
    struct object *object;
    struct span span = stream_span(p);
    if (!parse_object(p, &object))
        return false;
    accept(p, TOKEN_COMMA);
    if (object->kind != OBJECT_MESH || object->mesh->triangle_count == 0)
        return error_at(p, span, NULL,
                        "this mesh has no triangles to look from");
    if (parts->count == CAMERA_MESHES)
        return error_at(p, span, NULL, "a camera has at most %d meshes",
                        CAMERA_MESHES);
    *ARRAY_PUSH(p->scene_arena, parts) =
        (struct camera_mesh_part){ object->mesh, *object->maps->own };
    return true;
}

/* Where the triangles are in the plane of u and v. */
static const struct box_tree *uv_tree(struct parser *p, const struct mesh *mesh)
{
    if (!mesh->uvs)
        return NULL;
    struct box3 *boxes =
        ARENA_ARRAY(p->scene_arena, struct box3, mesh->triangle_count);
    for (size_t i = 0; i < mesh->triangle_count; i++) {
        const uint32_t *face = mesh->uv_faces[i];
        boxes[i] = box3_empty();
        for (int k = 0; k < 3 && face[0] != MESH_NONE; k++)
            boxes[i] = box3_add(boxes[i], vec3_make(mesh->uvs[face[k]][0],
                                                    mesh->uvs[face[k]][1], 0));
        if (face[0] == MESH_NONE)
            boxes[i] =
                (struct box3){ { 1e30, 1e30, 1e30 }, { 1e30, 1e30, 1e30 } };
    }
    return box_tree_new(p->scene_arena, boxes, mesh->triangle_count);
}

static bool mesh_camera_check(struct parser *p, struct span span, int rays,
                              const struct camera_mesh *mesh)
{
    if (mesh->count == 0)
        return error_expected(p, "'mesh' or 'mesh2'");
    if (mesh->distribution == CAMERA_EACH && rays > mesh->count)
        return error_at(p, span, NULL,
                        "with distribution 0 each of the %d rays of a pixel "
                        "needs a mesh of its own, found %d",
                        rays, mesh->count);
    if (mesh->distribution >= CAMERA_ROW && rays != 1)
        return error_at(p, span, "1",
                        "with distribution %d a pixel has 1 ray, found %d",
                        (int)mesh->distribution, rays);
    return mesh->distribution == CAMERA_UV || !mesh->smooth ||
           error_at(p, span, NULL, "'smooth' goes with distribution 3");
}

static bool mesh_camera_body(struct parser *p, struct camera *camera)
{
    struct camera_mesh *mesh = ARENA_NEW(p->scene_arena, struct camera_mesh);
    struct camera_mesh_parts parts = { NULL, 0, 0 };
    struct span span = stream_span(p);
    int rays, distribution;
    double distance;
    if (!parse_integer(p, &rays))
        return false;
    accept(p, TOKEN_COMMA);
    if (rays < 1 || rays > CAMERA_RAYS)
        return error_at(p, span, NULL, "a pixel has 1 to %d rays, found %d",
                        CAMERA_RAYS, rays);
    struct span second = stream_span(p);
    if (!parse_integer(p, &distribution))
        return false;
    accept(p, TOKEN_COMMA);
    if (distribution < 0 || distribution > 3)
        return error_at(p, second, "0",
                        "there are distributions 0 to 3, found %d",
                        distribution);
    if (at_number(p) && !parse_float(p, &distance))
        return false;
    accept(p, TOKEN_COMMA);
    while (stream_keyword(p) == KEYWORD_MESH ||
           stream_keyword(p) == KEYWORD_MESH2)
        if (!parse_camera_part(p, &parts))
            return false;
    mesh->distribution = (enum camera_distribution)distribution;
    mesh->parts = parts.items;
    mesh->count = (int)parts.count;
    mesh->smooth = accept_keyword(p, KEYWORD_SMOOTH);
    if (!mesh_camera_check(p, span, rays, mesh))
        return false;
    if (mesh->distribution == CAMERA_UV)
        mesh->tree = uv_tree(p, mesh->parts[0].mesh);
    /* More rays than one of all meshes in a row are not shot (measured). */
    camera->rays = mesh->distribution == CAMERA_EACH ? rays : 1;
    camera->mesh = mesh;
    return true;
}

/* mesh_camera = "mesh_camera" "{" float [","] float [","] [float [","]]
 *               {( mesh | mesh2 ) [","]} ["smooth"] "}" .
 * How many rays a pixel has; the distribution; the last is without effect. */
bool parse_mesh_camera(struct parser *p, struct camera *camera)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) &&
           block_end(p, open, mesh_camera_body(p, camera));
}
