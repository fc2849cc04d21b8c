/* Media as data: see medium.h. The phase functions are measured on POV-Ray 3.7,
 * to four digits; its manual names them after Nishita 1987. */
#include "scene/medium.h"

#include <string.h>

struct medium medium_default(void)
{
    return (struct medium){
        .phase = PHASE_NONE,
        .extinction = 1,
        .method = 3,
        .intervals = 1,
        .samples = 10,
        .levels = 3,
        .threshold = 0.1,
        .confidence = 0.9,
        .variance = 1.0 / 128,
        .ratio = 0.9,
    };
}

rgb medium_density(const struct medium *medium, vec3 point)
{
    rgb density = rgb_grey(1);
    for (size_t i = 0; i < medium->density_count && !rgb_is_black(density);
         i++) {
        rgb d = colour_rgb(pigment_colour(medium->densities[i], point));
        density = rgb_mul(density, d);
    }
    return density;
}

/* Those of the points where something is, and their numbers. */
struct dense {
    struct spots at;
    int number[SPOTS_MAX];
};

static void dense_find(struct dense *dense, const struct spots *points,
                       const rgb *densities)
{
    dense->at.count = 0;
    for (int k = 0; k < points->count; k++) {
        if (rgb_is_black(densities[k]))
            continue;
        dense->number[dense->at.count] = k;
        spots_add(&dense->at, spots_at(points, k));
    }
}

void medium_densities(const struct medium *medium, const struct spots *points,
                      rgb *densities)
{
    colour colours[SPOTS_MAX];
    struct dense dense;
    for (int k = 0; k < points->count; k++)
        densities[k] = rgb_grey(1);
    for (size_t i = 0; i < medium->density_count; i++) {
        dense_find(&dense, points, densities);
        pigment_colours(medium->densities[i], &dense.at, colours);
        for (int k = 0; k < dense.at.count; k++) {
            rgb *density = &densities[dense.number[k]];
            *density = rgb_mul(*density, colour_rgb(colours[k]));
        }
    }
}

static rgb rgb_most(rgb a, rgb b)
{
    return (rgb){ fmax(a.r, b.r), fmax(a.g, b.g), fmax(a.b, b.b) };
}

/* The colours that it blends; images and pictures of functions have up to 1.
 * More than `budget` pigments are not looked at. */
static rgb pigment_most(const struct pigment *pigment, int *budget)
{
    rgb most = rgb_grey(0);
    if (pigment->kind == PIGMENT_COLOUR)
        return colour_rgb(pigment->colour);
    const struct blend_map *map =
        pigment->map ? pigment->map : pattern_map(&pigment->pattern);
    if (pigment->kind == PIGMENT_IMAGE || !map || --*budget < 0)
        return rgb_grey(1);
    for (size_t i = 0; i < map->count; i++) {
        const struct blend_entry *entry = &map->entries[i];
        most =
            rgb_most(most, entry->pigment ? pigment_most(entry->pigment, budget)
                                          : colour_rgb(entry->colour));
    }
    return most;
}

rgb medium_density_most(const struct medium *medium)
{
    rgb most = rgb_grey(1);
    int budget = 1000;
    for (size_t i = 0; i < medium->density_count; i++)
        most = rgb_mul(most, pigment_most(medium->densities[i], &budget));
    return most;
}

bool medium_is_dark(const struct medium *medium)
{
    return rgb_is_black(medium->emission) && rgb_is_black(medium->scattering);
}

rgb medium_extinction(const struct medium *medium)
{
    return rgb_add_scaled(medium->absorption, medium->scattering,
                          medium->extinction);
}

double medium_phase(const struct medium *medium, double cosine)
{
    double half = (1 + cosine) / 2, e = medium->eccentricity;
    switch (medium->phase) {
    case PHASE_NONE:
    case PHASE_ISOTROPIC:
        break;
    case PHASE_MIE_HAZY:
        return 0.57667 * (1 + 9 * pow(half, 8));
    case PHASE_MIE_MURKY:
        return 0.49572 * (1 + 50 * pow(half, 32));
    case PHASE_RAYLEIGH:
        return 0.79937 * (1 + cosine * cosine);
    case PHASE_HENYEY_GREENSTEIN:
        return (1 - e * e) / pow(1 + e * e - 2 * e * cosine, 1.5);
    }
    return 1;
}

const struct medium *medium_moved(struct arena *arena,
                                  const struct medium *medium,
                                  const affine *transform)
{
    struct medium *moved = ARENA_NEW(arena, struct medium);
    *moved = *medium;
    moved->densities =
        ARENA_ARRAY(arena, const struct pigment *, medium->density_count);
    for (size_t i = 0; i < medium->density_count; i++)
        moved->densities[i] =
            pigment_moved(arena, medium->densities[i], transform);
    return moved;
}

struct media media_with(struct arena *arena, struct media media,
                        const struct medium *medium)
{
    const struct medium **items =
        ARENA_ARRAY(arena, const struct medium *, media.count + 1);
    if (media.count)
        memcpy(items, media.items, media.count * sizeof *items);
    items[media.count] = medium;
    return (struct media){ items, media.count + 1 };
}

const struct interior *interior_moved(struct arena *arena,
                                      const struct interior *interior,
                                      const affine *transform)
{
    if (interior->media.count == 0 || affine_is_identity(*transform))
        return interior;
    struct interior *moved = ARENA_NEW(arena, struct interior);
    *moved = *interior;
    moved->media = (struct media){ NULL, 0 };
    for (size_t i = 0; i < interior->media.count; i++)
        moved->media = media_with(
            arena, moved->media,
            medium_moved(arena, interior->media.items[i], transform));
    return moved;
}
