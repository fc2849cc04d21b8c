/* What the world keeps for each mesh, however many objects share it. */
#ifndef WORLD_MESH_TABLE_H
#define WORLD_MESH_TABLE_H

#include "base/arena.h"
#include "scene/mesh.h"

struct mesh_entry {
    const struct mesh *mesh; /* NULL: free */
    const struct mesh_tree *tree;
    size_t uses;    /* objects that give it to Embree as it is; */
    bool special;   /* one of them is not plain (look_is_plain) */
    void *instance; /* Embree's scene, if it is shared by instances */
};

/* Zeroed: empty. */
struct mesh_table {
    struct mesh_entry *entries;
    size_t count, capacity;
};

/* The mesh's entry, a new one if need be; valid until the next call. */
struct mesh_entry *mesh_table_entry(struct arena *arena,
                                    struct mesh_table *table,
                                    const struct mesh *mesh);

#endif
