/* scene/primitive: what shapes say of a piece of a ray is what they say of all
 * of it. */
#include "harness.h"

#include <math.h>

#include "scene_world.h"
#include "shapes.h"

/* Tries all shapes, whose rays must meet something. */
static void each_shape(const char *const *shapes, size_t count,
                       void (*agree)(void *met, const struct solid *solid))
{
    for (size_t i = 0; i < count; i++) {
        struct scene_world *all = scene_world_new(shapes[i]);
        int met = 0;
        world_visit(all->world, agree, NULL, &met);
        assert_true(met > 400);
        scene_world_free(all);
    }
}

/* Rays at one shape, in its space. What they meet between two places is asked
 * three ways. */
static void shape_crossings_agree(void *context, const struct solid *solid)
{
    const struct object *object = solid->leaf->object;
    const struct primitive *primitive = object->primitive;
    struct dice dice = { 5 };
    const double begins = 0.02; /* rays that begin on a surface are others */
    int *met = context;
    if (!primitive->crosses)
        return;
    for (int i = 0; i < 4000; i++) {
        struct ray ray = { dice_point(&dice, 1.5), dice_point(&dice, 1.5) };
        double tmin = dice_between(&dice, -1, 1), first = HUGE_VAL;
        double tmax = tmin + dice_between(&dice, 0, 4);
        struct ray from = { ray_point(&ray, tmin), ray.direction };
        struct hits hits;
        struct hit hit;
        if (primitive->first &&
            primitive->first(object->shape, &ray, tmin, tmin + begins, &hit))
            continue;
        hits.count = 0;
        primitive->intersect(object->shape, &from, &hits);
        for (int k = 0; k < hits.count; k++)
            if (hits.at[k].t > 0 && hits.at[k].t < tmax - tmin)
                first = fmin(first, tmin + hits.at[k].t);
        bool crosses = first < HUGE_VAL;
        assert_true(primitive->crosses(object->shape, &ray, tmin, tmax) ==
                    crosses);
        *met += crosses;
        if (!primitive->first)
            continue;
        assert_true(primitive->first(object->shape, &ray, tmin, tmax, &hit) ==
                    crosses);
        if (crosses)
            assert_true(fabs(hit.t - first) < 1e-6);
        if (!primitive->first_roughly)
            continue;
        assert_true(primitive->first_roughly(object->shape, &ray, tmin, tmax,
                                             1e-6, NULL) == crosses);
        assert_true(primitive->first_roughly(object->shape, &ray, tmin, tmax,
                                             1e-6, &hit) == crosses);
        if (crosses)
            assert_true(fabs(hit.t - first) < 1e-5);
    }
}

/* All lanes, the first half or the second in turn. */
static struct lane_run run_number(int i)
{
    static const unsigned lanes[] = { 0xffff, 0x00a5, 0x8100 };
    return lane_run_of(lanes[i % 3]);
}

/* Rays side by side find to the bit what each finds alone, up to just that
 * place and just not. */
