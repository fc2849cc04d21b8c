/* See emitter_points.h. */
#include "shade/emitter_points.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/draw.h"
#include "base/warp.h"
#include "scene/primitive.h"

enum { SLOT_WAY, SLOT_PLACE, SLOT_SIDE };

/* Lines through the box of a shape, in its own space. */
struct thread_box {
    vec3 low, size;
    double reach; /* from before the box */
};

/* Of the reach, where crossings are told one by one: */
static const double hit_rough = 0.01; /* they may be off, */
static const double hit_apart = 0.02; /* and are apart */

static double side_seen(const struct thread_box *box, vec3 way, int axis)
{
    double sides = vec3_component(box->size, (axis + 1) % 3) *
                   vec3_component(box->size, (axis + 2) % 3);
    return fabs(vec3_component(way, axis)) * sides;
}

/* One of them, anywhere alike on the box as seen along the line. Returns how
 * large that is. */
static double thread_box_line(const struct thread_box *box,
                              const struct draws *draws, struct ray *ray)
{
    double u[2], seen[3], sum = 0;
    draw_pair(draws, SLOT_WAY, u);
    vec3 way = warp_sphere(u);
    for (int axis = 0; axis < 3; axis++)
        seen[axis] = sum += side_seen(box, way, axis);
    double which = draw_unit(draws, SLOT_SIDE) * sum;
    int axis = (which >= seen[0]) + (which >= seen[1]);
    draw_pair(draws, SLOT_PLACE, u);
    double place[3];
    place[axis] = vec3_component(way, axis) > 0 ? 0 : 1;
    place[(axis + 1) % 3] = u[0];
    place[(axis + 2) % 3] = u[1];
    const vec3 size = box->size;
    vec3 in = { place[0] * size.x, place[1] * size.y, place[2] * size.z };
    ray->direction = way;
    ray->origin = vec3_along(vec3_add(box->low, in), way, -box->reach);
    return sum;
}

bool emitter_points_can(const struct primitive *primitive)
{
    return primitive->normal && (!primitive->some || primitive->first_roughly);
}

static struct thread_box leaf_box(const struct leaf *leaf)
{
    struct box3 box = leaf->object->primitive->bounds(leaf->shape);
    vec3 size = vec3_sub(box.high, box.low);
    return (struct thread_box){ box.low, size, vec3_length(size) };
}

/* All crossings of a ray in the leaf's own space. Of a shape that tells but few
 * at a time the next is looked for behind each, and not exactly: it is one of
 * many. */
static void leaf_hits(const struct leaf *leaf, const struct ray *ray,
                      struct hits *hits)
{
    const struct primitive *primitive = leaf->object->primitive;
    hits->count = 0;
    if (!primitive->some) {
        primitive->intersect(leaf->shape, ray, hits);
        return;
    }
    const struct thread_box box = leaf_box(leaf);
    double slowness = 1 / vec3_length(ray->direction), from = 0;
    vec3 middle = vec3_along(box.low, box.size, 0.5);
    double far = vec3_length(vec3_sub(middle, ray->origin)) + box.reach;
    double spread = hit_rough * box.reach / (far * slowness);
    struct hit hit;
    while (hits->count < HITS_MAX &&
           primitive->first_roughly(leaf->shape, ray, from, (double)INFINITY,
                                    spread, &hit)) {
        hits->at[hits->count++] = hit;
        from = hit.t + hit_apart * box.reach * slowness;
    }
}

/* The normal there, in the world, of a length by which areas grow. */
static vec3 hit_area(const struct leaf *leaf, const struct cofactors *grown,
                     const struct ray *ray, const struct hit *hit)
{
    vec3 at = vec3_along(ray->origin, ray->direction, hit->t);
    vec3 n =
        vec3_normalise(leaf->object->primitive->normal(leaf->shape, &at, hit));
    return vec3_make(vec3_dot(grown->row[0], n), vec3_dot(grown->row[1], n),
                     vec3_dot(grown->row[2], n));
}

double emitter_points_density(const struct leaf *leaf, vec3 point,
                              vec3 direction)
{
    const struct cofactors grown = affine_cofactors(leaf->pose->outward);
    const struct ray way = { point, direction };
    const struct ray ray = ray_into(leaf->pose->inward, &way);
    struct hits hits;
    double sum = 0;
    leaf_hits(leaf, &ray, &hits);
    for (int i = 0; i < hits.count; i++) {
        if (!(hits.at[i].t > 0))
            continue;
        vec3 n = vec3_normalise(hit_area(leaf, &grown, &ray, &hits.at[i]));
        double cosine = fabs(vec3_dot(n, direction));
        if (cosine > 0)
            sum += hits.at[i].t * hits.at[i].t / cosine;
    }
    return sum;
}

static int by_place(const void *a, const void *b)
{
    double x = ((const struct emitter_point *)a)->along;
    double y = ((const struct emitter_point *)b)->along;
    return (x > y) - (x < y);
}

static int longest(vec3 size)
{
    int axis = size.y > size.x;
    return size.z > vec3_component(size, axis) ? 2 : axis;
}

/* Those of one line, whose crossings stand for that area each. */
static void line_add(struct arena *arena, const struct leaf *leaf,
                     const struct thread_box *box, const struct ray *ray,
                     double area, struct emitter_points *points)
{
    const int axis = longest(box->size);
    const struct cofactors grown = affine_cofactors(leaf->pose->outward);
    struct hits hits;
    leaf_hits(leaf, ray, &hits);
    for (int i = 0; i < hits.count; i++) {
        vec3 at = vec3_along(ray->origin, ray->direction, hits.at[i].t);
        vec3 n = hit_area(leaf, &grown, ray, &hits.at[i]);
        const struct emitter_point point = {
            .at = affine_point(leaf->pose->outward, at),
            .area = area * vec3_length(n),
            .along = vec3_component(at, axis),
        };
        if (isfinite(point.area) && vec3_finite(point.at))
            *ARRAY_PUSH(arena, points) = point;
    }
}

void emitter_points_add(struct arena *arena, const struct leaf *leaf,
                        uint32_t lines, struct emitter_points *points)
{
    const struct primitive *primitive = leaf->object->primitive;
    const struct box3 box = primitive->bounds(leaf->shape);
    if (!box3_is_finite(box) || box3_is_empty(box))
        return;
    const struct thread_box thread = leaf_box(leaf);
    const size_t first = points->count;
    for (uint32_t i = 0; i < lines; i++) {
        const struct draws draws = { leaf->number, i };
        struct ray ray;
        double area = 2 * thread_box_line(&thread, &draws, &ray) / lines;
        line_add(arena, leaf, &thread, &ray, area, points);
    }
    if (points->count > first)
        qsort(&points->items[first], points->count - first,
              sizeof *points->items, by_place);
}
