/* Rays and pieces of a sphere_sweep: see sweep_lanes.h. All balls between the
 * ends of a piece touch a cone. That of the share s at which
 * |p - c(s)|^2 - r(s)^2 is least touches it nearest to p: s is
 * (w axis + r0 dr) / a, w from the first ball's middle, a = axis^2 - dr^2. The
 * cone is convex, and the piece lies in it: who misses it misses the piece, and
 * who crosses it twice between the balls meets nothing else. */
#include "scene/sweep_lanes.h"

#include "base/clones.h"

/* The coordinates of a ball in arrays of such. */
enum { AT_X, AT_Y, AT_Z, RADIUS };

void sweep_lanes_set(struct sweep_lanes *lanes, size_t i,
                     const struct ball *from, const struct ball *to, bool first)
{
    const double begin[4] = { from->at.x, from->at.y, from->at.z,
                              from->radius };
    const double end[4] = { to->at.x, to->at.y, to->at.z, to->radius };
    double a = 0;
    for (int k = 0; k < 4; k++) {
        double way = end[k] - begin[k];
        lanes->from[k][i] = begin[k];
        lanes->axis[k][i] = way;
        a += k == RADIUS ? -way * way : way * way;
    }
    lanes->part[i] = a > 0 ? 1 / a : 0;
    lanes->first[i] = first;
}

/* The ray and the cones, seen from the points of the ray that are nearest to
 * the first balls' middles, where numbers are small. */
struct cone_lanes {
    double shift[OCTET]; /* where that point is */
    double w[3][OCTET];  /* from the middle to it */
    double along[OCTET]; /* s is (along + t speed) part */
    double speed[OCTET];
    double square[OCTET]; /* of square t^2 + 2 middle t + rest */
    double middle[OCTET], rest[OCTET];
};

/* Fills in the cones; `flag`: which the ray may meet. */
CLONES static void lanes_cones(const struct sweep_lanes *restrict lanes,
                               const struct ray *restrict ray,
                               struct cone_lanes *restrict cones,
                               lane_flag *restrict flag)
{
    const vec3 o = ray->origin, d = ray->direction;
    const double dd = vec3_dot(d, d), part = 1 / dd;
    for (int i = 0; i < OCTET; i++) {
        double x = o.x - lanes->from[AT_X][i], y = o.y - lanes->from[AT_Y][i];
        double z = o.z - lanes->from[AT_Z][i], r = lanes->from[RADIUS][i];
        double shift = -(x * d.x + y * d.y + z * d.z) * part;
        x += shift * d.x;
        y += shift * d.y;
        z += shift * d.z;
        double ax = lanes->axis[AT_X][i], ay = lanes->axis[AT_Y][i];
        double az = lanes->axis[AT_Z][i], a1 = lanes->part[i];
        double along = x * ax + y * ay + z * az + r * lanes->axis[RADIUS][i];
        double speed = d.x * ax + d.y * ay + d.z * az;
        double square = dd - speed * speed * a1;
        double middle = (x * d.x + y * d.y + z * d.z) - along * speed * a1;
        double rest = x * x + y * y + z * z - r * r - along * along * a1;
        cones->shift[i] = shift;
        cones->w[0][i] = x;
        cones->w[1][i] = y;
        cones->w[2][i] = z;
        cones->along[i] = along;
        cones->speed[i] = speed;
        cones->square[i] = square;
        cones->middle[i] = middle;
        cones->rest[i] = rest;
        bool missed =
            (a1 > 0) & (square > 0) & !(middle * middle - square * rest > 0);
        flag[i] = missed ? 0 : -1;
    }
}

