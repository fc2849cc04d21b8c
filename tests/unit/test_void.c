/* Voxels, void and walls of scenes: no wall leaks, doors stay open, areas are
 * true, and scenes that have little or too much get a result or a message. */
#include "harness.h"

#include "scene_world.h"
#include "skeleton/grid.h"
#include "skeleton/matter.h"
#include "skeleton/patches.h"
#include "skeleton/void.h"
#include "skeleton/voxelise.h"

#include "base/memory.h"
#include "shapes.h"

#define PI 3.14159265358979323846

/* The marks of a scene in a grid of its own. */
struct marked {
    struct scene_world *all;
    struct voxels grid;
    uint8_t *marks;
};

static struct marked marked_new(const char *text, int resolution,
                                unsigned threads)
{
    struct marked m = { .all = scene_world_new(text) };
    struct scene_world *all = m.all;
    assert_true(grid_place(&m.grid, all->world, &all->scene->camera,
                           (struct grid_wish){ .resolution = resolution },
                           &all->diag));
    m.marks = memory_new(voxels_count(&m.grid));
    const uint8_t *leaves =
        matter_marks(all->world, voxels_box(&m.grid), all->arena);
    voxelise(all->world, &m.grid, leaves, threads, NULL, m.marks);
    return m;
}

static void marked_free(struct marked *m)
{
    memory_free(m->marks);
    scene_world_free(m->all);
}

/* Scenes within 2 of the origin, their surfaces of many kinds. */
static const char *const surfaces[] = {
    "sphere { 0, 1.3 rotate 20 scale <1, 0.6, 1.2> }",
    "box { -1, <0.5, 1, 0.7> rotate <20, 30, 40> }",
    "cylinder { -y, y, 0.6 rotate 33 }",
    "cylinder { -y, y, 0.6 open rotate <50, 0, 20> }",
    "cone { -y, 1, y, 0.2 rotate <30, 0, 70> }",
    "torus { 1, 0.3 rotate <40, 0, 30> }",
    "plane { <1, 2, 3>, 0.4 }",
    "disc { <0.03, 0.01, 0>, <1, 1, 2>, 1.4, 0.5 }",
    "polygon { 5, <-1,-1>, <1,-1>, <1.2,1>, <-1,0.4>, <-1,-1> rotate 40 }",
    "quadric { <1,1,-1>, 0, 0, -0.3 clipped_by { box { -1.5, 1.5 } } }",
    "quartic { < 1,0,0,0, 2,0,0,2, 0,-2, 0,0,0,0, 0,0,0,0, 0,0, 1,0,0,2, 0,-2,"
    " 0,0,0,0, 1,0,-2,0, 0.9 > clipped_by { box { -1.5, 1.5 } } }",
    "cubic { <0,0,0,1, 0,0,0,0, 0,0, 1,0,0,0, 0,0, 0,0,-1,0>"
    " clipped_by { box { -1.2, 1.2 } } rotate 25 }",
    "difference { box { -1, 1 } sphere { 0, 1.3 } rotate <10, 20, 30> }",
    "difference { sphere { 0, 1.5 } box { -2, <0.03, 2, 2> } }",
    "intersection { cylinder { -2*z, 2*z, 1 } cylinder { -2*x, 2*x, 1 } }",
    "merge { sphere { -0.5*x, 1 } sphere { 0.5*x, 1 } }",
    "union { sphere { 0, 1 } box { 0.5, 1.5 } clipped_by { plane { y, 0.7 } } "
    "}",
    "triangle { <-1,-1.5,-1>, <1.7,0,1>, <-0.3,1.6,1.5> }",
    "mesh { triangle { <-1,-1,-1>, <1,-1,1>, <-1,1,0> }"
    " triangle { <0,0,-1.9>, <0.01,0,1.9>, <0,1.7,0.01> } rotate 15 }",
    "difference { mesh { triangle { <-1,-1,-1>, <1,-1,-1>, <0,1,0> }"
    " triangle { <-1,-1,-1>, <0,-1,1>, <0,1,0> }"
    " triangle { <1,-1,-1>, <0,-1,1>, <0,1,0> }"
    " triangle { <-1,-1,-1>, <1,-1,-1>, <0,-1,1> } inside_vector y }"
    " sphere { y, 0.7 } }",
    /* Cells have their middle on the axes of these, which are of a length to
     * which a unit vector is only nearly one. */
    "difference { cylinder { -1.9*z, 1.93*z, 0.6 }"
    " cylinder { -2*z, 1.8*z, 0.5 } }",
    "cylinder { -1.8*x, 1.9*x, 0.3 }",
    "cone { -1.9*y, 0.9, 1.93*y, 0.3 }",
    "torus { 1.3, 0.2 }",
    "torus { 0.8, 1 }",
    "quadric { <1,0,1>, 0, 0, -0.5 clipped_by { box { -1.9, 1.8 } } }",
};

