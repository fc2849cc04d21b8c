/* The light meshes of the paper to the letter (Debelov and Sevastyanov 2002,
 * equations (1) to (5) and (7)): two meshes, DLM and ILM, of points that hold
 * one number for each colour and no direction.
 *
 * Const of phi1 is 1 unit of length. Because (2) multiplies two sums that both
 * hold E / phi1, brightness goes with the square of the lamps': it is a look
 * and no irradiance. Lamps are points; where they fade or have a cone, that
 * multiplies E. D_y of (3) and (5) is the interpolation's, of which points
 * behind the surface or behind a wall are no part. */
#ifndef LIGHTMESH_SCALAR_H
#define LIGHTMESH_SCALAR_H

#include "lightmesh/direct.h"
#include "shade/surface.h"

#define SCALAR_CONST 1.0

/* phi1(t) of (1). */
static inline double scalar_phi1(double t)
{
    return SCALAR_CONST + t;
}

struct scalar_mesh {
    const struct lamps *lamps;
    struct point_mesh direct, indirect;
    struct lattice_view view;
    int samples; /* rays of an ILM point, a square number; 0: no ILM */
};

/* Frees with scalar_mesh_free. The lamps must outlive it. `samples` are the
 * rays of an ILM point, rounded down to a square, 0 for no indirect light; of
 * the options lattice, interpolation, radius and bytes count. */
struct scalar_mesh *scalar_mesh_new(const struct lamps *lamps,
                                    const struct direct_options *options,
                                    int samples);
void scalar_mesh_free(struct scalar_mesh *mesh);

/* E_i / phi1(r_i(y)), of (1) and (2); *direction is the way to the lamp. */
rgb scalar_lamp(const struct lamp *lamp, vec3 point, vec3 *direction);

/* What a point of either mesh holds. */
rgb scalar_held(const void *payload);

/* DirectLight(x), (1). */
rgb scalar_direct(const struct scalar_mesh *mesh, struct worker *worker,
                  vec3 place);

/* I~(y), (7): Emiss(y) and the mean of DirectLight around it, (3). */
rgb scalar_mean(const struct scalar_mesh *mesh, struct worker *worker,
                const struct surface *surface);

/* IndirectLight(x), (4): `key` names the samples. */
rgb scalar_indirect(const struct scalar_mesh *mesh, struct worker *worker,
                    vec3 place, uint64_t key);

/* I~d(y), (5); black without ILM. */
rgb scalar_indirect_mean(const struct scalar_mesh *mesh, struct worker *worker,
                         const struct surface *surface);

#endif
