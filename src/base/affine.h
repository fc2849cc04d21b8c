/* Affine maps of space: points, directions, normals; composition, inverse.
 * Column-vector convention: p' = m p + t, t in column 3. */
#ifndef BASE_AFFINE_H
#define BASE_AFFINE_H

#include "base/vec.h"

typedef struct {
    double m[3][4];
} affine;

/* An axis-aligned box; empty when low > high in any axis. Infinite shapes
 * have infinite corners. */
struct box3 {
    vec3 low, high;
};

affine affine_identity(void);
affine affine_translation(vec3 t);
affine affine_scaling(vec3 s);

/* POV-Ray's rotate: degrees about x, then y, then z, left-handed. */
affine affine_rotation(vec3 degrees);

/* The rotation by `degrees` about `axis` through the origin (left-handed), as
 * vaxis_rotate() does. `axis` need not be unit. */
affine affine_axis_rotation(vec3 axis, double degrees);

/* First `inner`, then `outer`. */
affine affine_compose(affine outer, affine inner);

/* Returns false and leaves *inverse alone if the map is singular. */
bool affine_inverse(affine a, affine *inverse);

double affine_determinant(affine a);
bool affine_is_identity(affine a);

vec3 affine_point(const affine *a, vec3 p);
vec3 affine_direction(const affine *a, vec3 d);

/* Multiplies n by the transpose of a's linear part: given the world-to-object
 * map, takes an object-space normal to world space. Not normalised. */
vec3 affine_normal(const affine *inverse, vec3 n);

/* The box around the image of `box`; infinite sides stay infinite. */
struct box3 affine_box(const affine *a, struct box3 box);

struct box3 box3_empty(void);
struct box3 box3_infinite(void);
struct box3 box3_union(struct box3 a, struct box3 b);
struct box3 box3_intersection(struct box3 a, struct box3 b);
struct box3 box3_add(struct box3 a, vec3 p);
bool box3_is_empty(struct box3 a);
bool box3_is_finite(struct box3 a);
bool box3_contains(struct box3 a, vec3 p);

#endif