static void rays_side_by_side_agree(void *context, const struct solid *solid)
{
    const struct object *object = solid->leaf->object;
    const struct primitive *primitive = object->primitive;
    struct dice dice = { 6 };
    int *met = context;
    for (int i = 0; i < 750; i++) {
        struct rays rays;
        struct rays_span span;
        struct rays_met first = { .u = { 0 } };
        lane_flag crosses[RAY_LANES];
        const struct lane_run run = run_number(i);
        for (int k = 0; k < RAY_LANES; k++) {
            struct ray ray = { dice_point(&dice, 1.5), dice_point(&dice, 1.5) };
            struct hit hit;
            if (k % 5 == 0)
                ray.direction.y = 0;
            rays_set(&rays, k, ray.origin, ray.direction);
            span.near[k] = dice_between(&dice, -1, 1);
            span.far[k] = span.near[k] + dice_between(&dice, 0, 4);
            if (k % 3 && primitive->first &&
                primitive->first(object->shape, &ray, span.near[k], span.far[k],
                                 &hit))
                span.far[k] = k % 3 == 1 ? hit.t : nextafter(hit.t, HUGE_VAL);
        }
        primitive->crosses_many(object->shape, run, &rays, &span, crosses);
        if (primitive->first_many)
            primitive->first_many(object->shape, run, &rays, &span, &first);
        for (int k = run.first; k < run.end; k++) {
            struct ray ray = rays_at(&rays, k);
            struct hit hit = { .t = (double)INFINITY };
            bool is = primitive->crosses(object->shape, &ray, span.near[k],
                                         span.far[k]);
            assert_true(crosses[k] == (is ? -1 : 0));
            *met += is;
            if (!primitive->first_many)
                continue;
            is = primitive->first(object->shape, &ray, span.near[k],
                                  span.far[k], &hit);
            assert_true(first.t[k] == (is ? hit.t : (double)INFINITY));
            assert_true(!is || first.part[k] == hit.part);
            assert_true(!is || first.u[k] == hit.u);
        }
    }
}

/* Crossings told in rounds, those of each ray in a row of its own. */
struct rounds {
    struct hits lane[RAY_LANES];
};

static unsigned take_round(void *context, unsigned met,
                           const double t[RAY_LANES])
{
    struct rounds *rounds = context;
    unsigned over = 0;
    for (int k = 0; k < RAY_LANES; k++)
        if (met >> k & 1)
            hits_add(&rounds->lane[k], t[k], 0);
    for (int k = 0; k < RAY_LANES; k++)
        over |= (unsigned)(rounds->lane[k].count == k % 4 + 1) << k;
    return over;
}

static bool take_alone(void *context, const struct hit *hit)
{
    struct hits *hits = context;
    hits_add(hits, hit->t, 0);
    return false;
}

/* In rounds rays side by side tell to the bit what each tells alone, until they
 * want no more. */
static void rounds_agree(void *context, const struct solid *solid)
{
    const struct object *object = solid->leaf->object;
    const struct primitive *primitive = object->primitive;
    struct dice dice = { 8 };
    int *met = context;
    for (int i = 0; i < 750; i++) {
        struct rays rays;
        struct rays_span span;
        static struct rounds rounds;
        const struct lane_run run = run_number(i);
        for (int k = 0; k < RAY_LANES; k++) {
            rays_set(&rays, k, dice_point(&dice, 1.5), dice_point(&dice, 1.5));
            span.near[k] = dice_between(&dice, -1, 1);
            span.far[k] = span.near[k] + dice_between(&dice, -.3, 4);
            rounds.lane[k].count = 0;
        }
        primitive->crossings_many(object->shape, run, &rays, &span, take_round,
                                  &rounds);
        for (int k = run.first; k < run.end; k++) {
            struct ray ray = rays_at(&rays, k);
            const struct hits *lane = &rounds.lane[k];
            static struct hits alone;
            alone.count = 0;
            primitive->crossings(object->shape, &ray, span.near[k], span.far[k],
                                 take_alone, &alone);
            int wanted = alone.count < k % 4 + 1 ? alone.count : k % 4 + 1;
            assert_int_equal(lane->count, wanted);
            for (int h = 0; h < wanted; h++)
                assert_true(lane->at[h].t == alone.at[h].t);
            *met += wanted;
        }
    }
}

static void shapes_tell_crossings_in_rounds(void **state)
{
    static const char *const shapes[] = {
        "julia_fractal { <-.083,0,-.83,-.025> quaternion max_iteration 8 }",
        "julia_fractal { <-.4,.2,.3,-.5> quaternion cube max_iteration 6 "
        "precision 50 }",
        "julia_fractal { <2.2,0,0,0> quaternion max_iteration 2 }",
        "julia_fractal { <-.4,.2,.3,-.1> hypercomplex max_iteration 8 }",
        "julia_fractal { <-.2,.1,.4,.1> hypercomplex exp max_iteration 5 }",
    };
    (void)state;
    each_shape(shapes, sizeof shapes / sizeof *shapes, rounds_agree);
}

