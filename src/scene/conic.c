/* Cones and cylinders: see conic.h. With p from the base, s = p.axis and q the
 * rest of p, the wall is |q|^2 = r(s)^2 with r(s) = base_radius + slope s. */
#include "scene/conic.h"

#include "scene/polynomial.h"

enum { CONIC_WALL, CONIC_BASE, CONIC_APEX };

bool conic_prepare(struct conic *conic)
{
    vec3 axis = vec3_sub(conic->apex, conic->base);
    conic->height = vec3_length(axis);
    if (!(conic->height > 0) || !isfinite(conic->height))
        return false;
    conic->axis = vec3_scale(axis, 1 / conic->height);
    conic->slope = (conic->apex_radius - conic->base_radius) / conic->height;
    return true;
}

static struct box3 rim_bounds(vec3 centre, vec3 n, double radius)
{
    double r = fabs(radius);
    vec3 half = { r * sqrt(fmax(0, 1 - n.x * n.x)),
                  r * sqrt(fmax(0, 1 - n.y * n.y)),
                  r * sqrt(fmax(0, 1 - n.z * n.z)) };
    return (struct box3){ vec3_sub(centre, half), vec3_add(centre, half) };
}

struct box3 conic_bounds(const void *shape)
{
    const struct conic *conic = shape;
    return box3_union(rim_bounds(conic->base, conic->axis, conic->base_radius),
                      rim_bounds(conic->apex, conic->axis, conic->apex_radius));
}

/* Around the box around the wider end's cylinder, as that stands when z is
 * turned the shortest way from the narrower end to the wider. */
struct box3 conic_told(const void *shape, const affine *place)
{
    const struct conic *conic = shape;
    bool down = fabs(conic->base_radius) >= fabs(conic->apex_radius);
    vec3 axis = down ? vec3_negate(conic->axis) : conic->axis;
    vec3 z = { 0, 0, 1 }, about = vec3_cross(z, axis);
    double radius = fabs(down ? conic->base_radius : conic->apex_radius);
    double degrees = atan2(vec3_length(about), axis.z) * 180 / M_PI;
    if (vec3_dot(about, about) == 0)
        about = vec3_make(1, 0, 0);
    affine turned =
        affine_compose(affine_translation(down ? conic->apex : conic->base),
                       affine_axis_rotation(about, degrees));
    turned = affine_compose(*place, turned);
    return affine_box(&turned,
                      (struct box3){ { -radius, -radius, 0 },
                                     { radius, radius, conic->height } });
}

/* POV-Ray keeps the map of these: moved they only cost less. */
bool conic_move(void *shape, const affine *outward, const affine *inward)
{
    struct conic *conic = shape;
    double scale = outward->m[0][0];
    (void)inward;
    if (!affine_is_along_axes(*outward) || outward->m[1][1] != scale ||
        outward->m[2][2] != scale)
        return false;
    conic->base = affine_point(outward, conic->base);
    conic->apex = affine_point(outward, conic->apex);
    conic->base_radius *= scale;
    conic->apex_radius *= scale;
    return conic_prepare(conic);
}

static inline vec3 reject(vec3 p, vec3 axis, double along)
{
    return vec3_along(p, axis, -along);
}

/* The wall along a ray: a t^2 + 2 b t + c is below 0 inside it, and s + ds t is
 * how far along the axis. All begins at t = shift, where the ray passes the
 * middle of the axis, so that far rays lose no digits. */
struct wall {
    double shift, s, ds, a, b, c;
    double from; /* along the axis at t = 0 */
};

/* The origin `o` is from the base. */
static inline struct wall wall_along(const struct conic *conic, vec3 o, vec3 d)
{
    struct wall wall;
    vec3 middle = vec3_scale(conic->axis, conic->height / 2);
    wall.shift = vec3_dot(vec3_sub(middle, o), d) / vec3_dot(d, d);
    vec3 near = vec3_along(o, d, wall.shift);
    wall.s = vec3_dot(near, conic->axis);
    wall.ds = vec3_dot(d, conic->axis);
    wall.from = vec3_dot(o, conic->axis);
    vec3 q = reject(near, conic->axis, wall.s);
    vec3 dq = reject(d, conic->axis, wall.ds);
    double r = conic->base_radius + conic->slope * wall.s;
    double dr = conic->slope * wall.ds;
    wall.a = vec3_dot(dq, dq) - dr * dr;
    wall.b = vec3_dot(q, dq) - r * dr;
    wall.c = vec3_dot(q, q) - r * r;
    return wall;
}

