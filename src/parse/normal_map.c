/* The lists of normals and of slopes that a normal's pattern picks from. */
#include "parse/rules.h"

enum {
    NORMAL_ENTRY_LIMIT = 256,   /* POV-Ray's limit for the entries of a map */
    NORMAL_DEPTH_LIMIT = 10,    /* maps in each other */
    NORMAL_PARTS_LIMIT = 10000, /* of one normal: each is work at each point */
};

struct normal_list {
    struct normal_entry *items;
    size_t count, capacity;
};

struct slope_list {
    struct slope_entry *items;
    size_t count, capacity;
};

static bool entry_room(struct parser *p, size_t count)
{
    return count < NORMAL_ENTRY_LIMIT ||
           error_at(p, p->last_span, NULL, "a map has at most %d entries",
                    NORMAL_ENTRY_LIMIT);
}

static bool map_begun(struct parser *p, size_t count, const char *example)
{
    return count || error_at(p, stream_span(p), example,
                             "a map needs at least one entry");
}

/* normal_map_entry = "[" [float] [","] normal_body "]" . */
static bool parse_normal_map_entry(struct parser *p, bool average,
                                   struct normal_list *list)
{
    struct normal_entry entry = { .normal = p->defaults.normal };
    struct span open;
    if (!entry_room(p, list->count) || !bracket_begin(p, &open) ||
        !parse_map_value(p, average, &entry.value))
        return false;
    accept(p, TOKEN_COMMA);
    if (!parse_normal_body(p, &entry.normal))
        return false;
    *ARRAY_PUSH(p->scene_arena, list) = entry;
    return expect(p, TOKEN_RBRACKET, open);
}

static bool normal_map_entries(struct parser *p, bool average,
                               const struct normal_map **out)
{
    const struct value *value = accept_value(p, VALUE_NORMAL_MAP);
    struct normal_list list = { .count = 0 };
    if (value) {
        *out = value->normal_map;
        return true;
    }
    while (stream_peek(p)->kind != TOKEN_RBRACE) {
        if (!parse_normal_map_entry(p, average, &list) || !entry_end(p))
            return false;
    }
    struct normal_map *map = ARENA_NEW(p->scene_arena, struct normal_map);
    *map = (struct normal_map){ list.items, list.count };
    *out = map;
    return map_begun(p, list.count, "[0 bumps 0.5] [1 dents 0.5]");
}

/* normal_map = "normal_map" "{" ( NORMAL_MAP
 *            | normal_map_entry {normal_map_entry} ) "}" . */
bool parse_normal_map(struct parser *p, bool average,
                      const struct normal_map **out)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) &&
           block_end(p, open, normal_map_entries(p, average, out));
}

/* normal_blocks = {normal [","]} .
 * One for each kind of block; those left out are the default normal. */
bool parse_normal_blocks(struct parser *p, struct normal *normal)
{
    const struct pattern *pattern = &normal->pattern;
    size_t blocks = (size_t)pattern->kind->blocks;
    struct span span = p->last_span;
    struct normal_list list = { .count = 0 };
    accept(p, TOKEN_COMMA);
    while (stream_keyword(p) == KEYWORD_NORMAL) {
        struct normal_entry entry = { .value = (double)list.count };
        if (!entry_room(p, list.count) || !parse_normal(p, &entry.normal))
            return false;
        *ARRAY_PUSH(p->scene_arena, &list) = entry;
        accept(p, TOKEN_COMMA);
    }
    normal->map = NULL;
    if (list.count == 0)
        return true;
    while (list.count < blocks) {
        struct normal_entry entry = { (double)list.count, p->defaults.normal };
        *ARRAY_PUSH(p->scene_arena, &list) = entry;
    }
    struct normal_map *map = ARENA_NEW(p->scene_arena, struct normal_map);
    *map = (struct normal_map){ list.items, list.count };
    normal->map = map;
    return list.count == blocks ||
           error_at(p, span, NULL, "'%s' needs %zu normals, found %zu",
                    pattern_name(pattern), blocks, list.count);
}

/* slope_map_entry = "[" float [","] vector "]" .
 * The vector is a height and a slope. */
static bool parse_slope_map_entry(struct parser *p, struct slope_list *list)
{
    struct slope_entry entry;
    struct span open;
    double numbers[5];
    if (!entry_room(p, list->count) || !bracket_begin(p, &open) ||
        !parse_float(p, &entry.value))
        return false;
    accept(p, TOKEN_COMMA);
    if (!parse_components(p, numbers, 2))
        return false;
    entry.height = numbers[0];
    entry.slope = numbers[1];
    *ARRAY_PUSH(p->scene_arena, list) = entry;
    return expect(p, TOKEN_RBRACKET, open);
}

static bool slope_map_entries(struct parser *p, const struct slope_map **out)
{
    const struct value *value = accept_value(p, VALUE_SLOPE_MAP);
    struct slope_list list = { .count = 0 };
    if (value) {
        *out = value->slope_map;
        return true;
    }
    while (stream_peek(p)->kind != TOKEN_RBRACE) {
        if (!parse_slope_map_entry(p, &list) || !entry_end(p))
            return false;
    }
    struct slope_map *map = ARENA_NEW(p->scene_arena, struct slope_map);
    *map = (struct slope_map){ list.items, list.count };
    *out = map;
    return map_begun(p, list.count, "[0 <0, 1>] [1 <1, 1>]");
}

/* slope_map = "slope_map" "{" ( SLOPE_MAP | slope_map_entry {slope_map_entry} )
 *             "}" . */
bool parse_slope_map(struct parser *p, const struct slope_map **out)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) &&
           block_end(p, open, slope_map_entries(p, out));
}

bool normal_count(struct parser *p, struct normal *normal)
{
    normal->depth = 0;
    normal->parts = 1;
    for (size_t i = 0; normal->map && i < normal->map->count; i++) {
        const struct normal *part = normal->map->entries[i].normal;
        if (part && part->depth >= normal->depth)
            normal->depth = part->depth + 1;
        normal->parts += part ? part->parts : 0;
    }
    if (normal->depth > NORMAL_DEPTH_LIMIT)
        return error_at(p, p->last_span, NULL,
                        "normals are nested more than %d deep",
                        NORMAL_DEPTH_LIMIT);
    return normal->parts <= NORMAL_PARTS_LIMIT ||
           error_at(p, p->last_span, NULL,
                    "a normal is made of more than %d others",
                    NORMAL_PARTS_LIMIT);
}
