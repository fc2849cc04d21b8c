/* Looks for finishes with ambient light: see ambient.h. */
#include "lighting/ambient.h"

#include "scene/mesh.h"

enum { NODES_MAX = 100 * 1000 }; /* declared objects may be used very often */

static bool rgb_same(rgb a, rgb b)
{
    return a.r == b.r && a.g == b.g && a.b == b.b;
}

static bool texture_glows(const struct texture *texture)
{
    rgb usual = finish_default().ambient;
    for (size_t i = 0; texture && i < texture->count; i++) {
        rgb ambient = texture->layers[i].finish->ambient;
        if (rgb_peak(ambient) > 0 && !rgb_same(ambient, usual))
            return true;
    }
    return false;
}

static const struct object *ambient_find(const struct object *object, int *left)
{
    if (--*left < 0)
        return NULL;
    if (texture_glows(object->texture))
        return object;
    if (object->kind == OBJECT_MESH)
        for (size_t i = 0; i < object->mesh->texture_count; i++)
            if (texture_glows(object->mesh->textures[i]))
                return object;
    for (size_t i = 0; i < object->child_count; i++) {
        const struct object *found = ambient_find(object->children[i], left);
        if (found)
            return found;
    }
    return NULL;
}

void ambient_dropped(const struct scene *scene, const char *method,
                     struct diag *diag)
{
    int left = NODES_MAX;
    if (rgb_peak(scene->settings.ambient_light) == 0)
        return;
    for (size_t i = 0; i < scene->objects.count; i++) {
        const struct object *found =
            ambient_find(scene->objects.items[i], &left);
        if (!found)
            continue;
        diag_print(diag, DIAG_WARNING, found->span, NULL,
                   "'--lighting %s' has no ambient light: for surfaces that "
                   "glow, write 'emission' in place of 'ambient'",
                   method);
        return;
    }
}
