/* Which of many points a lamp sees, all of them at once and exactly: an
 * irregular z-buffer (Johnson et al. 2005, The Irregular Z-Buffer; Aila and
 * Laine 2004, Alias-Free Shadow Maps). A shadow map asks at the places of its
 * own texels; here the points are sorted into the cells of a cube around the
 * lamp, and each triangle is held against those in the cells that it covers.
 * For many points that is several times cheaper than as many shadow rays. */
#ifndef LIGHTMESH_IRREGULAR_H
#define LIGHTMESH_IRREGULAR_H

#include "world/casters.h"

/* Surface points in single precision, from the casters' centre, and their
 * unit normals on the side that is lit. The arrays have room for
 * irregular_padded(count). */
struct irregular_points {
    size_t count;
    float *place[3], *normal[3];
};

static inline size_t irregular_padded(size_t count)
{
    return (count + 63) / 64 * 64;
}

/* What a thread needs to look. Frees with irregular_free; casters and points
 * must outlive it and not change. */
struct irregular;
struct irregular *irregular_new(const struct casters *casters,
                                const struct irregular_points *points);
void irregular_free(struct irregular *irregular);

/* A bit i % 64 of word i / 64 for each point; bits of points that are not
 * there, up to irregular_padded(count), are 0. */
struct irregular_sight {
    uint64_t *lit;   /* the lamp shines on it from before the surface, and no
                      * certain triangle hides it */
    uint64_t *doubt; /* it is lit, but for what is in a box of the doubtful */
};

/* What the lamp at `location` sees; all that it could see without `shadows`.
 * Triangles nearer to a point than irregular_margin are its own surface.
 * Depends on the arguments alone. */
void irregular_look(struct irregular *irregular, vec3 location, bool shadows,
                    const struct irregular_sight *sight);

/* How far rounding may take a surface from itself, seen from a lamp there. */
double irregular_margin(const struct casters *casters, vec3 location);

#endif
