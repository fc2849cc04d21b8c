/* From the scene's tree of objects to leaves, CSG solids, loose meshes and
 * lights, all in world space. */
#ifndef WORLD_FLATTEN_H
#define WORLD_FLATTEN_H

#include "base/array.h"
#include "world/light_table.h"
#include "world/mesh_table.h"
#include "world/shared.h"
#include "world/solid.h"
#include "scene/light.h"
#include "scene/scene.h"
#include "text/diag.h"

/* Limits: a scene of a few lines can ask for 2^60 objects. */
enum {
    FLAT_NODE_LIMIT = 4000000,
    FLAT_DEPTH_LIMIT = 1000,
};

struct flat {
    struct arena *arena;
    struct shared shared;
    struct diag *diag;
    bool failed;              /* a limit was met and reported */
    size_t nodes, node_limit; /* 0: FLAT_NODE_LIMIT */
    unsigned bodies, targets; /* of photons */
    size_t leaf_count, triangle_count;
    bool translucent; /* some leaf lets light pass */
    struct light_list {
        struct light *items;
        size_t count, capacity;
    } lights;
    struct light_table light_places; /* of those that show nothing */
    /* One for each shape or CSG object; unions are taken apart. */
    struct solid_list {
        struct solid **items;
        size_t count, capacity;
    } solids;
    /* Meshes that are no part of a CSG object and not clipped. */
    struct leaf_list {
        const struct leaf **items;
        size_t count, capacity;
    } meshes;
    /* Everything with an inside, in file order. */
    struct container_list {
        struct solid **items;
        size_t count, capacity;
    } containers;
    struct mesh_table meshes_used;
    const struct texture *fallback; /* of objects without a texture */
};

/* Everything in `arena`. Returns false after an error was printed. */
bool flatten_scene(struct flat *flat, const struct scene *scene);

#endif