static void intersect_wall(const struct conic *conic, const struct wall *wall,
                           struct hits *hits)
{
    double roots[2];
    int count = quadratic_roots(wall->a, wall->b, wall->c, roots);
    for (int i = 0; i < count; i++) {
        double along = wall->s + roots[i] * wall->ds;
        if (along >= 0 && along <= conic->height)
            hits_add(hits, roots[i] + wall->shift, CONIC_WALL);
    }
}

/* The disc that closes an end; the line passes its plane. */
static void intersect_cap(const struct conic *conic, const struct ray *line,
                          const struct wall *wall, int part, struct hits *hits)
{
    bool base = part == CONIC_BASE;
    double height = base ? 0 : conic->height;
    double radius = base ? conic->base_radius : conic->apex_radius;
    double t = (height - wall->from) / wall->ds;
    vec3 p = ray_point(line, t);
    vec3 q = reject(p, conic->axis, vec3_dot(p, conic->axis));
    if (vec3_dot(q, q) <= radius * radius)
        hits_add(hits, t, part);
}

/* Whether the wall, continued, is a cylinder or a single cone to the ray, which
 * passes it by without coming near the caps. */
static bool wall_is_missed(const struct conic *conic, const struct wall *wall)
{
    return wall->a > 0 && conic->base_radius >= 0 && conic->apex_radius >= 0 &&
           wall->b * wall->b < wall->a * wall->c * (1 - 1e-9);
}

void conic_intersect(const void *shape, const struct ray *ray,
                     struct hits *hits)
{
    const struct conic *conic = shape;
    vec3 o = vec3_sub(ray->origin, conic->base), d = ray->direction;
    struct wall wall = wall_along(conic, o, d);
    if (wall_is_missed(conic, &wall))
        return;
    intersect_wall(conic, &wall, hits);
    if (conic->open || wall.ds == 0)
        return;
    const struct ray line = { o, d };
    intersect_cap(conic, &line, &wall, CONIC_BASE, hits);
    intersect_cap(conic, &line, &wall, CONIC_APEX, hits);
}

static inline double lane_cap(const struct conic *conic, vec3 o, vec3 d,
                              const struct wall *wall, int part)
{
    bool base = part == CONIC_BASE;
    double height = base ? 0 : conic->height;
    double radius = base ? conic->base_radius : conic->apex_radius;
    double t = (height - wall->from) / wall->ds;
    vec3 p = vec3_along(o, d, t);
    vec3 q = reject(p, conic->axis, vec3_dot(p, conic->axis));
    bool is = (vec3_dot(q, q) <= radius * radius) & (wall->ds != 0);
    return is ? t : (double)INFINITY;
}

CLONES static void conic_lanes(const struct conic *shape, struct lane_run run,
                               const struct rays *restrict rays,
                               struct rays_crossings *restrict all)
{
    const struct conic conic = *shape;
    const bool single = (conic.base_radius >= 0) & (conic.apex_radius >= 0);
    const double none = (double)INFINITY;
    EACH_LANE(i, run) {
        vec3 o = vec3_sub(rays_origin(rays, i), conic.base);
        vec3 d = rays_direction(rays, i);
        struct wall wall = wall_along(&conic, o, d);
        bool missed = single & (wall.a > 0) &
                      (wall.b * wall.b < wall.a * wall.c * (1 - 1e-9));
        double roots[2];
        quadratic_roots_lane(wall.a, wall.b, wall.c, roots);
        for (int k = 0; k < 2; k++) {
            double along = wall.s + roots[k] * wall.ds;
            bool is = !missed & (along >= 0) & (along <= conic.height);
            all->t[k][i] = is ? roots[k] + wall.shift : none;
            all->part[k][i] = CONIC_WALL;
        }
        double base = lane_cap(&conic, o, d, &wall, CONIC_BASE);
        double apex = lane_cap(&conic, o, d, &wall, CONIC_APEX);
        all->t[2][i] = missed ? none : base;
        all->t[3][i] = missed ? none : apex;
        all->part[2][i] = CONIC_BASE;
        all->part[3][i] = CONIC_APEX;
    }
}

void conic_all_many(const void *shape, struct lane_run run,
                    const struct rays *rays, struct rays_crossings *all)
{
    const struct conic *conic = shape;
    conic_lanes(conic, run, rays, all);
    all->count = conic->open ? 2 : 4;
}

