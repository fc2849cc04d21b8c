/* Pigments: a colour for each point of space. */
#include "scene/image_map.h"
#include "scene/map_entry.h"
#include "scene/material.h"
#include "scene/spots.h"

/* Pigments inside pigments deeper than this are black; where both sides of a
 * blend are pigments, the work doubles at every level, so below half of it
 * only the nearer one counts. The parser refuses what is deeper. */
enum { DEPTH_BLEND = PIGMENT_DEPTH / 2 };

/* How deep it is, and on which surface, or NULL. */
struct depth {
    int levels;
    const struct uv_source *surface;
};

static struct depth depth_below(struct depth depth)
{
    depth.levels++;
    return depth;
}

struct pigment pigment_default(struct arena *arena)
{
    return (struct pigment){ .kind = PIGMENT_COLOUR,
                             .pattern = pattern_new(arena, NULL) };
}

static colour pigment_at(const struct pigment *pigment, vec3 point,
                         struct depth depth);

static colour entry_colour(const struct blend_entry *entry, vec3 point,
                           struct depth depth)
{
    const struct pigment *pigment = entry->pigment;
    return pigment ? pigment_at(
                         pigment,
                         pattern_start(&pigment->pattern, point, depth.surface),
                         depth_below(depth))
                   : entry->colour;
}

static colour map_colour(const struct blend_map *map, double value, vec3 point,
                         struct depth depth)
{
    const struct map_place place = map_place_of(
        &map->entries[0].value, sizeof map->entries[0], map->count, value);
    const struct blend_entry *entry = &map->entries[place.entry];
    if (depth.levels >= DEPTH_BLEND && place.share < 0.5)
        return entry_colour(entry - 1, point, depth);
    if (depth.levels >= DEPTH_BLEND || place.share >= 1)
        return entry_colour(entry, point, depth);
    return colour_mix(entry_colour(entry - 1, point, depth),
                      entry_colour(entry, point, depth), place.share);
}

colour blend_map_colour(const struct blend_map *map, double value)
{
    struct depth depth = { 0 };
    return map_colour(map, value, vec3_make(0, 0, 0), depth);
}

/* The entries' numbers are their weights. */
static void average_add(colour *sum, double weight, colour c)
{
    *sum = (colour){ sum->r + weight * c.r, sum->g + weight * c.g,
                     sum->b + weight * c.b, sum->filter + weight * c.filter,
                     sum->transmit + weight * c.transmit };
}

static colour average_of(colour sum, double total)
{
    return (colour){ sum.r / total, sum.g / total, sum.b / total,
                     sum.filter / total, sum.transmit / total };
}

static colour average_colour(const struct blend_map *map, vec3 point,
                             struct depth depth)
{
    colour sum = { 0 };
    double total = 0;
    for (size_t i = 0; i < map->count; i++) {
        const struct blend_entry *entry = &map->entries[i];
        average_add(&sum, entry->value, entry_colour(entry, point, depth));
        total += entry->value;
    }
    return average_of(sum, total);
}

/* Whether it says what the block's colour is. */
static inline bool block_has(const struct blend_map *map, double value)
{
    return map && (size_t)value < map->count;
}

/* Blocks that the scene gives no colour have the pattern's own; in a list of
 * pigments they are black. */
static colour block_colour(const struct pigment *pigment, double value,
                           vec3 point, struct depth depth)
{
    const struct pattern_kind *kind = pigment->pattern.kind;
    const struct blend_map *map = pigment->map;
    size_t block = (size_t)value;
    if (block_has(map, value))
        return entry_colour(&map->entries[block], point, depth);
    if (map && map->count > 0 && map->entries[0].pigment)
        return (colour){ 0 };
    if (kind->block_colours && block < (size_t)kind->blocks) {
        const double *c = kind->block_colours[block];
        return colour_opaque(rgb_make(c[0], c[1], c[2]));
    }
    return colour_opaque(rgb_grey(value));
}

/* What a value of the pattern is made of at a point of its space. */
static colour value_colour(const struct pigment *pigment, double value,
                           vec3 located, struct depth depth)
{
    const struct pattern *pattern = &pigment->pattern;
    if (pattern->kind && pattern->kind->blocks > 0)
        return block_colour(pigment, value, located, depth);
    const struct blend_map *map =
        pigment->map ? pigment->map : pattern_map(pattern);
    if (!map || map->count == 0)
        return colour_opaque(rgb_grey(value));
    if (pattern->kind->average)
        return average_colour(map, located, depth);
    return map_colour(map, value, located, depth);
}

/* Measured: inner pigments are seen through the outer's transformation and
 * turbulence, save for wood and marble, which keep theirs to themselves. */
static colour pattern_colour(const struct pigment *pigment, vec3 point,
                             struct depth depth)
{
    const struct pattern *pattern = &pigment->pattern;
    vec3 located = pattern_locate(pattern, point);
    double value = pattern_value_seen(pattern, located, depth.surface);
    return value_colour(pigment, value, located, depth);
}

