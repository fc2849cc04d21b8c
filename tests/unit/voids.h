/* The voids that the skeleton's tests know everything about: rooms carved out
 * of solid rock, also with rough walls. */
#ifndef TESTS_UNIT_VOIDS_H
#define TESTS_UNIT_VOIDS_H

#include <stdlib.h>
#include <string.h>

#include "base/random.h"
#include "skeleton/voxels.h"

struct void_box {
    int from[3], to[3]; /* half open */
    int fill;           /* 1: void, 0: matter */
};

/* Boxes in this order; `light` is inside of the void, in world units (a voxel
 * has 0.1). */
struct void_case {
    const char *name;
    int size[3];
    struct void_box boxes[40];
    vec3 light;
};

#define CARVE(x0, x1, y0, y1, z0, z1)                                          \
    {                                                                          \
        { x0, y0, z0 }, { x1, y1, z1 }, 1                                      \
    }
#define REFILL(x0, x1, y0, y1, z0, z1)                                         \
    {                                                                          \
        { x0, y0, z0 }, { x1, y1, z1 }, 0                                      \
    }
#define ROOM(a, b)                                                             \
    CARVE(4 + 34 * a, 34 + 34 * a, 2, 27, 4 + 34 * b, 34 + 34 * b)
#define DOOR(x0, x1, z0, z1) CARVE(x0, x1, 2, 20, z0, z1)
#define PILLARS(k)                                                             \
    REFILL(14 + 18 * k, 20 + 18 * k, 2, 48, 16, 20),                           \
        REFILL(14 + 18 * k, 20 + 18 * k, 2, 48, 40, 44)

static const struct void_case void_box = {
    "box", { 64, 40, 64 }, { CARVE(2, 62, 2, 38, 2, 62) }, { 3.2, 3.0, 3.2 }
};

static const struct void_case void_u = { "u",
                                         { 100, 30, 100 },
                                         { CARVE(2, 98, 2, 26, 2, 26),
                                           CARVE(74, 98, 2, 26, 2, 98),
                                           CARVE(2, 98, 2, 26, 74, 98) },
                                         { 0.9, 1.9, 1.4 } };

static const struct void_case void_rooms = {
    "rooms",
    { 128, 36, 98 },
    { CARVE(2, 40, 2, 32, 2, 40), CARVE(40, 44, 2, 22, 14, 24),
      CARVE(44, 60, 2, 32, 2, 94), CARVE(60, 64, 2, 22, 76, 88),
      CARVE(64, 124, 2, 32, 60, 94), CARVE(60, 64, 2, 22, 10, 18),
      CARVE(64, 124, 2, 32, 2, 50), REFILL(90, 96, 2, 32, 74, 80) },
    { 2.0, 2.6, 2.0 }
};

static const struct void_case void_nine = {
    "nine",
    { 106, 30, 106 },
    { ROOM(0, 0), ROOM(1, 0), ROOM(2, 0), ROOM(0, 1), ROOM(1, 1), ROOM(2, 1),
      ROOM(0, 2), ROOM(1, 2), ROOM(2, 2), DOOR(34, 38, 12, 22),
      DOOR(68, 72, 14, 24), DOOR(80, 90, 34, 38), DOOR(34, 38, 48, 58),
      DOOR(12, 22, 34, 38), DOOR(46, 56, 68, 72), DOOR(68, 72, 80, 90),
      DOOR(12, 22, 68, 72) },
    { 1.9, 2.2, 1.9 }
};

static const struct void_case void_hall = {
    "hall",
    { 140, 50, 60 },
    { CARVE(2, 138, 2, 48, 2, 58), PILLARS(0), PILLARS(1), PILLARS(2),
      PILLARS(3), PILLARS(4), PILLARS(5), PILLARS(6),
      REFILL(2, 138, 28, 48, 16, 20), REFILL(2, 138, 28, 48, 40, 44) },
    { 1.0, 3.8, 3.0 }
};

static inline struct voxels void_case_new(const struct void_case *what)
{
    struct voxels v = { .edge = 0.1 };
    memcpy(v.size, what->size, sizeof v.size);
    v.empty = calloc(1, voxels_count(&v));
    for (const struct void_box *box = what->boxes; box->to[0] > 0; box++)
        for (int z = box->from[2]; z < box->to[2]; z++)
            for (int y = box->from[1]; y < box->to[1]; y++)
                for (int x = box->from[0]; x < box->to[0]; x++)
                    v.empty[voxels_index(&v, x, y, z)] = (uint8_t)box->fill;
    return v;
}

/* One in five of the void voxels at a wall becomes matter. */
static inline void void_case_roughen(struct voxels *v, uint64_t seed)
{
    uint8_t *before = malloc(voxels_count(v));
    size_t rows = (size_t)v->size[0], slices = rows * (size_t)v->size[1];
    memcpy(before, v->empty, voxels_count(v));
    for (size_t i = slices; i < voxels_count(v) - slices; i++)
        if (before[i] &&
            !(before[i - 1] && before[i + 1] && before[i - rows] &&
              before[i + rows] && before[i - slices] && before[i + slices]) &&
            random_unit(random_key(seed, i)) < 0.2)
            v->empty[i] = 0;
    free(before);
}

static inline void void_case_free(struct voxels *v)
{
    free(v->empty);
}

#endif
