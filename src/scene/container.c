/* Boxes and balls around shapes: see container.h. */
#include "scene/container.h"

struct container container_default(void)
{
    return (struct container){ .low = { -1, -1, -1 }, .high = { 1, 1, 1 } };
}

const char *container_prepare(struct container *container)
{
    struct container *c = container;
    vec3 r = { c->radius, c->radius, c->radius };
    c->box = c->ball ? (struct box3){ vec3_sub(c->centre, r),
                                      vec3_add(c->centre, r) }
                     : (struct box3){ vec3_min(c->low, c->high),
                                      vec3_max(c->low, c->high) };
    return c->ball && !(c->radius > 0)
               ? "the radius of its container must be above 0"
               : NULL;
}

enum { SIDE_BALL, SIDE_BOX };

static bool ball_interval(const struct container *c, const struct ray *ray,
                          int part, struct hit ends[2])
{
    vec3 o = vec3_sub(ray->origin, c->centre);
    double dd = vec3_dot(ray->direction, ray->direction);
    double middle = -vec3_dot(o, ray->direction) / dd;
    vec3 nearest = vec3_along(o, ray->direction, middle);
    double rest = c->radius * c->radius - vec3_dot(nearest, nearest);
    if (!(rest > 0))
        return false;
    double half = sqrt(rest / dd);
    ends[0] = (struct hit){ middle - half, part + SIDE_BALL, 0, 0 };
    ends[1] = (struct hit){ middle + half, part + SIDE_BALL, 0, 0 };
    return true;
}

static bool box_interval(const struct container *c, const struct ray *ray,
                         int part, struct hit ends[2])
{
    part += SIDE_BOX;
    ends[0] = (struct hit){ -HUGE_VAL, part, 0, 0 };
    ends[1] = (struct hit){ HUGE_VAL, part, 0, 0 };
    for (int axis = 0; axis < 3; axis++) {
        double o = vec3_component(ray->origin, axis);
        double d = vec3_component(ray->direction, axis);
        double low = vec3_component(c->box.low, axis);
        double high = vec3_component(c->box.high, axis);
        if (d == 0 && (o < low || o > high))
            return false;
        if (d == 0)
            continue;
        double a = ((d > 0 ? low : high) - o) / d;
        double b = ((d > 0 ? high : low) - o) / d;
        int side = part + 2 * axis;
        if (a > ends[0].t)
            ends[0] = (struct hit){ a, side + (d < 0), 0, 0 };
        if (b < ends[1].t)
            ends[1] = (struct hit){ b, side + (d > 0), 0, 0 };
    }
    return ends[0].t < ends[1].t;
}

bool container_interval(const struct container *container,
                        const struct ray *ray, int part, struct hit ends[2])
{
    return (container->ball ? ball_interval : box_interval)(container, ray,
                                                            part, ends);
}

vec3 container_normal(const struct container *container, vec3 point, int side)
{
    if (container->ball)
        return vec3_sub(point, container->centre);
    int axis = (side - SIDE_BOX) / 2;
    double sign = (side - SIDE_BOX) & 1 ? 1 : -1;
    return vec3_make(axis == 0 ? sign : 0, axis == 1 ? sign : 0,
                     axis == 2 ? sign : 0);
}

bool container_holds(const struct container *container, vec3 point)
{
    vec3 p = vec3_sub(point, container->centre);
    return container->ball
               ? vec3_dot(p, p) < container->radius * container->radius
               : box3_contains(container->box, point);
}

bool container_meets(const struct container *container, const struct cell *cell)
{
    return cell_meets_box(cell, container->box) &&
           (!container->ball ||
            cell_nearest(cell, container->centre) <= container->radius);
}

bool container_covers(const struct container *container,
                      const struct cell *cell)
{
    struct box3 box = cell_box(cell);
    return container->ball
               ? cell_farthest(cell, container->centre) < container->radius
               : box3_contains(container->box, box.low) &&
                     box3_contains(container->box, box.high);
}
