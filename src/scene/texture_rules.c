/* Textures that are picked by what a surface is, and not by a pattern:
 * material_map, corners of triangles, parts of blobs, what was cut away. */
#include "image/image.h"
#include "scene/blob.h"
#include "scene/cutaway.h"
#include "scene/image_map.h"
#include "scene/material.h"
#include "scene/object_probe.h"

/* The shares of several, made 1 in all; returns how many. None: the first
 * entry. */
static int picks_even(const struct texture_choice *choice, int count,
                      struct texture_pick *picks)
{
    double sum = 0;
    for (int i = 0; i < count; i++)
        sum += picks[i].share;
    for (int i = 0; i < count; i++)
        picks[i].share /= sum;
    if (count > 0 && sum > 0 && isfinite(sum))
        return count;
    picks[0] = (struct texture_pick){ choice->entries[0].texture, 1 };
    return 1;
}

int pick_by_corners(const struct texture_choice *choice, vec3 point,
                    const struct uv_source *surface, struct texture_pick *picks)
{
    double shares[3] = { 1, 0, 0 };
    int count = 0;
    (void)point;
    if (surface && surface->corners)
        surface->corners(surface, shares);
    for (int i = 0; i < 3; i++)
        if (shares[i] > 0)
            picks[count++] =
                (struct texture_pick){ choice->entries[i].texture, shares[i] };
    return picks_even(choice, count, picks);
}

/* A number above theirs wraps, the number itself is the last (measured). */
int pick_by_image(const struct texture_choice *choice, vec3 point,
                  const struct uv_source *surface, struct texture_pick *picks)
{
    const struct image_map *map = choice->thing;
    colour found = image_map_colour(map, point);
    double red = found.transmit >= 1 ? 0 : found.r; /* outside of it: 0 */
    size_t count = choice->count;
    double value = map->image->indexed ? red : red * 255;
    const double most = 1e9; /* pictures of floats may hold any number */
    size_t number = value > 0 ? (size_t)(fmin(value, most) + 1e-4) : 0;
    (void)surface;
    number = number > count    ? number % count
             : number == count ? count - 1
                               : number;
    picks[0] = (struct texture_pick){ choice->entries[number].texture, 1 };
    return 1;
}

struct part_picks {
    const struct texture_choice *choice;
    struct texture_pick *picks;
    int count;
};

static void part_pick(void *context, size_t number, double density)
{
    struct part_picks *part = context;
    const struct blob *blob = part->choice->thing;
    const struct texture *texture =
        part->choice->entries[blob->textures[number]].texture;
    for (int i = 0; i < part->count; i++)
        if (part->picks[i].texture == texture) {
            part->picks[i].share += fabs(density);
            return;
        }
    if (part->count < TEXTURE_PICKS)
        part->picks[part->count++] =
            (struct texture_pick){ texture, fabs(density) };
}

/* Each as much as it adds to the density (measured). */
int pick_by_parts(const struct texture_choice *choice, vec3 point,
                  const struct uv_source *surface, struct texture_pick *picks)
{
    struct part_picks part = { choice, picks, 0 };
    (void)surface;
    blob_densities(choice->thing, point, part_pick, &part);
    return picks_even(choice, part.count, picks);
}

/* A choice among the parts' textures, and for the parts without one `own`. */
static const struct texture *parts_choice(struct arena *arena,
                                          const struct blob *blob,
                                          const struct texture *own)
{
    struct texture *texture = ARENA_NEW(arena, struct texture);
    struct texture_choice *choice = ARENA_NEW(arena, struct texture_choice);
    *texture = (struct texture){ .choice = choice, .span = own->span };
    choice->pattern = pattern_new(arena, NULL);
    choice->rule = pick_by_parts;
    choice->thing = blob;
    choice->depth = 1;
    choice->count = blob->texture_count;
    choice->entries = ARENA_ARRAY(arena, struct texture_entry, choice->count);
    for (size_t i = 0; i < choice->count; i++) {
        const struct texture *part = i == 0 ? own : blob->part_textures[i];
        choice->entries[i] = (struct texture_entry){ (double)i, part };
        texture->count += part->count;
        if (part->choice && part->choice->depth >= choice->depth)
            choice->depth = part->choice->depth + 1;
    }
    texture->layers = ARENA_ARRAY(arena, struct layer, texture->count);
    struct layer *layer = texture->layers;
    for (size_t i = 0; i < choice->count; i++) {
        const struct texture *part = choice->entries[i].texture;
        memcpy(layer, part->layers, part->count * sizeof *layer);
        layer += part->count;
    }
    return choice->depth <= TEXTURE_DEPTH ? texture : own;
}

const struct texture *blob_texture(struct arena *arena, const struct blob *blob,
                                   const affine *to_world,
                                   const struct texture *own,
                                   affine *from_texture)
{
    affine inward;
    if (!blob->textures || !own || !affine_inverse(*to_world, &inward))
        return own;
    affine moved = affine_compose(inward, *from_texture);
    *from_texture = *to_world;
    return parts_choice(arena, blob, texture_moved(arena, own, &moved));
}

/* All whose insides the point is in, each as much. */
int pick_by_insides(const struct texture_choice *choice, vec3 point,
                    const struct uv_source *surface, struct texture_pick *picks)
{
    const struct cutaway *cutaway = choice->thing;
    int count = 0;
    (void)surface;
    for (size_t i = 0; i < cutaway->count && count < TEXTURE_PICKS; i++)
        if (object_inside(cutaway->objects[i], point))
            picks[count++] =
                (struct texture_pick){ choice->entries[i + 1].texture, 1 };
    return picks_even(choice, count, picks);
}