enum { SURFACES = sizeof surfaces / sizeof *surfaces };

/* A camera, and two small walls that settle where the grid is. */
static struct marked surface_marked(size_t number, int resolution,
                                    unsigned threads)
{
    char text[1000];
    snprintf(text, sizeof text,
             "camera { location <0,0,-1.9> look_at 0 }\n"
             "sphere { -2, 0.001 } sphere { 2, 0.001 } %s\n",
             surfaces[number]);
    return marked_new(text, resolution, threads);
}

/* The number of hits of random rays in voxels without a mark; `hit` gets a 1
 * where there was one. */
static size_t missed(const struct marked *m, size_t rays, uint8_t *hit)
{
    struct dice dice = { 5 };
    size_t count = 0;
    for (size_t i = 0; i < rays; i++) {
        vec3 from = dice_point(&dice, 2), to = dice_point(&dice, 2);
        struct ray ray = { from, vec3_normalise(vec3_sub(to, from)) };
        struct intersection at;
        int place[3];
        if (!world_closest(m->all->world, &ray, 1e-9, RAY_CAMERA, &at) ||
            !voxels_find(&m->grid, at.point, place))
            continue;
        size_t index = voxels_index(&m->grid, place[0], place[1], place[2]);
        hit[index] = 1;
        count += !m->marks[index];
    }
    return count;
}

static void marks_hold_all_surfaces(void **state)
{
    (void)state;
    for (size_t number = 0; number < SURFACES; number++) {
        struct marked m = surface_marked(number, 40, 2);
        uint8_t *hit = calloc(1, voxels_count(&m.grid));
        size_t misses = missed(&m, 10000, hit);
        if (misses > 0)
            fail_msg("%zu hits outside of marks: %s", misses, surfaces[number]);
        free(hit);
        marked_free(&m);
    }
}

/* Rays find most of the voxels that are marked: few marks are too many. */
static void marks_are_not_generous(void **state)
{
    (void)state;
    for (size_t number = 0; number < SURFACES; number++) {
        struct marked m = surface_marked(number, 16, 1);
        size_t count = voxels_count(&m.grid), marks = 0, hits = 0;
        uint8_t *hit = calloc(1, count);
        missed(&m, 50000, hit);
        for (size_t i = 0; i < count; i++) {
            marks += m.marks[i] != 0;
            hits += hit[i];
        }
        if (100 * hits < 75 * marks)
            fail_msg("of %zu marks only %zu are hit: %s", marks, hits,
                     surfaces[number]);
        free(hit);
        marked_free(&m);
    }
}

