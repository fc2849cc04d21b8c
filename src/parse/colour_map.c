/* The lists of colours and pigments that a pattern's value picks from. */
#include "parse/expression.h"
#include "parse/rules.h"

/* POV-Ray's limit for the entries of a map. */
enum { MAP_ENTRY_LIMIT = 256 };

struct map_builder {
    struct blend_entry *items;
    size_t count, capacity;
    bool average; /* entries may lack their number */
};

static struct blend_map *map_finish(struct parser *p,
                                    const struct map_builder *builder)
{
    struct blend_map *map = ARENA_NEW(p->scene_arena, struct blend_map);
    map->entries = builder->items;
    map->count = builder->count;
    return map;
}

static bool map_push(struct parser *p, struct map_builder *builder,
                     struct blend_entry entry)
{
    if (builder->count >= MAP_ENTRY_LIMIT)
        return error_at(p, p->last_span, NULL, "a map has at most %d entries",
                        MAP_ENTRY_LIMIT);
    *ARRAY_PUSH(p->scene_arena, builder) = entry;
    return true;
}

/* A second number where a colour should be, and what may be meant by it and the
 * next: 1, 0, 0. */
static bool map_bare_colour(struct parser *p, struct span first, double red)
{
    double part[3] = { red, 0, 0 };
    for (int i = 1; i < 3 && stream_peek(p)->kind == TOKEN_NUMBER; i++) {
        if (!parse_float(p, &part[i]))
            return false;
        accept(p, TOKEN_COMMA);
    }
    return error_at(
        p, first,
        arena_printf(p->arena, "rgb <%g, %g, %g>", part[0], part[1], part[2]),
        "expected a colour, found bare numbers");
}

/* From one value to another. */
static bool map_old_entry(struct parser *p, struct map_builder *builder,
                          struct span number, struct blend_entry *entry,
                          double end)
{
    if (stream_peek(p)->kind == TOKEN_RBRACKET)
        return error_at(p, number, arena_printf(p->arena, "rgb %g", end),
                        "expected a colour, found a number");
    if (stream_peek(p)->kind == TOKEN_NUMBER)
        return map_bare_colour(p, number, end);
    if (!parse_colour(p, &entry->colour) || !map_push(p, builder, *entry))
        return false;
    accept(p, TOKEN_COMMA);
    entry->value = end;
    if (stream_peek(p)->kind == TOKEN_RBRACKET)
        return error_at(p, stream_span(p), NULL,
                        "an entry that goes from one number to another "
                        "has two colours");
    return parse_colour(p, &entry->colour) && map_push(p, builder, *entry);
}

/* colour_map_entry = "[" float [","] ( colour | float [","] colour [","] colour
 * )
 *                    "]" .
 * The second form is that of old scenes: from one value to another. A colour
 * may begin as that number does: 0.5 * Red. */
static bool parse_colour_map_entry(struct parser *p,
                                   struct map_builder *builder)
{
    struct blend_entry entry = { .pigment = NULL };
    struct span open;
    double end;
    bool old;
    if (!bracket_begin(p, &open))
        return false;
    const struct token *first = stream_peek(p);
    if (first->kind == TOKEN_WORD && colour_begins(first->word->keyword))
        return error_at(p, stream_span(p),
                        arena_printf(p->arena, "0 %s ...", first->word->text),
                        "an entry begins with its number, from 0 to 1");
    if (!parse_float(p, &entry.value))
        return false;
    accept(p, TOKEN_COMMA);
    if (!parse_colour_or_number(p, &entry.colour, &end, &old))
        return false;
    const struct span number = p->last_span;
    accept(p, TOKEN_COMMA);
    if (old ? !map_old_entry(p, builder, number, &entry, end)
            : !map_push(p, builder, entry))
        return false;
    accept(p, TOKEN_COMMA);
    return expect(p, TOKEN_RBRACKET, open);
}

/* Whether it begins a number, as an entry must that is not of an average. */
bool parse_map_value(struct parser *p, bool average, double *value)
{
    *value = 1;
    return (average && !at_number(p)) || parse_float(p, value);
}

/* pigment_map_entry = "[" [float] [","] pigment_body "]" .
 * Only those of an average may lack the number: it is 1. */
