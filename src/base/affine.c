/* Affine maps: see affine.h. */
#include "base/affine.h"

#include "base/arena.h"

const affine affine_unmoved = {
    { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 } }
};

affine affine_identity(void)
{
    return affine_unmoved;
}

const affine *affine_kept(struct arena *arena, const affine *a)
{
    if (affine_is_identity(*a))
        return &affine_unmoved;
    affine *kept = ARENA_NEW(arena, affine);
    *kept = *a;
    return kept;
}

affine affine_translation(vec3 t)
{
    return (affine){ { { 1, 0, 0, t.x }, { 0, 1, 0, t.y }, { 0, 0, 1, t.z } } };
}

affine affine_scaling(vec3 s)
{
    return (affine){ { { s.x, 0, 0, 0 }, { 0, s.y, 0, 0 }, { 0, 0, s.z, 0 } } };
}

affine affine_axis_rotation(vec3 axis, double degrees)
{
    vec3 u = vec3_normalise(axis);
    double angle = degrees * (M_PI / 180);
    double c = cos(angle), s = sin(angle), k = 1 - c;
    return (affine){ {
        { c + u.x * u.x * k, u.x * u.y * k - u.z * s, u.x * u.z * k + u.y * s,
          0 },
        { u.y * u.x * k + u.z * s, c + u.y * u.y * k, u.y * u.z * k - u.x * s,
          0 },
        { u.z * u.x * k - u.y * s, u.z * u.y * k + u.x * s, c + u.z * u.z * k,
          0 },
    } };
}

affine affine_rotation(vec3 degrees)
{
    affine x = affine_axis_rotation(vec3_make(1, 0, 0), degrees.x);
    affine y = affine_axis_rotation(vec3_make(0, 1, 0), degrees.y);
    affine z = affine_axis_rotation(vec3_make(0, 0, 1), degrees.z);
    return affine_compose(z, affine_compose(y, x));
}

affine affine_compose(affine outer, affine inner)
{
    affine out;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            double sum = j == 3 ? outer.m[i][3] : 0;
            for (int k = 0; k < 3; k++)
                sum += outer.m[i][k] * inner.m[k][j];
            out.m[i][j] = sum;
        }
    }
    return out;
}

double affine_determinant(affine a)
{
    vec3 x = { a.m[0][0], a.m[1][0], a.m[2][0] };
    vec3 y = { a.m[0][1], a.m[1][1], a.m[2][1] };
    vec3 z = { a.m[0][2], a.m[1][2], a.m[2][2] };
    return vec3_dot(x, vec3_cross(y, z));
}

struct cofactors affine_cofactors(const affine *a)
{
    vec3 row[3];
    for (int i = 0; i < 3; i++)
        row[i] = vec3_make(a->m[i][0], a->m[i][1], a->m[i][2]);
    vec3 first = vec3_cross(row[1], row[2]);
    return (struct cofactors){ { first, vec3_cross(row[2], row[0]),
                                 vec3_cross(row[0], row[1]) },
                               vec3_dot(row[0], first) };
}

/* Whether it only turns, to the last digits. */
static bool affine_turns(const affine *a, double determinant)
{
    const double rounding = 4e-16;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j <= i; j++) {
            double dot = a->m[0][i] * a->m[0][j] + a->m[1][i] * a->m[1][j] +
                         a->m[2][i] * a->m[2][j];
            if (fabs(dot - (i == j)) > rounding)
                return false;
        }
    return determinant > 0;
}

/* Of the linear part. */
static double inverse_entry(const affine *a, double determinant, int i, int j)
{
    int i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
    return (a->m[j1][i1] * a->m[j2][i2] - a->m[j1][i2] * a->m[j2][i1]) /
           determinant;
}

