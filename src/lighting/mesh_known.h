/* What a light mesh knows before its picture begins: from the picture before
 * or from a file. */
#ifndef LIGHTING_MESH_KNOWN_H
#define LIGHTING_MESH_KNOWN_H

#include "lighting/lighting.h"
#include "lightmesh/mesh_file.h"
#include "lightmesh/plan.h"

struct point_mesh;

struct mesh_known {
    struct mesh_file file;
    bool found;
    const char *name;          /* of the file; NULL: the picture before */
    struct map *map;           /* the file, which its points stay in */
    struct plan_levels levels; /* for this picture */
};

/* Looks for a mesh made of what `wanted` says. The picture before is taken only
 * if its points send about as many rays as wanted, and levels of them are about
 * as near to each other; a file however near they are. Returns false after an
 * error was printed: there is a file, and it is not such a mesh. To be ended in
 * any case. */
bool mesh_known_find(struct mesh_known *known, const struct mesh_stamp *wanted,
                     const struct lighting_options *options, const char *file,
                     struct diag *diag);

/* Into *root how the root of an animation has its mesh points, if that is of
 * the same settings but of another scene: something moves. */
bool mesh_known_root(const struct mesh_stamp *wanted,
                     const struct lighting_options *options,
                     struct mesh_frame *root);

/* Once it is known what the picture's own mesh is made of: whether the mesh of
 * the picture before (KEPT_SAME) is the same. */
bool mesh_known_same(struct mesh_known *known, const struct mesh_stamp *made,
                     const struct lighting_options *options);

/* Into meshes made with known->file.stamp.frame, if something was found.
 * Returns false after an error was printed. */
bool mesh_known_fill(const struct mesh_known *known,
                     const struct point_mesh *const *meshes, size_t count,
                     struct diag *diag);

void mesh_known_end(struct mesh_known *known);

#endif
