/* Between which entries of a map a pattern's value falls. */
#ifndef SCENE_MAP_ENTRY_H
#define SCENE_MAP_ENTRY_H

#include <stddef.h>

/* The entry sought and the share it has; the rest is the entry's before it. A
 * share of 1 is that entry alone: there may be none before it. */
struct map_place {
    size_t entry;
    double share;
};

/* `first` is the value of the first of `count` entries (at least one) in
 * increasing order; `size` is theirs in bytes. Measured: from the last entry's
 * value on the last counts, even where others have that value; else the first
 * whose value is not below. */
static inline struct map_place map_place_of(const double *first, size_t size,
                                            size_t count, double value)
{
    const char *entries = (const char *)first;
    size_t low = 0, high = count - 1;
    if (value >= *(const double *)(const void *)(entries + high * size))
        return (struct map_place){ high, 1 };
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (*(const double *)(const void *)(entries + middle * size) < value)
            low = middle + 1;
        else
            high = middle;
    }
    const double *after = (const double *)(const void *)(entries + low * size);
    if (low == 0 || *after <= value)
        return (struct map_place){ low, 1 };
    const double *before =
        (const double *)(const void *)(entries + (low - 1) * size);
    return (struct map_place){ low, (value - *before) / (*after - *before) };
}

#endif
