/* Photons: none of their light is lost, and the map finds what a look at all of
 * them finds. */
#include "harness.h"

#include <string.h>

#include "base/memory.h"
#include "base/random.h"
#include "base/warp.h"
#include "scene_world.h"
#include "shade/photon_map.h"
#include "tracer/photons.h"

static double coordinate(uint64_t number)
{
    return random_unit(random_key(7, number));
}

static void packing(void **state)
{
    (void)state;
    for (uint64_t i = 0; i < 1000; i++) {
        const double u[2] = { coordinate(2 * i), coordinate(2 * i + 1) };
        vec3 direction = warp_sphere(u);
        int16_t packed[2];
        photon_pack(direction, packed);
        vec3 error = vec3_sub(photon_unpack(packed), direction);
        assert_true(vec3_length(error) < 2e-4);
    }
}

/* Many on a floor, every third of them from below, some in one place. */
static struct photon *floor_photons(size_t count)
{
    struct photon *photons = memory_new(count * sizeof *photons);
    for (size_t i = 0; i < count; i++) {
        struct photon *p = &photons[i];
        uint64_t place = i % 50 == 0 ? 0 : i;
        p->at[0] = (float)coordinate(3 * place);
        p->at[2] = (float)coordinate(3 * place + 1);
        p->flux[0] = p->flux[1] = p->flux[2] = 1 + (float)(i % 5);
        photon_pack(vec3_make(0, i % 3 ? 1 : -1, 0), p->from);
    }
    return photons;
}

struct found {
    unsigned count;
    double light;
};

static void visit_found(void *context, const struct photon *photon,
                        rgb irradiance)
{
    struct found *found = context;
    (void)photon;
    found->count++;
    found->light += irradiance.g;
}

/* The same by looking at all: the square of the distance of number `most`, and
 * the sum of the kernel. */
static double floor_light(const struct photon *photons, size_t count,
                          unsigned most, vec3 at, double reach)
{
    double *squares = memory_new(count * sizeof *squares), light = 0;
    for (size_t i = 0; i < count; i++) {
        double x = (double)photons[i].at[0] - at.x;
        double z = (double)photons[i].at[2] - at.z;
        squares[i] = i % 3 ? x * x + z * z : 1e9;
    }
    for (size_t within = count; within >= most;) {
        double farthest = 0;
        within = 0;
        for (size_t i = 0; i < count; i++)
            if (squares[i] < reach) {
                within++;
                farthest = fmax(farthest, squares[i]);
            }
        if (within >= most)
            reach = farthest;
    }
    for (size_t i = 0; i < count; i++)
        if (squares[i] < reach)
            light += (1 + (double)(i % 5)) * 2 * (1 - squares[i] / reach) /
                     (WARP_PI * reach);
    memory_free(squares);
    return light;
}

/* Where a worker asked before changes nothing, to the bit. */
static void map_forgets_where_it_was_asked(void **state)
{
    enum { COUNT = 3000 };
    struct worker walking = { .scratch = arena_new(0) };
    struct photon_gather gather = { 5, 40, 0.08, 1 };
    struct photon_map *map =
        photon_map_new(floor_photons(COUNT), COUNT, &gather, 2);
    (void)state;
    for (int i = 0; i < 500; i++) {
        struct worker fresh = { .scratch = walking.scratch };
        struct found walked = { 0, 0 }, found = { 0, 0 };
        vec3 at = { i % 10 ? 0.002 * i : coordinate(0) + 1e-5 * i, 0,
                    i % 10 ? 0.5 : coordinate(1) };
        photon_map_visit(map, &walking, at, vec3_make(0, 1, 0), visit_found,
                         &walked);
        photon_map_visit(map, &fresh, at, vec3_make(0, 1, 0), visit_found,
                         &found);
        assert_true(walked.count == found.count && walked.light == found.light);
    }
    photon_map_free(map);
    arena_free(walking.scratch);
}

static void map_finds_the_nearest(void **state)
{
    enum { COUNT = 3000, MOST = 60 };
    struct worker worker = { .scratch = arena_new(0) };
    struct photon *photons = floor_photons(COUNT), *copy = floor_photons(COUNT);
    struct photon_gather gather = { 1, MOST, 0.2, 1 };
    struct photon_map *map = photon_map_new(copy, COUNT, &gather, 2);
    (void)state;
    for (uint64_t i = 0; i < 50; i++) {
        vec3 at = { coordinate(9000 + i), 0, coordinate(9500 + i) * 1.2 };
        struct found found = { 0, 0 };
        photon_map_visit(map, &worker, at, vec3_make(0, 1, 0), visit_found,
                         &found);
        double light = floor_light(photons, COUNT, MOST, at, 0.2 * 0.2);
        assert_true(found.count <= MOST);
        assert_true(fabs(found.light - light) <= 1e-3 * light + 1e-9);
    }
    photon_map_free(map);
    memory_free(photons);
    arena_free(worker.scratch);
}