static bool crossing_between(const struct conic *conic, const struct ray *ray,
                             double tmin, double tmax)
{
    struct hits hits;
    hits.count = 0;
    conic_intersect(conic, ray, &hits);
    return hits_between(&hits, tmin, tmax);
}

/* What is closed, and isn't steeper than the ray, is a piece of it: that
 * between the roots and between the ends. */
bool conic_crosses(const void *shape, const struct ray *ray, double tmin,
                   double tmax)
{
    const struct conic *conic = shape;
    vec3 o = vec3_sub(ray->origin, conic->base);
    struct wall wall = wall_along(conic, o, ray->direction);
    double rest = wall.b * wall.b - wall.a * wall.c;
    if (conic->open || !(wall.a > 0) || conic->base_radius < 0 ||
        conic->apex_radius < 0)
        return crossing_between(conic, ray, tmin, tmax);
    if (!(rest >= 0))
        return false;
    double root = sqrt(rest), enter = (-wall.b - root) / wall.a;
    double leave = (-wall.b + root) / wall.a;
    if (wall.ds != 0) {
        double base = -wall.s / wall.ds;
        double apex = (conic->height - wall.s) / wall.ds;
        double first = base < apex ? base : apex;
        double last = base < apex ? apex : base;
        enter = enter > first ? enter : first;
        leave = leave < last ? leave : last;
    } else if (!(wall.s >= 0 && wall.s <= conic->height)) {
        return false;
    }
    enter += wall.shift;
    leave += wall.shift;
    return enter <= leave &&
           ((enter > tmin && enter < tmax) || (leave > tmin && leave < tmax));
}

/* The same side by side, of what is closed. `doubtful`: steeper than the ray.
 */
struct piece {
    double enter, leave;
    bool doubtful, missed;
};

static inline struct piece piece_of(const struct conic *conic, vec3 origin,
                                    vec3 direction)
{
    struct wall wall =
        wall_along(conic, vec3_sub(origin, conic->base), direction);
    double rest = wall.b * wall.b - wall.a * wall.c, root = sqrt(rest);
    double enter = (-wall.b - root) / wall.a;
    double leave = (-wall.b + root) / wall.a;
    double base = -wall.s / wall.ds;
    double apex = (conic->height - wall.s) / wall.ds;
    double first = base < apex ? base : apex;
    double last = base < apex ? apex : base;
    bool along = wall.ds == 0;
    bool beside = along & !((wall.s >= 0) & (wall.s <= conic->height));
    enter = (along | (enter > first)) ? enter : first;
    leave = (along | (leave < last)) ? leave : last;
    enter += wall.shift;
    leave += wall.shift;
    return (struct piece){ enter, leave, !(wall.a > 0),
                           !(rest >= 0) | beside | !(enter <= leave) };
}

CLONES static void pieces_cross(const struct conic *shape, struct lane_run run,
                                const struct rays *restrict rays,
                                const struct rays_span *restrict span,
                                lane_flag *restrict met,
                                lane_flag *restrict doubtful)
{
    const struct conic conic = *shape;
    EACH_LANE(i, run) {
        struct piece piece =
            piece_of(&conic, rays_origin(rays, i), rays_direction(rays, i));
        double near = span->near[i], far = span->far[i];
        bool either = ((piece.enter > near) & (piece.enter < far)) |
                      ((piece.leave > near) & (piece.leave < far));
        met[i] = (!piece.missed & either) ? -1 : 0;
        doubtful[i] = piece.doubtful ? -1 : 0;
    }
}

void conic_crosses_many(const void *shape, struct lane_run run,
                        const struct rays *rays, const struct rays_span *span,
                        lane_flag *met)
{
    const struct conic *conic = shape;
    LANE_LINES lane_flag doubtful[RAY_LANES];
    if (conic->open || conic->base_radius < 0 || conic->apex_radius < 0) {
        struct rays_crossings all;
        conic_all_many(conic, run, rays, &all);
        rays_crosses_of(&all, run, span, met);
        return;
    }
    pieces_cross(conic, run, rays, span, met, doubtful);
    unsigned left = lane_run_bits(run) & rays_bits(doubtful);
    for (; left; left &= left - 1) {
        int i = __builtin_ctz(left);
        struct ray ray = rays_at(rays, i);
        met[i] =
            conic_crosses(conic, &ray, span->near[i], span->far[i]) ? -1 : 0;
    }
}

