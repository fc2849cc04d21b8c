/* Lights by voxel and side: see shore.h. Each is written once or more with the
 * same values, its weight last; that is 1 more than it says, so that 0 is what
 * nobody wrote. Voxels are numbered by counting bits, first those of the shore,
 * and those of one side stand together: what rays ask for at random should fit
 * in caches. */
#include "skeleton/shore.h"

#include <stdatomic.h>

#include "base/memory.h"

struct shore_side {
    _Atomic float light[3], weight;
};

enum { SHORE, INLAND, KINDS };

/* 64 voxels. */
struct shore_word {
    uint64_t has[KINDS]; /* bit by voxel */
    size_t before[KINDS];
};

struct shore {
    struct shore_word *words;
    size_t count; /* void voxels */
    struct shore_side *sides;
};

/* Whether a voxel and both its neighbours along x are void. */
static bool is_void_along(const struct voxels *v, int x, int y, int z)
{
    if (y < 0 || y >= v->size[1] || z < 0 || z >= v->size[2] || x < 1 ||
        x + 1 >= v->size[0])
        return false;
    const uint8_t *at = &v->empty[voxels_index(v, x, y, z)];
    return at[-1] & at[0] & at[1];
}

static bool is_inland(const struct voxels *v, int x, int y, int z)
{
    for (int dz = -1; dz <= 1; dz++)
        for (int dy = -1; dy <= 1; dy++)
            if (!is_void_along(v, x, y + dy, z + dz))
                return false;
    return true;
}

struct shore *shore_new(const struct voxels *v)
{
    struct shore *shore = memory_new(sizeof *shore);
    size_t words = voxels_count(v) / 64 + 1, voxel = 0;
    shore->words = memory_new(words * sizeof *shore->words);
    for (int z = 0; z < v->size[2]; z++)
        for (int y = 0; y < v->size[1]; y++)
            for (int x = 0; x < v->size[0]; x++, voxel++)
                if (v->empty[voxel])
                    shore->words[voxel / 64]
                        .has[is_inland(v, x, y, z) ? INLAND : SHORE] |=
                        (uint64_t)1 << voxel % 64;
    for (int kind = 0; kind < KINDS; kind++)
        for (size_t i = 0; i < words; i++) {
            struct shore_word *word = &shore->words[i];
            word->before[kind] = shore->count;
            shore->count += (size_t)__builtin_popcountll(word->has[kind]);
        }
    shore->sides =
        memory_new(SHORE_SIDES * shore->count * sizeof *shore->sides);
    return shore;
}

void shore_free(struct shore *shore)
{
    if (!shore)
        return;
    memory_free(shore->sides);
    memory_free(shore->words);
    memory_free(shore);
}

/* NULL for a voxel that isn't void. */
static struct shore_side *shore_side(const struct shore *shore, size_t voxel,
                                     int side)
{
    const struct shore_word *word = &shore->words[voxel / 64];
    uint64_t bit = (uint64_t)1 << voxel % 64;
    for (int kind = 0; kind < KINDS; kind++) {
        if (!(word->has[kind] & bit))
            continue;
        uint64_t before = word->has[kind] & (bit - 1);
        size_t number =
            word->before[kind] + (size_t)__builtin_popcountll(before);
        return &shore->sides[(size_t)side * shore->count + number];
    }
    return NULL;
}

bool shore_known(const struct shore *shore, size_t voxel, int side,
                 struct shore_light *out)
{
    const struct shore_side *known = shore_side(shore, voxel, side);
    if (!known)
        return false;
    float weight = atomic_load_explicit(&known->weight, memory_order_acquire);
    if (!(weight > 0))
        return false;
    double light[3];
    for (int i = 0; i < 3; i++)
        light[i] = (double)atomic_load_explicit(&known->light[i],
                                                memory_order_relaxed);
    *out = (struct shore_light){ rgb_make(light[0], light[1], light[2]),
                                 (double)weight - 1 };
    return true;
}

void shore_keep(const struct shore *shore, size_t voxel, int side,
                struct shore_light *light)
{
    struct shore_side *known = shore_side(shore, voxel, side);
    double *values[3] = { &light->light.r, &light->light.g, &light->light.b };
    float weight = (float)(light->weight + 1);
    light->weight = (double)weight - 1;
    for (int i = 0; i < 3; i++) {
        float value = (float)*values[i];
        *values[i] = (double)value;
        if (known)
            atomic_store_explicit(&known->light[i], value,
                                  memory_order_relaxed);
    }
    if (known)
        atomic_store_explicit(&known->weight, weight, memory_order_release);
}
