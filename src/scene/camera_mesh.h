/* What a mesh_camera looks from: triangles, of which each gives a ray. */
#ifndef SCENE_CAMERA_MESH_H
#define SCENE_CAMERA_MESH_H

#include "base/affine.h"

struct box_tree;
struct mesh;

/* Which triangle is a pixel's. */
enum camera_distribution {
    CAMERA_EACH, /* that of the pixel's number, of each mesh in turn */
    CAMERA_SUM,  /* of all meshes in a row */
    CAMERA_ROW,  /* of the mesh whose part of the picture's width it is in */
    CAMERA_UV,   /* of the first mesh, at the picture's place on it */
};

enum { CAMERA_RAYS = 10000, CAMERA_MESHES = 10000 }; /* at most */

struct camera_mesh {
    enum camera_distribution distribution;
    struct camera_mesh_part {
        const struct mesh *mesh;
        affine transform;
    } * parts;
    int count;
    bool smooth;                 /* by interpolated normals */
    const struct box_tree *tree; /* of CAMERA_UV: over the triangles in the
                                  * plane of their u and v; or NULL */
};

#endif
