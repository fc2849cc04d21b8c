/* Looks for finishes that glow by ambient light: see ambient.h. */
#include "lighting/ambient.h"

#include "scene/mesh.h"

enum { NODES_MAX = 100 * 1000 }; /* declared objects may be used very often */

/* Most ambient light stands for that of other surfaces, which the method finds
 * by itself. More than finishes have anyway, and than they would scatter in
 * surroundings half as bright as white: then the surface is to glow. */
static bool finish_glows(const struct finish *finish, rgb light)
{
    double ambient = rgb_peak(rgb_mul(finish->ambient, light));
    return ambient > rgb_peak(finish_default().ambient) &&
           ambient > 0.5 * finish->diffuse;
}

static bool texture_glows(const struct texture *texture, rgb light)
{
    for (size_t i = 0; texture && i < texture->count; i++)
        if (finish_glows(texture->layers[i].finish, light))
            return true;
    return false;
}

static const struct object *ambient_find(const struct object *object, rgb light,
                                         int *left)
{
    if (--*left < 0)
        return NULL;
    if (texture_glows(object->texture, light))
        return object;
    if (object->kind == OBJECT_MESH)
        for (size_t i = 0; i < object->mesh->texture_count; i++)
            if (texture_glows(object->mesh->textures[i], light))
                return object;
    for (size_t i = 0; i < object->child_count; i++) {
        const struct object *found =
            ambient_find(object->children[i], light, left);
        if (found)
            return found;
    }
    return NULL;
}

void ambient_dropped(const struct scene *scene, const char *method,
                     struct diag *diag)
{
    int left = NODES_MAX;
    rgb light = scene->settings.ambient_light;
    for (size_t i = 0; i < scene->objects.count; i++) {
        const struct object *found =
            ambient_find(scene->objects.items[i], light, &left);
        if (!found)
            continue;
        diag_print(diag, DIAG_WARNING, found->span, NULL,
                   "'--lighting %s' has no ambient light: for surfaces that "
                   "glow, write 'emission' in place of 'ambient'",
                   method);
        return;
    }
}