/* Skies and grounds are cut, and what is far away is left outside. */
static void grids_are_around_what_matters(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double edge; /* at most, of 40 voxels */
    } rows[] = {
        { "sphere { 0, 1 }", 0.17 },
        { "sphere { 0, 1 } sphere { 0, 1e5 hollow }", 0.17 },
        { "sphere { 0, 1 } box { <-900,-2,-900>, <900,-1,900> }", 0.17 },
        { "sphere { 0, 1 } light_source { 1e4, 1 }", 0.17 },
        { "sphere { 1e9*x, 1 } sphere { 0, 1 }", 0.17 },
        { "sphere { 0, 0.1 } box { -5, 5 }", 0.28 },
        { "plane { y, -4 } plane { -y, -4 } plane { x, -4 } plane { -x, -4 }"
          " plane { z, -4 } plane { -z, -4 } light_source { 0, 1 }",
          0.22 },
        { "plane { y, -4 } plane { -y, -4 } plane { x, -4 } plane { -x, -4 }"
          " union { plane { z, -4 } plane { -z, -4 } } box { -.3, .3 }"
          " light_source { <0, -3.9, 0>, 1 }",
          0.22 },
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[600];
        snprintf(text, sizeof text,
                 "camera { location <0,0,-3> look_at 0 } %s\n", rows[i].text);
        struct marked m = marked_new(text, 40, 1);
        if (m.grid.edge > rows[i].edge || m.grid.edge < 0.5 * rows[i].edge)
            fail_msg("edge %g: %s", m.grid.edge, rows[i].text);
        marked_free(&m);
    }
}

/* Against the definition, voxel by voxel. */
static void sphere_marks_are_exact(void **state)
{
    (void)state;
    struct marked m = marked_new("camera { location <0,0,-1.9> look_at 0 }\n"
                                 "sphere { -2, 0.001 } sphere { 2, 0.001 }\n"
                                 "sphere { <0.1, 0.2, 0.05>, 1.3 }\n",
                                 48, 2);
    vec3 centre = { 0.1, 0.2, 0.05 };
    for (size_t i = 0; i < voxels_count(&m.grid); i++) {
        int at[3];
        voxels_place(&m.grid, i, at);
        vec3 d = vec3_sub(voxels_centre(&m.grid, at), centre);
        double h = m.grid.edge / 2, near = 0, far = 0;
        for (int k = 0; k < 3; k++) {
            double x = fabs(vec3_component(d, k));
            near += pow(fmax(0, x - h), 2);
            far += pow(x + h, 2);
        }
        bool wanted = near <= 1.69 && far >= 1.69;
        bool corner = i == voxels_index(&m.grid, 1, 1, 1) ||
                      vec3_length(vec3_add(d, centre)) > 3.2;
        if (!corner)
            assert_int_equal(m.marks[i] != 0, wanted);
    }
    marked_free(&m);
}

/* Shapes that can't tell what a cell meets are searched with rays. */
static void shapes_without_a_test_are_searched(void **state)
{
    (void)state;
    struct scene_world *all = scene_world_new(
        "camera { location <0,0,-1.9> look_at 0 }\n"
        "difference { sphere { 0, 1.9 } sphere { 0.4, 1.5 } }\n");
    struct primitive plain = *primitive_find("sphere");
    const struct object *top = all->scene->objects.items[0];
    plain.meets = NULL;
    for (size_t i = 0; i < 2; i++)
        ((struct object *)(uintptr_t)top->more->children[i])->primitive =
            &plain;
    struct marked m = { .all = all };
    assert_true(grid_place(&m.grid, all->world, &all->scene->camera,
                           (struct grid_wish){ .resolution = 30 }, &all->diag));
    size_t count = voxels_count(&m.grid), hits = 0;
    m.marks = memory_new(count);
    voxelise(all->world, &m.grid,
             matter_marks(all->world, voxels_box(&m.grid), all->arena), 2, NULL,
             m.marks);
    uint8_t *hit = calloc(1, count);
    size_t misses = missed(&m, 20000, hit);
    for (size_t i = 0; i < count; i++)
        hits += hit[i];
    assert_true(hits > 1000);
    assert_true(misses < 100); /* of 20000: corners that no ray passes */
    free(hit);
    marked_free(&m);
}

/* A room of six slabs, in which the camera looks at many small things: the
 * chamber is the room. */
