/* Affine maps of space: points, directions, normals; composition, inverse.
 * Column-vector convention: p' = m p + t, t in column 3. */
#ifndef BASE_AFFINE_H
#define BASE_AFFINE_H

#include "base/vec.h"

struct arena;

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

/* Whether it only moves and scales: the axes stay what they are, and point to
 * the same side. */
bool affine_is_along_axes(affine a);

/* The other side of a box that ends on one side alone; else everything. */
struct box3 box3_complement(struct box3 box);

/* The identity, which whoever is not moved can point to. */
extern const affine affine_unmoved;

/* The map in `arena`, or affine_unmoved if it is the identity. */
const affine *affine_kept(struct arena *arena, const affine *a);

static inline vec3 affine_direction(const affine *a, vec3 d)
{
    return (vec3){
        a->m[0][0] * d.x + a->m[0][1] * d.y + a->m[0][2] * d.z,
        a->m[1][0] * d.x + a->m[1][1] * d.y + a->m[1][2] * d.z,
        a->m[2][0] * d.x + a->m[2][1] * d.y + a->m[2][2] * d.z,
    };
}

static inline vec3 affine_point(const affine *a, vec3 p)
{
    vec3 d = affine_direction(a, p);
    return (vec3){ d.x + a->m[0][3], d.y + a->m[1][3], d.z + a->m[2][3] };
}

/* Multiplies n by the transpose of a's linear part: given the world-to-object
 * map, takes an object-space normal to world space. Not normalised. */
static inline vec3 affine_normal(const affine *inverse, vec3 n)
{
    const affine *a = inverse;
    return (vec3){
        a->m[0][0] * n.x + a->m[1][0] * n.y + a->m[2][0] * n.z,
        a->m[0][1] * n.x + a->m[1][1] * n.y + a->m[2][1] * n.z,
        a->m[0][2] * n.x + a->m[1][2] * n.y + a->m[2][2] * n.z,
    };
}

/* The cofactors of the linear part, row by row: the inverse transpose times the
 * determinant. */
struct cofactors {
    vec3 row[3];
    double determinant;
};

struct cofactors affine_cofactors(const affine *a);

/* The box around the image of `box`; infinite sides stay infinite. */
struct box3 affine_box(const affine *a, struct box3 box);

struct box3 box3_empty(void);
struct box3 box3_infinite(void);
struct box3 box3_union(struct box3 a, struct box3 b);
struct box3 box3_intersection(struct box3 a, struct box3 b);

/* As POV-Ray sees it, to which nothing is larger than 1e10 (measured). */
double box3_volume(struct box3 box);
struct box3 box3_add(struct box3 a, vec3 p);
static inline bool box3_is_empty(struct box3 a)
{
    return a.low.x > a.high.x || a.low.y > a.high.y || a.low.z > a.high.z;
}

bool box3_is_finite(struct box3 a);

/* By so much on each side. */
static inline struct box3 box3_grown(struct box3 a, double by)
{
    const vec3 more = vec3_make(by, by, by);
    return (struct box3){ vec3_sub(a.low, more), vec3_add(a.high, more) };
}

/* Squared distance of the point from it; 0 inside. */
static inline double box3_distance2(struct box3 a, vec3 p)
{
    vec3 below = vec3_sub(a.low, p), above = vec3_sub(p, a.high);
    vec3 out = vec3_make(fmax(fmax(below.x, above.x), 0),
                         fmax(fmax(below.y, above.y), 0),
                         fmax(fmax(below.z, above.z), 0));
    return vec3_dot(out, out);
}

/* Half of its surface. */
static inline double box3_half_area(struct box3 a)
{
    double x = a.high.x - a.low.x, y = a.high.y - a.low.y;
    double z = a.high.z - a.low.z;
    return x * y + y * z + z * x;
}

static inline bool box3_contains(struct box3 a, vec3 p)
{
    return (p.x >= a.low.x) & (p.x <= a.high.x) & (p.y >= a.low.y) &
           (p.y <= a.high.y) & (p.z >= a.low.z) & (p.z <= a.high.z);
}

#endif
