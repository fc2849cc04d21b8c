/* Triangles that share vertices: mesh{}, mesh2{}, and single triangles. Given
 * to Embree as they are; immutable and shared by all copies of the object. */
#ifndef SCENE_MESH_H
#define SCENE_MESH_H

#include <stdint.h>

#include "base/affine.h"
#include "base/arena.h"
#include "scene/ray.h"

struct mesh_probes;
struct texture;

enum { MESH_NONE = 0xffffffff };

struct mesh_triangle {
    uint32_t vertex[3];
    uint32_t normal[3]; /* MESH_NONE in [0]: flat */
    uint32_t texture;   /* index into textures, MESH_NONE: the object's */
};

struct mesh {
    vec3 *vertices;
    size_t vertex_count;
    vec3 *normals; /* unit */
    size_t normal_count;
    struct mesh_triangle *triangles; /* none degenerate */
    size_t triangle_count;
    const struct texture **textures;
    size_t texture_count;
    bool mapped;      /* has coordinates of its own, of which none are said */
    double (*uvs)[2]; /* they are 0, or between those of three of these: */
    uint32_t (*uv_faces)[3]; /* of each triangle, MESH_NONE in [0]: none */
    bool solid;              /* has an inside_vector */
    vec3 inside_vector;      /* direction of the ray that counts crossings */
    bool turned; /* outside is where corners turn to the right: a lone triangle
                  * that was moved, a patch (measured) */
    bool lone;   /* a triangle that is no mesh's */
    struct box3 bounds;
    struct mesh_probes *probes; /* scene/object_probe.h; NULL: few triangles */
};

/* Around the corners of a triangle. */
struct box3 mesh_triangle_box(const struct mesh *mesh, size_t triangle);

/* The box around it, moved by `place`, that min_extent and max_extent tell:
 * around the bounds, but around the corners of a lone triangle (measured). */
struct box3 mesh_told(const struct mesh *mesh, const affine *place);

/* Whether three points span no area (also when any is not finite). */
bool mesh_degenerate(vec3 a, vec3 b, vec3 c);

/* Removes degenerate triangles, normalises normals, makes triangles flat
 * whose three normals are equal (as POV-Ray does), fills bounds. Returns how
 * many triangles were removed. */
size_t mesh_prepare(struct mesh *mesh);

/* The crossing of the ray with triangle `index`: t and barycentric u, v of
 * vertices 1 and 2. Both sides count. Of two triangles that share an edge a ray
 * through it hits exactly one. */
bool mesh_intersect(const struct mesh *mesh, size_t index,
                    const struct ray *ray, struct hit *hit);

/* The crossing of the ray with the triangle's plane, which the caller knows to
 * be within the triangle or as good as: t alone, which is not finite if the ray
 * is in the plane; or u, v, too. */
double mesh_distance(const struct mesh *mesh, size_t index,
                     const struct ray *ray);
void mesh_refine(const struct mesh *mesh, size_t index, const struct ray *ray,
                 struct hit *hit);

/* The surface's own coordinates at a point of a triangle, if it is mapped. */
void mesh_uv(const struct mesh *mesh, size_t index, vec3 point, double uv[2]);

/* The flat normal, any length. */
vec3 mesh_face(const struct mesh *mesh, size_t index);

/* The interpolated or flat normal, any length. */
vec3 mesh_normal(const struct mesh *mesh, size_t index, double u, double v);

#endif
