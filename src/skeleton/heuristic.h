/* The interface of the ways to tell from the skeleton how much light reaches a
 * point: one file in heuristic/ and one row in heuristic/list.h each. */
#ifndef SKELETON_HEURISTIC_H
#define SKELETON_HEURISTIC_H

#include "skeleton/pieces.h"
#include "skeleton/skeleton.h"

struct heuristic {
    const char *name;
    const char *help;
    bool wayless; /* it follows no lamp's light: their paths are NULL */
    /* What it finds out once: skeleton->state. NULL: nothing. */
    void *(*start)(const struct skeleton *skeleton);
    void (*finish)(void *state);
    /* The light at a point, whose node is not GRAPH_NONE. Depends on the point
     * alone. */
    struct skeleton_light (*answer)(const struct skeleton *skeleton,
                                    struct worker *worker,
                                    const struct skeleton_point *point);
    /* The answer's `indirect`, if that alone is cheaper; or NULL. */
    rgb (*indirect)(const struct skeleton *skeleton,
                    const struct skeleton_point *point);
    /* The same for places in one voxel taken together; or NULL. */
    rgb (*close)(const struct skeleton *skeleton,
                 const struct skeleton_point *point);
    /* The radiance that comes against a ray that starts in the void, and how
     * far off that starts (HUGE_VAL: out of the grid); `key` names its random
     * numbers. NULL: not known. */
    rgb (*seen)(const struct skeleton *skeleton, const struct ray *ray,
                uint64_t key, double *distance);
    /* How it has cut the void; or NULL. */
    const struct pieces *(*pieces)(const struct skeleton *skeleton);
    /* What a surface outside of the grid gets besides; NULL: nothing. */
    rgb (*outside)(const struct skeleton *skeleton, vec3 normal);
};

/* By name, or NULL; by number, or NULL past the end. The first is the
 * default. */
const struct heuristic *heuristic_find(const char *name);
const struct heuristic *heuristic_at(size_t index);

#endif
