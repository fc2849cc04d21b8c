/* Textures that a pattern picks: texture_map, and one for each block. */
#include "parse/rules.h"

enum {
    CHOICE_ENTRY_LIMIT = 256,   /* POV-Ray's limit for the entries of a map */
    CHOICE_PARTS_LIMIT = 10000, /* all are asked whether they are opaque */
};

struct choice_builder {
    struct texture_choice *choice;
    struct {
        struct texture_entry *items;
        size_t count, capacity;
    } entries;
};

static bool choice_push(struct parser *p, struct choice_builder *b,
                        double value, const struct texture *texture)
{
    if (b->entries.count >= CHOICE_ENTRY_LIMIT)
        return error_at(p, p->last_span, NULL, "a map has at most %d entries",
                        CHOICE_ENTRY_LIMIT);
    *ARRAY_PUSH(p->scene_arena, &b->entries) =
        (struct texture_entry){ value, texture };
    return true;
}

/* texture_map_entry = "[" [float] [","] texture_body "]" . */
static bool parse_texture_map_entry(struct parser *p, struct choice_builder *b)
{
    const struct texture *texture;
    struct span open;
    double value;
    bool average = b->choice && b->choice->pattern.kind->average;
    if (!bracket_begin(p, &open) || !parse_map_value(p, average, &value))
        return false;
    accept(p, TOKEN_COMMA);
    return parse_texture_body(p, &texture) &&
           choice_push(p, b, value, texture) && expect(p, TOKEN_RBRACKET, open);
}

static bool texture_map_entries(struct parser *p, struct choice_builder *b)
{
    const struct value *value = accept_value(p, VALUE_TEXTURE_MAP);
    const struct texture_map *map = value ? value->texture_map : NULL;
    for (size_t i = 0; map && i < map->count; i++)
        if (!choice_push(p, b, map->entries[i].value, map->entries[i].texture))
            return false;
    while (stream_peek(p)->kind != TOKEN_RBRACE) {
        if (!parse_texture_map_entry(p, b) || !entry_end(p))
            return false;
    }
    return true;
}

/* texture_map = "texture_map" "{" [TEXTURE_MAP] {texture_map_entry} "}" . */
static bool parse_texture_map(struct parser *p, struct choice_builder *b)
{
    struct span open;
    stream_next(p);
    b->entries.count = 0;
    return block_begin(p, &open) &&
           block_end(p, open, texture_map_entries(p, b));
}

bool parse_declared_texture_map(struct parser *p,
                                const struct texture_map **out)
{
    struct choice_builder b = { .choice = NULL };
    struct texture_map *map = ARENA_NEW(p->scene_arena, struct texture_map);
    *out = map;
    if (!parse_texture_map(p, &b))
        return false;
    *map = (struct texture_map){ b.entries.items, b.entries.count };
    return true;
}

/* texture_blocks = {texture [","]} .
 * One for each kind of block; those left out are the default texture. */
static bool parse_texture_blocks(struct parser *p, struct choice_builder *b)
{
    const struct pattern *pattern = &b->choice->pattern;
    size_t blocks = (size_t)pattern->kind->blocks;
    struct span span = p->last_span;
    const struct texture *texture;
    accept(p, TOKEN_COMMA);
    while (stream_keyword(p) == KEYWORD_TEXTURE) {
        if (!parse_texture(p, &texture) ||
            !choice_push(p, b, (double)b->entries.count, texture))
            return false;
        accept(p, TOKEN_COMMA);
    }
    while (b->entries.count < blocks)
        if (!choice_push(p, b, (double)b->entries.count,
                         texture_from_defaults(p)))
            return false;
    return b->entries.count == blocks ||
           error_at(p, span, NULL, "'%s' needs %zu textures, found %zu",
                    pattern_name(pattern), blocks, b->entries.count);
}

static bool choice_items(struct parser *p, struct choice_builder *b)
{
    static const struct field names[] = { { .name = "texture_map" },
                                          { .name = NULL } };
    struct pattern *pattern = &b->choice->pattern;
    while (!at_body_end(p)) {
        bool map =
            stream_keyword(p) == KEYWORD_TEXTURE_MAP && !pattern->kind->blocks;
        enum taken taken =
            map ? parse_texture_map(p, b) : parse_pattern_item(p, pattern);
        if (taken == NOT_MINE)
            return error_unknown_item(p, "texture", names);
        if (taken == WRONG)
            return false;
    }
    return b->entries.count ||
           error_at(p, stream_span(p), "texture_map { [0 ...] [1 ...] }",
                    "a texture that begins with a pattern needs a texture_map");
}