/* Not even who looks for one photon alone finds it dark where there are some.
 */
static void one_photon_is_light(void **state)
{
    enum { COUNT = 300 };
    struct worker worker = { .scratch = arena_new(0) };
    struct photon_gather gather = { 1, 1, 0, 1 };
    struct photon_map *map =
        photon_map_new(floor_photons(COUNT), COUNT, &gather, 1);
    struct found found = { 0, 0 };
    (void)state;
    photon_map_visit(map, &worker, vec3_make(.5, 0, .5), vec3_make(0, 1, 0),
                     visit_found, &found);
    assert_true(found.light > 0);
    photon_map_free(map);
    arena_free(worker.scratch);
}

static void map_of_none(void **state)
{
    struct worker worker = { .scratch = arena_new(0) };
    struct photon_gather gather = { 20, 100, 0, 1 };
    struct photon_map *map = photon_map_new(NULL, 0, &gather, 1);
    struct found found = { 0, 0 };
    (void)state;
    photon_map_visit(map, &worker, vec3_make(0, 0, 0), vec3_make(0, 1, 0),
                     visit_found, &found);
    assert_int_equal(found.count, 0);
    photon_map_free(map);
    arena_free(worker.scratch);
}

/* What the scene's lamps send; their sum into *flux. */
static struct photon_map *sent(const char *text, unsigned threads, rgb *flux)
{
    struct scene_world *all = scene_world_new(text);
    struct tracer tracer = { .scene = all->scene,
                             .world = all->world,
                             .quality = 9 };
    struct photon_map *map;
    size_t count;
    assert_true(photons_send(&tracer, threads, NULL, &all->diag, &map));
    const struct photon *photons = photon_map_all(map, &count);
    *flux = rgb_grey(0);
    for (size_t i = 0; i < count; i++)
        *flux = rgb_add(*flux, rgb_make((double)photons[i].flux[0],
                                        (double)photons[i].flux[1],
                                        (double)photons[i].flux[2]));
    scene_world_free(all);
    return map;
}

#define LENS                                                                   \
    "global_settings { photons { count 40000 } }"                              \
    "plane { y, -4 pigment { rgb 1 } }"                                        \
    "sphere { 0, 1 pigment { rgbf <1, .5, 1, 1> }"                             \
    "  finish { diffuse 0 } interior { ior 1.5 }"                              \
    "  photons { target refraction on } }"

/* All that enters a lens lands below it: its cross-section times the light,
 * green halved by either surface. */
static void lens_loses_nothing(void **state)
{
    rgb flux;
    (void)state;
    photon_map_free(
        sent("light_source { 10*y, rgb <1, 1, .5> parallel }" LENS, 1, &flux));
    assert_true(fabs(flux.r - WARP_PI) < 0.01 * WARP_PI);
    assert_true(fabs(flux.g - WARP_PI / 4) < 0.01 * WARP_PI);
    assert_true(fabs(flux.b - WARP_PI / 2) < 0.01 * WARP_PI);
}

static void threads_change_nothing(void **state)
{
    rgb flux;
    size_t count, other;
    struct photon_map *one = sent("light_source { 5*y, 1 }" LENS, 1, &flux);
    struct photon_map *more = sent("light_source { 5*y, 1 }" LENS, 3, &flux);
    const struct photon *a = photon_map_all(one, &count);
    const struct photon *b = photon_map_all(more, &other);
    (void)state;
    assert_int_equal(count, other);
    assert_true(count > 10000);
    assert_memory_equal(a, b, count * sizeof *a);
    photon_map_free(one);
    photon_map_free(more);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(packing),
        cmocka_unit_test(map_finds_the_nearest),
        cmocka_unit_test(map_forgets_where_it_was_asked),
        cmocka_unit_test(one_photon_is_light),
        cmocka_unit_test(map_of_none),
        cmocka_unit_test(lens_loses_nothing),
        cmocka_unit_test(threads_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
