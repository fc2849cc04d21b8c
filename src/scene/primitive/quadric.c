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
static inline vec3 quadric_matrix(const struct quadric *q, vec3 p)
{
    return (vec3){
        q->square.x * p.x + (q->mixed.x * p.y + q->mixed.y * p.z) / 2,
        q->square.y * p.y + (q->mixed.x * p.x + q->mixed.z * p.z) / 2,
        q->square.z * p.z + (q->mixed.y * p.x + q->mixed.z * p.y) / 2,
    };
}

static inline double quadric_value(const struct quadric *q, vec3 p)
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

/* Least value of a t^2 + b t for t in [low, high], either of which may be
 * infinite. */
static double least_quadratic(double a, double b, double low, double high)
{
    double least = HUGE_VAL, ends[2] = { low, high };
    for (int i = 0; i < 2; i++) {
        double t = ends[i], value;
        if (isfinite(t))
            value = (a * t + b) * t;
        else if (a != 0)
            value = copysign(HUGE_VAL, a);
        else
            value = b == 0 ? 0 : copysign(HUGE_VAL, b * t);
        least = fmin(least, value);
    }
    double turn = -b / (2 * a);
    if (a > 0 && turn > low && turn < high)
        least = fmin(least, (a * turn + b) * turn);
    return least;
}

/* Least and greatest value of k t for t in [low, high]. */
static double least_linear(double k, double low, double high)
{
    return k == 0 ? 0 : fmin(k * low, k * high);
}

static double least_product(double k, const double *s, const double *t)
{
    if (k == 0)
        return 0;
    if (!isfinite(s[0]) || !isfinite(s[1]) || !isfinite(t[0]) ||
        !isfinite(t[1]))
        return -HUGE_VAL;
    return fmin(least_linear(k * s[0], t[0], t[1]),
                least_linear(k * s[1], t[0], t[1]));
}

/* The largest t >= 0 with a t^2 + b t + c <= 0, for the least possible b and
 * c; 0 if there is none. */
static double last_root(double a, double b, double c)
{
    if (!isfinite(b) || !isfinite(c))
        return HUGE_VAL;
    if (a > 0) {
        double discriminant = b * b - 4 * a * c;
        return discriminant < 0 ? 0
                                : fmax(0, (-b + sqrt(discriminant)) / (2 * a));
    }
    return a == 0 && b > 0 ? fmax(0, -c / b) : HUGE_VAL;
}

/* Narrows [range[i][0], range[i][1]] to where F <= 0 is possible: F is a t^2
 * + b t + c in the i-th coordinate t, with b and c from the other two. */
static void narrow_axis(const struct quadric *q, int i, double range[3][2])
{
    int j = (i + 1) % 3, k = (i + 2) % 3;
    /* The product of axes m and n has the factor mixed[m + n - 1]. */
    const double square[3] = { q->square.x, q->square.y, q->square.z };
    const double mixed[3] = { q->mixed.x, q->mixed.y, q->mixed.z };
    const double linear[3] = { q->linear.x, q->linear.y, q->linear.z };
    double c = q->constant +
               least_quadratic(square[j], linear[j], range[j][0], range[j][1]) +
               least_quadratic(square[k], linear[k], range[k][0], range[k][1]) +
               least_product(mixed[j + k - 1], range[j], range[k]);
    double with_j = mixed[i + j - 1], with_k = mixed[i + k - 1];
    double least = linear[i] + least_linear(with_j, range[j][0], range[j][1]) +
                   least_linear(with_k, range[k][0], range[k][1]);
    double most = linear[i] - least_linear(-with_j, range[j][0], range[j][1]) -
                  least_linear(-with_k, range[k][0], range[k][1]);
    double high = last_root(square[i], least, c);
    double low = -last_root(square[i], -most, c);
    /* A straight line has no bound on the side where it falls. */
    if (square[i] == 0 && least <= 0)
        high = HUGE_VAL;
    if (square[i] == 0 && most >= 0)
        low = -HUGE_VAL;
    range[i][1] = fmin(range[i][1], high);
    range[i][0] = fmax(range[i][0], low);
}

/* Interval arithmetic, a few rounds: the other sides of an intersection often
 * leave little of a paraboloid. */