vec3 conic_normal(const void *shape, const vec3 *at, const struct hit *hit)
{
    const vec3 point = *at;
    const struct conic *conic = shape;
    if (hit->part != CONIC_WALL)
        return hit->part == CONIC_APEX ? conic->axis : vec3_negate(conic->axis);
    vec3 p = vec3_sub(point, conic->base);
    double s = vec3_dot(p, conic->axis);
    vec3 q = reject(p, conic->axis, s);
    double r = conic->base_radius + conic->slope * s;
    vec3 normal = vec3_along(q, conic->axis, -r * conic->slope);
    return vec3_dot(normal, normal) > 0 ? normal : conic->axis;
}

/* Not quite up to the surface, as in POV-Ray (measured: 1e-10 of the height
 * and of the squared radius), which settles shapes that share a face. Of an
 * open one the ends are inside (measured: 1e-9 of the height beyond), so that
 * what it is taken from is open there too. */
static inline bool conic_holds(const struct conic *conic, vec3 point)
{
    const double margin = 1e-10, beyond = 1e-9;
    vec3 p = vec3_sub(point, conic->base);
    double s = vec3_dot(p, conic->axis), h = conic->height;
    double end = (conic->open ? -beyond : margin) * h;
    vec3 q = reject(p, conic->axis, s);
    double r = conic->base_radius + conic->slope * s;
    return (s > end) & (s < h - end) & (vec3_dot(q, q) < r * r * (1 - margin));
}

bool conic_inside(const void *shape, vec3 point)
{
    return conic_holds(shape, point);
}

CLONES void conic_inside_many(const void *shape, struct lane_run run,
                              const struct lane_points *restrict points,
                              lane_flag *restrict inside)
{
    const struct conic conic = *(const struct conic *)shape;
    EACH_LANE(i, run)
        inside[i] = conic_holds(&conic, lane_get(points->at, i)) ? -1 : 0;
}

static double conic_radius(const struct conic *conic, double s)
{
    return conic->base_radius + conic->slope * s;
}

/* The unit vector away from the axis at c, so far along it; none where that is
 * lost in rounding, as what is left there needn't be across the axis. */
static vec3 conic_outward(const struct conic *conic, vec3 c, double along)
{
    const double lost = 1e-9;
    vec3 q = reject(c, conic->axis, along);
    double distance = vec3_length(q);
    return distance > lost * fabs(along) ? vec3_scale(q, 1 / distance)
                                         : vec3_make(0, 0, 0);
}

/* The distance from the axis less the radius there, a convex function, is
 * nowhere below its tangent, nor the distance below 0. */
static double conic_least(const struct conic *conic, const struct cell *cell,
                          double along, struct range s)
{
    vec3 c = vec3_sub(cell->centre, conic->base);
    vec3 outward = conic_outward(conic, c, along);
    vec3 slope = vec3_along(outward, conic->axis, -conic->slope);
    double tangent = vec3_dot(slope, c) - conic->base_radius;
    double most = fmax(conic_radius(conic, s.low), conic_radius(conic, s.high));
    return fmax(tangent - cell_reach(cell, slope), -most);
}

/* Whether it is below 0 at all corners, and so in all the cell. */
static bool conic_surrounds(const struct conic *conic, const struct cell *cell)
{
    for (int i = 0; i < 8; i++) {
        vec3 p = vec3_sub(cell_corner(cell, i), conic->base);
        double at = vec3_dot(p, conic->axis), r = conic_radius(conic, at);
        vec3 q = reject(p, conic->axis, at);
        if (!(r > 0 && vec3_dot(q, q) < r * r))
            return false;
    }
    return true;
}

/* Of a radius that changes its sign on the way no more is known than where its
 * box is. */
unsigned conic_meets(const void *shape, const struct cell *cell)
{
    const struct conic *conic = shape;
    double reach = cell_reach(cell, conic->axis), h = conic->height;
    double at = vec3_dot(vec3_sub(cell->centre, conic->base), conic->axis);
    struct range s = { at - reach, at + reach };
    if (s.low > h || s.high < 0)
        return 0;
    if (conic->base_radius < 0 || conic->apex_radius < 0)
        return cell_meets_box(cell, conic_bounds(conic))
                   ? CELL_SURFACE | CELL_BORDER
                   : 0;
    if (conic_least(conic, cell, at, s) > 0)
        return 0;
    if (!conic_surrounds(conic, cell))
        return CELL_SURFACE | CELL_BORDER;
    if (s.low <= 0 || s.high >= h)
        return conic->open ? CELL_BORDER : CELL_SURFACE | CELL_BORDER;
    return 0;
}