static void rooms_are_held_around_small_things(void **state)
{
    (void)state;
    struct scene_world *all = scene_world_new(
        "camera { location <0,0,-1> look_at 0 } light_source { 4*y, 1 }\n"
        "#for (I, 0, 7) sphere { <0.1*I, 0, 0>, 0.05 } #end\n"
        "box { <-9,-9,-9>, <9,-8,9> } box { <-9,8,-9>, <9,9,9> }\n"
        "box { <-9,-8,-9>, <-8,8,9> } box { <8,-8,-9>, <9,8,9> }\n"
        "box { <-8,-8,-9>, <8,8,-8> } box { <-8,-8,8>, <8,8,9> }\n");
    static const vec3 middles[6] = { { -8, 0, 0 }, { 8, 0, 0 },  { 0, -8, 0 },
                                     { 0, 8, 0 },  { 0, 0, -8 }, { 0, 0, 8 } };
    struct voxels grid;
    assert_true(grid_place(
        &grid, all->world, &all->scene->camera,
        (struct grid_wish){ .resolution = 48, .still = true }, &all->diag));
    for (int i = 0; i < 6; i++)
        assert_true(box3_contains(voxels_box(&grid), middles[i]));
    scene_world_free(all);
}

static void marks_are_the_same_for_any_threads(void **state)
{
    (void)state;
    for (size_t number = 0; number < SURFACES; number += 3) {
        struct marked one = surface_marked(number, 50, 1);
        struct marked many = surface_marked(number, 50, 4);
        assert_memory_equal(one.marks, many.marks, voxels_count(&one.grid));
        marked_free(&one);
        marked_free(&many);
    }
}

/* A scene's void. */
struct voided {
    struct scene_world *all;
    struct void_space *space;
};

static struct voided voided_new(const char *text, int resolution,
                                unsigned threads)
{
    struct voided v = { .all = scene_world_new(text) };
    v.space = void_new(v.all->scene, v.all->world,
                       (struct grid_wish){ .resolution = resolution }, threads,
                       NULL, &v.all->diag);
    fflush(v.all->diag.out);
    return v;
}

static void voided_free(struct voided *v)
{
    void_free(v->space);
    scene_world_free(v->all);
}

/* Somebody who doesn't want it any more gets none. */
static void a_stop_is_heard(void **state)
{
    (void)state;
    struct scene_world *all = scene_world_new(
        "sphere { 0, 2 pigment { rgb 0.5 } } light_source { <0,1,0>, 1 }\n");
    atomic_int stop = 1;
    assert_null(void_new(all->scene, all->world,
                         (struct grid_wish){ .resolution = 30 }, 2, &stop,
                         &all->diag));
    fflush(all->diag.out);
    assert_string_equal(all->printed, "");
    scene_world_free(all);
}

/* Whether the rooms of two_rooms() are in one part of the void. */
static bool connected(const struct void_space *space, double turn)
{
    affine rotation = affine_rotation(vec3_make(turn, turn, 0));
    vec3 a = affine_point(&rotation, vec3_make(-2, 0, 0));
    vec3 b = affine_point(&rotation, vec3_make(2, 0, 0));
    size_t i = voxels_empty_at(&space->voxels, a);
    size_t k = voxels_empty_at(&space->voxels, b);
    return i != VOXEL_NONE && k != VOXEL_NONE &&
           space->label[i] == space->label[k];
}

/* Two rooms of 4 x 3 x 4 with a wall of this thickness between them, turned
 * and moved so that it lies anyhow in the grid, and a door of this size; lit
 * in both. A voxel is 0.14 or more. */