static struct box3 quadric_within(const void *shape, struct box3 box)
{
    double range[3][2] = { { box.low.x, box.high.x },
                           { box.low.y, box.high.y },
                           { box.low.z, box.high.z } };
    for (int round = 0; round < 9; round++) {
        for (int i = 0; i < 3; i++)
            if (!(range[i][0] <= range[i][1]))
                return box3_empty();
        narrow_axis(shape, round % 3, range);
    }
    return (struct box3){ { range[0][0], range[1][0], range[2][0] },
                          { range[0][1], range[1][1], range[2][1] } };
}

/* With m the matrix above the diagonal, that of a quadric in the place of p is
 * that of one in the place of m p: p is `inward` of a point. */
static bool quadric_move(void *shape, const affine *outward,
                         const affine *inward)
{
    const double near = 1000; /* else the new constant would cancel */
    struct quadric *q = shape;
    double from[4][4] = {
        { q->square.x, q->mixed.x, q->mixed.y, q->linear.x },
        { 0, q->square.y, q->mixed.z, q->linear.y },
        { 0, 0, q->square.z, q->linear.z },
        { 0, 0, 0, q->constant },
    };
    double in[4][4] = { { 0 } }, half[4][4], m[4][4];
    (void)outward;
    for (int i = 0; i < 3; i++) {
        if (!(fabs(inward->m[i][3]) < near))
            return false;
        for (int j = 0; j < 4; j++)
            in[j][i] = inward->m[i][j];
    }
    in[3][3] = 1;
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            half[i][j] = in[i][0] * from[0][j] + in[i][1] * from[1][j] +
                         in[i][2] * from[2][j] + in[i][3] * from[3][j];
    for (int i = 0; i < 4; i++)
        for (int j = 0; j < 4; j++)
            m[i][j] = half[i][0] * in[j][0] + half[i][1] * in[j][1] +
                      half[i][2] * in[j][2] + half[i][3] * in[j][3];
    q->square = vec3_make(m[0][0], m[1][1], m[2][2]);
    q->mixed =
        vec3_make(m[0][1] + m[1][0], m[0][2] + m[2][0], m[1][2] + m[2][1]);
    q->linear =
        vec3_make(m[0][3] + m[3][0], m[1][3] + m[3][1], m[2][3] + m[3][2]);
    q->constant = m[3][3];
    q->bounds = quadric_find_bounds(q);
    return true;
}

/* a t^2 + 2 b t + c along a ray. */
struct along {
    double a, b, c;
};

/* With the operations in POV-Ray's order (measured). */
static inline struct along quadric_along(const struct quadric *q, vec3 o,
                                         vec3 d)
{
    const vec3 s = q->square, m = q->mixed, l = q->linear;
    return (struct along){
        d.x * (s.x * d.x + m.x * d.y + m.y * d.z) +
            d.y * (s.y * d.y + m.z * d.z) + d.z * (s.z * d.z),
        d.x * (s.x * o.x + 0.5 * (m.x * o.y + m.y * o.z + l.x)) +
            d.y * (s.y * o.y + 0.5 * (m.x * o.x + m.z * o.z + l.y)) +
            d.z * (s.z * o.z + 0.5 * (m.y * o.x + m.z * o.y + l.z)),
        o.x * (s.x * o.x + m.x * o.y + m.y * o.z + l.x) +
            o.y * (s.y * o.y + m.z * o.z + l.y) + o.z * (s.z * o.z + l.z) +
            q->constant,
    };
}

/* The crossings in increasing order, INFINITY where there is none, of a unit
 * ray: POV-Ray's to the last bit (measured): what is seen through glass may
 * hang on it. False where digits cancel. */
static inline bool quadric_plain(const struct quadric *q, vec3 origin, vec3 d,
                                 double roots[2])
{
    const double rounding = 1e-15, grazing = 1e-8, far = 1e4;
    const double none = (double)INFINITY;
    struct along line = quadric_along(q, origin, d);
    double rest = line.b * line.b - line.a * line.c, root = sqrt(rest);
    double first = (-line.b - root) / line.a;
    double second = (-line.b + root) / line.a;
    roots[0] = first < second ? first : second;
    roots[1] = first < second ? second : first;
    roots[0] = rest > 0 ? roots[0] : none;
    roots[1] = rest > 0 ? roots[1] : none;
    return (fabs(vec3_dot(d, d) - 1) < rounding) &
           (fabs(rest) > grazing * line.b * line.b) &
           (fabs(line.b) < far * fabs(line.a));
}

/* Begun where the ray passes the shape's origin nothing cancels, however far it
 * comes from. */
