/* Defaults of materials, and copies of textures that are moved. */
#include "scene/map_entry.h"
#include "scene/material.h"
#include "scene/spots.h"

struct interior interior_default(void)
{
    return (
        struct interior){ .ior = 1, .dispersion = 1, .dispersion_samples = 7 };
}

static int texture_average(const struct texture_choice *choice,
                           struct texture_pick picks[TEXTURE_PICKS])
{
    int count = (int)choice->count;
    double total = 0;
    for (int i = 0; i < count; i++)
        total += choice->entries[i].value;
    for (int i = 0; i < count; i++)
        picks[i] = (struct texture_pick){ choice->entries[i].texture,
                                          choice->entries[i].value / total };
    return count;
}

/* Between two entries of a map, or one of them. */
static int texture_of_value(const struct texture_choice *choice, double value,
                            struct texture_pick *picks)
{
    const struct texture_entry *entries = choice->entries;
    struct map_place place = map_place_of(&entries[0].value, sizeof entries[0],
                                          choice->count, value);
    picks[0] = (struct texture_pick){ entries[place.entry].texture, 1 };
    if (place.share >= 1 || choice->pattern.kind->blocks)
        return 1;
    picks[0].share = place.share;
    picks[1] = (struct texture_pick){ entries[place.entry - 1].texture,
                                      1 - place.share };
    return 2;
}

int texture_choose(const struct texture_choice *choice, vec3 point,
                   const struct uv_source *surface,
                   struct texture_pick picks[TEXTURE_PICKS], vec3 *located)
{
    *located = pattern_locate(&choice->pattern,
                              pattern_start(&choice->pattern, point, surface));
    if (choice->rule)
        return choice->rule(choice, *located, surface, picks);
    if (choice->pattern.kind->average)
        return texture_average(choice, picks);
    return texture_of_value(
        choice, pattern_value_seen(&choice->pattern, *located, surface), picks);
}

void texture_choose_all(const struct texture_choice *choice,
                        const struct spots *points, struct spots *located,
                        struct texture_pick (*picks)[2], int *counts)
{
    double values[SPOTS_MAX];
    pattern_locate_all(&choice->pattern, points, located);
    pattern_values_at(&choice->pattern, located, values);
    for (int i = 0; i < points->count; i++)
        counts[i] = texture_of_value(choice, values[i], picks[i]);
}

bool texture_choice_ways(const struct texture_choice *choice, const affine *to,
                         const affine *from, affine *inner_to,
                         affine *inner_from)
{
    if (!choice->bumps)
        return false;
    affine inward = pattern_affine(&choice->pattern), outward;
    if (!affine_inverse(inward, &outward))
        return false;
    *inner_to = affine_compose(inward, *to);
    *inner_from = affine_compose(*from, outward);
    return true;
}

rgb texture_transmittance(const struct texture *texture, vec3 point,
                          const struct uv_source *uv)
{
    rgb through = rgb_grey(1);
    if (texture->choice) {
        struct texture_pick picks[TEXTURE_PICKS];
        vec3 located;
        int count = texture_choose(texture->choice, point, uv, picks, &located);
        through = rgb_grey(0);
        for (int i = 0; i < count; i++)
            through = rgb_add_scaled(
                through, texture_transmittance(picks[i].texture, located, uv),
                picks[i].share);
        return through;
    }
    for (size_t i = texture->count; i-- > 0;) {
        const struct pigment *layer = texture->layers[i].pigment;
        colour pigment = pigment_seen(layer, point, uv);
        through = rgb_mul(through, colour_transmittance(pigment));
        if (rgb_peak(through) == 0)
            break;
    }
    return through;
}

/* Of a choice all must be; more than the budget are not looked at. */
static bool texture_opaque(const struct texture *texture, int *budget)
{
    if (--*budget < 0)
        return false;
    const struct texture_choice *choice = texture->choice;
    for (size_t i = 0; choice && i < choice->count; i++)
        if (!texture_opaque(choice->entries[i].texture, budget))
            return false;
    for (size_t i = 0; !choice && i < texture->count; i++)
        if (pigment_is_opaque(texture->layers[i].pigment))
            return true;
    return choice != NULL;
}

bool texture_is_opaque(const struct texture *texture)
{
    int budget = 1000;
    return texture_opaque(texture, &budget);
}

static bool layers_are_plain(const struct texture *texture, bool mapped)
{
    for (size_t i = 0; i < texture->count; i++) {
        const struct layer *layer = &texture->layers[i];
        const struct finish *finish = layer->finish;
        if ((layer->normal && (mapped || !normal_is_of_space(layer->normal))) ||
            !pigment_is_of_point(layer->pigment) ||
            (i > 0 && finish->conserve_energy && finish_mirrors(finish)))
            return false;
    }
    return true;
}

/* Two at a place have room for their layers. */
static bool choice_is_plain(const struct texture_choice *choice, bool mapped)
{
    int budget = 1000;
    if (choice->rule || choice->pattern.kind->average ||
        !pattern_is_of_space(&choice->pattern, &budget))
        return false;
    for (size_t i = 0; i < choice->count; i++) {
        const struct texture *texture = choice->entries[i].texture;
        if (texture->choice || 2 * texture->count > TEXTURE_LAYERS ||
            !texture_is_plain(texture, mapped))
            return false;
    }
    return true;
}

