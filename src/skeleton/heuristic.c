/* The list of heuristics: see heuristic.h. */
#include "skeleton/heuristic.h"

#include <string.h>

#define X(name) extern const struct heuristic name##_heuristic;
#include "skeleton/heuristic/list.h"
#undef X

static const struct heuristic *const heuristics[] = {
#define X(name) &name##_heuristic,
#include "skeleton/heuristic/list.h"
#undef X
};

const struct heuristic *heuristic_at(size_t index)
{
    return index < sizeof heuristics / sizeof *heuristics ? heuristics[index]
                                                          : NULL;
}

const struct heuristic *heuristic_find(const char *name)
{
    for (size_t i = 0; i < sizeof heuristics / sizeof *heuristics; i++)
        if (strcmp(heuristics[i]->name, name) == 0)
            return heuristics[i];
    return NULL;
}
