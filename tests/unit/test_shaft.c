/* world/shaft: rays of a shaft meet what they meet without it. */
#include "harness.h"

#include "scene_world.h"
#include "shapes.h"

#define THING "pigment { rgb 1 } "

/* Things of all kinds in a room of planes, and a light with an area, without
 * which there are no shafts. */
static const char things[] =
    "light_source { <0, 3, 0>, 1 area_light x, z, 3, 3\n"
    "  looks_like { sphere { 0, 0.2 " THING "} } }\n"
    "plane { y, -2 " THING "}\n"
    "plane { x, -4 " THING "}\n"
    "#declare S = seed(5);\n"
    "#macro P(R) <rand(S) - 0.5, rand(S) - 0.5, rand(S) - 0.5> * 2 * R #end\n"
    "#macro M() rotate P(180) translate P(3) #end\n"
    "#for (I, 1, 12)\n"
    "  sphere { P(3), 0.2 " THING "}\n"
    "  box { -0.3, 0.3 " THING "M() }\n"
    "  cylinder { P(3), P(3), 0.1 " THING "}\n"
    "  cone { 0, 0.3, y, 0 " THING "M() }\n"
    "  torus { 0.3, 0.1 pigment { rgbt <1, 1, 1, 0.5> } M() }\n"
    "  difference { sphere { 0, 0.4 } plane { y, 0 } " THING "M() }\n"
    "  sphere { P(3), 0.3 " THING "no_shadow }\n"
    "#end\n";

static bool count_filter(void *context, const struct ray *ray,
                         const struct world_hit *hit)
{
    (void)ray;
    (void)hit;
    ++*(int *)context;
    return false;
}

/* Half of them are on surfaces, where most rays begin. */
static void random_place(const struct world *world, struct dice *dice,
                         struct shaft_rays *rays)
{
    struct ray ray = { rays->from, vec3_normalise(dice_point(dice, 1)) };
    struct intersection at;
    if (dice_between(dice, 0, 1) < 0.5 &&
        world_closest(world, &ray, 0, RAY_CAMERA, &at)) {
        rays->from = at.point;
        rays->leaf = at.leaf;
        rays->normal = at.face;
    }
}

static struct shaft_rays random_rays(const struct world *world,
                                     struct dice *dice)
{
    struct shaft_rays rays = {
        .from = dice_point(dice, 3),
        .middle = dice_point(dice, 4),
        .half = { dice_point(dice, 0.5), dice_point(dice, 0.5) },
        .tmin = 1e-3,
    };
    double kind = dice_between(dice, 0, 1);
    random_place(world, dice, &rays);
    if (kind < 0.1) /* all in one plane */
        rays.middle = vec3_add(rays.from, rays.half[0]);
    else if (kind < 0.2) /* along the axes */
        rays.half[0] = vec3_make(0.5, 0, 0),
        rays.half[1] = vec3_make(0, 0, 0.4);
    else if (kind < 0.3) /* almost a line */
        rays.half[1] = vec3_scale(rays.half[1], 1e-3);
    else if (kind < 0.4) /* as from the sun */
        rays.middle = vec3_scale(rays.middle, 1e4);
    return rays;
}

struct seen {
    int clear, blocked, free, crowded, crossings, plain, together;
};

static void look(const struct world *world, const struct shaft_rays *rays,
                 const struct shaft *shaft, struct dice *dice,
                 struct seen *seen)
{
    double place[2] = { dice_between(dice, -1, 1), dice_between(dice, -1, 1) };
    vec3 end = vec3_along(vec3_along(rays->middle, rays->half[0], place[0]),
                          rays->half[1], place[1]);
    vec3 way = vec3_sub(end, rays->from);
    struct ray ray = { rays->from, vec3_normalise(way) };
    double to = vec3_length(way) - 1e-3;
    int wanted = 0, met = 0;
    bool blocked =
        world_occluded(world, &(struct occlusion){ .ray = &ray,
                                                   .tmin = rays->tmin,
                                                   .tmax = to,
                                                   .filter = count_filter,
                                                   .context = &wanted });
    assert_true(world_occluded_in(world, shaft, place,
                                  &(struct occlusion){ .ray = &ray,
                                                       .tmin = rays->tmin,
                                                       .tmax = to,
                                                       .filter = count_filter,
                                                       .context = &met }) ==
                blocked);
    if (!blocked)
        assert_int_equal(met, wanted);
    if (shaft_clear(shaft, place)) {
        assert_false(blocked);
        assert_int_equal(wanted, 0);
        seen->clear++;
    }
    seen->blocked += blocked;
    seen->free += !blocked;
    seen->crossings += wanted > 0;
}