static struct voided two_rooms(double thickness, double door, double turn)
{
    char text[1500];
    snprintf(text, sizeof text,
             "#declare T = %g; #declare D = %g;\n"
             "#macro Slab(A, B) box { A, B rotate <%g, %g, 0>"
             " pigment { rgb 0.5 } } #end\n"
             "Slab(<-4.1,-1.6,-2.1>, <4.1,-1.5,2.1>)\n"
             "Slab(<-4.1,1.5,-2.1>, <4.1,1.6,2.1>)\n"
             "Slab(<-4.1,-1.6,-2.1>, <-4,1.6,2.1>)\n"
             "Slab(<4,-1.6,-2.1>, <4.1,1.6,2.1>)\n"
             "Slab(<-4.1,-1.6,-2.1>, <4.1,1.6,-2>)\n"
             "Slab(<-4.1,-1.6,2>, <4.1,1.6,2.1>)\n"
             "difference { box { <-T/2,-1.55,-2.05>, <T/2,1.55,2.05> }\n"
             "  #if (D > 0) box { <-1,-D/2,-D/2>, <1,D/2,D/2> } #end\n"
             "  rotate <%g, %g, 0> pigment { rgb 0.5 } }\n"
             "light_source { <2,0,0>, 1 rotate <%g, %g, 0> }\n"
             "light_source { <-2,0,0>, 1 rotate <%g, %g, 0> }\n"
             "camera { location <2,0,0.5> look_at 0 rotate <%g, %g, 0> }\n",
             thickness, door, turn, turn, turn, turn, turn, turn, turn, turn,
             turn, turn);
    return voided_new(text, 60, 2);
}

static void thin_walls_do_not_leak(void **state)
{
    (void)state;
    for (int i = 0; i < 4; i++) {
        double turn = i * 17;
        struct voided v = two_rooms(0.07, 0, turn);
        assert_non_null(v.space);
        assert_int_equal(v.space->part_count, 2);
        assert_false(connected(v.space, i * 17));
        assert_false(v.space->parts[0].sky);
        assert_false(v.space->parts[1].sky);
        voided_free(&v);
    }
}

static void doors_of_four_voxels_stay_open(void **state)
{
    (void)state;
    for (int i = 0; i < 4; i++) {
        struct voided v = two_rooms(0.3, 0, i * 17);
        double door = 4 * v.space->voxels.edge;
        voided_free(&v);
        v = two_rooms(0.3, door, i * 17);
        assert_true(connected(v.space, i * 17));
        assert_int_equal(v.space->part_count, 1);
        voided_free(&v);
    }
}

static struct patches *voided_patches(const struct voided *v, unsigned threads)
{
    struct ambience ambience = ambience_new(v->all->world, v->all->scene);
    struct patches_scene from = { .world = v->all->world,
                                  .ambience = &ambience,
                                  .seed = 1,
                                  .threads = threads };
    return patches_new(&v->space->voxels, &from);
}

static double wall_area(const struct voided *v, rgb *albedo)
{
    struct patches *patches = voided_patches(v, 2);
    double area = 0;
    rgb sum = rgb_grey(0);
    for (size_t i = 0; i < patches->count; i++) {
        const struct wall_patch *patch = &patches->items[i];
        assert_true(v->space->voxels.empty[patch->voxel]);
        area += (double)patch->area;
        sum =
            rgb_add_scaled(sum, patch_rgb(patch->albedo), (double)patch->area);
    }
    patches_free(patches);
    *albedo = rgb_scale(sum, 1 / area);
    return area;
}

/* From within and from without, of bodies straight and turned. */
static void areas_are_true(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double area;
    } rows[] = {
        { "sphere { 0, 1.7 }", 4 * PI * 1.7 * 1.7 },
        { "box { <-1.3,-1,-1.6>, <1.3,1,1.6> }", 39.84 },
        { "box { <-1.3,-1,-1.6>, <1.3,1,1.6> rotate <31,17,9> }", 39.84 },
        { "difference { box { -1.1, 1.1 } box { -1, 1 } rotate 20 }", 24 },
        { "sphere { <2,2,2>, 1 }", 4 * PI },
        { "box { <1,1,1>, <3,3,3> rotate 10 }", 24 },
        { "cylinder { <1,2,2>, <3,1,2>, 0.9 }",
          2 * PI * 0.81 + 2 * PI * 0.9 * 2.2360679775 },
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[600];
        snprintf(text, sizeof text,
                 "#default { pigment { rgb <0.8, 0.5, 0.2> }"
                 " finish { diffuse 0.5 } }\n"
                 "camera { location <0,0.2,0> look_at <0,0,3> }\n"
                 "light_source { 0.1, 1 } %s\n",
                 rows[i].text);
        rgb albedo;
        struct voided v = voided_new(text, 64, 2);
        double area = wall_area(&v, &albedo);
        if (fabs(area - rows[i].area) > 0.03 * rows[i].area)
            fail_msg("area %g, not %g: %s", area, rows[i].area, rows[i].text);
        assert_true(fabs(albedo.r - 0.4) < 1e-6);
        assert_true(fabs(albedo.g - 0.25) < 1e-6);
        assert_true(fabs(albedo.b - 0.1) < 1e-6);
        voided_free(&v);
    }
}