static inline void quadric_far(const struct quadric *q, vec3 origin, vec3 d,
                               double roots[2])
{
    double shift = -vec3_dot(origin, d) / vec3_dot(d, d);
    struct along line = quadric_along(q, vec3_along(origin, d, shift), d);
    quadratic_roots_lane(line.a, line.b, line.c, roots);
    roots[0] += shift;
    roots[1] += shift;
}

static void quadric_intersect(const void *shape, const struct ray *ray,
                              struct hits *hits)
{
    double roots[2];
    if (!quadric_plain(shape, ray->origin, ray->direction, roots))
        quadric_far(shape, ray->origin, ray->direction, roots);
    for (int i = 0; i < 2; i++)
        if (roots[i] < (double)INFINITY)
            hits_add(hits, roots[i], 0);
}

CLONES static void plain_lanes(const struct quadric *shape, struct lane_run run,
                               const struct rays *restrict rays,
                               struct rays_crossings *restrict all,
                               lane_flag *restrict plain)
{
    const struct quadric quadric = *shape;
    EACH_LANE(i, run) {
        double roots[2];
        bool is = quadric_plain(&quadric, rays_origin(rays, i),
                                rays_direction(rays, i), roots);
        all->t[0][i] = roots[0];
        all->t[1][i] = roots[1];
        all->part[0][i] = all->part[1][i] = 0;
        plain[i] = is ? -1 : 0;
    }
}

CLONES static void far_lanes(const struct quadric *shape, struct lane_run run,
                             const struct rays *restrict rays,
                             struct rays_crossings *restrict all,
                             const lane_flag *restrict plain)
{
    const struct quadric quadric = *shape;
    EACH_LANE(i, run) {
        double roots[2];
        quadric_far(&quadric, rays_origin(rays, i), rays_direction(rays, i),
                    roots);
        all->t[0][i] = plain[i] ? all->t[0][i] : roots[0];
        all->t[1][i] = plain[i] ? all->t[1][i] : roots[1];
    }
}

static void quadric_all_many(const void *shape, struct lane_run run,
                             const struct rays *rays,
                             struct rays_crossings *all)
{
    LANE_LINES lane_flag plain[RAY_LANES];
    all->count = 2;
    plain_lanes(shape, run, rays, all, plain);
    if (~rays_bits(plain) & lane_run_bits(run))
        far_lanes(shape, run, rays, all, plain);
}

static vec3 quadric_normal(const void *shape, const vec3 *at,
                           const struct hit *hit)
{
    const vec3 point = *at;
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

CLONES static void
quadric_inside_many(const void *shape, struct lane_run run,
                    const struct lane_points *restrict points,
                    lane_flag *restrict inside)
{
    const struct quadric quadric = *(const struct quadric *)shape;
    EACH_LANE(i, run)
        inside[i] =
            quadric_value(&quadric, lane_get(points->at, i)) <= 0 ? -1 : 0;
}

/* F(c + d) = F(c) + grad F(c).d + d.Md, where d is a sum of sides: their
 * squares have one sign, their products two. */
static unsigned quadric_meets(const void *shape, const struct cell *cell)
{
    const struct quadric *quadric = shape;
    vec3 slope = vec3_scale(quadric_matrix(quadric, cell->centre), 2);
    slope = vec3_add(slope, quadric->linear);
    double reach = cell_reach(cell, slope), least = 0, most = 0;
    for (int i = 0; i < 3; i++) {
        vec3 md = quadric_matrix(quadric, cell->side[i]);
        double square = vec3_dot(md, cell->side[i]);
        least += fmin(0, square);
        most += fmax(0, square);
        reach += 2 * fabs(vec3_dot(md, cell->side[(i + 1) % 3]));
    }
    double value = quadric_value(quadric, cell->centre);
    bool apart = value + least - reach > 0 || value + most + reach < 0;
    return apart ? 0 : CELL_SURFACE | CELL_BORDER;
}

const struct primitive quadric_primitive = {
    .name = "quadric",
    .help = "a surface of order 2: ellipsoid, paraboloid, hyperboloid ...",
    .size = sizeof(struct quadric),
    .arguments = quadric_arguments,
    .solid = true,
    .prepare = quadric_prepare,
    .bounds = quadric_bounds,
    .move = quadric_move,
    .within = quadric_within,
    .intersect = quadric_intersect,
    .all_many = quadric_all_many,
    .normal = quadric_normal,
    .inside = quadric_inside,
    .inside_many = quadric_inside_many,
    .meets = quadric_meets,
};