/* All layers of all entries, for those who ask what there is. */
static bool choice_gather(struct parser *p, const struct choice_builder *b,
                          struct texture *texture)
{
    struct texture_choice *choice = b->choice;
    for (size_t i = 0; i < b->entries.count; i++) {
        const struct texture *part = b->entries.items[i].texture;
        texture->count += part->count;
        for (size_t k = 0; k < part->count; k++)
            choice->bumps |= part->layers[k].normal != NULL;
        if (part->choice && part->choice->depth >= choice->depth)
            choice->depth = part->choice->depth + 1;
    }
    if (choice->depth > TEXTURE_DEPTH)
        return error_at(p, p->last_span, NULL,
                        "textures are nested more than %d deep", TEXTURE_DEPTH);
    /* Other rules pick some of many entries. */
    bool mixed = choice->rule ? choice->rule == pick_by_corners
                              : choice->pattern.kind->average;
    if (mixed && texture->count > TEXTURE_LAYERS)
        return error_at(p, p->last_span, NULL,
                        "an average is made of at most %d layers of textures",
                        TEXTURE_LAYERS);
    if (texture->count > CHOICE_PARTS_LIMIT)
        return error_at(p, p->last_span, NULL,
                        "a texture is made of more than %d layers",
                        CHOICE_PARTS_LIMIT);
    texture->layers = ARENA_ARRAY(p->scene_arena, struct layer, texture->count);
    size_t at = 0;
    for (size_t i = 0; i < b->entries.count; i++) {
        const struct texture *part = b->entries.items[i].texture;
        memcpy(texture->layers + at, part->layers,
               part->count * sizeof *part->layers);
        at += part->count;
    }
    choice->entries = b->entries.items;
    choice->count = b->entries.count;
    texture->choice = choice;
    return true;
}

const struct texture *texture_by_rule(struct parser *p, texture_rule *rule,
                                      const void *thing,
                                      const struct texture *const *textures,
                                      size_t count)
{
    struct texture *texture = ARENA_NEW(p->scene_arena, struct texture);
    struct choice_builder b = { .choice = ARENA_NEW(p->scene_arena,
                                                    struct texture_choice) };
    b.choice->pattern = pattern_new(p->scene_arena, NULL);
    b.choice->rule = rule;
    b.choice->thing = thing;
    b.choice->depth = 1;
    for (size_t i = 0; i < count; i++)
        *ARRAY_PUSH(p->scene_arena, &b.entries) =
            (struct texture_entry){ (double)i, textures[i] };
    return choice_gather(p, &b, texture) ? texture : NULL;
}

const struct texture *texture_by_blocks(struct parser *p,
                                        const struct pattern_kind *kind,
                                        const struct texture *const *textures)
{
    struct texture *texture = ARENA_NEW(p->scene_arena, struct texture);
    struct choice_builder b = { .choice = ARENA_NEW(p->scene_arena,
                                                    struct texture_choice) };
    b.choice->pattern = pattern_new(p->scene_arena, kind);
    b.choice->depth = 1;
    for (int i = 0; i < kind->blocks; i++)
        *ARRAY_PUSH(p->scene_arena, &b.entries) =
            (struct texture_entry){ (double)i, textures[i] };
    return choice_gather(p, &b, texture) ? texture : NULL;
}

/* texture_choice = pattern texture_blocks {texture_map | pattern_item} . */
enum taken parse_texture_choice(struct parser *p, const struct texture **out)
{
    struct pattern pattern = pattern_new(p->scene_arena, NULL);
    enum taken taken = parse_pattern(p, &pattern);
    if (taken != TAKEN)
        return taken;
    struct texture *texture = ARENA_NEW(p->scene_arena, struct texture);
    struct choice_builder b = { .choice = ARENA_NEW(p->scene_arena,
                                                    struct texture_choice) };
    b.choice->pattern = pattern;
    texture->span = p->last_span;
    b.choice->depth = 1;
    *out = texture;
    return (!pattern.kind->blocks ||
            parse_pattern_end(p, &pattern, parse_texture_blocks(p, &b))) &&
           choice_items(p, &b) && choice_gather(p, &b, texture);
}