static void walls_are_the_same_for_any_threads(void **state)
{
    (void)state;
    const char *text = "camera { location 0 look_at z } light_source { 0.1, 1 }"
                       "difference { box { -2, 2 } sphere { 0, 1.7 } }"
                       "torus { 1, 0.2 finish { emission 1 } }";
    struct voided one = voided_new(text, 50, 1);
    struct voided many = voided_new(text, 50, 5);
    size_t count = voxels_count(&one.space->voxels);
    assert_memory_equal(one.space->label, many.space->label,
                        count * sizeof *one.space->label);
    struct patches *a = voided_patches(&one, 1);
    struct patches *b = voided_patches(&many, 5);
    assert_int_equal(a->count, b->count);
    assert_memory_equal(a->items, b->items, a->count * sizeof *a->items);
    patches_free(a);
    patches_free(b);
    voided_free(&one);
    voided_free(&many);
}

/* What holds a light and what is said. */
static void odd_scenes_get_a_result_or_a_message(void **state)
{
    (void)state;
    static const char camera[] = "camera { location <0,0,-3> look_at 0 }\n";
    static const struct {
        const char *text;
        size_t parts;
        const char *message; /* part of it, or NULL: none */
    } rows[] = {
        { "", 1, NULL },
        { "light_source { 5, 1 }", 1, NULL },
        { "triangle { 0, x, y }", 1, NULL },
        { "triangle { 0, x, y } light_source { <3,3,-3>, 1 }", 1, NULL },
        { "plane { y, -1 } light_source { <3,3,-3>, 1 }", 1, NULL },
        { "box { -1, 1 } light_source { 0, 1 }", 2, NULL },
        { "global_settings { light_mesh { sky on } }"
          " box { -1, 1 } light_source { 0, 1 }",
          2, "no light gets into the part" },
        { "global_settings { light_mesh { sky on } }"
          " box { -1, 1 } light_source { 0, 1 } background { rgb 0.1 }",
          2, NULL },
        { "box { -5, 5 } box { -1, 1 } light_source { 0, 1 }", 2,
          "no light gets into the part" },
        { "box { -5, 5 } box { -1, 1 } light_source { 0, 1 }", 2,
          "test.pov:4:29: note: this light is shut in" },
        { "box { -5, 5 } box { -1, 1 no_shadow } light_source { 0, 1 }", 1,
          NULL },
        { "box { -5, 5 } box { -1, 1 pigment { rgbt <1,1,1,0.9> } }"
          " light_source { 0, 1 }",
          1, NULL },
        { "box { -5, 5 } sphere { 0, 1 finish { emission 1 } }", 1, NULL },
        { "sphere { 0, 5 finish { emission 1 } } sphere { 0, 1 }", 2, NULL },
        { "box { -5, 5 finish { emission 1 } } light_source { <9,9,9>, 1 }", 2,
          NULL },
        { "box { -5, 5 }", 1, "no light gets into the part" },
        { "difference { box { -5, 5 } box { -4.5, 4.5 } #for (I, -9, 9)"
          " box { <I*0.4,-4,4>, <I*0.4+0.1,4,6> } #end }"
          " light_source { <0,0,15>, 1 }",
          2, NULL },
        { "difference { box { -5, 5 } box { -4.5, 4.5 } #for (I, -9, 9)"
          " box { <I*0.4,-4,4>, <I*0.4+0.1,4,6> } #end }"
          " light_source { <0,15,5.1>, 1 }",
          2, NULL },
        { "difference { box { -5, 5 } box { -4.5, 4.5 } }"
          " light_source { <0,0,15>, 1 }",
          2, "no light gets into the part" },
        { "sphere { 0, 0.1 scale <9,9,1> } #for (I, -99, 99)"
          " box { <-9,-9,I/33>, <9,9,I/33+0.02> } #end"
          " light_source { 0, 1 }",
          1, "test.pov:4:94: warning: this light is inside of matter" },
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char text[600];
        snprintf(text, sizeof text, "%s%s\n", camera, rows[i].text);
        struct voided v = voided_new(text, 40, 2);
        assert_non_null(v.space);
        if (v.space->part_count != rows[i].parts)
            fail_msg("%zu parts, not %zu: %s", v.space->part_count,
                     rows[i].parts, rows[i].text);
        const char *printed = v.all->printed;
        bool right = rows[i].message ? strstr(printed, rows[i].message) != NULL
                                     : !*printed;
        if (!right)
            fail_msg("printed: %s\nby: %s", printed, rows[i].text);
        voided_free(&v);
    }
}