static bool parse_pigment_map_entry(struct parser *p,
                                    struct map_builder *builder)
{
    struct blend_entry entry = { .pigment = p->defaults.pigment };
    struct span open;
    if (!bracket_begin(p, &open) ||
        !parse_map_value(p, builder->average, &entry.value))
        return false;
    accept(p, TOKEN_COMMA);
    return parse_pigment_body(p, &entry.pigment) &&
           map_push(p, builder, entry) && expect(p, TOKEN_RBRACKET, open);
}

typedef bool map_entry_rule(struct parser *p, struct map_builder *builder);

static bool map_entries(struct parser *p, enum value_kind kind,
                        map_entry_rule *rule, bool average,
                        const struct blend_map **out)
{
    const struct value *value = accept_value(p, kind);
    if (value) {
        *out = value->map;
        return true;
    }
    struct map_builder builder = { .average = average };
    while (stream_peek(p)->kind != TOKEN_RBRACE) {
        if (!rule(p, &builder) || !entry_end(p))
            return false;
    }
    *out = map_finish(p, &builder);
    return builder.count || error_at(p, stream_span(p), "[0 rgb 0] [1 rgb 1]",
                                     "a map needs at least one entry");
}

/* After the word that names the kind of map. */
static bool map_block(struct parser *p, enum value_kind kind,
                      map_entry_rule *rule, bool average,
                      const struct blend_map **out)
{
    struct span open;
    stream_next(p);
    return block_begin(p, &open) &&
           block_end(p, open, map_entries(p, kind, rule, average, out));
}

/* colour_map = "colour_map" "{" ( COLOUR_MAP | colour_map_entry
 * {colour_map_entry} )
 *              "}" . */
bool parse_colour_map(struct parser *p, const struct blend_map **out)
{
    return map_block(p, VALUE_COLOUR_MAP, parse_colour_map_entry, false, out);
}

/* pigment_map = "pigment_map" "{" ( PIGMENT_MAP
 *             | pigment_map_entry {pigment_map_entry} ) "}" . */
bool parse_pigment_map(struct parser *p, bool average,
                       const struct blend_map **out)
{
    return map_block(p, VALUE_PIGMENT_MAP, parse_pigment_map_entry, average,
                     out);
}

bool parse_density_entries(struct parser *p, bool average,
                           const struct blend_map **out)
{
    return map_block(p, VALUE_DENSITY_MAP, parse_pigment_map_entry, average,
                     out);
}

static struct blend_entry block_default(const struct pattern_kind *kind, int i)
{
    struct blend_entry entry = { .value = i };
    const double *c = kind->block_colours ? kind->block_colours[i] : NULL;
    double grey = kind->blocks > 1 ? (double)i / (kind->blocks - 1) : 0;
    entry.colour = c ? (colour){ .r = c[0], .g = c[1], .b = c[2] }
                     : colour_opaque(rgb_grey(grey));
    return entry;
}

/* block_list = [colour {[","] colour} | pigment {[","] pigment}] .
 * One for each kind of block; of those left out colours are the pattern's own
 * and pigments the default pigment (measured). */
bool parse_block_list(struct parser *p, const struct pattern *pattern,
                      const struct blend_map **out)
{
    const struct pattern_kind *kind = pattern->kind;
    struct map_builder builder = { .count = 0 };
    enum keyword word = p->density ? KEYWORD_DENSITY : KEYWORD_PIGMENT;
    bool pigments = stream_keyword(p) == word;
    bool more = pigments || at_any_colour(p);
    for (int i = 0; i < kind->blocks; i++) {
        struct blend_entry entry = block_default(kind, i);
        entry.pigment = pigments ? p->defaults.pigment : NULL;
        if (more && pigments) {
            if (!parse_pigment_block(p, &entry.pigment))
                return false;
        } else if (more && !parse_colour(p, &entry.colour)) {
            return false;
        }
        if (!map_push(p, &builder, entry))
            return false;
        if (more)
            accept(p, TOKEN_COMMA);
        more =
            more && (pigments ? stream_keyword(p) == word : at_any_colour(p));
    }
    *out = map_finish(p, &builder);
    return true;
}