/* Those of random bits, to a place each; as long as the way, if not unit. */
static unsigned look_together(const struct world *world,
                              const struct shaft_rays *rays,
                              const struct shaft *shaft, struct dice *dice)
{
    LANE_LINES double place[2][RAY_LANES];
    struct occlusions units = { .light = -1, .shaft = shaft };
    struct occlusions whole = units;
    unsigned lanes = (unsigned)dice_between(dice, 0, 0x10000 - 1e-9);
    unsigned blocked = 0;
    units.place = (const double(*)[RAY_LANES])place;
    for (int i = 0; i < RAY_LANES; i++) {
        for (int k = 0; k < 2; k++)
            place[k][i] = dice_between(dice, -1, 1);
        vec3 end =
            vec3_along(vec3_along(rays->middle, rays->half[0], place[0][i]),
                       rays->half[1], place[1][i]);
        vec3 way = vec3_sub(end, rays->from);
        double length = vec3_length(way), to = length - 1e-3;
        struct ray ray = { rays->from, vec3_normalise(way) };
        const struct occlusion alone = {
            .ray = &ray, .tmin = rays->tmin, .tmax = to, .light = -1
        };
        rays_set(&units.rays, i, ray.origin, ray.direction);
        units.span.near[i] = rays->tmin;
        units.span.far[i] = to;
        rays_set(&whole.rays, i, ray.origin, way);
        whole.span.near[i] = rays->tmin / length;
        whole.span.far[i] = to / length;
        if (lanes >> i & 1 && world_occluded(world, &alone))
            blocked |= 1u << i;
    }
    assert_int_equal(blocked & ~lanes, 0);
    assert_int_equal(blocked & ~shaft_shaded_many(shaft, units.place), 0);
    struct occluded found = world_occluded_many(world, &units, lanes);
    assert_int_equal(found.dark & ~blocked, 0);
    assert_int_equal(blocked & ~(found.dark | found.panes), 0);
    if (!shaft->crowded && shaft->plain)
        assert_int_equal(shaft_hides_many(shaft, units.place, &whole.rays,
                                          &whole.span, lanes),
                         blocked);
    return blocked;
}

static void rays_in_shafts_are_as_without(void **state)
{
    (void)state;
    struct scene_world *all = scene_world_new(things);
    struct dice dice = { 17 };
    struct seen seen = { 0 };
    for (int trial = 0; trial < 20000; trial++) {
        struct shaft_rays rays = random_rays(all->world, &dice);
        struct shaft shaft;
        world_shaft(all->world, &rays, &shaft);
        seen.crowded += shaft.crowded;
        for (int i = 0; i < 8; i++)
            look(all->world, &rays, &shaft, &dice, &seen);
        seen.together +=
            __builtin_popcount(look_together(all->world, &rays, &shaft, &dice));
        seen.plain += !shaft.crowded && shaft.plain;
    }
    assert_true(seen.blocked > 30000 && seen.crossings > 1000);
    assert_true(seen.clear > 4000 && seen.crowded < 8000);
    assert_true(seen.plain > 1000 && seen.together > 30000);
    scene_world_free(all);
}

/* Triangles are Embree's; without lights that have an area there is no tree. */
static void other_shafts_are_crowded(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "light_source { y, 1 area_light x, z, 3, 3 }\n"
        "mesh { triangle { -x, x, z } " THING "}\n",
        "light_source { y, 1 } sphere { 0, 1 " THING "}\n",
    };
    for (int i = 0; i < 2; i++) {
        struct scene_world *all = scene_world_new(texts[i]);
        struct shaft_rays rays = { .from = { 0, -2, 0 },
                                   .middle = { 0, 2, 0 },
                                   .half = { { 1, 0, 0 }, { 0, 0, 1 } },
                                   .tmin = 1e-3 };
        struct ray ray = { rays.from, { 0, 1, 0 } };
        double place[2] = { 0, 0 };
        struct shaft shaft;
        world_shaft(all->world, &rays, &shaft);
        assert_true(shaft.crowded);
        assert_false(shaft_clear(&shaft, place));
        assert_true(world_occluded_in(
            all->world, &shaft, place,
            &(struct occlusion){ .ray = &ray, .tmax = 4, .light = -1 }));
        scene_world_free(all);
    }
}