/* The inverses of scalings and rotations are as exact as these. */
bool affine_inverse(affine a, affine *inverse)
{
    double determinant = affine_determinant(a);
    if (determinant == 0 || !isfinite(determinant))
        return false;
    affine out = affine_identity();
    bool scaling = affine_is_along_axes(a);
    bool turns = !scaling && affine_turns(&a, determinant);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            if (scaling)
                out.m[i][j] = i == j ? 1 / a.m[i][i] : 0;
            else
                out.m[i][j] =
                    turns ? a.m[j][i] : inverse_entry(&a, determinant, i, j);
    for (int i = 0; i < 3; i++)
        out.m[i][3] = -(out.m[i][0] * a.m[0][3] + out.m[i][1] * a.m[1][3] +
                        out.m[i][2] * a.m[2][3]);
    *inverse = out;
    return true;
}

bool affine_is_identity(affine a)
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 4; j++)
            if (a.m[i][j] != (i == j ? 1 : 0))
                return false;
    return true;
}

bool affine_is_along_axes(affine a)
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            if (i == j ? !(a.m[i][j] > 0) : a.m[i][j] != 0)
                return false;
    return true;
}

struct box3 box3_complement(struct box3 box)
{
    double low[3] = { box.low.x, box.low.y, box.low.z };
    double high[3] = { box.high.x, box.high.y, box.high.z };
    int finite = 0, axis = 0;
    bool upper = false;
    for (int i = 0; i < 3; i++) {
        if (isfinite(low[i]) || isfinite(high[i])) {
            finite += isfinite(low[i]) + isfinite(high[i]);
            axis = i;
            upper = isfinite(high[i]);
        }
    }
    struct box3 other = box3_infinite();
    if (finite != 1)
        return other;
    double *side = upper ? &other.low.x : &other.high.x;
    side[axis] = upper ? high[axis] : low[axis];
    return other;
}

/* Arvo 1990: per output axis, each input interval adds its smaller and larger
 * product. Zero coefficients are skipped so that 0 * infinity can't arise. */
struct box3 affine_box(const affine *a, struct box3 box)
{
    double low[3], high[3];
    if (box3_is_empty(box))
        return box;
    for (int i = 0; i < 3; i++) {
        low[i] = high[i] = a->m[i][3];
        for (int j = 0; j < 3; j++) {
            double k = a->m[i][j];
            if (k == 0)
                continue;
            double u = k * vec3_component(box.low, j);
            double v = k * vec3_component(box.high, j);
            low[i] += lesser(u, v);
            high[i] += greater(v, u);
        }
    }
    return (struct box3){ { low[0], low[1], low[2] },
                          { high[0], high[1], high[2] } };
}

struct box3 box3_empty(void)
{
    return (struct box3){ { HUGE_VAL, HUGE_VAL, HUGE_VAL },
                          { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL } };
}

struct box3 box3_infinite(void)
{
    return (struct box3){ { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL },
                          { HUGE_VAL, HUGE_VAL, HUGE_VAL } };
}

struct box3 box3_union(struct box3 a, struct box3 b)
{
    return (struct box3){ vec3_min(a.low, b.low), vec3_max(a.high, b.high) };
}

struct box3 box3_intersection(struct box3 a, struct box3 b)
{
    return (struct box3){ vec3_max(a.low, b.low), vec3_min(a.high, b.high) };
}

double box3_volume(struct box3 box)
{
    enum { SIDES = 3 };
    const double most = 1e10;
    const double low[SIDES] = { box.low.x, box.low.y, box.low.z };
    const double high[SIDES] = { box.high.x, box.high.y, box.high.z };
    double volume = 1;
    for (int i = 0; i < SIDES; i++)
        volume *= fmax(fmin(high[i], most) - fmax(low[i], -most), 0);
    return volume;
}

struct box3 box3_add(struct box3 a, vec3 p)
{
    return (struct box3){ vec3_min(a.low, p), vec3_max(a.high, p) };
}

bool box3_is_finite(struct box3 a)
{
    return vec3_finite(a.low) && vec3_finite(a.high);
}