/* The crossings in lane `i`, without the gaps. */
static struct hits lane_hits(const struct rays_crossings *all, int i)
{
    struct hits hits;
    hits.count = 0;
    for (int k = 0; k < all->count; k++)
        if (all->t[k][i] != (double)INFINITY)
            hits_add(&hits, all->t[k][i], (int)all->part[k][i]);
    return hits;
}

/* All crossings of rays side by side, and which points are inside, are to the
 * bit those of each alone. */
static void crossings_side_by_side_agree(void *context,
                                         const struct solid *solid)
{
    const struct object *object = solid->leaf->object;
    const struct primitive *primitive = object->primitive;
    struct dice dice = { 7 };
    int *met = context;
    for (int i = 0; i < 750; i++) {
        struct rays rays;
        struct rays_crossings all;
        struct lane_points points;
        lane_flag inside[RAY_LANES];
        const struct lane_run run = run_number(i);
        for (int k = 0; k < RAY_LANES; k++) {
            vec3 direction = dice_point(&dice, 1.5);
            if (k % 5 == 0)
                direction.y = 0;
            if (k % 7 == 0)
                direction.x = direction.z = 0;
            if (!(vec3_dot(direction, direction) > 0))
                direction.y = 1;
            rays_set(&rays, k, dice_point(&dice, 1.5), direction);
            lane_put(points.at, (unsigned)k, dice_point(&dice, 1.5));
        }
        primitive->all_many(object->shape, run, &rays, &all);
        primitive->inside_many(object->shape, run, &points, inside);
        for (int k = run.first; k < run.end; k++) {
            struct ray ray = rays_at(&rays, k);
            struct hits alone, lane = lane_hits(&all, k);
            vec3 point = lane_get(points.at, (unsigned)k);
            alone.count = 0;
            primitive->intersect(object->shape, &ray, &alone);
            assert_int_equal(lane.count, alone.count);
            for (int h = 0; h < lane.count; h++)
                assert_true(lane.at[h].t == alone.at[h].t &&
                            lane.at[h].part == alone.at[h].part);
            assert_true(inside[k] ==
                        (primitive->inside(object->shape, point) ? -1 : 0));
            *met += lane.count;
        }
    }
}

static void shapes_tell_all_crossings_side_by_side(void **state)
{
    static const char *const shapes[] = {
        "sphere { <.1,.2,0>, 1 }",
        "plane { <.3,1,.2>, .1 }",
        "plane { y, .1 }",
        "box { -1, <1,.5,.7> }",
        "cylinder { -y, <.5,1,0>, .6 }",
        "cylinder { -y, y, .9 open }",
        "cone { -y, .9, <.2,1,0>, .2 }",
        "cone { -y, 1.4, <.2,.1,0>, 0 open }",
        "cone { -y, .2, <.2,.1,0>, -.7 }",
        "quadric { <1, 1.5, 1>, <.3,0,0>, <.1,0,0>, -.9 }",
        "quadric { <1, -1.5, 1>, <.3,.2,.1>, 0, -.1 }",
        "quadric { x, 0, z, -.4 }",
        "quadric { 0, 0, <.3,1,.2>, -.4 }",
    };
    (void)state;
    each_shape(shapes, sizeof shapes / sizeof *shapes,
               crossings_side_by_side_agree);
}

