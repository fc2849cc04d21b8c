/* Up to version 3.1 only the bottom layer of a texture is a filter: those above
 * it let through as much without colouring it, but for images (measured). So
 * what their pigments filter is made what they transmit; blends stay what they
 * are, since both are linear. */
#include "parse/rules.h"

static const struct pigment *pigment_veiled(struct parser *p,
                                            const struct pigment *pigment);

static colour colour_veiled(colour c)
{
    c.transmit += c.filter;
    c.filter = 0;
    return c;
}

static const struct blend_map *map_veiled(struct parser *p,
                                          const struct blend_map *map)
{
    struct blend_map *copy = ARENA_NEW(p->scene_arena, struct blend_map);
    struct blend_entry *entries =
        ARENA_ARRAY(p->scene_arena, struct blend_entry, map->count);
    for (size_t i = 0; i < map->count; i++) {
        entries[i] = map->entries[i];
        if (entries[i].pigment)
            entries[i].pigment = pigment_veiled(p, entries[i].pigment);
        else
            entries[i].colour = colour_veiled(entries[i].colour);
    }
    *copy = (struct blend_map){ entries, map->count };
    return copy;
}

static const struct pigment *pigment_veiled(struct parser *p,
                                            const struct pigment *pigment)
{
    struct pigment *copy = ARENA_NEW(p->scene_arena, struct pigment);
    *copy = *pigment;
    copy->colour = colour_veiled(copy->colour);
    if (copy->kind == PIGMENT_PATTERN && copy->map)
        copy->map = map_veiled(p, copy->map);
    return copy;
}

const struct texture *texture_veiled(struct parser *p,
                                     const struct texture *texture)
{
    struct texture *copy = texture_copy(p, texture);
    for (size_t i = 0; i < copy->count; i++)
        copy->layers[i].pigment = pigment_veiled(p, copy->layers[i].pigment);
    return copy;
}
