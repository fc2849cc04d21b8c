/* quadric { <A,B,C>, <D,E,F>, <G,H,I>, J }:
 * A x^2 + B y^2 + C z^2 + D xy + E xz + F yz + G x + H y + I z + J = 0. */
#include "scene/polynomial.h"
#include "scene/primitive.h"

struct quadric {
    vec3 square, mixed, linear;
    double constant;
    struct box3 bounds;
};

static const struct field quadric_arguments[] = {
    { "square terms", FIELD_VECTOR, offsetof(struct quadric, square), 0, 0,
      "factors of x^2, y^2, z^2", false },
    { "mixed terms", FIELD_VECTOR, offsetof(struct quadric, mixed), 0, 0,
      "factors of xy, xz, yz", false },
    { "linear terms", FIELD_VECTOR, offsetof(struct quadric, linear), 0, 0,
      "factors of x, y, z", false },
    { "constant", FIELD_FLOAT, offsetof(struct quadric, constant), 0, 0,
      "the constant term", false },
    { .name = NULL },
};

/* Half the gradient's part that depends on p: the symmetric matrix times p. */
static vec3 quadric_matrix(const struct quadric *q, vec3 p)
{
    return (vec3){
        q->square.x * p.x + (q->mixed.x * p.y + q->mixed.y * p.z) / 2,
        q->square.y * p.y + (q->mixed.x * p.x + q->mixed.z * p.z) / 2,
        q->square.z * p.z + (q->mixed.y * p.x + q->mixed.z * p.y) / 2,
    };
}

static double quadric_value(const struct quadric *q, vec3 p)
{
    return vec3_dot(vec3_add(quadric_matrix(q, p), q->linear), p) + q->constant;
}

/* An ellipsoid about centre c with F(c) < 0 reaches sqrt(-F(c) (M^-1)_ii)
 * along axis i. A direction the quadric doesn't depend on (a cylinder's axis)
 * is given a 1 in the matrix, to be infinite in the end. */
static struct box3 quadric_find_bounds(const struct quadric *q)
{
    bool free_axis[3] = {
        q->square.x == 0 && q->mixed.x == 0 && q->mixed.y == 0 &&
            q->linear.x == 0,
        q->square.y == 0 && q->mixed.x == 0 && q->mixed.z == 0 &&
            q->linear.y == 0,
        q->square.z == 0 && q->mixed.y == 0 && q->mixed.z == 0 &&
            q->linear.z == 0,
    };
    double a = free_axis[0] ? 1 : q->square.x;
    double b = free_axis[1] ? 1 : q->square.y;
    double c = free_axis[2] ? 1 : q->square.z;
    double d = q->mixed.x / 2, e = q->mixed.y / 2, f = q->mixed.z / 2;
    affine matrix = { { { a, d, e, 0 }, { d, b, f, 0 }, { e, f, c, 0 } } };
    affine inverse;
    bool definite = a > 0 && a * b - d * d > 1e-12 * a * b &&
                    affine_determinant(matrix) > 1e-12 * a * b * c &&
                    affine_inverse(matrix, &inverse);
    if (!definite)
        return box3_infinite();
    vec3 centre = vec3_scale(affine_direction(&inverse, q->linear), -0.5);
    double depth = -quadric_value(q, centre);
    if (depth < 0)
        return box3_empty();
    double half[3];
    for (int i = 0; i < 3; i++)
        half[i] = free_axis[i]
                      ? HUGE_VAL
                      : sqrt(depth * fmax(0, inverse.m[i][i])) * (1 + 1e-9);
    vec3 size = { half[0], half[1], half[2] };
    return (struct box3){ vec3_sub(centre, size), vec3_add(centre, size) };
}

static const char *quadric_prepare(void *shape, struct arena *arena,
                                   const char **warning)
{
    struct quadric *quadric = shape;
    (void)arena;
    (void)warning;
    quadric->bounds = quadric_find_bounds(quadric);
    return NULL;
}

static struct box3 quadric_bounds(const void *shape)
{
    const struct quadric *quadric = shape;
    return quadric->bounds;
}

/* The ray starts where it passes the shape's origin: from afar the
 * coefficients would cancel. */
static void quadric_intersect(const void *shape, const struct ray *ray,
                              struct hits *hits)
{
    const struct quadric *quadric = shape;
    vec3 d = ray->direction;
    double shift = -vec3_dot(ray->origin, d) / vec3_dot(d, d);
    vec3 o = ray_point(ray, shift);
    vec3 md = quadric_matrix(quadric, d);
    double a = vec3_dot(md, d);
    double b = vec3_dot(md, o) + vec3_dot(quadric->linear, d) / 2;
    double roots[2];
    int count = quadratic_roots(a, b, quadric_value(quadric, o), roots);
    for (int i = 0; i < count; i++)
        hits_add(hits, roots[i] + shift, 0);
}

static vec3 quadric_normal(const void *shape, vec3 point, const struct hit *hit)
{
    const struct quadric *quadric = shape;
    vec3 slope = vec3_scale(quadric_matrix(quadric, point), 2);
    vec3 normal = vec3_add(slope, quadric->linear);
    (void)hit;
    return vec3_dot(normal, normal) > 0 ? normal : vec3_make(1, 0, 0);
}

static bool quadric_inside(const void *shape, vec3 point)
{
    return quadric_value(shape, point) <= 0;
}

const struct primitive quadric_primitive = {
    .name = "quadric",
    .help = "a surface of order 2: ellipsoid, paraboloid, hyperboloid ...",
    .size = sizeof(struct quadric),
    .arguments = quadric_arguments,
    .solid = true,
    .bounded = true,
    .prepare = quadric_prepare,
    .bounds = quadric_bounds,
    .intersect = quadric_intersect,
    .normal = quadric_normal,
    .inside = quadric_inside,
};