static colour pigment_at(const struct pigment *pigment, vec3 point,
                         struct depth depth)
{
    if (depth.levels > PIGMENT_DEPTH)
        return (colour){ 0 };
    switch (pigment->kind) {
    case PIGMENT_COLOUR:
        return pigment->colour;
    case PIGMENT_PATTERN:
        return pattern_colour(pigment, point, depth);
    case PIGMENT_IMAGE:
        return image_map_colour(pigment->image,
                                pattern_locate(&pigment->pattern, point));
    }
    return pigment->colour;
}

colour pigment_colour(const struct pigment *pigment, vec3 point)
{
    return pigment_at(pigment, point, (struct depth){ 0, NULL });
}

/* block_colour, of a block that has a colour. */
static inline bool block_simple(const struct blend_map *map, double value,
                                colour *made)
{
    size_t block = (size_t)value;
    if (!block_has(map, value) || map->entries[block].pigment)
        return false;
    *made = map->entries[block].colour;
    return true;
}

/* A value between entries that are colours: all there is to most maps. */
static inline bool map_simple(const struct blend_map *map, double value,
                              colour *made)
{
    const struct map_place place = map_place_of(
        &map->entries[0].value, sizeof map->entries[0], map->count, value);
    const struct blend_entry *entry = &map->entries[place.entry];
    if (entry->pigment)
        return false;
    if (place.share >= 1) {
        *made = entry->colour;
        return true;
    }
    if (entry[-1].pigment)
        return false;
    *made = colour_mix(entry[-1].colour, entry->colour, place.share);
    return true;
}

static void pigments_at(const struct pigment *pigment,
                        const struct spots *points, struct depth depth,
                        colour *colours);

/* entry_colour of several. */
static void entry_colours(const struct blend_entry *entry,
                          const struct spots *points, struct depth depth,
                          colour *colours)
{
    if (entry->pigment) {
        pigments_at(entry->pigment, points, depth_below(depth), colours);
        return;
    }
    for (int i = 0; i < points->count; i++)
        colours[i] = entry->colour;
}

/* average_colour of several. */
static void average_colours(const struct blend_map *map,
                            const struct spots *points, struct depth depth,
                            colour *colours)
{
    colour each[SPOTS_MAX];
    double total = 0;
    for (int i = 0; i < points->count; i++)
        colours[i] = (colour){ 0 };
    for (size_t k = 0; k < map->count; k++) {
        const struct blend_entry *entry = &map->entries[k];
        entry_colours(entry, points, depth, each);
        for (int i = 0; i < points->count; i++)
            average_add(&colours[i], entry->value, each[i]);
        total += entry->value;
    }
    for (int i = 0; i < points->count; i++)
        colours[i] = average_of(colours[i], total);
}

/* The points of `lanes`. */
static struct spots spots_of_lanes(const struct spots *points, unsigned lanes)
{
    struct spots some;
    some.count = 0;
    for (; lanes; lanes &= lanes - 1)
        spots_add(&some, spots_at(points, __builtin_ctz(lanes)));
    return some;
}

/* block_colour of those of `lanes`, of blocks that the map has. */
static void blocks_colours(const struct blend_map *map, const double *values,
                           const struct spots *points, unsigned lanes,
                           struct depth depth, colour *colours)
{
    while (lanes) {
        const double block = values[__builtin_ctz(lanes)];
        unsigned same = 0;
        for (unsigned each = lanes; each; each &= each - 1)
            same |= values[__builtin_ctz(each)] == block ? each & -each : 0;
        colour made[SPOTS_MAX];
        const struct spots some = spots_of_lanes(points, same);
        entry_colours(&map->entries[(size_t)block], &some, depth, made);
        lanes &= ~same;
        for (int k = 0; same; same &= same - 1)
            colours[__builtin_ctz(same)] = made[k++];
    }
}

/* Points with a map's places. */
struct map_places {
    const struct blend_map *map;
    const struct spots *points;
    struct map_place of[SPOTS_MAX];
};

/* Those of `lanes`, which are between the same entries, or at the same one. */
static void places_blend(const struct map_places *places, unsigned lanes,
                         struct depth depth, colour *colours)
{
    const struct map_place place = places->of[__builtin_ctz(lanes)];
    const struct blend_entry *entry = &places->map->entries[place.entry];
    const struct spots some = spots_of_lanes(places->points, lanes);
    bool blended = place.share < 1;
    colour before[SPOTS_MAX], after[SPOTS_MAX];
    entry_colours(entry, &some, depth, after);
    if (blended)
        entry_colours(entry - 1, &some, depth, before);
    for (int k = 0; lanes; lanes &= lanes - 1, k++) {
        int i = __builtin_ctz(lanes);
        colours[i] = blended
                         ? colour_mix(before[k], after[k], places->of[i].share)
                         : after[k];
    }
}