static void a_thousand_lights_are_placed(void **state)
{
    (void)state;
    struct voided v =
        voided_new("camera { location <0,0,-3> look_at 0 } box { -5, 5 }\n"
                   "#for (I, 1, 1000) light_source { <4*sin(I), 4*cos(I),"
                   " 4*sin(I*I)>, 1 } #end\n",
                   64, 2);
    assert_int_equal(v.space->light_count, 1000);
    for (size_t i = 0; i < 1000; i++)
        assert_true(v.space->lights[i].voxel != VOXEL_NONE);
    assert_int_equal(v.space->parts[0].lights, 1000);
    voided_free(&v);
}

static void too_many_voxels_are_refused(void **state)
{
    (void)state;
    struct voided v = voided_new("camera { location <0,0,-3> look_at 0 }"
                                 " box { -5, 5 }",
                                 60000, 2);
    assert_null(v.space);
    assert_non_null(strstr(v.all->printed, "a skeleton of resolution 60000"));
    assert_int_equal(v.all->diag.errors, 1);
    voided_free(&v);
}

/* Of a floor the void above, of a thin wall each its own side. */
static void points_face_their_void(void **state)
{
    (void)state;
    struct voided v = two_rooms(0.07, 0, 0);
    for (int i = -15; i <= 15; i++) {
        vec3 point = { 0.035, 0.1 * i, 0.13 * i }, normal = { 1, 0, 0 };
        size_t right = void_facing(v.space, point, normal);
        size_t left =
            void_facing(v.space, vec3_negate(point), vec3_negate(normal));
        assert_true(right != VOXEL_NONE && left != VOXEL_NONE);
        assert_true(v.space->label[right] != v.space->label[left]);
    }
    voided_free(&v);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_stop_is_heard),
        cmocka_unit_test(marks_hold_all_surfaces),
        cmocka_unit_test(marks_are_not_generous),
        cmocka_unit_test(sphere_marks_are_exact),
        cmocka_unit_test(shapes_without_a_test_are_searched),
        cmocka_unit_test(grids_are_around_what_matters),
        cmocka_unit_test(rooms_are_held_around_small_things),
        cmocka_unit_test(marks_are_the_same_for_any_threads),
        cmocka_unit_test(thin_walls_do_not_leak),
        cmocka_unit_test(doors_of_four_voxels_stay_open),
        cmocka_unit_test(areas_are_true),
        cmocka_unit_test(walls_are_the_same_for_any_threads),
        cmocka_unit_test(odd_scenes_get_a_result_or_a_message),
        cmocka_unit_test(a_thousand_lights_are_placed),
        cmocka_unit_test(too_many_voxels_are_refused),
        cmocka_unit_test(points_face_their_void),
    };
    return cmocka_run_group_tests_name("void", tests, NULL, NULL);
}
