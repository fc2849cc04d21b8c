/* Defaults of materials, and copies of textures that are moved. */
#include "scene/material.h"

struct finish finish_default(void)
{
    return (struct finish){
        .ambient = { 0.1, 0.1, 0.1 },
        .diffuse = 0.6,
        .brilliance = 1,
        .phong_size = 40,
        .roughness = 0.05,
        .reflection = { .falloff = 1, .exponent = 1 },
    };
}

struct interior interior_default(void)
{
    return (struct interior){ .ior = 1 };
}

bool texture_is_opaque(const struct texture *texture)
{
    for (size_t i = 0; i < texture->count; i++)
        if (pigment_is_opaque(texture->layers[i].pigment))
            return true;
    return false;
}

const struct texture *texture_moved(struct arena *arena,
                                    const struct texture *texture,
                                    const affine *transform)
{
    struct texture *moved = ARENA_NEW(arena, struct texture);
    moved->count = texture->count;
    moved->layers = ARENA_ARRAY(arena, struct layer, texture->count);
    for (size_t i = 0; i < texture->count; i++) {
        const struct layer *layer = &texture->layers[i];
        moved->layers[i] = (struct layer){
            .pigment = pigment_moved(arena, layer->pigment, transform),
            .normal = layer->normal
                          ? normal_moved(arena, layer->normal, transform)
                          : NULL,
            .finish = layer->finish,
        };
    }
    return moved;
}
