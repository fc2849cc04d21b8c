/* material_map, a texture for each number of a picture; tiles, two textures in
 * a checker, as POV-Ray 2 had it. */
#include "parse/rules.h"
#include "scene/image_map.h"

enum { MATERIALS_LIMIT = 256 };

struct materials {
    const struct texture **items;
    size_t count, capacity;
};

static bool parse_materials(struct parser *p, struct materials *materials)
{
    while (stream_keyword(p) == KEYWORD_TEXTURE) {
        const struct texture *texture;
        if (materials->count == MATERIALS_LIMIT)
            return error_at(p, stream_span(p), NULL,
                            "a material_map has at most %d textures",
                            MATERIALS_LIMIT);
        if (!parse_texture(p, &texture))
            return false;
        *ARRAY_PUSH(p->scene_arena, materials) = texture;
        accept(p, TOKEN_COMMA);
    }
    return materials->count || error_expected(p, "'texture'");
}

/* What follows the block, up to its texture's end. */
static bool rule_items(struct parser *p, const struct texture **out)
{
    while (!at_body_end(p)) {
        affine step = affine_identity();
        enum taken taken = parse_transformation(p, &step);
        if (taken == NOT_MINE)
            return error_unknown_item(p, "texture", NULL);
        if (taken == WRONG)
            return false;
        *out = texture_moved(p->scene_arena, *out, &step);
    }
    return true;
}

static bool material_map_body(struct parser *p, const struct texture **out)
{
    const struct image_map *map;
    struct materials materials = { NULL, 0, 0 };
    if (!parse_material_image(p, &map) || !parse_materials(p, &materials))
        return false;
    *out = texture_by_rule(p, pick_by_image, map, materials.items,
                           materials.count);
    return *out != NULL;
}

/* material_map = "material_map" "{" image_source {[","] image_item}
 *                texture {[","] texture} "}" {transformation} . */
static bool parse_material_map_block(struct parser *p,
                                     const struct texture **out)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) &&
           block_end(p, open, material_map_body(p, out)) && rule_items(p, out);
}

static bool tiles_body(struct parser *p, const struct texture *both[2])
{
    return parse_texture(p, &both[1]) &&
           (accept_keyword(p, KEYWORD_TILE2) || error_expected(p, "'tile2'")) &&
           parse_texture(p, &both[0]);
}

/* The second is where a checker has its first (measured).
 * tiles = "tiles" "{" texture "tile2" texture "}" {transformation} . */
static bool parse_tiles(struct parser *p, const struct texture **out)
{
    const struct texture *both[2];
    struct span open;
    stream_next(p);
    if (!block_begin(p, &open) || !block_end(p, open, tiles_body(p, both)))
        return false;
    *out = texture_by_blocks(p, pattern_find("checker"), both);
    return *out && rule_items(p, out);
}

/* texture_by_picture = material_map | tiles . */
enum taken parse_material_map(struct parser *p, const struct texture **out)
{
    enum keyword keyword = stream_keyword(p);
    return keyword == KEYWORD_TILES          ? parse_tiles(p, out)
           : keyword == KEYWORD_MATERIAL_MAP ? parse_material_map_block(p, out)
                                             : NOT_MINE;
}
