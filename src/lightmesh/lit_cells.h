/* The places where lamps light what gather rays meet: virtual lights
 * (virtual_lights.h) bring their light to mesh points. */
#ifndef LIGHTMESH_LIT_CELLS_H
#define LIGHTMESH_LIT_CELLS_H

#include "lightmesh/bright.h"

/* Those cells that most of the light comes from, of so many hits, which come in
 * any order; as large as they must be to be few. */
struct bright lit_cells_of(const struct bright_hit *hits, size_t count);

#endif
