/* Light meshes as bytes, for a file or for the next picture: what they were
 * made of and with (mesh_stamp.h), then the records of their tables by
 * increasing key, so that the same points give the same bytes however many
 * threads found them.
 *
 *     16 bytes   "glim light mesh\n"
 *     4, 4       MESH_VERSION, 0x01020304: the order of bytes
 *     8          bytes in all
 *     116 x 8    the frame; 4 x 8 the scene's fingerprint
 *     1024       settings, text
 *     8          tables, two for each mesh; and for each of these:
 *       8, 8     bytes of a record, records
 *       8, n     key, record: so many times
 *     8          hash of all before it (base/hash.h)
 *
 * Numbers are the machine's: on one of another order of bytes it is refused. */
#ifndef LIGHTMESH_MESH_FILE_H
#define LIGHTMESH_MESH_FILE_H

#include "lightmesh/mesh_stamp.h"

struct point_mesh;

/* Freed with memory_free. Not while the meshes are in use. */
void *mesh_file_pack(const struct mesh_stamp *stamp,
                     const struct point_mesh *const *meshes, size_t count,
                     size_t *size);

/* Bytes that have been read; they must outlive it. */
struct mesh_file {
    struct mesh_stamp stamp;
    const char *tables, *end;
    size_t count;
};

/* Looks at all of it, and trusts nothing. On failure false, and in
 * problem[problem_size] what is wrong: "it is damaged". */
bool mesh_file_open(struct mesh_file *file, const void *bytes, size_t size,
                    char *problem, size_t problem_size);

/* Puts the points into meshes that are new, made with the file's frame; those
 * of a table that would be fuller than `full`, 0..1, are left out. Where the
 * bytes are those of `map` (NULL: not) points stay there, if they can. False if
 * these can't be the meshes it was made of. */
struct map;
bool mesh_file_fill(const struct mesh_file *file,
                    const struct point_mesh *const *meshes, size_t count,
                    double full, struct map *map);

#endif