static void shapes_agree_on_rays_side_by_side(void **state)
{
    static const char *const shapes[] = {
        "sphere { <.1,.2,0>, 1 }",
        "plane { <.3,1,.2>, .1 }",
        "plane { y, .1 }",
        "box { -1, <1,.5,.7> }",
        "box { <-.3,0,-2>, <1,.5,.7> }",
        "cylinder { -y, <.5,1,0>, .6 }",
        "cylinder { -y, y, .9 }",
        "cylinder { -y, <.5,1,0>, .6 open }",
        "cone { -y, .9, <.2,1,0>, .2 }",
        "cone { -y, 1.4, <.2,.1,0>, 0 }",
        "torus { .8, .4 }",
        "torus { .3, .6 }",
        "torus { -.2, .9 }",
        "torus { 0, .9 }",
        "isosurface { function { x*x + y*y - z*z - .2 } max_gradient 4 }",
        "isosurface { function { sin(x*5) + cos(y*4) + sin(z*5) } open "
        "max_gradient 9 contained_by { sphere { 0, 1 } } }",
        "#declare Noise = function { internal(76) } "
        "isosurface { function { x*x + y*y + z*z - .8 + "
        "Noise(x*4, y*4, z*4)*.3 } max_gradient 5 accuracy .01 }",
        "isosurface { function { exp(x) - pow(abs(y), 1.3) + z*z - .9 } "
        "max_gradient 4 }",
        "blob { threshold .4 sphere { <-.5,.2,0>, .9, 1 } "
        "sphere { <.5,0,.1>, .8, 1 scale <1,.7,1.3> } "
        "cylinder { -y, <.3,1,.2>, .6, .8 } sphere { <0,.3,-.5>, .5, -.7 } "
        "sphere { <.6,.9,.3>, .5, 1 } }",
        "quartic { <1,0,0,0,2,0,0,2,0,-1.6,0,0,0,0,0,0,0,0,0,0,1,0,0,2,0,"
        "1.28,0,0,0,0,1,0,-1.6,0,.4096> }",
        "polynomial { 4, xyz(4,0,0): 1, xyz(0,1,1): -.3, xyz(0,0,0): -.2 }",
        "cubic { <1,0,0,0,0,0,-1,0,0,0,1,0,0,0,0,0,0,0,.5,.1> }",
        "prism { cubic_spline -.5, .5, 7, <-1,0>, <0,1>, <1,0>, <0,-1>, "
        "<-1,0>, <0,1>, <1,0> }",
        "prism { linear_spline -.9, .7, 5, <-1,-1>, <1,-1>, <.4,.8>, <-1,1>, "
        "<-1,-1> open }",
        "prism { conic_sweep linear_spline .1, 1, 5, <-1,-1>, <1,-1>, <.4,.8>, "
        "<-1,1>, <-1,-1> }",
        "lathe { cubic_spline 6, <0,-1.2>, <.5,-1>, <1,-.4>, <.4,.4>, <.7,1>, "
        "<.5,1.2> }",
        "lathe { linear_spline 5, <0,-1>, <1,-1>, <.5,0>, <1,1>, <0,1> }",
        "julia_fractal { <-.083,0,-.83,-.025> quaternion max_iteration 8 }",
        "julia_fractal { <-.4,.2,.3,-.5> quaternion cube max_iteration 6 }",
        "julia_fractal { <-.4,.2,.3,-.1> hypercomplex max_iteration 8 }",
        "julia_fractal { <-.2,.1,.4,.1> hypercomplex exp max_iteration 5 }",
        /* Few parts on a ray, then more than rays side by side keep. */
        "blob { threshold .5 #local I = 0; #while (I < 90) "
        "sphere { <cos(I), sin(I*1.7), sin(I*2.9)>, .3, 1 } "
        "#local I = I + 1; #end }",
        "blob { threshold 30 #local I = 0; #while (I < 90) "
        "sphere { <cos(I), sin(I*1.7), sin(I*2.9)>/9, 1, 1 } "
        "#local I = I + 1; #end }",
    };
    (void)state;
    each_shape(shapes, sizeof shapes / sizeof *shapes, rays_side_by_side_agree);
}

