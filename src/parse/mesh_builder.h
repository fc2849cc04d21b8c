/* The growing lists a mesh is read into, by mesh{} and by mesh2{}. */
#ifndef PARSE_MESH_BUILDER_H
#define PARSE_MESH_BUILDER_H

#include "parse/parser.h"
#include "scene/mesh.h"

struct vec3_list {
    vec3 *items;
    size_t count, capacity;
};

struct mesh_builder {
    struct vec3_list vertices, normals;
    struct {
        double (*items)[2];
        size_t count, capacity;
    } uvs;
    struct {
        uint32_t (*items)[3];
        size_t count, capacity;
    } uv_faces; /* of the first triangles; the others have none */
    struct {
        struct mesh_triangle *items;
        size_t count, capacity;
    } triangles;
    struct {
        const struct texture **items;
        size_t count, capacity;
    } textures;
};

/* What both kinds read besides triangles; base: the struct mesh. */
extern const struct field mesh_fields[];

/* Makes the lists those of the mesh. */
void mesh_take(struct parser *p, struct mesh *mesh,
               struct mesh_builder *builder);

/* Three of the uvs for the triangle read last. */
void mesh_add_uv_face(struct parser *p, struct mesh_builder *b,
                      const uint32_t corners[3]);

/* The number of the texture that blends one for each corner, or MESH_NONE after
 * an error. */
uint32_t mesh_corner_textures(struct parser *p, struct mesh_builder *b,
                              const struct texture *const corners[3]);

/* After the modifiers: prepares the mesh and warns of what was left out. */
void mesh_end(struct parser *p, struct object *object, struct mesh *mesh);

#endif
