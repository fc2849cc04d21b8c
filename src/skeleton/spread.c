/* Light spreads from piece to piece, a round for each step: see spread.h. */
#include "skeleton/spread.h"

#include "base/memory.h"

/* What a piece hears of those beside it. */
struct hearsay {
    rgb light;
    double faces;
};

struct spread {
    const struct pieces *pieces;
    const struct voxels *voxels;
    struct piece_light *light;
    struct hearsay *heard; /* of each piece, in this round */
};

static void spread_tell(struct spread *spread, uint32_t from, uint32_t to)
{
    struct hearsay *heard = &spread->heard[to];
    if (!spread->light[from].known || spread->light[to].known)
        return;
    heard->light = rgb_add(heard->light, spread->light[from].light);
    heard->faces++;
}

/* Two neighbours tell each other. */
static void spread_face(struct spread *spread, size_t a, size_t b)
{
    uint32_t p = spread->pieces->of_voxel[a], q = spread->pieces->of_voxel[b];
    if (p == q || p == PIECE_NONE || q == PIECE_NONE)
        return;
    spread_tell(spread, p, q);
    spread_tell(spread, q, p);
}

static void spread_faces(struct spread *spread)
{
    const int *size = spread->voxels->size;
    size_t rows = (size_t)size[0], slices = rows * (size_t)size[1], voxel = 0;
    for (int z = 0; z < size[2]; z++)
        for (int y = 0; y < size[1]; y++)
            for (int x = 0; x < size[0]; x++, voxel++) {
                if (x > 0)
                    spread_face(spread, voxel, voxel - 1);
                if (y > 0)
                    spread_face(spread, voxel, voxel - rows);
                if (z > 0)
                    spread_face(spread, voxel, voxel - slices);
            }
}

/* Those that were told know it from now on. False: there were none, or all are
 * known now. */
static bool spread_round(struct spread *spread)
{
    bool told = false, unknown = false;
    for (size_t i = 0; i < spread->pieces->count; i++) {
        struct hearsay *heard = &spread->heard[i];
        struct piece_light *light = &spread->light[i];
        if (light->known)
            continue;
        if (!(heard->faces > 0)) {
            unknown = true;
            continue;
        }
        light->light = rgb_scale(heard->light, 1 / heard->faces);
        light->known = told = true;
    }
    return told && unknown;
}

void spread_light(const struct pieces *pieces, const struct voxels *voxels,
                  struct piece_light *light)
{
    struct spread spread = {
        .pieces = pieces,
        .voxels = voxels,
        .light = light,
        .heard = memory_new(pieces->count * sizeof *spread.heard),
    };
    do
        spread_faces(&spread);
    while (spread_round(&spread));
    memory_free(spread.heard);
}