static void crossings_asked_for_alone_agree(void **state)
{
    static const char *const shapes[] = {
        "sphere { <.1,.2,0>, 1 }",
        "box { -1, <1,.5,.7> }",
        "cylinder { -y, <.5,1,0>, .6 }",
        "cylinder { -y, <.5,1,0>, .6 open }",
        "cone { -y, .9, <.2,1,0>, .2 }",
        "cone { -y, .9, <.2,1,0>, 0 open }",
        "isosurface { function { x*x + y*y*y*y + z*z - .8 } max_gradient 7 "
        "accuracy 1e-5 }",
        "isosurface { function { x*x + y*y - z*z - .2 } max_gradient 4 "
        "contained_by { sphere { 0, 1 } } accuracy 1e-5 }",
        "isosurface { function { x*x + y*y - z*z - .2 } max_gradient 4 open "
        "contained_by { box { -1, 1 } } accuracy 1e-5 }",
        "sor { 6, <0,-1.2> <.7,-1> <1,-.2> <.4,.4> <.8,.9> <.3,1.3> }",
        "sor { 5, <.2,-1.2> <.7,-1> <1.2,-.2> <.4,.7> <.8,1> open }",
        "superellipsoid { <.3,.6> }",
        "superellipsoid { <1.5,1> }",
        "superellipsoid { <2.5,.7> }",
        "superellipsoid { <.25,3> }",
        "superellipsoid { <2.2,2.1> }",
        "superellipsoid { .2 }",
        "superellipsoid { <.4,.3> }",
        "superellipsoid { <.5,2> }",
        "plane { <.3,1,.2>, .1 }",
        "torus { .8, .4 }",
        "torus { .3, .6 }",
        "torus { -.2, .9 }",
        "torus { 0, .9 }",
        "cubic { <1,0,0,0,0,0,-1,0,0,0,1,0,0,0,0,0,0,0,.5,.1> }",
        "quartic { <1,0,0,0,2,0,0,2,0,-1.6,0,0,0,0,0,0,0,0,0,0,1,0,0,2,0,"
        "1.28,0,0,0,0,1,0,-1.6,0,.4096> }",
        "polynomial { 6, xyz(6,0,0): 1, xyz(0,6,0): 1, xyz(0,0,6): 1, "
        "xyz(0,0,0): -.7 }",
        "prism { cubic_spline -.5, .5, 7, <-1,0>, <0,1>, <1,0>, <0,-1>, "
        "<-1,0>, <0,1>, <1,0> }",
        "prism { linear_spline -.9, .7, 5, <-1,-1>, <1,-1>, <.4,.8>, <-1,1>, "
        "<-1,-1> open }",
        "lathe { cubic_spline 6, <0,-1.2>, <.5,-1>, <1,-.4>, <.4,.4>, <.7,1>, "
        "<.5,1.2> }",
        "lathe { linear_spline 5, <0,-1>, <1,-1>, <.5,0>, <1,1>, <0,1> }",
        "prism { conic_sweep linear_spline .1, 1, 5, <-1,-1>, <1,-1>, <.4,.8>, "
        "<-1,1>, <-1,-1> }",
        "blob { threshold .4 sphere { <-.5,.2,0>, .9, 1 } "
        "sphere { <.5,0,.1>, .8, 1 scale <1,.7,1.3> } "
        "cylinder { -y, <.3,1,.2>, .6, .8 } sphere { <0,.3,-.5>, .5, -.7 } "
        "sphere { <.6,.9,.3>, .5, 1 } }",
    };
    (void)state;
    each_shape(shapes, sizeof shapes / sizeof *shapes, shape_crossings_agree);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(crossings_asked_for_alone_agree),
        cmocka_unit_test(shapes_tell_all_crossings_side_by_side),
        cmocka_unit_test(shapes_agree_on_rays_side_by_side),
        cmocka_unit_test(shapes_tell_crossings_in_rounds),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