/* Where it crosses the cones between the balls; `flag`: who may meet balls. */
CLONES static void lanes_cross(const struct sweep_lanes *restrict lanes,
                               const struct cone_lanes *restrict cones,
                               struct sweep_stretches *restrict found,
                               lane_flag *restrict met,
                               lane_flag *restrict flag)
{
    for (int i = 0; i < OCTET; i++) {
        double square = cones->square[i], middle = cones->middle[i];
        double rest = cones->rest[i], a1 = lanes->part[i];
        double discriminant = middle * middle - square * rest;
        double root = sqrt(discriminant > 0 ? discriminant : 0);
        double q = -(middle + copysign(root, middle));
        double first = q / square, second = rest / q;
        double s1 = (cones->along[i] + first * cones->speed[i]) * a1;
        double s2 = (cones->along[i] + second * cones->speed[i]) * a1;
        bool two = (a1 > 0) & (discriminant > 0) & (square != 0);
        bool on1 = two & (s1 >= 0) & (s1 <= 1);
        bool on2 = two & (s2 >= 0) & (s2 <= 1);
        bool before =
            two & (square > 0) & (s1 < 0) & (s2 < 0) & !(lanes->first[i] > 0);
        double t1 = on1 ? first : second, t2 = on2 ? second : first;
        double near = t1 < t2 ? t1 : t2, far = t1 < t2 ? t2 : t1;
        bool any = on1 | on2, whole = on1 & on2 & (square > 0);
        found->near[i] = any ? near : (double)INFINITY;
        found->far[i] = any ? far : -(double)INFINITY;
        flag[i] = met[i] & ((before | whole) ? 0 : -1);
        met[i] = before ? 0 : met[i];
    }
}

/* Joins the ray's way through both balls of those that are asked for. */
CLONES static void lanes_balls(const struct sweep_lanes *restrict lanes,
                               const struct ray *restrict ray,
                               const struct cone_lanes *restrict cones,
                               const lane_flag *restrict asked,
                               struct sweep_stretches *restrict found)
{
    const vec3 d = ray->direction;
    const double dd = vec3_dot(d, d), part = 1 / dd;
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < OCTET; i++) {
            double x = cones->w[0][i] - k * lanes->axis[AT_X][i];
            double y = cones->w[1][i] - k * lanes->axis[AT_Y][i];
            double z = cones->w[2][i] - k * lanes->axis[AT_Z][i];
            double r = lanes->from[RADIUS][i] + k * lanes->axis[RADIUS][i];
            double middle = -(x * d.x + y * d.y + z * d.z) * part;
            x += middle * d.x;
            y += middle * d.y;
            z += middle * d.z;
            double rest = (r * r - (x * x + y * y + z * z)) * part;
            double half = sqrt(rest > 0 ? rest : 0);
            bool hit = (asked[i] != 0) & (rest > 0);
            double near = middle - half, far = middle + half;
            found->near[i] =
                (hit & (near < found->near[i])) ? near : found->near[i];
            found->far[i] = (hit & (far > found->far[i])) ? far : found->far[i];
        }
}

/* As the ray counts. */
CLONES static void lanes_shift(const struct cone_lanes *restrict cones,
                               const lane_flag *restrict met,
                               struct sweep_stretches *restrict found)
{
    for (int i = 0; i < OCTET; i++) {
        double near = found->near[i] + cones->shift[i];
        double far = found->far[i] + cones->shift[i];
        found->near[i] = met[i] ? near : (double)INFINITY;
        found->far[i] = met[i] ? far : -(double)INFINITY;
    }
}

static bool lanes_any(const lane_flag *flag)
{
    lane_flag any = 0;
    for (int i = 0; i < OCTET; i++)
        any |= flag[i];
    return any != 0;
}

bool sweep_lanes_meet(const struct sweep_lanes *lanes, const struct ray *ray,
                      struct sweep_stretches *found)
{
    LANE_LINES lane_flag met[OCTET], asked[OCTET];
    LANE_LINES struct cone_lanes cones;
    lanes_cones(lanes, ray, &cones, met);
    if (!lanes_any(met))
        return false;
    lanes_cross(lanes, &cones, found, met, asked);
    if (lanes_any(asked))
        lanes_balls(lanes, ray, &cones, asked, found);
    lanes_shift(&cones, met, found);
    return true;
}