/* A lid 2 wide, a third of the way to a light 2 wide, casts a penumbra 1 wide:
 * on all of a piece of the floor that the rays to the light can leave, on none
 * beside, and where the lid nearly lies on the floor next to none. */
static void penumbras_are_as_wide_as_things_are_far(void **state)
{
    static const struct {
        double x, height, radius, least, most;
    } rows[] = {
        { 0, 3, 0, 0.999, 1.001 },  { 0, 3, 0.5, 0.999, 1.001 },
        { 1.5, 3, 0, 0.98, 1 },     { 2.1, 3, 0, HUGE_VAL, HUGE_VAL },
        { 2.1, 3, 0.3, 0.97, 1 },   { 0, 0.01, 0, 0.001, 0.003 },
        { 0, 9.5, 0, 2, HUGE_VAL }, { 0, 12, 0, HUGE_VAL, HUGE_VAL },
    };
    (void)state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[400];
        snprintf(text, sizeof text,
                 "light_source { 9*y, 1 area_light x, z, 3, 3 }\n"
                 "plane { y, 0 " THING "}\n"
                 "box { <-1, %g, -1>, <1, %g, 1> " THING "}\n",
                 rows[i].height, rows[i].height + 0.1);
        struct scene_world *all = scene_world_new(text);
        struct shaft_rays rays = { .from = { rows[i].x, 0, 0 },
                                   .radius = rows[i].radius,
                                   .middle = { 0, 9, 0 },
                                   .half = { { 1, 0, 0 }, { 0, 0, 1 } },
                                   .tmin = 1e-3,
                                   .normal = { 0, 1, 0 } };
        struct ray down = { { 5, 1, 0 }, { 0, -1, 0 } };
        struct intersection at;
        assert_true(world_closest(all->world, &down, 0, RAY_CAMERA, &at));
        rays.leaf = at.leaf;
        double blur = world_blur(all->world, &rays, 0);
        assert_true(blur >= rows[i].least && blur <= rows[i].most);
        scene_world_free(all);
    }
}

static const char marbles[] =
    "light_source { <0, 3, 0>, 1 area_light x, z, 3, 3 }\n"
    "plane { y, -2 " THING "}\n"
    "#declare S = seed(6);\n"
    "#for (I, 1, 20)\n"
    "  sphere { <rand(S), rand(S), rand(S)>*5 - 2.5, 0.3 " THING "}\n"
    "#end\n";

/* Where no penumbra is, no ray from the piece meets anything. */
static void nothing_stands_before_lit_pieces(void **state)
{
    (void)state;
    struct scene_world *all = scene_world_new(marbles);
    struct dice dice = { 23 };
    int lit = 0;
    for (int trial = 0; trial < 20000; trial++) {
        struct ray down = { dice_point(&dice, 3), { 0, -1, 0 } };
        struct intersection at;
        if (!world_closest(all->world, &down, 0, RAY_CAMERA, &at) ||
            at.point.y > -1.999)
            continue;
        struct shaft_rays rays = { .from = at.point,
                                   .radius = dice_between(&dice, 0, 0.5),
                                   .middle = dice_point(&dice, 2),
                                   .half = { { 0.2, 0, 0.1 }, { 0, 0.3, 0 } },
                                   .tmin = 1e-3,
                                   .leaf = at.leaf,
                                   .normal = at.face };
        if (world_blur(all->world, &rays, 0) < HUGE_VAL)
            continue;
        vec3 off = vec3_scale(dice_point(&dice, 0.7), rays.radius);
        off.y = 0;
        double u = dice_between(&dice, -1, 1), v = dice_between(&dice, -1, 1);
        vec3 from = vec3_add(rays.from, off);
        vec3 end = vec3_along(vec3_along(rays.middle, rays.half[0], u),
                              rays.half[1], v);
        vec3 way = vec3_sub(end, from);
        struct ray ray = { from, vec3_normalise(way) };
        assert_false(world_occluded(
            all->world,
            &(struct occlusion){ .ray = &ray,
                                 .tmin = rays.tmin,
                                 .tmax = vec3_length(way) - 1e-3 }));
        lit++;
    }
    assert_true(lit > 500);
    scene_world_free(all);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rays_in_shafts_are_as_without),
        cmocka_unit_test(other_shafts_are_crowded),
        cmocka_unit_test(penumbras_are_as_wide_as_things_are_far),
        cmocka_unit_test(nothing_stands_before_lit_pieces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