/* map_colour of those of `lanes`, where both sides of a blend count. */
static void map_colours(const struct blend_map *map, const double *values,
                        const struct spots *points, unsigned lanes,
                        struct depth depth, colour *colours)
{
    struct map_places places = { .map = map, .points = points };
    for (unsigned each = lanes; each; each &= each - 1) {
        int i = __builtin_ctz(each);
        places.of[i] =
            map_place_of(&map->entries[0].value, sizeof map->entries[0],
                         map->count, values[i]);
    }
    while (lanes) {
        const struct map_place *first = &places.of[__builtin_ctz(lanes)];
        unsigned same = 0;
        for (unsigned each = lanes; each; each &= each - 1) {
            const struct map_place *place = &places.of[__builtin_ctz(each)];
            bool is = place->entry == first->entry &&
                      (place->share < 1) == (first->share < 1);
            same |= is ? each & -each : 0;
        }
        places_blend(&places, same, depth, colours);
        lanes &= ~same;
    }
}

/* value_colour of several. */
static void values_colours(const struct pigment *pigment, const double *values,
                           const struct spots *located, struct depth depth,
                           colour *colours)
{
    const struct pattern *pattern = &pigment->pattern;
    const struct pattern_kind *kind = pattern->kind;
    const struct blend_map *map =
        pigment->map ? pigment->map : pattern_map(pattern);
    bool blocks = kind && kind->blocks > 0;
    bool mapped = kind && !blocks && map && map->count > 0;
    unsigned left = 0, own = 0; /* not simple; of them, blocks of the map */
    if (mapped && kind->average) {
        average_colours(map, located, depth, colours);
        return;
    }
    for (int i = 0; i < located->count; i++) {
        if ((blocks && block_simple(pigment->map, values[i], &colours[i])) ||
            (mapped && map_simple(map, values[i], &colours[i])))
            continue;
        left |= 1u << i;
        own |= (unsigned)(blocks && block_has(pigment->map, values[i])) << i;
    }
    if (left && mapped && depth.levels < DEPTH_BLEND) {
        map_colours(map, values, located, left, depth, colours);
        return;
    }
    blocks_colours(pigment->map, values, located, own, depth, colours);
    for (left &= ~own; left; left &= left - 1) {
        int i = __builtin_ctz(left);
        colours[i] =
            value_colour(pigment, values[i], spots_at(located, i), depth);
    }
}

/* pigment_at of several that are on no surface. */
static void pigments_at(const struct pigment *pigment,
                        const struct spots *points, struct depth depth,
                        colour *colours)
{
    struct spots located;
    double values[SPOTS_MAX];
    if (pigment->kind != PIGMENT_PATTERN || depth.levels > PIGMENT_DEPTH) {
        for (int i = 0; i < points->count; i++)
            colours[i] = pigment_at(pigment, spots_at(points, i), depth);
        return;
    }
    pattern_locate_all(&pigment->pattern, points, &located);
    pattern_values_at(&pigment->pattern, &located, values);
    values_colours(pigment, values, &located, depth, colours);
}

void pigment_colours(const struct pigment *pigment, const struct spots *points,
                     colour *colours)
{
    pigments_at(pigment, points, (struct depth){ 0, NULL }, colours);
}

colour pigment_seen(const struct pigment *pigment, vec3 point,
                    const struct uv_source *surface)
{
    return pigment_at(pigment, pattern_start(&pigment->pattern, point, surface),
                      (struct depth){ 0, surface });
}

/* Looks at no more than *budget pigments, since shared ones could be met
 * any number of times; beyond that the answer is the safe one, false. */
static bool pigment_opaque(const struct pigment *pigment, int *budget)
{
    if (--*budget < 0)
        return false;
    if (pigment->kind == PIGMENT_COLOUR)
        return pigment->colour.filter == 0 && pigment->colour.transmit == 0;
    if (pigment->kind == PIGMENT_IMAGE)
        return image_map_is_opaque(pigment->image);
    const struct blend_map *map = pigment->map;
    for (size_t i = 0; map && i < map->count; i++) {
        const struct blend_entry *entry = &map->entries[i];
        if (entry->pigment
                ? !pigment_opaque(entry->pigment, budget)
                : entry->colour.filter != 0 || entry->colour.transmit != 0)
            return false;
    }
    return true;
}

bool pigment_is_opaque(const struct pigment *pigment)
{
    int budget = 1000;
    return pigment_opaque(pigment, &budget);
}

bool pigment_all_of_space(const struct pigment *pigment, int *budget)
{
    const struct blend_map *map = pigment->map;
    if (--*budget < 0 || !pattern_is_of_space(&pigment->pattern, budget))
        return false;
    for (size_t i = 0; map && i < map->count; i++)
        if (map->entries[i].pigment &&
            !pigment_all_of_space(map->entries[i].pigment, budget))
            return false;
    return true;
}

bool pigment_is_of_space(const struct pigment *pigment)
{
    int budget = 1000;
    return pigment_all_of_space(pigment, &budget);
}

bool pigment_is_of_point(const struct pigment *pigment)
{
    struct pigment laid = *pigment;
    laid.pattern.uv = false;
    return pigment_is_of_space(&laid);
}

const struct pigment *pigment_moved(struct arena *arena,
                                    const struct pigment *pigment,
                                    const affine *transform)
{
    struct pigment *moved = ARENA_NEW(arena, struct pigment);
    *moved = *pigment;
    pattern_transform(&moved->pattern, transform);
    return moved;
}
