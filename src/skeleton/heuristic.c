/* The list of heuristics: see heuristic.h. */
#include "skeleton/heuristic.h"

#include "base/listing.h"

#define X(name) extern const struct heuristic name##_heuristic;
#include "skeleton/heuristic/list.h"
#undef X

static const struct heuristic *const heuristics[] = {
#define X(name) &name##_heuristic,
#include "skeleton/heuristic/list.h"
#undef X
};

LISTING(heuristic, heuristic, heuristics);
