/* The walk over objects: see finishes.h. */
#include "lighting/finishes.h"

#include "scene/mesh.h"

enum { NODES_MAX = 100 * 1000 }; /* declared objects may be used very often */

struct search {
    finish_test *test;
    const struct settings *settings;
    int left; /* nodes */
};

static bool search_texture(const struct search *search,
                           const struct texture *texture)
{
    for (size_t i = 0; texture && i < texture->count; i++)
        if (search->test(texture->layers[i].finish, search->settings))
            return true;
    return false;
}

static const struct object *search_object(struct search *search,
                                          const struct object *object)
{
    if (--search->left < 0)
        return NULL;
    if (search_texture(search, object->texture))
        return object;
    if (object->kind == OBJECT_MESH)
        for (size_t i = 0; i < object->mesh->texture_count; i++)
            if (search_texture(search, object->mesh->textures[i]))
                return object;
    const struct object *found = NULL;
    for (size_t i = 0; !found && i < object->more->child_count; i++)
        found = search_object(search, object->more->children[i]);
    return found;
}

const struct object *finishes_find(const struct scene *scene, finish_test *test)
{
    struct search search = { test, &scene->settings, NODES_MAX };
    const struct object *found = NULL;
    for (size_t i = 0; !found && i < scene->objects.count; i++)
        found = search_object(&search, scene->objects.items[i]);
    return found;
}
