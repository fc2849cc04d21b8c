/* Which places of a way through media are looked at: see media_march.h. */
#include "shade/media_march.h"

#include <string.h>

#include "base/random.h"

static bool media_even(const struct media_list *media)
{
    for (int i = 0; i < media->count; i++)
        if (media->at[i]->density_count > 0)
            return false;
    return true;
}

struct march march_begin(const struct media_way *way)
{
    return (struct march){ .way = way,
                           .how = way->media->at[0],
                           .veil = { rgb_grey(0), rgb_grey(1) },
                           .even = !way->photons && media_even(way->media) };
}

int march_intervals(const struct march *march)
{
    const struct media_list *media = march->way->media;
    int intervals = 1;
    for (int i = 0; i < media->count; i++)
        if (media->at[i]->intervals > intervals)
            intervals = media->at[i]->intervals;
    return intervals;
}

bool march_dims(const struct march *march)
{
    const struct media_way *way = march->way;
    return (!way->lamps || way->media->dark) && !way->photons &&
           (march->how->method == 3 ? march->how->threshold > 0
                                    : march->how->variance >= 0);
}

static uint64_t way_key(const struct media_way *way)
{
    uint64_t bits[6];
    memcpy(bits, &way->origin, sizeof way->origin);
    memcpy(bits + 3, &way->direction, sizeof way->direction);
    uint64_t key = 0;
    for (int i = 0; i < 6; i++)
        key = random_key(key, bits[i]);
    return key;
}

double march_random(struct march *march)
{
    if (!march->keyed)
        march->key = way_key(march->way);
    march->keyed = true;
    march->key = random_mix(march->key);
    return random_unit(march->key);
}

int march_pieces(const struct march *march)
{
    int count = march->how->samples / 2 + 2;
    return count < 3 ? 3 : count;
}

/* Measured: forwards more than back. */
double march_moved(struct march *march)
{
    return march->how->jitter > 0
               ? march->how->jitter * (1.476 * march_random(march) - 0.29)
               : 0;
}

double march_share(struct march *march, int i)
{
    const struct medium *how = march->how;
    bool row = how->method == 2;
    double moved = row ? 0.5 : march_random(march);
    if (row && how->jitter > 0)
        moved += how->jitter * (march_random(march) - 0.5);
    double share = row ? (i + moved) / how->samples : moved;
    return fmin(fmax(share, 0), 1);
}
