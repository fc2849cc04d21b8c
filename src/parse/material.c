/* Materials: a texture and an interior under one name. */
#include "parse/rules.h"
#include "scene/medium.h"

static const struct field material_names[] = {
    { .name = "texture" },
    { .name = "interior_texture" },
    { .name = "interior" },
    { .name = NULL },
};

/* interior_texture = "interior_texture" "{" texture_body "}" .
 * Over the one there was, which may be NULL. */
bool parse_interior_texture(struct parser *p, const struct texture **inner)
{
    const struct texture *texture;
    if (!parse_texture(p, &texture))
        return false;
    *inner = *inner ? texture_stack(p, *inner, texture) : texture;
    return true;
}

/* material_item = texture | interior_texture | interior | transformation .
 * One texture after the other makes layers. */
static bool parse_material_item(struct parser *p, struct material *material)
{
    const struct texture *texture;
    affine step = affine_identity();
    if (stream_keyword(p) == KEYWORD_INTERIOR)
        return parse_interior(p, &material->interior);
    if (stream_keyword(p) == KEYWORD_INTERIOR_TEXTURE)
        return parse_interior_texture(p, &material->interior_texture);
    if (stream_keyword(p) == KEYWORD_TEXTURE) {
        if (!parse_texture(p, &texture))
            return false;
        material->texture = material->texture
                                ? texture_stack(p, material->texture, texture)
                                : texture;
        return true;
    }
    enum taken taken = parse_transformation(p, &step);
    if (taken == NOT_MINE)
        return error_unknown_thing(p, "material", material_names, "a material");
    if (taken == WRONG)
        return false;
    if (material->texture)
        material->texture =
            texture_moved(p->scene_arena, material->texture, &step);
    if (material->interior_texture)
        material->interior_texture =
            texture_moved(p->scene_arena, material->interior_texture, &step);
    if (material->interior)
        material->interior =
            interior_moved(p->scene_arena, material->interior, &step);
    return true;
}

static bool material_items(struct parser *p, struct material *material)
{
    const struct value *value = accept_value(p, VALUE_MATERIAL);
    *material = value ? *value->material : (struct material){ NULL };
    while (stream_peek(p)->kind != TOKEN_RBRACE)
        if (!parse_material_item(p, material))
            return false;
    return true;
}

/* material = "material" "{" [MATERIAL] {material_item} "}" . */
bool parse_material(struct parser *p, struct material *out)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) && block_end(p, open, material_items(p, out));
}