bool texture_is_plain(const struct texture *texture, bool mapped)
{
    return texture->choice
               ? choice_is_plain(texture->choice, mapped)
               : texture->count > 0 && layers_are_plain(texture, mapped);
}

bool texture_is_spatial(const struct texture *texture)
{
    for (size_t i = 0; i < texture->count; i++)
        if (texture->layers[i].pigment->pattern.uv)
            return false;
    return true;
}

bool texture_is_even(const struct texture *texture)
{
    bool even = !texture->choice;
    for (size_t i = 0; i < texture->count; i++)
        even = even && texture->layers[i].pigment->kind == PIGMENT_COLOUR;
    return even;
}

bool texture_mirrors(const struct texture *texture)
{
    for (size_t i = 0; i < texture->count; i++)
        if (finish_mirrors(texture->layers[i].finish))
            return true;
    return false;
}

bool texture_shines(const struct texture *texture)
{
    for (size_t i = 0; i < texture->count; i++) {
        const struct finish *finish = texture->layers[i].finish;
        if (finish->phong != 0 || finish->specular != 0 ||
            finish->film.amount != 0)
            return true;
    }
    return false;
}

bool interior_passes(const struct interior *interior)
{
    return interior->ior == 1 && interior->dispersion == 1 &&
           interior->caustics == 0 &&
           (interior->fade_power == 0 || interior->fade_distance == 0);
}

bool texture_takes_light(const struct texture *texture)
{
    for (size_t i = 0; i < texture->count; i++)
        if (texture->layers[i].finish->diffuse != 0)
            return true;
    return false;
}

const struct finish *texture_finish(const struct texture *texture)
{
    const struct finish *most = NULL;
    for (size_t i = 0; i < texture->count; i++) {
        const struct finish *finish = texture->layers[i].finish;
        if (!most || finish->diffuse > most->diffuse)
            most = finish;
    }
    return most;
}

static const struct texture *choice_moved(struct arena *arena,
                                          const struct texture *texture,
                                          const affine *transform)
{
    struct texture *moved = ARENA_NEW(arena, struct texture);
    struct texture_choice *choice = ARENA_NEW(arena, struct texture_choice);
    *moved = *texture;
    *choice = *texture->choice;
    pattern_transform(&choice->pattern, transform);
    moved->choice = choice;
    return moved;
}

/* What has coordinates of the surface stays (measured). */
static struct layer layer_moved(struct arena *arena, const struct layer *layer,
                                const affine *transform)
{
    struct layer moved = *layer;
    if (!layer->pigment->pattern.uv)
        moved.pigment = pigment_moved(arena, layer->pigment, transform);
    if (layer->normal && !layer->normal->pattern.uv)
        moved.normal = normal_moved(arena, layer->normal, transform);
    return moved;
}

const struct texture *texture_moved(struct arena *arena,
                                    const struct texture *texture,
                                    const affine *transform)
{
    if (texture->choice)
        return texture->choice->pattern.uv
                   ? texture
                   : choice_moved(arena, texture, transform);
    struct texture *moved = ARENA_NEW(arena, struct texture);
    moved->count = texture->count;
    moved->span = texture->span;
    moved->layers = ARENA_ARRAY(arena, struct layer, texture->count);
    for (size_t i = 0; i < texture->count; i++)
        moved->layers[i] = layer_moved(arena, &texture->layers[i], transform);
    return moved;
}

static struct layer layer_mapped(struct arena *arena, const struct layer *layer)
{
    struct pigment *pigment = ARENA_NEW(arena, struct pigment);
    struct layer mapped = { pigment, NULL, layer->finish };
    *pigment = *layer->pigment;
    pigment->pattern.uv = true;
    if (layer->normal) {
        struct normal *normal = ARENA_NEW(arena, struct normal);
        *normal = *layer->normal;
        normal->uv_turned = !normal->pattern.uv;
        normal->pattern.uv = true;
        mapped.normal = normal;
    }
    return mapped;
}

const struct texture *texture_mapped(struct arena *arena,
                                     const struct texture *texture)
{
    struct texture *mapped = ARENA_NEW(arena, struct texture);
    *mapped = *texture;
    if (texture->choice) {
        struct texture_choice *choice = ARENA_NEW(arena, struct texture_choice);
        *choice = *texture->choice;
        choice->pattern.uv = true;
        mapped->choice = choice;
        return mapped;
    }
    mapped->layers = ARENA_ARRAY(arena, struct layer, texture->count);
    for (size_t i = 0; i < texture->count; i++)
        mapped->layers[i] = layer_mapped(arena, &texture->layers[i]);
    return mapped;
}

const struct texture *texture_default(struct arena *arena)
{
    struct texture *texture = ARENA_NEW(arena, struct texture);
    struct pigment *pigment = ARENA_NEW(arena, struct pigment);
    struct finish *finish = ARENA_NEW(arena, struct finish);
    *pigment = pigment_default(arena);
    *finish = finish_default();
    texture->layers = ARENA_NEW(arena, struct layer);
    texture->count = 1;
    texture->layers[0] = (struct layer){ pigment, NULL, finish };
    return texture;
}
